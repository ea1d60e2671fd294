// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/commands/command_line.h"
#include "app/input/share_directory.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/error.h"
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "params/grammar/ini_file.h"
#include "params/keys/materials.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"

namespace frana::app {
namespace {

/// A scene to begin with, and what was found in its files.
struct SceneDraft {
    std::string dtm, perimeter;  ///< as the scene names them
    std::string thickness;       ///< empty: open
    std::string preset;          ///< empty: open
    std::string title;
    std::string cell_size;                       ///< of the DTM [m]; empty: it is not in metres
    std::map<std::string, std::string> columns;  ///< of the perimeter, by the region's key that they look like
    std::vector<std::string> about_dtm, about_crs, about_cells, about_unit, about_perimeter, about_thickness;
};

namespace fs = std::filesystem;

constexpr const char* k_of_preset = "Where given, it replaces that of the preset.";

/// A line of the draft.
struct DraftLine {
    std::string key, value;
    bool commented = false;
    std::vector<std::string> notes{};
};

/// Whether a column's name has one of these words, in lower case.
bool has_word(std::string name, const std::vector<std::string>& words) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return name.find(word) != std::string::npos; });
}

/// Names of columns in which surveyors write a thickness, in the languages of the reports.
bool looks_like_thickness(const std::string& name) {
    return has_word(name, {"thick", "depth", "spess", "profond", "potenza", "epais", "\u00e9pais", "espes", "espesor",
                           "dicke", "tiefe", "m\u00e4cht", "maecht"});
}

/// Columns with what a region asks for, by their names in the languages of the reports; of several the first.
std::map<std::string, std::string> region_columns(const gis::PolygonLayer& layer) {
    std::map<std::string, std::string> found;
    const auto take = [&](const char* key, const std::string& column, const std::vector<std::string>& words) {
        if (has_word(column, words)) found.try_emplace(key, one_line(column));
    };
    for (const Feature& feature : layer.features) {
        for (const auto& [column, value] : feature.numbers) {
            take("return-period", column,
                 {"year", "jahr", "anni", "ann\u00e9e", "annee", "a\u00f1o", "return", "ritorno"});
            take("release.volume", column, {"volum", "m3"});
            take("frequency.rate", column, {"rate", "freq"});
        }
        for (const auto& [column, value] : feature.texts) {
            take("name", column, {"name", "nom"});
            take("scenario", column, {"scenari", "sc\u00e9nario", "szenari", "escenari"});
            take("frequency.rate", column, {"rate", "freq"});
            if (value.find(':') != std::string::npos) take("frequency.volumes", column, {"volum", "m3"});
        }
    }
    return found;
}

/// A question for each column of the perimeter that may be the thickness.
std::vector<std::string> questions(const gis::PolygonLayer& layer) {
    std::map<std::string, std::pair<double, double>> columns;
    for (const Feature& feature : layer.features) {
        for (const auto& [name, value] : feature.numbers) {
            if (!looks_like_thickness(name) || std::isnan(value)) continue;
            const auto [at, added] = columns.try_emplace(name, value, value);
            at->second = {std::min(at->second.first, value), std::max(at->second.second, value)};
        }
    }
    std::vector<std::string> lines;
    for (const auto& [name, range] : columns) {
        lines.push_back("Is the column " + one_line(name) + " (" + number_text(range.first) + " to " +
                        number_text(range.second) +
                        ") the thickness in metres? Then write: thickness = attribute:" + one_line(name));
    }
    return lines;
}

const Parameter& declared(const std::string& key) {
    static const std::vector<Parameter>& k_keys = scene_parameters();
    return *find_parameter(k_keys, key);
}

std::string comment(const std::string& text) {
    constexpr std::size_t k_width = 100;
    std::string lines;
    for (const std::string& line : wrapped(text, k_width)) lines += "# " + line + '\n';
    return lines;
}

/// What a preset says of a key of the material: its value, else what it gives in its place. Empty without a preset.
std::string of_preset(const std::string& name, const std::string& key) {
    if (name.empty()) return "";
    std::string others;
    for (const MaterialPreset& preset : material_presets(materials_directory())) {
        if (preset.name != name) continue;
        for (const IniEntry& entry : preset.entries) {
            if (entry.name == key) return entry.value;
            others += (others.empty() ? "" : ", ") + entry.name.substr(entry.name.find('.') + 1) + " = " + entry.value;
        }
    }
    return "(the preset has " + others + ")";
}

