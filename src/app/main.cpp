// SPDX-License-Identifier: Apache-2.0
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
#include <vector>

#include "app/commands/commands.h"
#include "app/commands/guarded_process.h"
#include "app/commands/json_output.h"
#include "app/commands/library_versions.h"
#include "app/pictures/map_source.h"
#include "app/process/machine_memory.h"
#include "app/process/signals.h"
#include "app/process/terminal.h"
#include "app/study/ranks/job.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/error.h"
#include "gis/access/network.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

int dispatch(Arguments words) {
    // Only the user who starts the program can allow it, never a scene.
    if (std::erase(words, "--allow-network") > 0) gis::allow_network();
    const bool quiet = std::any_of(words.begin(), words.end(),
                                   [](const std::string& word) { return word == "--quiet" || word == "-q"; });
    guard_process(gis::network_allowed(), quiet);
    if (words.empty()) {
        std::cerr << help_text();
        return static_cast<int>(ExitCode::input);
    }
    if (words.front() == "help" && words.size() > 1) words = {words[1], "--help"};
    if (words.front() == "completion") words.front() = "complete";  // as users' start files may still call it
    const std::string& name = words.front();
    if (name == "--help" || name == "-h" || name == "help") {
        std::cout << folded(help_text(), output_width());
        return static_cast<int>(ExitCode::done);
    }
    if (name == "--version") {
        std::cout << k_program << ' ' << k_version << '\n' << library_versions();
        return static_cast<int>(ExitCode::done);
    }
    std::vector<std::string> names;
    for (const Command& command : commands()) {
        if (name == command.name) {
            if (const study::StartedRank own = study::started_rank(); !command.uses_ranks && own.size > 1) {
                std::cerr << "frana: warning: " << name << " does not share its work between processes: rank "
                          << own.rank << " of " << own.size << (own.rank > 0 ? " does nothing\n" : " goes on alone\n");
                if (own.rank > 0) return static_cast<int>(ExitCode::done);
            }
            const int code = command.run({words.begin() + 1, words.end()});
            if (const auto warning = letter_warning()) std::cerr << "frana: warning: " << warning->text() << '\n';
            return code;
        }
        names.emplace_back(command.name);
    }
    const std::string nearest = nearest_name(name, names);
    throw Error(ErrorKind::input,
                Problem{"unknown command", "command line", name, "",
                        nearest.empty() ? "`frana --help` lists the commands" : "Did you mean " + nearest + "?"});
}

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
}  // namespace frana::app

int main(int count, char** arguments) {
    const frana::app::Arguments words(arguments + 1, arguments + count);
    try {
        frana::app::fill_standard_streams();
        frana::app::ignore_file_signals();
        frana::app::map_sparingly();
        const int code = frana::app::dispatch(words);
        std::cout.flush();
        // An earlier failed write is recorded although the last one succeeded.
        const bool written = std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
        if (!written && !frana::app::nobody_reads_output()) {
            std::cerr << "frana: the output could not be written to stdout\n";
            return static_cast<int>(frana::app::ExitCode::environment);
        }
        return code;
    } catch (const frana::Error& error) {
        return frana::app::report(error, words);
    } catch (const std::bad_alloc&) {
        const frana::app::MemoryBound bound = frana::app::machine_memory();
        return frana::app::report(
            {frana::ErrorKind::environment,
             frana::Problem{"out of memory", "", "", frana::app::bytes_text(bound.bytes) + ", which " + bound.what,
                            frana::system_remedy(ENOMEM)}},
            words);
    } catch (const std::filesystem::filesystem_error& error) {
        // An impossible path is invalid input, whatever it was used for.
        const bool word = error.code() == std::errc::filename_too_long || error.code() == std::errc::invalid_argument;
        return frana::app::report({word ? frana::ErrorKind::input : frana::ErrorKind::environment,
                                   frana::Problem{error.code().message(), error.path1().string(), "", "",
                                                  word ? "" : frana::system_remedy(error.code().value())}},
                                  words);
    } catch (const std::system_error& error) {  // a thread could not be created
        return frana::app::report(
            {frana::ErrorKind::environment,
             frana::Problem{error.code().message(), "the system", "", "", frana::system_remedy(error.code().value())}},
            words);
    } catch (const std::exception& error) {
        return frana::app::report(
            {frana::ErrorKind::environment,
             frana::Problem{error.what(), "", "", "",
                            "If memory, threads or open files run out, allow more (ulimit -a) or use fewer --threads"}},
            words);
    }
}
