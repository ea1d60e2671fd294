// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <iostream>
#include <sstream>

#include "app/commands/command_line.h"
#include "app/input/share_directory.h"
#include "core/error.h"
#include "params/grammar/data_file.h"
#include "params/keys/materials.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/read_scheme.h"

namespace frana::app {
namespace {

// Both scripts ask `frana complete`, whose first line is "words", and the words follow, each with its meaning after a
// tabulator; or "files", "folders" or "scenes", which the shell lists, "=files" after the "=" of its word.
constexpr const char* k_bash = R"(# bash completion of frana, written by `frana complete bash`

_frana() {
    local word=${COMP_WORDS[COMP_CWORD]} before= kind
    [[ $word == = ]] && word=  # readline parts the words at "="
    mapfile -t COMPREPLY < <("${COMP_WORDS[0]}" complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2> /dev/null | cut -f 1)
    kind=${COMPREPLY[0]}
    COMPREPLY=("${COMPREPLY[@]:1}")
    [[ $kind == =* ]] && before=${word%%=*}= word=${word#*=}
    case $kind in
        *files) mapfile -t COMPREPLY < <(compgen -P "$before" -f -- "$word") ;;
        *folders) mapfile -t COMPREPLY < <(compgen -P "$before" -d -- "$word") ;;
        scenes) mapfile -t COMPREPLY < <(compgen -f -X '!*.ini' -- "$word"; compgen -d -- "$word") ;;
    esac
    [[ $kind != words ]] && compopt -o filenames
    [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace
}
complete -F _frana frana
)";

constexpr const char* k_zsh = R"(#compdef frana
# zsh completion of frana, written by `frana complete zsh`

local -a lines names shown
local line
lines=("${(@f)$(${(Q)words[1]} complete -- "${(@Q)words[2,CURRENT]}" 2> /dev/null)}")
[[ $lines[1] == '='* ]] && compset -P 1 '*='
case $lines[1] in
    *files) _files ;;
    *folders) _files -/ ;;
    scenes) _files -g '*.ini' ;;
    words)
        for line in "${(@)lines[2,-1]}"; do
            names+=("${line%%$'\t'*}")
            shown+=("${line/$'\t'/  -- }")
        done
        if [[ $names[1] == *= ]]; then compadd -S '' -ld shown -a names; else compadd -ld shown -a names; fi
        ;;
esac
)";

/// What may stand at a place of the command line.
struct Fitting {
    struct Word {
        std::string text, meaning{};
    };
    std::vector<Word> words{};
    std::string kind = "words";  ///< or files, folders, scenes, which the shell lists
};

/// The lower-case words at the beginning of each alternative: "bash|zsh", "speed|robustness SCENE.ini".
Fitting literal_words(const std::string& text) {
    Fitting fitting;
    std::istringstream alternatives(text);
    for (std::string one; std::getline(alternatives, one, '|');) {
        const std::string word = one.substr(0, one.find(' '));
        if (!word.empty() && std::none_of(word.begin(), word.end(), [](unsigned char letter) {
                return std::isupper(letter) != 0 || letter == '.';
            }))
            fitting.words.push_back({word});
    }
    return fitting;
}

Fitting command_names() {
    Fitting fitting;
    for (const Command& one : commands()) fitting.words.push_back({one.name, one.summary});
    return fitting;
}

/// @param value its name in the help: FILE, FOLDER, MAP, lower-case words
Fitting option_value(const std::string& value) {
    if (value.starts_with("FILE")) return {{}, "files"};
    if (value == "FOLDER") return {{}, "folders"};
    if (value != "MAP") return literal_words(value);
    Fitting fitting;
    for (const ResultRaster& raster : result_rasters())
        if (!raster.by_value) fitting.words.push_back({raster.name});
    return fitting;
}

Fitting operand_of(const Command& command, const std::string& operand) {
    if (operand == "COMMAND") {
        Fitting fitting = command_names();
        fitting.words.push_back({"scene"});
        return fitting;
    }
    Fitting fitting = literal_words(operand);
    if (fitting.words.empty() && !operand.empty())
        fitting.kind = operand.find(".ini") != std::string::npos && command.run != cmd_render ? "scenes" : "files";
    return fitting;
}

