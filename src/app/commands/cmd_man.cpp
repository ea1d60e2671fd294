// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands/command_line.h"
#include "app/text/text_file.h"
#include "app/text/version.h"
#include "core/error.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

/// A manual page in roff.
struct ManPage {
    std::string name;  ///< "frana-run.1"
    std::string text;
};

/// A text of roff: no letter of it is a command.
std::string roff(const std::string& text) {
    std::string safe;
    bool line_begins = true;
    for (const char letter : text) {
        if (line_begins && (letter == '.' || letter == '\'')) safe += "\\&";
        line_begins = letter == '\n';
        if (letter == '\\')
            safe += "\\e";
        else if (letter == '-')
            safe += "\\-";
        else
            safe += letter;
    }
    return safe;
}

std::string bold(const std::string& text) {
    return "\\fB" + roff(text) + "\\fR";
}
std::string italic(const std::string& text) {
    return "\\fI" + roff(text) + "\\fR";
}
std::string head(const std::string& name, int section, const std::string& summary) {
    std::string title;
    for (const char letter : name) title += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return ".TH " + roff(title) + " " + std::to_string(section) + " \"\" \"" + k_program + " " + roff(k_version) +
           "\" \"" + k_program + "\"\n.SH NAME\n" + roff(name + " - " + summary) + "\n";
}
/// An entry with a hanging name.
std::string entry(const std::string& name, const std::string& text) {
    return ".TP\n" + name + "\n" + roff(text) + "\n";
}
std::string synopsis(const std::string& usage) {
    std::istringstream lines(usage);
    std::string text = ".SH SYNOPSIS\n.nf\n";
    for (std::string line; std::getline(lines, line);) text += roff(line.substr(line.find("frana "))) + "\n";
    return text + ".fi\n";
}
const std::string k_status = std::string(".SH EXIT STATUS\n") + roff(k_exit_codes) + "\n";

std::string command_page(const Command& command) {
    const CommandForm form = command.form();
    std::string text = head("frana-" + std::string(command.name), 1, command.summary) + synopsis(form.usage) +
                       ".SH DESCRIPTION\n" + roff(form.purpose) + "\n.SH OPTIONS\n";
    for (const OptionRow& row : option_rows(form)) {
        std::string name = row.brief.empty() ? bold(row.name) : bold(row.brief) + ", " + bold(row.name);
        if (!row.value.empty()) name += " " + italic(row.value);
        text += entry(name, row.meaning);
    }
    return text + k_status + ".SH SEE ALSO\n.BR frana (1),\n.BR frana\\-scene (5)\n";
}

std::string program_page() {
    std::string text =
        head("frana", 1, "run-out of landslides") +
        synopsis("frana COMMAND [arguments]\nfrana COMMAND --help\nfrana --version") +
        ".SH DESCRIPTION\nReads GIS files and a scene, computes how far a landslide flows and how deep and fast, and "
        "writes maps, rasters and tables.\nEvery command has a page of its own.\n.SH COMMANDS\n";
    for (const Command& command : commands()) text += entry(bold(command.name), command.summary);
    text += ".SH OPTIONS\n" + entry(bold("--allow-network"), "inputs may be URLs, databases and map services") +
            entry(bold("--version"), "print the version and those of the libraries") + k_status + ".SH SEE ALSO\n";
    for (const Command& command : commands()) text += ".BR " + roff("frana-" + std::string(command.name)) + " (1),\n";
    return text + ".BR frana\\-scene (5)\n";
}

std::string scene_page() {
    std::string text = head("frana-scene", 5, "every key of a scene file") +
                       ".SH DESCRIPTION\nA scene is an INI file: sections in brackets, lines of key = value, comments "
                       "after #.\nPaths are relative to the file.\n";
    for (const Section& section : scene_sections()) {
        text += ".SH \"[" + roff(section.name) + "]\"\n" + roff(section.meaning) + "\n";
        for (const Parameter& parameter : scene_parameters()) {
            if (parameter.section != section.name) continue;
            std::string facts = parameter.meaning + "\nType: " + parameter.type;
            if (!parameter.unit.empty()) facts += " in " + parameter.unit;
            if (!parameter.limits.empty() && parameter.limits != parameter.type)
                facts += "; values: " + parameter.limits;
            const std::string fixed = parameter.default_text();
            text +=
                entry(bold(parameter.key), facts + ".\nDefault: " + (fixed.empty() ? parameter.absent : fixed) + ".");
        }
    }
    return text + ".SH SEE ALSO\n.BR frana (1)\n";
}

/// Returns every page: frana(1), one per command, frana-scene(5) with every key.
std::vector<ManPage> man_pages() {
    std::vector<ManPage> pages{{"frana.1", program_page()}};
    for (const Command& command : commands())
        pages.push_back({"frana-" + std::string(command.name) + ".1", command_page(command)});
    pages.push_back({"frana-scene.5", scene_page()});
    return pages;
}

}  // namespace

CommandForm man_form() {
    CommandForm form{
        "frana man [COMMAND|scene] [options]",
        "Prints a manual page, for `frana man run | man -l -`: that of frana, of a command, or of the keys "
        "of a scene.",
        "COMMAND",
        {}};
    form.operand_optional = true;
    form.options.add_options()("out", one("FOLDER"), "write all pages into this folder instead");
    return form;
}

int cmd_man(const Arguments& arguments) {
    const auto values = parse_arguments(man_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const auto pages = man_pages();
    if (const auto out = text_option(*values, "out")) {
        std::filesystem::create_directories(*out);
        for (const ManPage& page : pages)
            write_text_file((std::filesystem::path(*out) / page.name).string(), page.text);
        return static_cast<int>(ExitCode::done);
    }
    const std::string wanted = text_option(*values, "operand").value_or("");
    std::vector<std::string> names;
    for (const ManPage& page : pages) {
        const std::string name = page.name.size() > 8 ? page.name.substr(6, page.name.size() - 8) : "";
        names.push_back(name);
        if (name != wanted) continue;
        std::cout << page.text;
        return static_cast<int>(ExitCode::done);
    }
    const std::string nearest = nearest_name(wanted, names);
    throw Error(ErrorKind::input,
                Problem{"has no manual page", "command line", wanted, "",
                        nearest.empty() ? "`frana man` lists the commands" : "Did you mean " + nearest + "?"});
}

}  // namespace frana::app