std::string text_of(const DraftLine& line) {
    const Parameter& key = declared(line.key);
    std::string facts = key.meaning;
    if (!key.unit.empty()) facts += " [" + key.unit + "]";
    if (!key.limits.empty()) facts += " Values: " + key.limits + ".";
    std::string text = comment(facts);
    for (const std::string& note : line.notes) text += comment(note);
    const std::string fixed = key.default_text();
    const std::string value =
        line.value.empty() && line.commented ? (fixed.empty() ? "(" + key.absent + ")" : fixed) : line.value;
    return text + (line.commented ? "# " : "") + key.key + " =" + (value.empty() ? "" : " " + value) + '\n';
}

std::string presets() {
    std::string names;
    for (const MaterialPreset& preset : material_presets(materials_directory()))
        names += (names.empty() ? "" : ", ") + preset.name;
    return names;
}

/// Reads the head of the DTM and the perimeter. Throws Error(input) if one cannot be read or they do not overlap.
SceneDraft draft_of(const std::string& dtm, const std::string& perimeter) {
    SceneDraft draft;
    const gis::RasterInfo info = gis::inspect_raster(dtm, "DTM");
    const gis::PolygonLayer layer = gis::read_polygons(perimeter, info.crs_wkt, "PERIMETER");
    const Bounds &map = info.bounds, &box = layer.bounds;
    const bool degrees = !info.crs_wkt.empty() && gis::longitude_turn(info.crs_wkt) > 0;
    if (are_apart(map, box))
        throw Error(ErrorKind::input, Problem{"lies outside the DTM", "PERIMETER", extent_text(box, degrees),
                                              "the DTM's " + extent_text(map, degrees) + ", in " + info.crs_label,
                                              "Check the coordinate reference systems of both files"});
    draft.title = fs::path(dtm.substr(0, dtm.find('|'))).stem().string();
    draft.about_dtm = {"Found: " + info.driver + " of " + grouped(info.columns) + " x " + grouped(info.rows) +
                       " cells, " + extent_text(map, degrees) + "."};
    if (info.crs_wkt.empty())
        draft.about_crs = {"The DTM names no CRS: give it with dtm-crs (for example EPSG:32632)."};
    else if (gis::is_projected_in_metres(info.crs_wkt))
        draft.about_crs = {"The DTM is in " + one_line(info.crs_label) + ", in metres: frana computes in that."};
    else
        draft.about_crs = {"The DTM is in " + one_line(info.crs_label) + ": frana computes in the local UTM zone."};
    if (!degrees && !info.crs_wkt.empty() && gis::is_projected_in_metres(info.crs_wkt))
        draft.cell_size = shortest_text(std::max(info.cell_x, info.cell_y));
    draft.about_cells = {"Those of the DTM: " + shortest_text(info.cell_x) + " x " + shortest_text(info.cell_y) +
                         (degrees                   ? " degrees."
                          : draft.cell_size.empty() ? " of its units."
                                                    : " m.") +
                         " Larger cells are quicker: twice the size takes about an eighth of the time."};
    draft.about_unit = {info.vertical_unit_stated ? "The file says: " + info.vertical_unit + "."
                                                  : "The file does not say: metre is assumed."};
    const auto count = layer.features.size();
    draft.about_perimeter = {"Found: " + std::to_string(count) + (count == 1 ? " polygon" : " polygons") +
                             " in the layer " + one_line(layer.layer_name) + ", in " + one_line(layer.crs_label) +
                             "; on the DTM " + extent_text(box, degrees) + "."};
    draft.about_thickness = questions(layer);
    draft.columns = region_columns(layer);
    return draft;
}

