// SPDX-License-Identifier: Apache-2.0
#include "params/scene/reference.h"

#include <nlohmann/json.hpp>

#include "core/json.h"
#include "params/keys/main_keys.h"
#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

std::string default_or_absent(const Parameter& parameter) {
    const std::string text = parameter.default_text();
    return text.empty() ? parameter.absent : text;
}

/// '|' would end a cell of a Markdown table.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return escaped;
}

}  // namespace

std::string reference_ini() {
    std::string text;
    for (const Section& section : scene_sections()) {
        if (!text.empty()) text += '\n';
        text += "# " + section.meaning + "\n[" + section.name + "]\n";
        for (const Parameter& parameter : scene_parameters()) {
            if (parameter.section != section.name) continue;
            text += "# " + parameter.meaning + '\n';
            std::string facts = parameter.type;
            if (!parameter.unit.empty()) facts += ", " + parameter.unit;
            if (!parameter.limits.empty()) facts += ": " + parameter.limits;
            text += "#   " + facts + '\n';
            const std::string fixed = parameter.default_text();
            text += "# " + parameter.key + " = ";
            text += fixed.empty() ? '(' + parameter.absent + ')' : fixed;
            text += '\n';
        }
    }
    return text;
}

std::string reference_json() {
    Json keys = Json::array();
    for (const Parameter& parameter : scene_parameters()) {
        Json& key = keys.emplace_back(Json{{"name", parameter.name()},
                                           {"section", parameter.section},
                                           {"key", parameter.key},
                                           {"type", parameter.type},
                                           {"unit", parameter.unit}});
        if (!parameter.content.empty()) key["content"] = parameter.content;
        const std::string fixed = parameter.default_text();
        key["default"] = fixed.empty() ? Json() : Json(fixed);
        if (fixed.empty()) key["when_absent"] = parameter.absent;
        key["limits"] = parameter.limits;
        key["meaning"] = parameter.meaning;
        key["main"] = is_main_key(parameter.name());
    }
    return json_text(keys);
}

std::string reference_markdown() {
    std::string text =
        "<!-- SPDX-License-Identifier: Apache-2.0 -->\n<!-- Written by `frana params --markdown`; do not edit. "
        "-->\n# Keys of a scene file\n";
    for (const Section& section : scene_sections()) {
        text += "\n## [" + section.name + "]\n" + section.meaning +
                "\n\n| key | type | unit | default | allowed | meaning |\n|---|---|---|---|---|---|\n";
        for (const Parameter& parameter : scene_parameters()) {
            if (parameter.section != section.name) continue;
            text += "| `" + parameter.key + "` | " + cell(parameter.type) + " | " + cell(parameter.unit) + " | " +
                    cell(default_or_absent(parameter)) + " | " + cell(parameter.limits) + " | " +
                    cell(parameter.meaning) + " |\n";
        }
    }
    return text;
}

}  // namespace frana
