// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_scene.h"

#include <fnmatch.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "params/check/check_scene.h"
#include "params/grammar/data_file.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/laws.h"
#include "params/keys/materials.h"
#include "params/keys/parameter.h"
#include "params/keys/plausible.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"
#include "params/scene/read_friction_table.h"
#include "params/scene/read_scheme.h"

namespace frana {

namespace fs = std::filesystem;

std::vector<NamedFile> named_files(const SceneSpec& scene) {
    std::vector<NamedFile> files;
    SceneSpec copy = scene;
    for (const Parameter& parameter : scene_parameters()) {
        if (!parameter.reads_files()) continue;
        parameter.map_files(copy, [&](const std::string& path) {
            files.push_back({parameter.name(), path});
            return path;
        });
    }
    const FrictionTableSpec& table = scene.friction_table;
    if (table.resolved && !is_own_file(*table.name))
        files.push_back({"material.friction-table", table.resolved->file, true});
    return files;
}

std::vector<std::string> input_files(const SceneSpec& scene) {
    std::vector<std::string> files{scene.file};
    for (const NamedFile& named : named_files(scene)) files.push_back(named.path);
    return files;
}

std::vector<std::string> overridden(std::vector<std::string> all, const std::vector<std::string>& more) {
    std::erase_if(all, [&](const std::string& one) {
        return std::any_of(more.begin(), more.end(), [&](const std::string& other) {
            return one.starts_with(other.substr(0, other.find('=') + 1));
        });
    });
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

namespace {

/// Classes of avalanches on what is too heavy for snow, those of other processes on what is too light for water.
void question_scheme(SceneReading& reading) {
    constexpr double k_heaviest_snow = 700;  // [kg/m3], wet and packed
    const SceneSpec& scene = reading.scene;
    if (!scene.hazard.resolved || scene.origin_of("material.density") == Origin::default_value) return;
    const std::string& name = *scene.hazard.scheme;
    const bool is_snow = scene.material.density <= k_heaviest_snow;
    if ((name.find("avalanche") != std::string::npos) == is_snow || name.ends_with(".ini")) return;
    reading.warnings.push_back(worded("hazard.scheme = {1} does not fit material.density = {2} kg/m3",
                                      {name, numeral(shortest_text(scene.material.density))}));
}

}  // namespace

SceneReading read_scene(const std::string& path, const std::vector<std::string>& overrides, const std::string& share,
                        const std::string& override_label) {
    SceneReading reading;
    reading.label = path;
    reading.override_label = override_label;
    const fs::path absolute = fs::absolute(path).lexically_normal();
    reading.scene.file = absolute.string();
    if (has_control_characters(reading.scene.file)) {
        throw Error(ErrorKind::input,
                    Problem{"the scene's path contains a line break or another control character, "
                            "which the result's own scene file cannot contain",
                            without_control_characters(path), without_control_characters(reading.scene.file), "",
                            "Rename the file or folder"});
    }

    const KeySource file{Origin::scene_file, path, read_ini(path)};
    const KeySource command_line = override_source(overrides, override_label, reading.problems);
    SceneReader reader(reading, absolute.parent_path().string());
    reader.apply_preset(command_line, file, share);
    reader.apply(file);
    reader.apply(command_line);
    reader.drop_unread_of_preset();
    reader.resolve_files(share);
    check_scene(reading.scene, reader.given(), path, reading.problems);
    for (const std::string& name : reader.given()) {
        const Parameter* const key = find_parameter(scene_parameters(), name);
        if (key == nullptr || (key->type != "number" && key->section != "structured")) continue;
        const auto value = number_from_text(key->write(reading.scene).value_or(""));
        if (const auto warning = value ? implausible(name, *value) : std::nullopt) reading.warnings.push_back(*warning);
    }
    question_scheme(reading);
    return reading;
}

namespace {

/// Returns the preset that a scene names, the first source before the second; none: not named.
std::optional<std::pair<std::string, std::string>> preset_of(const KeySource& first, const KeySource& second) {
    for (const KeySource* source : {&first, &second})
        for (const IniEntry& entry : source->entries)
            if (entry.name == "material.preset" && !entry.value.empty())
                return std::pair{entry.value, source->where(entry.name)};
    return std::nullopt;
}

std::optional<KeySource> preset_source(const std::string& name, const Place& where, const std::string& directory,
                                       Problems& problems) {
    const auto file = std::filesystem::path(directory) / (name + ".ini");
    std::error_code ignored;  // a name longer than file systems have
    if (name.find('/') == name.npos && std::filesystem::is_regular_file(file, ignored))
        return KeySource{Origin::preset, file.string(), read_ini(file.string())};
    std::vector<std::string> names;
    for (const MaterialPreset& preset : material_presets(directory)) names.push_back(preset.name);
    problems.add({"is not a material preset", where, name, joined(names, ", "), "`frana materials` prints them"});
    return std::nullopt;
}

}  // namespace

SceneReader::SceneReader(SceneReading& reading, std::string directory)
    : reading_(reading), directory_(std::move(directory)), parameters_(scene_parameters()) {}

namespace {

/// Keys of earlier versions, and what to use.
constexpr std::pair<const char*, const char*> k_gone_keys[] = {
    {"structured.confined-share", "Use structured.confined-fraction"},
    {"structured.softening", "Divide structured.young-modulus and structured.bulk-modulus by it"},
    {"structured.modulus-reduction", "Divide structured.young-modulus and structured.bulk-modulus by it"},
    {"structured.pore-pressure-share", "Use structured.basal-pore-pressure-fraction"},
    {"entrainment.critical-shear", "Use entrainment.critical-shear-stress"},
    {"entrainment.deposition-shear", "Use entrainment.deposition-shear-stress"},
    {"entrainment.potential-depth", "Use entrainment.erosion-depth-per-stress"},
    {"terrain.resampling", "Remove it: the mean on coarser cells, bilinear on finer ones"},
    {"output.map-legend", "Remove it: colours are in classes"},
    {"output.map-organisation", "Write it into output.map-author"},
    {"output.map-background-licence", "Write it into output.map-attribution"},
    {"hazard.*-limits", "Write the limits into a scheme of your own, hazard.scheme = FILE.ini"},
    {"release.perimeter-layer", "Name it in release.perimeter: FILE|layer=NAME"},
    {"observed.perimeter-layer", "Name it in observed.perimeter: FILE|layer=NAME"},
    {"output.names", "Remove it; AvaFrame reads the GeoTIFFs of the result"},
    {"output.view-exaggeration", "Remove it: `frana render --view 3d --exaggeration` draws such a view"},
    {"output.view-background", "Remove it: `frana render --view 3d --plain` draws without a sky"},
    {"output.view-camera", "Remove it: `frana render --view 3d --camera` draws such a view"},
    {"structured.velocity-profile-factor", "Remove it: the velocity's shape is 3"},
    {"structured.placement", "Remove it: particles start on a lattice"},
    {"structured.damage", "Remove it: distortion counts; structured.critical-strain is its limit"},
    {"structured.initial-structured-fraction",
     "Remove it: intact solids are structured; lower structured.confined-fraction"},
    {"structured.yield-check", "Remove it: the total stress yields"},
    {"structured.broken-material", "Remove it: broken material has earth pressure"},
    {"structured.earth-pressure", "Remove it: the load beyond the strength is hydrostatic"},
    {"structured.pic-fraction", "Remove it: solids move by increments of the grid's velocity"},
    {"structured.drag-exponent", "Remove it: the drag is quadratic"},
    {"structured.richardson-zaki*", "Remove it: the exponent is 2.4; structured.grain-diameter sets the drag"},
    {"structured.smoothing-velocity", "Remove it: it is 1 m/s; structured.grain-diameter sets the drag"},
    {"structured.drag-mixing*", "Remove it: structured.grain-diameter sets the drag"},
    {"structured.block-size", "Remove it: blocks are as large as the flow is deep"},
    {"structured.virtual-mass", "Remove it: the law is that of Pudasaini 2012"},
    {"structured.viscosity-growth", "Remove it: it is 10; structured.fluid-viscosity sets the viscosity"},
    {"structured.mobility", "Remove it: it is 1; structured.fluid-viscosity sets the stress"},
    {"structured.solids-profile-factor", "Remove it: it is 2; structured.fluid-viscosity sets the stress"},
    {"entrainment.velocity-ratio", "Remove it: it is 1"},
    {"numerics.gravity", "Remove it: it is 9.81 m/s2"},
    {"numerics.flight-angle", "Remove it: it is 55 degrees"},
    {"numerics.flight-drag", "Remove it: it is 1"},
    {"release.slip-shape", "Remove it: the outline decides"},
    {"release.thickness-crs", "Write the CRS into the raster: gdal_edit.py -a_srs EPSG:..."},
    {"zones.beyond-dtm", "Remove it: the part on the grid is used"},
    {"time.stop-energy-fraction", "Use time.stop-momentum"},
    {"time.stop-moving-fraction", "Use time.stop-momentum"},
    {"time.stop-window", "Remove it: time.stop-change sets how still the flow must be"},
    {"time.moving-speed", "Remove it: it is 0.1 m/s"},
    {"material.yield-ratio", "Remove it: the root is exact"},
    {"material.yield-regularisation", "Remove it: it is 0.01 1/s"},
    {"output.classes*", "Remove it: classes follow the values of the result"}};

}  // namespace

Problem unknown_key(const std::vector<Parameter>& parameters, const std::string& name, const Place& where) {
    for (const auto& [gone, instead] : k_gone_keys)
        if (::fnmatch(gone, name.c_str(), 0) == 0) return {"is no longer a key", where, "", "", instead};
    const std::string nearest = nearest_name(name, names_of(parameters));
    return {"unknown key", where, "", "",
            nearest.empty() ? "`frana params` lists all keys" : "Did you mean " + nearest + "?"};
}

std::optional<Problem> read_value(const Parameter& parameter, const Place& where, const std::string& value,
                                  SceneSpec& scene) {
    if (value.empty()) return Problem{"has no value", where, "", parameter.limits, "Give one or remove the key"};
    const auto refusal = parameter.read(scene, value);
    if (!refusal) return std::nullopt;
    const std::string unit = parameter.unit.empty() || parameter.limits.empty() ? "" : " [" + parameter.unit + "]";
    const std::string remedy =
        refusal->remedy.empty() && !parameter.absent.empty() ? "Without the key: " + parameter.absent : refusal->remedy;
    return Problem{refusal->what, where, value, parameter.limits + unit, remedy};
}

bool has_control_characters(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return (c < 0x20 && c != '\t') || c == 0x7F; });
}