/// Returns the scene file; its comments are the sentences of the declarations.
std::string draft_text(const SceneDraft& draft) {
    std::vector<std::string> thickness = draft.about_thickness;
    if (draft.thickness.empty())
        thickness.insert(thickness.begin(), "To be given: only you know how thick the mass is that fails.");
    std::vector<std::string> preset{"One of " + presets() +
                                    ": starting points, not calibrated values (`frana materials`)."};
    if (draft.preset.empty())
        preset.insert(preset.begin(),
                      "To be given, or a law with its values: only you know what the slope is made of.");
    // What is written of a main key besides its meaning; the others have their default, after #.
    const std::vector<DraftLine> known{
        {"terrain.dtm", draft.dtm, false, draft.about_dtm},
        {"terrain.crs", "", true, draft.about_crs},
        {"terrain.cell-size", draft.cell_size, true, draft.about_cells},
        {"terrain.vertical-unit", "", true, draft.about_unit},
        {"release.perimeter", draft.perimeter, false, draft.about_perimeter},
        {"release.thickness", draft.thickness, false, thickness},
        {"release.dtm-contains-release",
         "on",
         true,
         {"Does the DTM show the slope before it failed? Then remove the # of the next line; without it the mass is "
          "laid on top of the DTM."}},
        {"material.preset", draft.preset, false, preset},
        {"material.friction-angle", of_preset(draft.preset, "material.friction-angle"), true, {k_of_preset}},
        {"material.turbulence", of_preset(draft.preset, "material.turbulence"), true, {k_of_preset}},
        {"material.density", of_preset(draft.preset, "material.density"), true, {k_of_preset}},
        {"time.end", declared("time.end").default_text(), false},
        {"output.title", draft.title, false},
    };
    std::string text =
        "# A scene of frana to begin with. A line after # is not used; `frana params` prints all keys.\n";
    for (const Section& section : scene_sections()) {
        std::string lines;
        for (const Parameter& key : scene_parameters()) {
            if (key.section != section.name || !is_main_key(key.name())) continue;
            const auto line =
                std::find_if(known.begin(), known.end(), [&](const DraftLine& one) { return one.key == key.name(); });
            lines += text_of(line != known.end() ? *line : DraftLine{key.name(), "", true});
        }
        if (!lines.empty()) text += "\n[" + section.name + "]\n" + lines;
    }
    return text;
}

/// What a study of a scene begins with, whose file is named from the study's folder. No preset asks for what finite
/// volumes lack.
std::string study_text(const std::string& scene, const SceneDraft&) {
    return "# A study of frana to begin with: `frana ensemble`, or with [objective] `frana calibrate`.\n\n[study]\n"
           "scene = " +
           scene +
           "\n# Finite volumes are quick, and without flight. Two members are computed again by the default scheme:\n"
           "# where the differences in the report are large, write default.\n"
           "scheme = finite-volume\nsamples = 200\n\n[vary]\n"
           "# To be given: only you know what is uncertain, and how much (share/doc/ensembles.md).\n"
           "# release.volume = triangular(LEAST, LIKELIEST, GREATEST)\n"
           "# material.friction-angle = triangular(LEAST, LIKELIEST, GREATEST)\n"
           "# material.turbulence = log-uniform(LEAST, GREATEST)\n\n"
           "# How often the slope fails, with which volumes [m3] exceeded once in so many years; release.volume leaves "
           "from\n"
           "# [vary] then. Without it every probability is that of a slope that has failed.\n"
           "# [frequency]\n# volumes = 8000: 30, 15000: 100, 35000: 300\n";
}

/// The same of a region; columns that were found stand in it.
std::string region_text(const std::string& scene, const SceneDraft& draft) {
    const auto line = [&](const std::string& key, bool is_used = true) {
        const auto found = draft.columns.find(key);
        const bool is_found = found != draft.columns.end();
        return (is_found && is_used ? "" : "# ") + key + " = " + (is_found ? found->second : "COLUMN") + "\n";
    };
    return "# A region of frana to begin with: `frana batch` runs each polygon of the scene as a slope of its own.\n\n"
           "[region]\nscene = " +
           scene +
           "\nscheme = finite-volume\n"
           "# Columns of the polygons: what each is called; which of several events it is, if each is a polygon.\n" +
           line("name") + line("scenario") + line("return-period", false) +
           "\n# Once for all: the country's scheme, the process whose matrix gives the degree of hazard, the "
           "friction.\n"
           "[set]\n# hazard.scheme = swiss-debris-flow\n# hazard.process = channel-debris-flow\n"
           "# material.friction-table = ngi-avalanche\n\n"
           "# Any key of the scene may come from a column.\n[columns]\n" +
           line("release.volume") +
           "\n# Or every path in every scenario, whose name is its return period (years); also that of the friction.\n"
           "# A path without a value has no such event.\n"
           "# [scenario 30]\n# release.thickness = COLUMN\n# [scenario 100]\n# release.thickness = COLUMN\n\n"
           "# In place of scenarios and release.volume: how often each slope fails, with which volumes\n"
           "# (share/doc/region.md), by columns or the same for all.\n" +
           line("frequency.rate", false) + line("frequency.volumes", false) +
           "# [frequency]\n# volumes = M3: YEARS, M3: YEARS\n\n# [vary]\n"
           "# material.friction-angle = triangular(LEAST, LIKELIEST, GREATEST)\n";
}

/// What can be written beside a scene.
struct Beginning {
    const char *option, *meaning;
    std::string (*text)(const std::string& scene, const SceneDraft& draft);
};
constexpr Beginning k_beginnings[] = {{"study", "also a study of the scene to begin with", study_text},
                                      {"region", "also a region of its polygons to begin with", region_text}};

