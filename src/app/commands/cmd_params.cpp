// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <sstream>

#include "app/commands/command_line.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/text/text_table.h"
#include "core/error.h"
#include "params/keys/materials.h"
#include "params/scene/read_scene.h"
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

CommandForm materials_form() {
    return {"frana materials",
            "Prints the material presets (material.preset): the sources of their values, their range, and the values.",
            "",
            {}};
}

int cmd_materials(const Arguments& arguments) {
    if (!parse_arguments(materials_form(), arguments)) return static_cast<int>(ExitCode::done);
    std::ostringstream text;
    for (const MaterialPreset& preset : material_presets(materials_directory())) {
        if (text.tellp() > 0) text << '\n';
        text << preset.name << '\n'
             << "  A starting point, not a calibrated value: fit it to a known event of the same kind and place.\n";
        for (const std::string& line : preset.comments) text << "  # " << line << '\n';
        for (const IniEntry& entry : preset.entries) text << "  " << entry.name << " = " << entry.value << '\n';
    }
    std::cout << folded(text.str(), output_width());
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
