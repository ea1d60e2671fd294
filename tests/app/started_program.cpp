// SPDX-License-Identifier: Apache-2.0
#include "started_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace frana::test {

StartedProgram::StartedProgram(const std::string& folder, const std::vector<std::string>& arguments,
                               const std::string& program)
    : out_(folder + "/.started_stdout"), err_(folder + "/.started_stderr") {
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    child_ = ::fork();
    if (child_ != 0) return;
    const int out_file = ::open(out_.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
    const int err_file = ::open(err_.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
    if (::chdir(folder.c_str()) != 0 || ::dup2(out_file, 1) < 0 || ::dup2(err_file, 2) < 0) ::_exit(126);
    ::execvp(program.c_str(), words.data());
    ::_exit(127);
}

StartedProgram::~StartedProgram() {
    if (!ended(false)) {
        send(SIGKILL);
        ended(true);
    }
    ::unlink(out_.c_str());
    ::unlink(err_.c_str());
}

void StartedProgram::send(int signal_number) const {
    if (!ended_) ::kill(child_, signal_number);
}

void StartedProgram::pause() const {
    if (ended_) return;
    ::kill(child_, SIGSTOP);
    siginfo_t stopped{};
    ::waitid(P_PID, static_cast<id_t>(child_), &stopped, WSTOPPED | WEXITED | WNOWAIT);
}

bool StartedProgram::ended(bool block) {
    if (!ended_) ended_ = ::waitpid(child_, &status_, block ? 0 : WNOHANG) == child_;
    return ended_;
}

bool StartedProgram::wait_until(const std::function<bool()>& happens) {
    while (!happens()) {
        if (ended(false)) return happens();  // between the two looks, before its end
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

Outcome StartedProgram::wait() {
    ended(true);
    return {WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_), read_text(out_), read_text(err_), 0, 0};
}

}  // namespace frana::test
