// SPDX-License-Identifier: Apache-2.0
#include "supervised_program.h"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <regex>

namespace frana::test {
namespace {

using Clock = std::chrono::steady_clock;

// Longer than anything here takes on a busy machine.
constexpr double k_patience_seconds = k_sanitized ? 600 : 120;
constexpr const char *k_out = ".stdout", *k_err = ".stderr";  // beside the folder

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A descriptor that is closed by its destructor.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return number_; }
    [[nodiscard]] bool good() const { return number_ >= 0; }

  private:
    int number_;
};

void send_descriptor(int socket, int descriptor) {
    char byte = 0, room[CMSG_SPACE(sizeof(int))] = {};
    iovec data{&byte, 1};
    msghdr message{};
    message.msg_iov = &data;
    message.msg_iovlen = 1;
    message.msg_control = room;
    message.msg_controllen = sizeof room;
    cmsghdr* head = CMSG_FIRSTHDR(&message);
    head->cmsg_level = SOL_SOCKET;
    head->cmsg_type = SCM_RIGHTS;
    head->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(head), &descriptor, sizeof descriptor);
    if (descriptor < 0) message.msg_controllen = 0;
    ::sendmsg(socket, &message, MSG_NOSIGNAL);
}

int receive_descriptor(int socket) {
    char byte = 0, room[CMSG_SPACE(sizeof(int))] = {};
    iovec data{&byte, 1};
    msghdr message{};
    message.msg_iov = &data;
    message.msg_iovlen = 1;
    message.msg_control = room;
    message.msg_controllen = sizeof room;
    if (::recvmsg(socket, &message, MSG_CMSG_CLOEXEC) <= 0) return -1;
    const cmsghdr* head = CMSG_FIRSTHDR(&message);
    int descriptor = -1;
    if (head != nullptr) std::memcpy(&descriptor, CMSG_DATA(head), sizeof descriptor);
    return descriptor;
}

