// SPDX-License-Identifier: Apache-2.0
#include "params/scene/write_scene.h"

#include "core/text.h"
#include "core/words/words.h"
#include "params/keys/laws.h"
#include "params/keys/scene_parameters.h"

namespace frana {

std::string describe(Origin origin) {
    switch (origin) {
        case Origin::preset:
            return worded("preset");
        case Origin::friction_table:
            return worded("friction table");
        case Origin::scene_file:
            return worded("scene file");
        case Origin::command_line:
            return worded("command line");
        case Origin::default_value:
            break;
    }
    return worded("default");
}

std::string scene_text(const SceneSpec& scene, const std::map<std::string, std::string>& resolved) {
    std::string text = "# Every parameter of a run, as used; `frana run` on this file repeats the run.\n# Read from " +
                       one_line(scene.file) + "\n";
    std::string section;
    for (const Parameter& parameter : scene_parameters()) {
        const bool by_table = scene.friction_table.name && gives_by_table(parameter.name());
        if (by_table || !model_reads(scene, parameter.name())) continue;
        if (parameter.section != section) {
            section = parameter.section;
            text += "\n[" + section + "]\n";
        }
        text += "# " + parameter.meaning;
        if (!parameter.unit.empty()) text += " [" + parameter.unit + "]";
        text += " From: " + describe(scene.origin_of(parameter.name()));
        const auto chosen = resolved.find(parameter.name());
        if (chosen != resolved.end()) text += "; used: " + one_line(chosen->second);
        text += '\n';
        const auto value = parameter.write(scene);
        text += value && !value->empty() ? parameter.key + " = " + *value + '\n'
                                         : "# " + parameter.key + " = (" + parameter.absent + ")\n";
    }
    return text;
}

}  // namespace frana
