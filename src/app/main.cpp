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
#include "app/commands/library_versions.h"
#include "app/pictures/letter_warning.h"
#include "app/process/machine_memory.h"
#include "app/process/signals.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/system_remedy.h"
#include "gis/access/network.h"
#include "params/grammar/nearest_name.h"

namespace frana::app {
namespace {

constexpr const char* k_help =
    "frana computes the run-out of landslides.\n\nUsage: frana COMMAND [arguments]\n\n  run SCENE.ini            "
    "compute a scene; write rasters, maps, animation, comparison\n  check SCENE.ini          validate a scene or a "
    "study and "
    "print what would run; writes nothing\n  render RESULT_DIR        draw maps, views or an animation of a result\n  "
    "compare RESULT_DIR|RASTER --observed VECTOR\n                           compare a result with a surveyed "
    "outline\n  "
    "params                   every key of a scene file: type, unit, default, range, meaning\n  materials              "
    "  the material presets\n  converge SCENE.ini       the scene at several resolutions: estimated error\n  ensemble "
    "STUDY.ini       many runs with uncertain values: probabilities, sensitivities\n  batch REGION.ini         each "
    "polygon of a layer as a slope of its own: union, scenarios, hazard\n  calibrate STUDY.ini      values "
    "that explain surveyed events, and how uncertain they stay\n  bench "
    "accuracy|stability|speed\n                           tests of frana: errors against exact solutions, hard cases, "
    "throughput\n  bench robustness SCENE.ini\n                           the scene with its grid shifted and rotated, "
    "noise, other particles and time steps\n\n  frana COMMAND --help     more about a command\n  frana --version       "
    "   its version and its libraries'\n  frana COMMAND --allow-network ...\n                           inputs may be "
    "URLs, databases and map services\n\nExit codes: 0 done; 2 usage, wrong configuration or input data; 3 numerical "
    "failure; 4 environment (disk,\nrights, graphics); 129, 130, 143 stopped by a signal.\n";

struct Command {
    const char* name;
    int (*run)(const Arguments&);
};

constexpr Command k_commands[] = {
    {"run", cmd_run},       {"check", cmd_check},         {"render", cmd_render},     {"compare", cmd_compare},
    {"params", cmd_params}, {"materials", cmd_materials}, {"converge", cmd_converge}, {"ensemble", cmd_ensemble},
    {"batch", cmd_batch},   {"calibrate", cmd_calibrate}, {"bench", cmd_bench}};

int dispatch(Arguments words) {
    // Only the user who starts the program can allow it, never a scene.
    if (std::erase(words, "--allow-network") > 0) gis::allow_network();
    const bool quiet = std::any_of(words.begin(), words.end(),
                                   [](const std::string& word) { return word == "--quiet" || word == "-q"; });
    guard_process(gis::network_allowed(), quiet);
    if (words.empty()) {
        std::cerr << k_help;
        return static_cast<int>(ExitCode::input);
    }
    if (words.front() == "help" && words.size() > 1) words = {words[1], "--help"};
    const std::string& name = words.front();
    if (name == "--help" || name == "-h" || name == "help") {
        std::cout << k_help;
        return static_cast<int>(ExitCode::done);
    }
    if (name == "--version") {
        std::cout << k_program << ' ' << k_version << '\n' << library_versions();
        return static_cast<int>(ExitCode::done);
    }
    std::vector<std::string> names;
    for (const Command& command : k_commands) {
        if (name == command.name) {
            const int code = command.run({words.begin() + 1, words.end()});
            if (const std::string warning = letter_warning(); !warning.empty())
                std::cerr << "frana: warning: " << warning << '\n';
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

int report(const Error& error) {
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
    switch (error.kind()) {
        case ErrorKind::numerical:
            return static_cast<int>(ExitCode::numerical);
        case ErrorKind::environment:
            return static_cast<int>(ExitCode::environment);
        case ErrorKind::input:
            break;
    }
    return static_cast<int>(ExitCode::input);
}

}  // namespace
}  // namespace frana::app

int main(int count, char** words) {
    try {
        frana::app::fill_standard_streams();
        frana::app::ignore_file_signals();
        frana::app::map_sparingly();
        const int code = frana::app::dispatch({words + 1, words + count});
        std::cout.flush();
        // An earlier failed write is recorded although the last one succeeded.
        const bool written = std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
        if (!written && !frana::app::nobody_reads_output()) {
            std::cerr << "frana: the output could not be written to stdout\n";
            return static_cast<int>(frana::app::ExitCode::environment);
        }
        return code;
    } catch (const frana::Error& error) {
        return frana::app::report(error);
    } catch (const std::bad_alloc&) {
        const frana::app::MemoryBound bound = frana::app::machine_memory();
        return frana::app::report(
            {frana::ErrorKind::environment,
             frana::Problem{"out of memory", "", "", frana::app::bytes_text(bound.bytes) + ", which " + bound.what,
                            frana::system_remedy(ENOMEM)}});
    } catch (const std::filesystem::filesystem_error& error) {
        // An impossible path is invalid input, whatever it was used for.
        const bool word = error.code() == std::errc::filename_too_long || error.code() == std::errc::invalid_argument;
        return frana::app::report({word ? frana::ErrorKind::input : frana::ErrorKind::environment,
                                   frana::Problem{error.code().message(), error.path1().string(), "", "",
                                                  word ? "" : frana::system_remedy(error.code().value())}});
    } catch (const std::system_error& error) {  // a thread could not be created
        return frana::app::report(
            {frana::ErrorKind::environment,
             frana::Problem{error.code().message(), "the system", "", "", frana::system_remedy(error.code().value())}});
    } catch (const std::exception& error) {
        std::cerr << "frana: " << error.what()
                  << ". If memory, threads or open files run out, allow more (ulimit -a) or use fewer --threads\n";
    }
    return static_cast<int>(frana::app::ExitCode::environment);
}
