// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/value_semantic.hpp>
#include <boost/program_options/variables_map.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/json.h"
#include "params/grammar/value_text.h"

namespace frana::app {

/// Exit codes of the program; a stop by a signal adds the signal's number to `signal`.
enum class ExitCode { done = 0, input = 2, numerical = 3, environment = 4, signal = 128 };

using Arguments = std::vector<std::string>;

/// The options of a command as given, and the words that gave them.
struct Options : boost::program_options::variables_map {
    Arguments words;
};

/// One command: the text of `frana COMMAND --help` and the accepted arguments.
struct CommandForm {
    std::string usage;    ///< "frana run SCENE.ini [options]"
    std::string purpose;  ///< one or two sentences
    std::string operand;  ///< name of the one positional argument, "" if there is none
    boost::program_options::options_description options;
    bool repeats = false;  ///< the positional argument may be given more than once
    bool operand_optional = false;
};

/// A row of the table from which `frana --help` and the dispatch follow; share/package/documents.sh makes completion of
/// shells and manual pages of the help.
struct Command {
    const char* name;
    const char* summary;  ///< one line
    CommandForm form;
    /// Prints the requested output to stdout and returns the exit code. Throws Error.
    int (*run)(const Options& values);
    /// Whether the processes that mpirun started share its work; of other commands the first alone goes on.
    bool uses_ranks = false;
};

Command command_bench();  // of the program frana-bench, too
/// Every command, in the order of the help.
const std::vector<Command>& commands();

/// The text of `frana --help`.
std::string help_text();
/// What the exit codes mean, as one paragraph.
inline constexpr const char* k_exit_codes =
    "0 done; 2 usage, wrong configuration or input data; 3 numerical failure; 4 environment (disk,\nrights, graphics); "
    "129, 130, 143 stopped by a signal.";

/// Meaning of --strict, which run, ensemble, batch and calibrate have.
inline constexpr const char* k_strict_meaning =
    "exit code 3, after everything is written, if a run was cut, left the ground or failed";

/// The value of an option, with its name in the help.
inline auto* one(const char* name) {
    return boost::program_options::value<std::string>()->value_name(name);
}
/// The same of an option that may be given more than once.
inline auto* many(const char* name) {
    return boost::program_options::value<std::vector<std::string>>()->value_name(name);
}

/// Reads the arguments of a command. None: help was requested and printed, and nothing else is to be done. Throws
/// Error(input) for anything not in the form, or if the operand is missing.
std::optional<Options> parse_arguments(const CommandForm& form, const Arguments& arguments);
/// Parses the arguments and runs the command.
int run_command(const Command& command, const Arguments& arguments);

/// Returns a text option, if it was given.
std::optional<std::string> text_option(const Options& values, const std::string& name);
/// Returns all texts of an option that may be repeated.
std::vector<std::string> text_options(const Options& values, const std::string& name);
/// Returns --threads: as given (1 to 1024), else the number of processors available to this process. Throws
/// Error(input).
int thread_count(const Options& values);
/// Returns --size WxH. Throws Error(input).
std::optional<Size> size_option(const Options& values);
/// Returns --threshold in metres, greater than 0. Throws Error(input).
std::optional<double> threshold_option(const Options& values);

/// Throws Error(input) if the word of a command that takes a result or a raster names a scene.
inline void refuse_scene(const std::string& operand) {
    if (std::filesystem::path(operand).extension() != ".ini" || !std::filesystem::is_regular_file(operand)) return;
    throw Error(ErrorKind::input, Problem{"is a scene, not its result", "RESULT_DIR|RASTER", operand, "",
                                          "Name the folder of the result; `frana run` computes it"});
}

// The one document that --json writes to stdout; share/doc/scripts.md explains its members.

/// Returns its beginning: program, version, command, exit_code (0).
Json document_of(const std::string& command);

/// Returns the document of a failed command, with each problem in its parts.
std::string error_document(const Arguments& words, ExitCode code, const std::vector<Problem>& problems);

/// Whether the words of the command line ask for the document.
bool wants_document(const Arguments& words);

void print_document(const Json& document);

}  // namespace frana::app
