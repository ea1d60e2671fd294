// SPDX-License-Identifier: Apache-2.0
#include "app/commands/completion.h"

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

using Kind = Completion::Kind;

/// The command that fills COMPREPLY; `word` is completed.
std::string fill(const Completion& completion) {
    switch (completion.kind) {
        case Kind::files:
            return "_frana_files -f";
        case Kind::folders:
            return "_frana_files -d";
        case Kind::scenes:
            return "_frana_scenes";
        case Kind::keys:
            return "_frana_keys";
        case Kind::words:
            return "_frana_words '" + joined(completion.words, " ") + "'";
        case Kind::nothing:
            break;
    }
    return ":";
}

constexpr const char* k_head = R"(# bash completion of frana, written by `frana completion bash`

_frana_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }
_frana_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen "$1" -- "$word")
}
_frana_scenes() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -X '!*.ini' -- "$word"; compgen -d -- "$word")
}
_frana_keys() {
    compopt -o nospace 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -S = -W "$keys" -- "$word")
}
)";

constexpr const char* k_body = R"(
_frana() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} key="" i
    COMPREPLY=()
    # readline parts the words at "=".
    if [[ $word == = ]]; then
        key=$before word=""
    elif [[ $before == = ]]; then
        key=${COMP_WORDS[COMP_CWORD - 2]}
    elif [[ $before == --set && $word == *=* ]]; then
        key=${word%%=*} word=${word#*=}
        _frana_value
        for i in "${!COMPREPLY[@]}"; do COMPREPLY[i]=$key=${COMPREPLY[i]}; done
        return
    fi
    if [[ $key == --* ]]; then
        before=$key
    elif [[ -n $key ]]; then
        _frana_value
        return
    fi
    if ((COMP_CWORD == 1)); then
        _frana_words "$commands --help --version"
        return
    fi
    case "$command $before" in
)";

}  // namespace

std::string bash_completion() {
    std::string keys, values, options, operands, names;
    for (const KeyCompletion& one : key_completions()) {
        keys += (keys.empty() ? "" : " ") + one.key;
        if (one.value.kind != Kind::nothing) values += "        " + one.key + ") " + fill(one.value) + " ;;\n";
    }
    for (const Command& command : commands()) {
        names += (names.empty() ? "" : " ") + std::string(command.name);
        const CommandForm form = command.form();
        std::string words;
        for (const OptionRow& row : option_rows(form)) {
            words += (words.empty() ? "" : " ") + row.name;
            if (row.value.empty()) continue;
            std::string pattern = "\"" + std::string(command.name) + " " + row.name + "\"";
            if (!row.brief.empty()) pattern += " | \"" + std::string(command.name) + " " + row.brief + "\"";
            options += "        " + pattern + ") " + fill(completion_of_value(row.value)) + "; return ;;\n";
        }
        operands += "        " + std::string(command.name) +
                    ")\n            if [[ $word == -* ]]; then _frana_words '" + words + "'\n            else " +
                    fill(completion_of_operand(command.name, form.operand)) + "; fi ;;\n";
    }
    return std::string(k_head) + "_frana_value() {\n    case $key in\n" + values + "    esac\n}\n" + k_body + options +
           "    esac\n    case $command in\n" + operands +
           "        help) _frana_words \"$commands\" ;;\n    esac\n}\n\n"
           "_frana_complete() {\n    local commands='" +
           names + "' keys='" + keys + "'\n    _frana\n}\ncomplete -F _frana_complete frana\n";
}

namespace {

using Kind = Completion::Kind;

/// The action of `_arguments` for a value.
std::string action(const Completion& completion) {
    switch (completion.kind) {
        case Kind::files:
            return "_files";
        case Kind::folders:
            return "_files -/";
        case Kind::scenes:
            return "_files -g \"*.ini\"";
        case Kind::keys:
            return "_frana_set";
        case Kind::words:
            return "(" + joined(completion.words, " ") + ")";
        case Kind::nothing:
            break;
    }
    return " ";
}

/// A text in single quotes for `_arguments`; the characters that would end it are escaped.
std::string escaped(const std::string& text, const std::string& special) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '\'')
            safe += "'\\''";
        else if (special.find(letter) != std::string::npos)
            safe += std::string("\\") + letter;
        else
            safe += letter == '\n' ? ' ' : letter;
    }
    return safe;
}

std::string argument_of(const OptionRow& row) {
    const std::string rest = "[" + escaped(row.meaning, "[]\\") + "]" +
                             (row.value.empty() ? ""
                                                : ":" + escaped(row.value, ":\\") + ":" +
                                                      escaped(action(completion_of_value(row.value)), ""));
    if (row.brief.empty()) return (row.repeats ? "'*" : "'") + row.name + rest + "'";
    return "'(" + row.brief + " " + row.name + ")'{" + row.brief + "," + row.name + "}'" + rest + "'";
}

/// Completes the value of a key after "KEY=".
std::string value_line(const KeyCompletion& key) {
    std::string command;
    switch (key.value.kind) {
        case Kind::words:
            command = "compadd -- " + joined(key.value.words, " ");
            break;
        case Kind::files:
            command = "_files";
            break;
        case Kind::folders:
            command = "_files -/";
            break;
        default:
            return {};
    }
    return "            " + key.key + ") " + command + " ;;\n";
}

}  // namespace

std::string zsh_completion() {
    std::string keys, values, list, cases;
    for (const KeyCompletion& one : key_completions()) {
        keys += " " + one.key;
        values += value_line(one);
    }
    for (const Command& command : commands()) {
        list += "        '" + std::string(command.name) + ":" + escaped(command.summary, ":\\") + "'\n";
        const CommandForm form = command.form();
        cases += "        " + std::string(command.name) + ")\n            _arguments -s";
        for (const OptionRow& row : option_rows(form)) cases += " \\\n                " + argument_of(row);
        if (!form.operand.empty())
            cases += " \\\n                '*:" + escaped(form.operand, ":\\") + ":" +
                     escaped(action(completion_of_operand(command.name, form.operand)), "") + "'";
        cases += "\n            ;;\n";
    }
    return "#compdef frana\n# zsh completion of frana, written by `frana completion zsh`\n\n_frana_set() {\n"
           "    if compset -P '*='; then\n        case ${${IPREFIX%=}#--set=} in\n" +
           values + "        esac\n    else\n        compadd -S = --" + keys +
           "\n    fi\n}\n\n_frana() {\n    local -a list\n    list=(\n" + list +
           "    )\n    if ((CURRENT == 2)); then\n        _describe command list\n        return\n    fi\n"
           "    local command=$words[2]\n    shift words\n    ((CURRENT--))\n    case $command in\n" +
           cases + "        help) _describe command list ;;\n    esac\n}\n\n_frana \"$@\"\n";
}

}  // namespace frana::app
