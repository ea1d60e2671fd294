// SPDX-License-Identifier: Apache-2.0
#include "app/commands/option_rows.h"

#include <algorithm>
#include <boost/program_options/cmdline.hpp>
#include <cctype>
#include <sstream>

#include "app/commands/commands.h"
#include "app/input/share_directory.h"
#include "params/keys/materials.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {

namespace options = boost::program_options;

namespace {

using Kind = Completion::Kind;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

/// The lower-case words at the beginning of each alternative: "bash|zsh", "speed|robustness SCENE.ini".
std::vector<std::string> literal_words(const std::string& text) {
    std::vector<std::string> words;
    for (const std::string& alternative : split(text, '|')) {
        const std::string word = alternative.substr(0, alternative.find(' '));
        const bool literal = !word.empty() && std::none_of(word.begin(), word.end(), [](unsigned char letter) {
            return std::isupper(letter) != 0 || letter == '.';
        });
        if (literal) words.push_back(word);
    }
    return words;
}

}  // namespace

std::vector<OptionRow> option_rows(const CommandForm& form) {
    std::vector<OptionRow> rows;
    for (const auto& option : form.options.options()) {
        OptionRow row{"--" + option->long_name(), "", "", option->description()};
        const std::string brief = option->canonical_display_name(options::command_line_style::allow_dash_for_short);
        if (brief.size() == 2 && brief.front() == '-') row.brief = brief;
        if (option->semantic()->max_tokens() > 0) {
            row.value = option->semantic()->name();
            // Boost adds the default: "N (=3)".
            row.value = row.value.substr(0, row.value.find(" (="));
            row.repeats = dynamic_cast<const options::typed_value<std::vector<std::string>>*>(
                              option->semantic().get()) != nullptr;
        }
        rows.push_back(std::move(row));
    }
    rows.push_back({"--allow-network", "", "", "inputs may be URLs, databases and map services"});
    rows.push_back({"--help", "-h", "", "print the help of the command"});
    return rows;
}

Completion completion_of_value(const std::string& value) {
    if (value.rfind("FILE", 0) == 0) return {Kind::files};
    if (value == "FOLDER") return {Kind::folders};
    if (value == "KEY=VALUE") return {Kind::keys};
    if (value == "MAP") {
        std::vector<std::string> names;
        for (const ResultRaster& raster : result_rasters())
            if (!raster.by_value) names.push_back(raster.name);
        return {Kind::words, names};
    }
    if (auto words = literal_words(value); !words.empty()) return {Kind::words, std::move(words)};
    return {};
}

Completion completion_of_operand(const std::string& command, const std::string& operand) {
    if (operand.empty()) return {};
    if (operand == "COMMAND") {
        std::vector<std::string> names;
        for (const Command& one : commands()) names.emplace_back(one.name);
        if (command == "man") names.emplace_back("scene");
        return {Kind::words, names};
    }
    if (auto words = literal_words(operand); !words.empty()) return {Kind::words, std::move(words)};
    return {operand.find(".ini") != std::string::npos && command != "render" ? Kind::scenes : Kind::files};
}

std::vector<KeyCompletion> key_completions() {
    std::vector<KeyCompletion> keys;
    for (const Parameter& parameter : scene_parameters()) {
        KeyCompletion key{parameter.name(), {}};
        if (parameter.name() == "material.preset") {
            key.value.kind = Kind::words;
            for (const MaterialPreset& preset : material_presets(materials_directory()))
                key.value.words.push_back(preset.name);
        } else if (parameter.type == "file" || parameter.type == "folder") {
            key.value.kind = parameter.type == "file" ? Kind::files : Kind::folders;
        } else {
            key.value.words = parameter.choices;
            key.value.words.insert(key.value.words.end(), parameter.forms.begin(), parameter.forms.end());
            if (!key.value.words.empty()) key.value.kind = Kind::words;
        }
        keys.push_back(std::move(key));
    }
    return keys;
}

}  // namespace frana::app
