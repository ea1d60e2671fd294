// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <string>
#include <vector>

#include "app/commands/command_line.h"
#include "app/commands/run_program.h"
#include "app/process/terminal.h"
#include "app/study/ranks/job.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/error.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

int dispatch(Arguments words) {
    if (words.empty()) {
        std::cerr << help_text();
        return static_cast<int>(ExitCode::input);
    }
    if (words.front() == "help" && words.size() > 1) words = {words[1], "--help"};
    const std::string& name = words.front();
    if (name == "--help" || name == "-h" || name == "help") {
        std::cout << folded(help_text(), output_width());
        return static_cast<int>(ExitCode::done);
    }
    if (name == "--version") {
        std::cout << k_program << ' ' << k_version << '\n' << library_versions();
        return static_cast<int>(ExitCode::done);
    }
    if (name == "complete" || name == "completion" || name == "man")
        throw Error(ErrorKind::input, Problem{"is no longer a command", "command line", name, "",
                                              "Completion of the shell and manual pages are installed with frana; "
                                              "`frana COMMAND --help` prints the same"});
    std::vector<std::string> names;
    for (const Command& command : commands()) {
        if (name == command.name) {
            if (const study::StartedRank own = study::started_rank(); !command.uses_ranks && own.size > 1) {
                std::cerr << "frana: warning: " << name << " does not share its work between processes: rank "
                          << own.rank << " of " << own.size
                          << (own.rank > 0 ? " does nothing\n" : " continues alone\n");
                if (own.rank > 0) return static_cast<int>(ExitCode::done);
            }
            return run_command(command, {words.begin() + 1, words.end()});
        }
        names.emplace_back(command.name);
    }
    const std::string nearest = nearest_name(name, names);
    throw Error(ErrorKind::input,
                Problem{"unknown command", "command line", name, "",
                        nearest.empty() ? "`frana --help` lists the commands" : "Did you mean " + nearest + "?"});
}

}  // namespace
}  // namespace frana::app

int main(int count, char** arguments) {
    return frana::app::run_program({arguments + 1, arguments + count}, frana::app::dispatch);
}
