// SPDX-License-Identifier: Apache-2.0
#include "app/commands/run_program.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <boost/version.hpp>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <string>
#include <system_error>

#include "app/commands/command_line.h"
#include "app/pictures/map_source.h"
#include "app/process/machine_memory.h"
#include "app/process/terminal.h"
#include "app/study/ranks/job.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
#include "params/grammar/value_text.h"
#include "render/canvas/page.h"

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

/// Protects the process beyond the filters of gis, for libraries that do not use GDAL: environment variables that would
/// allow a file to do more than contain data are cleared, and unless the network is allowed the kernel refuses this
/// process sockets to other machines (where supported; otherwise silently without).
/// A file that needs too long to be read ends the program. Must be called before any thread starts.
void guard_process(bool network) {
    // SpatiaLite's functions could otherwise read and write files, from a view in a database from others.
    ::unsetenv("SPATIALITE_SECURITY");
    // Ranks exchange messages by such sockets; what opens inputs still refuses the network.
    if (!network && !study::started_as_rank()) forbid_internet_sockets();
    gis::limit_reading(static_cast<unsigned>(std::ceil(seconds_to_read())));
}

}  // namespace

std::string library_versions() {
    const std::string boost = std::to_string(BOOST_VERSION / 100000) + "." +
                              std::to_string(BOOST_VERSION / 100 % 1000) + "." + std::to_string(BOOST_VERSION % 100);
    return gis::library_versions() + render::library_versions() + "Boost " + boost + "\nbuilt with " + FRANA_COMPILER +
           "\n";
}

namespace {

// Whether standard output is a pipe whose reader has ended, as `head` does when it has its lines.
bool nobody_reads_output() {
    pollfd output{STDOUT_FILENO, POLLOUT, 0};
    return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

int report(const Error& error, const Arguments& words) {
    const auto& problems = error.problems();
    if (problems.size() == 1) {
        std::cerr << "frana: " << describe(problems.front()) << '\n';
    } else {
        std::cerr << "frana: " << problems.size() << " problems:\n";
        // One per feature: with ten thousand, the first, which are as informative, would scroll off the screen.
        constexpr std::size_t k_printed = 50;
        for (std::size_t i = 0; i < std::min(problems.size(), k_printed); ++i)
            std::cerr << "  - " << describe(problems[i]) << '\n';
        if (problems.size() > k_printed) std::cerr << "  - and " << problems.size() - k_printed << " more\n";
    }
    const ExitCode code = error.kind() == ErrorKind::numerical     ? ExitCode::numerical
                          : error.kind() == ErrorKind::environment ? ExitCode::environment
                                                                   : ExitCode::input;
    if (wants_document(words)) std::cout << error_document(words, code, problems) << std::flush;
    return static_cast<int>(code);
}

}  // namespace

int run_program(const Arguments& arguments, int (*run)(Arguments)) {
    try {
        fill_standard_streams();
        ignore_file_signals();
        map_sparingly();
        Arguments words = arguments;
        // Only the user who starts the program can allow it, never a scene.
        const bool network = std::erase(words, "--allow-network") > 0;
        guard_process(network);
        if (network) gis::allow_network();
        const int code = run(std::move(words));
        if (const auto warning = letter_warning()) std::cerr << "frana: warning: " << warning->text() << '\n';
        std::cout.flush();
        // An earlier failed write is recorded although the last one succeeded.
        const bool written = std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
        if (!written && !nobody_reads_output()) {
            std::cerr << "frana: the output could not be written to stdout\n";
            return static_cast<int>(ExitCode::environment);
        }
        return code;
    } catch (const Error& error) {
        return report(error, arguments);
    } catch (const std::bad_alloc&) {
        const MemoryBound bound = machine_memory();
        return report(
            {ErrorKind::environment, Problem{"out of memory", "", "", bytes_text(bound.bytes) + ", which " + bound.what,
                                             system_remedy(ENOMEM)}},
            arguments);
    } catch (const std::filesystem::filesystem_error& error) {
        // An impossible path is invalid input, whatever it was used for.
        const bool word = error.code() == std::errc::filename_too_long || error.code() == std::errc::invalid_argument;
        return report({word ? ErrorKind::input : ErrorKind::environment,
                       Problem{error.code().message(), error.path1().string(), "", "",
                               word ? "" : system_remedy(error.code().value())}},
                      arguments);
    } catch (const std::system_error& error) {  // a thread could not be created
        return report({ErrorKind::environment,
                       Problem{error.code().message(), "the system", "", "", system_remedy(error.code().value())}},
                      arguments);
    } catch (const std::exception& error) {
        return report(
            {ErrorKind::environment,
             Problem{error.what(), "", "", "",
                     "If memory, threads or open files run out, allow more (ulimit -a) or use fewer --threads"}},
            arguments);
    }
}

}  // namespace frana::app
