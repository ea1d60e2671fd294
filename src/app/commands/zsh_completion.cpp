// SPDX-License-Identifier: Apache-2.0
#include "app/commands/commands.h"
#include "app/commands/completion.h"
#include "app/commands/option_rows.h"
#include "params/grammar/value_text.h"

namespace frana::app {
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