/// Throws Error(input) for a word that is no preset.
std::string preset_of(const std::string& word) {
    for (const MaterialPreset& preset : material_presets(materials_directory()))
        if (preset.name == word) return word;
    throw Error(ErrorKind::input, Problem{"is not a material preset", "--preset", word, presets(), ""});
}

/// What is still to be given in a draft; empty: nothing.
std::string open_keys(const SceneDraft& draft) {
    std::string keys;
    if (draft.thickness.empty()) keys = "release.thickness";
    if (draft.preset.empty()) keys += std::string(keys.empty() ? "" : " and ") + "material.preset";
    return keys;
}

/// The thickness as the scene will have it: its files relative to the scene's folder. Throws Error(input).
std::string thickness_of(const std::string& text, const fs::path& folder) {
    const std::vector<Parameter>& parameters = scene_parameters();
    const Parameter& key = *find_parameter(parameters, "release.thickness");
    SceneSpec spec;
    if (const auto refusal = key.read(spec, text))
        throw Error(ErrorKind::input,
                    Problem{refusal->what, "--thickness", text, key.limits + " [" + key.unit + "]", refusal->remedy});
    key.map_files(spec, [&](const std::string& file) {
        return relative_path(absolute_path(file, fs::current_path().string()), folder.string());
    });
    return key.write(spec).value_or(text);
}

constexpr const char* k_usage = "frana new DTM PERIMETER [options]";

int cmd_new(const Options& values) {
    const auto files = text_options(values, "operand");
    if (files.size() != 2)
        throw Error(ErrorKind::input, Problem{"needs two files: the DTM and the perimeter of the release",
                                              "command line", "", "", "Usage: " + std::string(k_usage)});
    const fs::path scene = fs::absolute(text_option(values, "out").value_or("scene.ini")).lexically_normal();
    std::vector<std::pair<std::string, std::string>> outputs{{"--out", scene.string()}};
    for (const Beginning& row : k_beginnings)
        if (const auto file = text_option(values, row.option))
            outputs.emplace_back(std::string("--") + row.option, *file);
    std::set<fs::path> all;
    for (const auto& [option, file] : outputs) {
        if (fs::exists(file) && values.count("overwrite") == 0)
            throw Error(ErrorKind::input,
                        Problem{"exists already", option, file, "", "Choose another name, or add --overwrite"});
        if (!all.insert(fs::absolute(file).lexically_normal()).second)
            throw Error(ErrorKind::input,
                        Problem{"is the same file as another", option, file, "", "Choose another name"});
    }
    const fs::path folder = scene.parent_path();
    SceneDraft draft = draft_of(files[0], files[1]);
    draft.dtm = relative_path(absolute_path(files[0], fs::current_path().string()), folder.string());
    draft.perimeter = relative_path(absolute_path(files[1], fs::current_path().string()), folder.string());
    if (const auto preset = text_option(values, "preset")) draft.preset = preset_of(*preset);
    if (const auto thickness = text_option(values, "thickness")) draft.thickness = thickness_of(*thickness, folder);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw Error(ErrorKind::environment, Problem{"the folder cannot be made: " + error.message(), "--out",
                                                    folder.string(), "", "Choose another place"});
    write_text_file(scene.string(), draft_text(draft));
    std::string written = scene.string();
    for (const Beginning& row : k_beginnings)
        if (const auto file = text_option(values, row.option)) {
            write_text_file(*file,
                            row.text(relative_path(scene.string(), fs::absolute(*file).parent_path().string()), draft));
            written += " and " + *file;
        }
    std::cerr << "frana: wrote " << written
              << "\nfrana: next: " << (open_keys(draft).empty() ? "" : "give " + open_keys(draft) + " in it, then ")
              << "frana check " << scene.string() << '\n';
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_new() {
    CommandForm form{k_usage,
                     "Writes a commented scene to begin with: the twenty keys that matter, with what the two files "
                     "contain. It leaves\nthickness and material open unless --thickness and --preset give them.",
                     "DTM PERIMETER",
                     {}};
    form.repeats = true;
    form.options.add_options()("out", one("FILE"), "scene file to write (default: scene.ini)")(
        "thickness", one("METRES"), "of the release: a number, attribute:NAME, raster:FILE, difference:PRE,POST")(
        "preset", one("NAME"), "of the material: one of `frana materials`")("overwrite", "replace an existing file");
    for (const Beginning& row : k_beginnings) form.options.add_options()(row.option, one("FILE"), row.meaning);
    return {"new", "write a commented scene to begin with", form, cmd_new};
}

}  // namespace frana::app