[[noreturn]] void become_frana(const std::string& folder, const Launch& launch, const Watch* watch, int socket) {
    const int out = ::open((folder + k_out).c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
    const int err = ::open((folder + k_err).c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
    if (::chdir(folder.c_str()) != 0 || ::dup2(out, 1) < 0 || ::dup2(err, 2) < 0) ::_exit(126);
    for (const std::string& variable : launch.environment) ::putenv(::strdup(variable.c_str()));
    if (launch.processors > 0) {
        cpu_set_t processors;
        CPU_ZERO(&processors);
        for (int k = 0; k < launch.processors; ++k) CPU_SET(k, &processors);
        ::sched_setaffinity(0, sizeof processors, &processors);
    }
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    std::vector<char*> words{const_cast<char*>(FRANA_PROGRAM)};
    for (const std::string& argument : launch.arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    if (watch != nullptr) send_descriptor(socket, watch_own_calls(*watch));
    ::execv(FRANA_PROGRAM, words.data());
    ::_exit(127);
}

std::string text_at(pid_t process, std::uint64_t address) {
    std::string text(PATH_MAX, '\0');
    // At most to a page's end at a time: the next page may not be mapped.
    std::size_t got = 0;
    while (got < text.size()) {
        const std::size_t step = std::min<std::size_t>(text.size() - got, 4096 - (address + got) % 4096);
        iovec here{text.data() + got, step};
        const iovec there{reinterpret_cast<void*>(address + got), step};
        const ssize_t count = ::process_vm_readv(process, &here, 1, &there, 1, 0);
        if (count <= 0) break;
        const std::size_t end = text.find('\0', got);
        got += static_cast<std::size_t>(count);
        if (end < got) return text.substr(0, end);
    }
    return {};
}

std::string descriptor_path(pid_t process, int descriptor) {
    char path[PATH_MAX];
    const std::string link = "/proc/" + std::to_string(process) + "/fd/" + std::to_string(descriptor);
    const ssize_t length = ::readlink(link.c_str(), path, sizeof path);
    return length < 0 ? "" : std::string(path, static_cast<std::size_t>(length));
}

// Returns the part of a path below the folder; "" for other paths.
std::string below(const std::string& path, const std::string& folder) {
    if (path.rfind(folder + "/", 0) != 0) return {};
    return path.substr(folder.size() + 1);
}

// Process numbers differ from run to run.
std::string without_chance(const std::string& path) {
    static const std::regex k_drawn(R"((partial)[0-9]+)");
    return std::regex_replace(path, k_drawn, "$1*");
}

/// Answers the calls of the watched program.
class Supervisor {
  public:
    Supervisor(std::string folder, pid_t child, int listener, const Judge& judge, Ending& ending)
        : folder_(std::move(folder)), child_(child), listener_(listener), judge_(judge), ending_(ending) {}

    void answer_one() {
        seccomp_notif asked{};
        if (::ioctl(listener_, SECCOMP_IOCTL_NOTIF_RECV, &asked) != 0) return;
        const std::string path = path_of(asked);
        Answer answer;
        if (!path.empty()) {
            const std::string name = call_name(asked.data.nr);
            const SystemCall call{name, path, seen_[{name, path}]++};
            ending_.calls.push_back(call);
            if (judge_) answer = judge_(call);
        }
        give(asked, answer);
    }

  private:
    [[nodiscard]] std::string path_of(const seccomp_notif& asked) const {
        const CallPlace place = call_place(asked.data.nr);
        const auto process = static_cast<pid_t>(asked.pid);
        const auto value = [&](int argument) { return asked.data.args[argument]; };
        if (place.kind == CallPlace::Kind::memory) return "memory";
        if (place.kind == CallPlace::Kind::descriptor)
            return without_chance(below(descriptor_path(process, static_cast<int>(value(place.argument))), folder_));
        std::string path = text_at(process, value(place.argument));
        if (path.empty()) return {};
        if (path.front() != '/') {
            const int from = place.folder < 0 ? AT_FDCWD : static_cast<int>(value(place.folder));
            path = (from == AT_FDCWD ? folder_ : descriptor_path(process, from)) + "/" + path;
        }
        return without_chance(below(path, folder_));
    }

    void give(const seccomp_notif& asked, const Answer& answer) const {
        seccomp_notif_resp reply{};
        reply.id = asked.id;
        reply.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
        if (answer.kind == Answer::Kind::fail) {
            reply.flags = 0;
            reply.error = -answer.number;
        } else if (answer.kind == Answer::Kind::shorten) {
            if (const ssize_t written = write_half(asked); written > 0) {
                reply.flags = 0;
                reply.val = written;
            }
        } else if (answer.kind == Answer::Kind::signal) {
            ::kill(child_, answer.number);
            if (answer.number == SIGKILL) return;
        }
        ::ioctl(listener_, SECCOMP_IOCTL_NOTIF_SEND, &reply);
    }

    // On behalf of the program, by its own open file; returns 0 if that is not possible.
    [[nodiscard]] ssize_t write_half(const seccomp_notif& asked) const {
        const bool placed = asked.data.nr == SYS_pwrite64;
        if ((!placed && asked.data.nr != SYS_write) || asked.data.args[2] < 2) return 0;
        std::string bytes(asked.data.args[2] / 2, '\0');
        iovec here{bytes.data(), bytes.size()};
        const iovec there{reinterpret_cast<void*>(asked.data.args[1]), bytes.size()};
        const ssize_t count = ::process_vm_readv(static_cast<pid_t>(asked.pid), &here, 1, &there, 1, 0);
        const Descriptor process(static_cast<int>(::syscall(SYS_pidfd_open, child_, 0)));
        const Descriptor file(
            static_cast<int>(::syscall(SYS_pidfd_getfd, process.get(), static_cast<int>(asked.data.args[0]), 0)));
        if (!file.good() || count != static_cast<ssize_t>(bytes.size())) return 0;
        return placed ? ::pwrite(file.get(), bytes.data(), bytes.size(), static_cast<off_t>(asked.data.args[3]))
                      : ::write(file.get(), bytes.data(), bytes.size());
    }

    std::string folder_;
    pid_t child_;
    int listener_;
    const Judge& judge_;
    Ending& ending_;
    std::map<std::pair<std::string, std::string>, int> seen_;
};

}  // namespace

Ending run_supervised(const std::string& folder, const Launch& launch, const Watch& watch, const Judge& judge) {
    Ending ending;
    int sockets[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) return ending;
    const bool watched = static_cast<bool>(judge);
    const pid_t child = ::fork();
    if (child == 0) become_frana(folder, launch, watched ? &watch : nullptr, sockets[1]);
    const Descriptor ours(sockets[0]);
    ::close(sockets[1]);
    const Descriptor listener(watched ? receive_descriptor(ours.get()) : -1);
    Supervisor supervisor(folder, child, listener.get(), judge, ending);

    const auto begin = Clock::now();
    const double patience = launch.patience_seconds > 0 ? launch.patience_seconds : k_patience_seconds;
    bool told = false;
    int status = 0;
    rusage used{};
    const Descriptor process(static_cast<int>(::syscall(SYS_pidfd_open, child, 0)));
    while (::wait4(child, &status, WNOHANG, &used) == 0) {
        pollfd waiting[]{{process.get(), POLLIN, 0}, {listener.get(), POLLIN, 0}};
        ::poll(waiting, listener.good() ? 2 : 1, 200);
        if ((waiting[1].revents & POLLIN) != 0) supervisor.answer_one();
        const double seconds = seconds_since(begin);
        if (launch.stop_after_seconds > 0 && !told && seconds > launch.stop_after_seconds) {
            told = true;
            ::kill(child, SIGTERM);
        }
        if (seconds > patience + launch.stop_after_seconds && !ending.hung) {
            ending.hung = true;
            ::kill(child, SIGKILL);
        }
    }
    ending.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    ending.peak_memory_bytes = 1024.0 * static_cast<double>(used.ru_maxrss);
    for (const auto& [name, text] : {std::pair{k_out, &ending.out}, {k_err, &ending.err}}) {
        *text = read_text(folder + name);
        ::unlink((folder + name).c_str());
    }
    return ending;
}

bool can_watch_calls() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(watch_own_calls({}) < 0 ? 1 : 0);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace frana::test
