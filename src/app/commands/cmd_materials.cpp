// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/input/share_directory.h"
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
    bool first = true;
    for (const MaterialPreset& preset : material_presets(materials_directory())) {
        if (!first) std::cout << '\n';
        first = false;
        std::cout
            << preset.name << '\n'
            << "  A starting point, not a calibrated value: fit it to a known event of the same kind and place.\n";
        for (const std::string& line : preset.comments) std::cout << "  # " << line << '\n';
        for (const IniEntry& entry : preset.entries) std::cout << "  " << entry.name << " = " << entry.value << '\n';
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