Fitting key_value(const std::string& key) {
    Fitting fitting;
    for (const Parameter& parameter : scene_parameters()) {
        if (parameter.name() != key) continue;
        if (parameter.type == "file" || parameter.type == "folder") fitting.kind = parameter.type + "s";
        for (const std::string& word : parameter.choices) fitting.words.push_back({word});
        for (const std::string& word : parameter.forms) fitting.words.push_back({word});
        for (const auto& [of, folder] :
             {std::pair{"hazard.scheme", k_scheme_folder}, std::pair{"material.friction-table", k_friction_folder}})
            if (key == of)
                for (const std::string& name : data_names(share_directory(), folder)) fitting.words.push_back({name});
        if (key == "hazard.scheme") fitting.words.push_back({k_custom_scheme});
        if (key != "material.preset") continue;
        fitting.words.clear();
        for (const MaterialPreset& preset : material_presets(materials_directory()))
            fitting.words.push_back({preset.name});
    }
    return fitting;
}

/// @param words those of a command with its arguments; the last is to be completed
/// @param begin where in it the part begins that is completed
Fitting fitting_of(const Arguments& words, std::size_t& begin) {
    const std::string& last = words.back();
    Fitting fitting = command_names();
    if (words.size() == 1) {
        fitting.words.insert(fitting.words.end(), {{"--help"}, {"--version"}});
        return fitting;
    }
    const Command* const command = find_command(words.front());
    if (command == nullptr) return words.front() == "help" ? fitting : Fitting{};
    const CommandForm form = command->form();
    std::string name = words[words.size() - 2];
    if (last.starts_with("--") && last.find('=') != std::string::npos) {
        begin = last.find('=') + 1;
        name = last.substr(0, begin - 1);
    }
    const std::vector<OptionRow> rows = option_rows(form);
    const auto option = std::find_if(rows.begin(), rows.end(), [&](const OptionRow& row) {
        return !row.value.empty() && (row.name == name || row.brief == name);
    });
    fitting = {};
    if (option == rows.end() && last.starts_with("-")) {
        for (const OptionRow& row : rows) fitting.words.push_back({row.name, row.meaning});
        return fitting;
    }
    if (option == rows.end()) return operand_of(*command, form.operand);
    if (option->value != "KEY=VALUE") return option_value(option->value);
    if (const auto sign = last.find('=', begin); sign != std::string::npos) {
        const std::string key = last.substr(begin, sign - begin);
        begin = sign + 1;
        return key_value(key);
    }
    for (const Parameter& parameter : scene_parameters())
        fitting.words.push_back({parameter.name() + "=", parameter.meaning});
    return fitting;
}

void print_fitting(const Arguments& parted) {
    if (parted.empty()) return;
    Arguments words;  // readline parts them at "="
    for (std::size_t i = 0; i < parted.size(); ++i) {
        const bool goes_on = i > 0 && (parted[i] == "=" || parted[i - 1] == "=");
        words.push_back(parted[i]);
        if (!goes_on) continue;
        words.pop_back();
        words.back() += parted[i];
    }
    const std::string& last = words.back();
    const std::size_t own = last.size() - (parted.back() == "=" ? 0 : parted.back().size());
    std::size_t begin = 0;
    const Fitting fitting = fitting_of(words, begin);
    std::cout << (fitting.kind != "words" && begin > own ? "=" : "") << fitting.kind << '\n';
    for (const auto& [text, meaning] : fitting.words) {
        const std::string whole = last.substr(0, begin) + text;
        if (whole.starts_with(last)) std::cout << whole.substr(own) << '\t' << one_line(meaning) << '\n';
    }
}

}  // namespace

CommandForm complete_form() {
    return {"frana complete bash|zsh\n       frana complete -- WORD...",
            "Prints the script that completes commands, options, keys after --set, the names of presets and other "
            "values.\nFor this shell only: source <(frana complete bash)\nThe scripts ask the second form what may "
            "stand for the last of the words after `frana`.",
            "bash|zsh",
            {}};
}

int cmd_complete(const Arguments& arguments) {
    if (!arguments.empty() && arguments.front() == "--") {
        print_fitting({arguments.begin() + 1, arguments.end()});
        return static_cast<int>(ExitCode::done);
    }
    const auto values = parse_arguments(complete_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const std::string shell = (*values)["operand"].as<std::string>();
    if (shell != "bash" && shell != "zsh")
        throw Error(ErrorKind::input, Problem{"no completion for this shell", "command line", shell, "bash, zsh", ""});
    std::cout << (shell == "bash" ? k_bash : k_zsh);
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