std::string without_control_characters(std::string text) {
    for (char& c : text)
        if (has_control_characters({c})) c = '?';
    return text;
}

void SceneReader::use_present_names(KeySource& source) {
    for (IniEntry& entry : source.entries) {
        const std::string now = present_name(entry.name);
        if (now == entry.name)
            reading_.written.erase(now);
        else
            reading_.written[now] = entry.name;
        entry.name = now;
    }
}

void SceneReader::apply(KeySource source) {
    use_present_names(source);
    static const std::string k_angle = "material.friction-angle", k_coefficient = "material.friction-coefficient";
    if (source.has(k_angle) && source.has(k_coefficient)) {
        reading_.problems.add({"contradicts material.friction-coefficient: both give the bed friction",
                               source.where(k_angle), "", "", "Keep one of the two"});
    }
    // Both keys specify one quantity: a later source replaces the value that an earlier one gave under the other name.
    if (source.has(k_angle)) find_parameter(parameters_, k_coefficient)->reset(reading_.scene);
    if (source.has(k_coefficient)) find_parameter(parameters_, k_angle)->reset(reading_.scene);
    if (source.has("material.friction-table"))
        for (const std::string& name : law_keys())
            if (gives_by_table(name)) forget(name);

    std::set<std::string> seen;
    for (const IniEntry& entry : source.entries) {
        if (!seen.insert(entry.name).second) {
            reading_.problems.add(
                {"is given more than once", source.where(entry.name), entry.value, "", "Keep one of the lines"});
            continue;
        }
        apply(source, entry);
    }
}

