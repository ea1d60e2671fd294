// SPDX-License-Identifier: Apache-2.0
#include "params/scene/write_scene.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "core/text.h"
#include "core/words/words.h"
#include "params/grammar/value_text.h"
#include "params/keys/laws.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

/// A word as in JSON: a number where it reads as one.
Json value_of(const std::string& word) {
    if (const auto whole = integer_from_text(word)) return *whole;
    if (const auto number = number_from_text(word)) return *number;
    return word;
}

/// What one value, or one item of a list, may be.
Json item_schema(const Parameter& parameter) {
    Json kinds = Json::array();
    if (parameter.range) {
        Json number{{"type", parameter.type == "integer" ? "integer" : "number"}};
        constexpr double k_none = std::numeric_limits<double>::max();
        if (parameter.range->lowest > -k_none)
            number[parameter.range->lowest_excluded ? "exclusiveMinimum" : "minimum"] = parameter.range->lowest;
        if (parameter.range->highest < k_none) number["maximum"] = parameter.range->highest;
        kinds.push_back(std::move(number));
        if (parameter.limits.find('%') != std::string::npos)
            kinds.push_back({{"type", "string"}, {"pattern", "^[0-9.]+ ?%$"}});
    }
    if (!parameter.choices.empty()) {
        Json words = Json::array();
        for (const std::string& word : parameter.choices) words.push_back(value_of(word));
        kinds.push_back({{"enum", std::move(words)}});
    }
    if (!parameter.forms.empty()) {
        std::string pattern;
        for (const std::string& form : parameter.forms) pattern += (pattern.empty() ? "^(" : "|") + form;
        kinds.push_back({{"type", "string"}, {"pattern", pattern + ")."}});
    }
    if (kinds.empty()) return {{"type", "string"}, {"minLength", 1}};
    if (kinds.size() == 1) return kinds.front();
    return {{"anyOf", std::move(kinds)}};
}

Json key_schema(const Parameter& parameter) {
    const bool is_list = parameter.type == "list";
    Json schema =
        is_list ? Json{{"type", "array"}, {"minItems", 1}, {"items", item_schema(parameter)}} : item_schema(parameter);
    schema["description"] = parameter.meaning;
    if (!parameter.unit.empty()) schema["unit"] = parameter.unit;
    const std::string fixed = parameter.default_text();
    if (fixed.empty()) {
        if (!parameter.absent.empty()) schema["$comment"] = "where absent: " + parameter.absent;
    } else if (is_list) {
        schema["default"] = Json::array();
        for (const std::string& word : words_of(fixed)) schema["default"].push_back(value_of(word));
    } else {
        schema["default"] = value_of(fixed);
    }
    return schema;
}

}  // namespace

std::string scene_schema() {
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"title", "Scene of frana"},
                {"type", "object"},
                {"properties", Json::object()},
                {"required", Json::array()},
                {"additionalProperties", false}};
    Json& sections = schema["properties"];
    for (const Section& section : scene_sections())
        sections[section.name] = {{"type", "object"},
                                  {"description", section.meaning},
                                  {"properties", Json::object()},
                                  {"additionalProperties", false}};
    for (const Parameter& parameter : scene_parameters()) {
        Json& section = sections[parameter.section];
        section["properties"][parameter.key] = key_schema(parameter);
        if (parameter.absent != "required") continue;
        section["required"].push_back(parameter.key);
        if (schema["required"].empty() || schema["required"].back() != parameter.section)
            schema["required"].push_back(parameter.section);
    }
    for (const FormerName& name : former_names()) {
        const std::string former = name.former, now = name.now;
        const auto dot = former.find('.'), present = now.find('.');
        Json& section = sections[former.substr(0, dot)];
        if (section.is_null()) section = {{"type", "object"}, {"additionalProperties", false}};
        section["properties"][former.substr(dot + 1)] =
            Json(sections[now.substr(0, present)]["properties"][now.substr(present + 1)]);
    }
    return json_text(schema);
}

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
