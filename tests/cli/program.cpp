// SPDX-License-Identifier: Apache-2.0
#include "program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace frana::test {

Outcome run_program(const std::string& folder, const std::vector<std::string>& arguments,
                    int signal_after_ms) {
    const std::string out = folder + "/.stdout", err = folder + "/.stderr";
    std::vector<char*> words{const_cast<char*>(FRANA_PROGRAM)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);

    const pid_t child = ::fork();
    if (child == 0) {
        const int out_file = ::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
        const int err_file = ::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
        if (::chdir(folder.c_str()) != 0 || ::dup2(out_file, 1) < 0 || ::dup2(err_file, 2) < 0) ::_exit(126);
        ::execv(FRANA_PROGRAM, words.data());
        ::_exit(127);
    }
    if (signal_after_ms > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(signal_after_ms));
        ::kill(child, SIGINT);
    }
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_text(out),
                    read_text(err), 1024.0 * static_cast<double>(used.ru_maxrss)};
    ::unlink(out.c_str());
    ::unlink(err.c_str());
    return outcome;
}

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream content;
    content << file.rdbuf();
    return content.str();
}

double json_number(const std::string& json, const std::string& key) {
    const std::string name = "\"" + key + "\": ";
    const auto place = json.find(name);
    if (place == std::string::npos) {
        ADD_FAILURE() << "no key " << key << " in\n" << json;
        return 0;
    }
    char* end = nullptr;
    const char* begin = json.c_str() + place + name.size();
    const double value = std::strtod(begin, &end);
    EXPECT_NE(begin, end) << key << " is no number in\n" << json;
    return value;
}

}  // namespace frana::test
