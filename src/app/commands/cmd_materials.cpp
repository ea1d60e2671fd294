// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <sstream>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/text/text_table.h"
#include "params/keys/materials.h"

namespace frana::app {

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
