// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "core/error.h"
#include "params/scene/reference.h"

namespace frana::app {

int cmd_params(const Arguments& arguments) {
    CommandForm form{"frana params [--ini|--json|--markdown]",
                     "Prints every key of a scene file: type, unit, default, allowed values, meaning.",
                     "",
                     {}};
    form.options.add_options()("ini", "as a scene file to fill in (default)")("json", "for programs")("markdown",
                                                                                                      "for documents");
    const auto values = parse_arguments(form, arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    if (values->count("ini") + values->count("json") + values->count("markdown") > 1) {
        throw Error(ErrorKind::input, Problem{"more than one format is requested", "command line", "", "",
                                              "Give one of --ini, --json, --markdown"});
    }
    std::cout << (values->count("json") > 0       ? reference_json()
                  : values->count("markdown") > 0 ? reference_markdown()
                                                  : reference_ini());
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
