// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <sstream>

#include "app/commands/command_line.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "core/error.h"
#include "core/text.h"
#include "params/grammar/data_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/materials.h"
#include "params/scene/read_friction_table.h"
#include "params/scene/read_scene.h"
#include "params/scene/read_scheme.h"

namespace frana::app {
namespace {

int cmd_params(const Options& values) {
    if (values.count("ini") + values.count("json") + values.count("markdown") > 1) {
        throw Error(ErrorKind::input, Problem{"more than one format is requested", "command line", "", "",
                                              "Give one of --ini, --json, --markdown"});
    }
    const std::string locale = text_option(values, "language").value_or("en");
    const std::optional<Language> language = language_of_code(locale.substr(0, locale.find_first_of("_.@")));
    if (!language)
        throw Error(ErrorKind::input, Problem{"is not one of the languages", "--language", locale, language_codes(),
                                              "Leave it out for English"});
    std::cout << (values.count("json") > 0       ? reference_json(*language)
                  : values.count("markdown") > 0 ? reference_markdown()
                                                 : reference_ini());
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_params() {
    CommandForm form{"frana params [--ini|--json|--markdown]",
                     "Prints every key of a scene file: type, unit, default, allowed values, meaning.",
                     "",
                     {}};
    form.options.add_options()("ini", "as a scene file to fill in (default)")("json", "for programs")(
        "markdown", "for documents")("language", one("LOCALE"),
                                     ("json: of titles and meanings: " + language_codes() + " (default: en)").c_str());
    return {"params", "every key of a scene file: type, unit, default, range, meaning", form, cmd_params};
}

namespace {

int cmd_materials(const Options&) {
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

}  // namespace

Command command_materials() {
    return {
        "materials", "the material presets",
        CommandForm{
            "frana materials",
            "Prints the material presets (material.preset): the sources of their values, their range, and the values.",
            "",
            {}},
        cmd_materials};
}

namespace {

std::string numbers_text(const std::vector<double>& numbers) {
    std::vector<std::string> texts;
    for (const double number : numbers) texts.push_back(grouped(number));
    return joined(texts, ", ");
}

template <class DataOfFile>
std::string head_text(const DataOfFile& data, const std::string& what, const std::string& unread) {
    return data.name + "\n  " + data.called + "; " + what +
           (data.periods.empty() ? "" : " of " + numbers_text(data.periods) + " years") +
           "\n  Source: " + data.named_source + "\n  " +
           (data.is_source_read() ? "Words read: \"" + data.quote + "\", " + data.read_at : unread) + '\n';
}

std::string text_of(const HazardScheme& scheme) {
    std::string text = head_text(scheme, scheme.has_zones() ? "zones of scenarios" : "intensities of scenarios",
                                 "Customary limits, source not read");
    for (const HazardClass& kind : scheme.classes)
        text += "  " + std::to_string(kind.value) + "  " + kind.label() + '\n';
    std::vector<std::string> processes;
    for (const ProcessMatrix& one : scheme.matrices) processes.push_back(one.process.empty() ? "all" : one.process);
    return text + (processes.empty() ? "" : "  Degree of hazard: " + joined(processes, ", ") + '\n');
}

std::string text_of(const FrictionTable& table) {
    std::string text = head_text(table, "events", "Source not read");
    if (!table.note.empty()) text += "  " + table.note + '\n';
    if (!table.volumes.empty()) text += "  Limits of volume: " + numbers_text(table.volumes) + " m3\n";
    if (!table.altitudes.empty()) text += "  Limits of altitude: " + numbers_text(table.altitudes) + " m\n";
    text += table.forest ? "  Has values for forest\n" : "  No values for forest\n";
    for (std::size_t i = 0; i < table.terrain.size(); ++i) {
        const FrictionTable::Terrain& kind = table.terrain[i];
        text += "  " + std::to_string(i + 1) + "  " + kind.name;
        if (table.terrain.size() > 1)
            text += kind.slope_below ? ": slope below " + shortest_text(*kind.slope_below) + " degrees"
                                     : ": curvature " + shortest_text(kind.curvature) + " 1/m";
        text += '\n';
    }
    return text;
}

/// Prints what `read` finds in files.
template <class Read>
void print_files(const std::vector<std::string>& files, const Read& read) {
    Problems problems;
    std::string text;
    for (const std::string& file : files) {
        const auto data = attempt(problems, [&] { return std::optional(read(file, file, problems)); });
        if (!data) continue;
        text += (text.empty() ? "" : "\n") + text_of(*data) + "  File: " + file + '\n';
    }
    problems.throw_if_any();
    std::cout << folded(text, output_width());
}

int cmd_schemes(const Options& values) {
    const bool friction = values.count("friction") > 0;
    std::vector<std::string> files;
    if (values.count("operand") > 0)
        files = {values["operand"].as<std::string>()};
    else
        files = data_files(share_directory(), friction ? k_friction_folder : k_scheme_folder);
    if (friction)
        print_files(files, read_friction_table);
    else
        print_files(files, read_scheme);
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_schemes() {
    CommandForm form{"frana schemes [FILE.ini] [--friction]",
                     "Prints the hazard schemes (hazard.scheme): their classes with limits, the source, and whether it "
                     "was read; with --friction the friction tables (material.friction-table).\nWith a file of one's "
                     "own: checks and prints that.",
                     "FILE.ini",
                     {}};
    form.operand_optional = true;
    form.options.add_options()("friction", "friction tables in place of hazard schemes");
    return {"schemes", "the hazard schemes with their sources; checks a file of one's own", form, cmd_schemes};
}

}  // namespace frana::app
