// SPDX-License-Identifier: Apache-2.0
#include "app/commands/run_program.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include "app/commands/guarded_process.h"
#include "app/commands/json_output.h"
#include "app/pictures/map_source.h"
#include "app/process/machine_memory.h"
#include "app/process/signals.h"
#include "app/process/terminal.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "gis/access/gdal_session.h"

namespace frana::app {
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
        const bool quiet = std::any_of(words.begin(), words.end(),
                                       [](const std::string& word) { return word == "--quiet" || word == "-q"; });
        guard_process(network, quiet);
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
