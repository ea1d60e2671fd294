// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// Exit codes of the program; a stop by a signal adds the signal's number to `signal`.
enum class ExitCode { done = 0, input = 2, numerical = 3, environment = 4, signal = 128 };

using Arguments = std::vector<std::string>;
struct CommandForm;

/// A row of the table from which `frana --help`, the dispatch, the completion of shells and the man pages follow.
struct Command {
    const char* name;
    const char* summary;    ///< one line
    CommandForm (*form)();  ///< its operands and options
    /// Takes the arguments after the name, prints the requested output to stdout and returns the exit code. Throws
    /// Error.
    int (*run)(const Arguments&);
    /// Whether the processes that mpirun started share its work; of other commands the first alone goes on.
    bool uses_ranks = false;
};

/// Every command, in the order of the help.
const std::vector<Command>& commands();
/// Returns the command of this name; null if there is none.
const Command* find_command(const std::string& name);

/// The text of `frana --help`.
std::string help_text();
/// What the exit codes mean, as one paragraph.
inline constexpr const char* k_exit_codes =
    "0 done; 2 usage, wrong configuration or input data; 3 numerical failure; 4 environment (disk,\nrights, graphics); "
    "129, 130, 143 stopped by a signal.";

CommandForm run_form();
int cmd_run(const Arguments& arguments);
CommandForm check_form();
int cmd_check(const Arguments& arguments);
CommandForm render_form();
int cmd_render(const Arguments& arguments);
CommandForm compare_form();
int cmd_compare(const Arguments& arguments);
CommandForm converge_form();
int cmd_converge(const Arguments& arguments);
CommandForm ensemble_form();
int cmd_ensemble(const Arguments& arguments);
CommandForm batch_form();
int cmd_batch(const Arguments& arguments);
CommandForm calibrate_form();
int cmd_calibrate(const Arguments& arguments);
CommandForm bench_form();
int cmd_bench(const Arguments& arguments);
CommandForm new_form();
int cmd_new(const Arguments& arguments);
CommandForm params_form();
int cmd_params(const Arguments& arguments);
CommandForm qgis_plugin_form();
int cmd_qgis_plugin(const Arguments& arguments);
CommandForm materials_form();
int cmd_materials(const Arguments& arguments);
CommandForm complete_form();
int cmd_complete(const Arguments& arguments);
CommandForm man_form();
int cmd_man(const Arguments& arguments);

}  // namespace frana::app
