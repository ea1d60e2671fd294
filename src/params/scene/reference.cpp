// SPDX-License-Identifier: Apache-2.0
#include "params/scene/reference.h"

#include "core/json.h"
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
    JsonWriter json;
    json.begin_array();
    for (const Parameter& parameter : scene_parameters()) {
        json.begin_object();
        json.text("name", parameter.name()).text("section", parameter.section).text("key", parameter.key);
        json.text("type", parameter.type).text("unit", parameter.unit);
        const std::string fixed = parameter.default_text();
        if (fixed.empty())
            json.null("default").text("when_absent", parameter.absent);
        else
            json.text("default", fixed);
        json.text("limits", parameter.limits).text("meaning", parameter.meaning);
        json.end_object();
    }
    json.end_array();
    return json.str();
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
