// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "core/error.h"
#include "params/scene/scene_reader.h"
#include "params/scene/write_scene.h"

namespace frana::app {

CommandForm params_form() {
    CommandForm form{"frana params [--ini|--json|--markdown|--schema]",
                     "Prints every key of a scene file: type, unit, default, allowed values, meaning.",
                     "",
                     {}};
    form.options.add_options()("ini", "as a scene file to fill in (default)")("json", "for programs")(
        "markdown", "for documents")("schema", "as a JSON Schema of scenes");
    return form;
}

int cmd_params(const Arguments& arguments) {
    const auto values = parse_arguments(params_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    if (values->count("ini") + values->count("json") + values->count("markdown") + values->count("schema") > 1) {
        throw Error(ErrorKind::input, Problem{"more than one format is requested", "command line", "", "",
                                              "Give one of --ini, --json, --markdown, --schema"});
    }
    std::cout << (values->count("json") > 0       ? reference_json()
                  : values->count("schema") > 0   ? scene_schema()
                  : values->count("markdown") > 0 ? reference_markdown()
                                                  : reference_ini());
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
