// SPDX-License-Identifier: Apache-2.0
#include "app/commands/guarded_process.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>

#include "app/commands/commands.h"
#include "app/study/ranks/job.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "gis/access/network.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

#if defined(__x86_64__)
constexpr unsigned k_machine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned k_machine = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned k_machine = 0;  // no filter available
#endif

/// socket(AF_INET or AF_INET6) fails with "permission denied"; all other calls are unchanged.
void forbid_internet_sockets() {
    if (k_machine == 0) return;
    constexpr auto k_domain = offsetof(seccomp_data, args);  // the low word comes first on both machines
    sock_filter steps[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, k_machine, 0, 5),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_socket, 0, 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, k_domain),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AF_INET, 2, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AF_INET6, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EACCES),
    };
    const sock_fprog program{static_cast<unsigned short>(std::size(steps)), steps};
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
    // Without the flag older kernels slow down the whole process.
    ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program);
}

/// Returns FRANA_READ_SECONDS, or five minutes.
double seconds_to_read() {
    constexpr double k_usual = 300, k_most = 1e6;
    const char* const text = std::getenv("FRANA_READ_SECONDS");
    if (text == nullptr) return k_usual;
    const auto seconds = number_from_text(text);
    if (!seconds || !(*seconds > 0 && *seconds <= k_most))
        throw Error(ErrorKind::input, Problem{"is not a time in seconds", "FRANA_READ_SECONDS", text,
                                              "above 0, up to " + shortest_text(k_most), "Correct or unset it"});
    return *seconds;
}

void print_reading(const std::string& where, double seconds) {
    std::cerr << "frana: reading " + where + ", " + number_text(seconds, 2) + " s so far\n";
}

/// The reading thread cannot be interrupted: the program ends here, before anything was computed.
void end_program(const Problem& problem) {
    std::cerr << "frana: " << describe(problem) << std::endl;
    ::_exit(static_cast<int>(ExitCode::input));
}

}  // namespace

void guard_process(bool network, bool quiet) {
    // SpatiaLite's functions could otherwise read and write files, from a view in a database from others.
    ::unsetenv("SPATIALITE_SECURITY");
    // Ranks exchange messages by such sockets; what opens inputs still refuses the network.
    if (!network && !study::started_as_rank()) forbid_internet_sockets();
    if (!quiet && ::isatty(STDERR_FILENO) == 1) gis::on_slow_reading(print_reading);
    gis::when_time_is_up(seconds_to_read(), end_program);
}

}  // namespace frana::app
