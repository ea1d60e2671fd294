// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/commands/command_line.h"

namespace frana::app {

/// An option of a command as completion and man pages show it.
struct OptionRow {
    std::string name;   ///< "--quiet"
    std::string brief;  ///< "-q"; empty: none
    std::string value;  ///< "FILE"; empty: a flag
    std::string meaning;
    bool repeats = false;
};

/// Returns the options of a command, with those of every command.
std::vector<OptionRow> option_rows(const CommandForm& form);

/// What a shell completes at some place.
struct Completion {
    enum class Kind { nothing, files, folders, scenes, keys, words };
    Kind kind = Kind::nothing;
    std::vector<std::string> words{};
};

/// Returns what completes the value of an option, by its name in the help ("FILE", "2d|3d").
Completion completion_of_value(const std::string& value);
/// The same of the operands of a command.
Completion completion_of_operand(const std::string& command, const std::string& operand);

/// A key after --set with the words or files that complete its value.
struct KeyCompletion {
    std::string key;
    Completion value;
};
/// Returns all keys of a scene, with the names of the material presets.
std::vector<KeyCompletion> key_completions();

}  // namespace frana::app