void SceneReader::apply(const KeySource& source, const IniEntry& entry) {
    const auto second = reading_.written.find(entry.name);
    const Place where = source.where(second == reading_.written.end() ? entry.name : second->second);
    const Parameter* const parameter = find_parameter(parameters_, entry.name);
    if (parameter == nullptr) {
        reading_.problems.add(unknown_key(parameters_, entry.name, where));
        return;
    }
    given_.insert(entry.name);
    if (source.origin == Origin::preset && parameter->section != "material") {
        reading_.problems.add({"a material preset may set only [material]", where, entry.value, "", "Remove the key"});
        return;
    }
    if (const auto problem = read_value(*parameter, where, entry.value, reading_.scene)) {
        reading_.problems.add(*problem);
        return;
    }
    reading_.scene.origins[entry.name] = source.origin;
    make_paths_absolute(*parameter, where);
}

void SceneReader::drop_unread_of_preset() {
    const std::vector<const Law*> laws = laws_of(reading_.scene);
    for (const std::string& name : law_keys()) {
        if (reading_.scene.origin_of(name) != Origin::preset || !readers_of(name, laws).empty()) continue;
        forget(name);
    }
}

void SceneReader::forget(const std::string& name) {
    find_parameter(parameters_, name)->reset(reading_.scene);
    reading_.scene.origins.erase(name);
    given_.erase(name);
}

void SceneReader::make_paths_absolute(const Parameter& parameter, const Place& where) {
    if (parameter.map_files) {
        parameter.map_files(reading_.scene, [&](const std::string& path) { return absolute_path(path, directory_); });
    }
    const std::string value = parameter.write(reading_.scene).value_or("");
    if (value.find(" #") != std::string::npos || value.find("\t#") != std::string::npos || value.rfind('#', 0) == 0) {
        reading_.problems.add({"contains '#' after a space, which starts a comment in scene files", where, value, "",
                               "Rename the file or folder"});
    }
    if (has_control_characters(value)) {
        reading_.problems.add({"contains a line break or another control character, which a scene file cannot contain",
                               where, without_control_characters(value), "",
                               "Rename the file or folder, or correct the text"});
    }
}

