// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/man_page.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "params/grammar/nearest_name.h"

namespace frana::app {

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
