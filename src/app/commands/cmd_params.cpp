// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/command_line.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/text/text_table.h"
#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/materials.h"
#include "params/scene/read_scene.h"
#include "params/scene/read_scheme.h"
#include "params/scene/write_scene.h"

namespace frana::app {

CommandForm params_form() {
    CommandForm form{"frana params [--ini|--json|--markdown|--schema]",
                     "Prints every key of a scene file: type, unit, default, allowed values, meaning.",
                     "",
                     {}};
    form.options.add_options()("ini", "as a scene file to fill in (default)")("json", "for programs")(
        "markdown", "for documents")("schema", "as a JSON Schema of scenes")(
        "language", one("LOCALE"), "json: of titles and meanings (default: English)");
    return form;
}

int cmd_params(const Arguments& arguments) {
    const auto values = parse_arguments(params_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    if (values->count("ini") + values->count("json") + values->count("markdown") + values->count("schema") > 1) {
        throw Error(ErrorKind::input, Problem{"more than one format is requested", "command line", "", "",
                                              "Give one of --ini, --json, --markdown, --schema"});
    }
    const Language language = language_of_locale(text_option(*values, "language").value_or(""));
    std::cout << (values->count("json") > 0       ? reference_json(language)
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

CommandForm schemes_form() {
    CommandForm form{"frana schemes [FILE.ini] [--json]",
                     "Prints the hazard schemes (hazard.scheme): their classes with limits, the source, and whether it "
                     "was read.\nWith a file of one's own: checks and prints that.",
                     "FILE.ini",
                     {}};
    form.operand_optional = true;
    form.options.add_options()("json", "print one JSON document for scripts instead (share/doc/scripts.md)");
    return form;
}

namespace {

Json scheme_json(const HazardScheme& scheme) {
    Json json{{"name", scheme.name},
              {"title", scheme.called},
              {"classes_are", scheme.has_zones() ? "zones" : "intensities"},
              {"source", scheme.named_source},
              {"source_read", scheme.is_source_read()},
              {"quote", scheme.is_source_read() ? Json(scheme.quote) : Json()},
              {"read_at", scheme.is_source_read() ? Json(scheme.read_at) : Json()},
              {"return_periods", scheme.periods},
              {"degree_of_hazard", scheme.matrix.has_value()},
              {"classes", Json::array()}};
    for (const HazardClass& kind : scheme.classes)
        json["classes"].push_back({{"class", kind.value},
                                   {"label", kind.name},
                                   {"thresholds", kind.thresholds},
                                   {"colour", hex(kind.colour)}});
    return json;
}

std::string scheme_text(const HazardScheme& scheme) {
    std::ostringstream text;
    text << scheme.name << "\n  " << scheme.called << "; " << (scheme.has_zones() ? "zones" : "intensities")
         << " of scenarios";
    std::vector<std::string> periods;
    for (const double period : scheme.periods) periods.push_back(shortest_text(period));
    if (!periods.empty()) text << " of " << joined(periods, ", ") << " years";
    text << "\n  Source: " << scheme.named_source << '\n';
    if (!scheme.is_source_read())
        text << "  Customary limits, source not read\n";
    else
        text << "  Words read: \"" << scheme.quote << "\", " << scheme.read_at << '\n';
    for (const HazardClass& kind : scheme.classes) text << "  " << kind.value << "  " << kind.label() << '\n';
    return text.str();
}

}  // namespace

int cmd_schemes(const Arguments& arguments) {
    const auto values = parse_arguments(schemes_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const std::vector<std::string> files = values->count("operand") > 0
                                               ? std::vector{(*values)["operand"].as<std::string>()}
                                               : scheme_files(share_directory());
    Problems problems;
    Json json = Json::array();
    std::string text;
    for (const std::string& file : files) {
        const auto scheme = attempt(problems, [&] { return std::optional(read_scheme(file, file, problems)); });
        if (!scheme) continue;
        json.push_back(scheme_json(*scheme));
        text += (text.empty() ? "" : "\n") + scheme_text(*scheme);
    }
    problems.throw_if_any();
    if (values->count("json") == 0) {
        std::cout << folded(text, output_width());
    } else {
        Json document = document_of("schemes");
        document["schemes"] = std::move(json);
        print_document(document);
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