void SceneReader::apply_preset(const KeySource& first, const KeySource& second, const std::string& share) {
    const auto preset = preset_of(first, second);
    if (!preset) return;
    const auto source =
        preset_source(preset->first, preset->second, (fs::path(share) / "materials").string(), reading_.problems);
    if (source) apply(*source);
}

void SceneReader::resolve_files(const std::string& share) {
    HazardSpec& hazard = reading_.scene.hazard;
    hazard.resolved = resolved_scheme(hazard, share, reading_.where("hazard.scheme"), reading_.problems);
    FrictionTableSpec& table = reading_.scene.friction_table;
    table.resolved =
        resolved_friction_table(table, share, reading_.where("material.friction-table"), reading_.problems);
    const std::string density = "material.density";
    if (!table.resolved || !table.resolved->density || reading_.scene.origin_of(density) != Origin::default_value)
        return;
    reading_.scene.material.density = *table.resolved->density;
    reading_.scene.origins[density] = Origin::friction_table;
}

KeySource override_source(const std::vector<std::string>& overrides, const std::string& label, Problems& problems) {
    KeySource source{Origin::command_line, "", {}, label};
    for (const std::string& text : overrides) {
        const auto equals = text.find('=');
        if (equals == std::string::npos) {
            problems.add({"is not section.key=value", "--set " + text, "", "", "Write for example --set time.end=60"});
            continue;
        }
        source.entries.push_back({trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))});
    }
    return source;
}

SceneReading read_scene_keys(const std::vector<std::string>& keys, const std::vector<std::string>& given,
                             const std::string& share, const std::string& label) {
    SceneReading reading;
    reading.label = label;
    const KeySource source = override_source(keys, reading.override_label, reading.problems);
    SceneReader reader(reading, "");
    reader.apply_preset(source, {}, share);
    reader.apply(source);
    reader.drop_unread_of_preset();
    reader.resolve_files(share);
    std::set<std::string> all = reader.given();
    all.insert(given.begin(), given.end());
    check_scene(reading.scene, all, label, reading.problems);
    return reading;
}

std::optional<Problem> problem_of_key(const std::string& name, const std::string& value) {
    const std::vector<Parameter>& parameters = scene_parameters();
    const Parameter* const parameter = find_parameter(parameters, present_name(name));
    if (parameter == nullptr) return unknown_key(parameters, name, name);
    SceneSpec scene;
    return read_value(*parameter, name, value, scene);
}

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

std::string reference_json(Language language) {
    const Words words(language);
    std::map<std::string, std::string> titles;
    for (const Section& section : scene_sections()) titles[section.name] = words(section.title);
    Json keys = Json::array();
    for (const Parameter& parameter : scene_parameters()) {
        Json& key = keys.emplace_back(Json{{"name", parameter.name()},
                                           {"section", parameter.section},
                                           {"key", parameter.key},
                                           {"type", parameter.type},
                                           {"unit", parameter.unit},
                                           {"title", words(title_of(parameter))},
                                           {"section_title", titles[parameter.section]},
                                           {"required", parameter.absent.starts_with("required")}});
        if (!parameter.content.empty()) key["content"] = parameter.content;
        const std::string fixed = parameter.default_text();
        key["default"] = fixed.empty() ? Json() : Json(fixed);
        if (fixed.empty()) key["when_absent"] = language == Language::english ? parameter.absent : "";
        key["limits"] = parameter.limits;
        key["meaning"] = meaning_in(parameter, words);
        key["main"] = is_main_key(parameter.name());
        if (const auto place = place_in_dialogue(parameter.name())) key["place"] = *place;
    }
    return json_text(keys);
}

std::string reference_markdown() {
    std::string text =
        "<!-- SPDX-License-Identifier: Apache-2.0 -->\n<!-- Written by `frana params --markdown`; do not edit. "
        "-->\n# Keys of a scene file\n";
    for (const Section& section : scene_sections()) {
        text += "\n## [" + section.name + "]\n" + section.meaning +
                "\n\n| key | default | allowed | meaning |\n|---|---|---|---|\n";
        for (const Parameter& parameter : scene_parameters()) {
            if (parameter.section != section.name) continue;
            const std::string& allowed = parameter.limits.empty() ? parameter.type : parameter.limits;
            const std::string unit = parameter.unit.empty() ? "" : " [" + parameter.unit + "]";
            text += "| `" + parameter.key + "` | " + cell(default_or_absent(parameter)) + " | " + cell(allowed + unit) +
                    " | " + cell(parameter.meaning) + " |\n";
        }
    }
    return text;
}

}  // namespace frana
