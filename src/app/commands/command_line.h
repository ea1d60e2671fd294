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
#include "params/grammar/picture_text.h"
#include "params/grammar/value_text.h"

namespace frana::app {

/// One command: the text of `frana COMMAND --help` and the accepted arguments.
struct CommandForm {
    std::string usage;    ///< "frana run SCENE.ini [options]"
    std::string purpose;  ///< one or two sentences
    std::string operand;  ///< name of the one positional argument, "" if there is none
    boost::program_options::options_description options;
    bool repeats = false;  ///< the positional argument may be given more than once
    bool operand_optional = false;
};

/// Meaning of --strict, which run, ensemble, batch and calibrate have.
inline constexpr const char* k_strict_meaning =
    "exit code 3, after everything is written, if a run was cut, left the ground or failed";

// The value of an option. Its name in the help also says what the shell completes: FILE, FOLDER, KEY=VALUE, MAP,
// lower-case words ("2d|3d"); of another name nothing.
inline auto* one(const char* name) {
    return boost::program_options::value<std::string>()->value_name(name);
}
/// The same of an option that may be given more than once.
inline auto* many(const char* name) {
    return boost::program_options::value<std::vector<std::string>>()->value_name(name);
}

/// Reads the arguments of a command. None: help was requested and printed, and nothing else is to be done. Throws
/// Error(input) for anything not in the form, or if the operand is missing.
std::optional<boost::program_options::variables_map> parse_arguments(const CommandForm& form,
                                                                     const std::vector<std::string>& arguments);

/// Returns a text option, if it was given.
std::optional<std::string> text_option(const boost::program_options::variables_map& values, const std::string& name);
/// Returns all texts of an option that may be repeated.
std::vector<std::string> text_options(const boost::program_options::variables_map& values, const std::string& name);
/// Returns --threads: as given (1 to 1024), else the number of processors available to this process. Throws
/// Error(input).
int thread_count(const boost::program_options::variables_map& values);
/// Returns --size WxH. Throws Error(input).
std::optional<Size> size_option(const boost::program_options::variables_map& values);
/// Returns --threshold in metres, greater than 0. Throws Error(input).
std::optional<double> threshold_option(const boost::program_options::variables_map& values);

/// An option of a command as completion and man pages show it.
struct OptionRow {
    std::string name;   ///< "--quiet"
    std::string brief;  ///< "-q"; empty: none
    std::string value;  ///< "FILE"; empty: a flag
    std::string meaning;
};

/// Returns the options of a command, with those of every command.
std::vector<OptionRow> option_rows(const CommandForm& form);

/// Throws Error(input) if the word of a command that takes a result or a raster names a scene.
inline void refuse_scene(const std::string& operand) {
    if (std::filesystem::path(operand).extension() != ".ini" || !std::filesystem::is_regular_file(operand)) return;
    throw Error(ErrorKind::input, Problem{"is a scene, not its result", "RESULT_DIR|RASTER", operand, "",
                                          "Name the folder of the result; `frana run` computes it"});
}

}  // namespace frana::app
