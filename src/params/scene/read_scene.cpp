// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_scene.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "params/check/check_scene.h"
#include "params/grammar/absolute_path.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/nearest_name.h"
#include "params/grammar/value_text.h"
#include "params/keys/former_names.h"
#include "params/keys/laws.h"
#include "params/keys/materials.h"
#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

/// Entries of one source; a later source overrides an earlier one.
struct Source {
    Origin origin;
    std::string file;  ///< for messages; empty: overrides
    std::vector<IniEntry> entries;
    std::string label{};  ///< of overrides

    [[nodiscard]] std::string where(const std::string& name) const {
        return file.empty() ? label + name : file + ": " + name;
    }
    [[nodiscard]] bool has(const std::string& name) const {
        return std::any_of(entries.begin(), entries.end(), [&](const IniEntry& e) { return e.name == name; });
    }
};

/// Applies sources to a scene and collects the problems.
class Reader {
  public:
    Reader(SceneReading& reading, std::string directory)
        : reading_(reading), directory_(std::move(directory)), parameters_(scene_parameters()) {}

    void apply(Source source);
    /// Drops values of a preset for laws that the scene does not select.
    void drop_unread_of_preset();
    [[nodiscard]] const std::set<std::string>& given() const { return given_; }

  private:
    void apply(const Source& source, const IniEntry& entry);
    void use_present_names(Source& source);
    void make_paths_absolute(const Parameter& parameter, const std::string& where);

    SceneReading& reading_;
    std::string directory_;
    std::vector<Parameter> parameters_;
    std::set<std::string> given_;  ///< by the preset, the file or the command line, valid or not
};

void Reader::use_present_names(Source& source) {
    for (IniEntry& entry : source.entries) {
        const FormerName* const former = former_name(entry.name);
        if (former == nullptr) {
            reading_.written.erase(entry.name);
            continue;
        }
        if (former->stays)
            reading_.written[former->now] = former->former;
        else
            reading_.warnings.push_back(source.where(entry.name) + " is now called " + former->now +
                                        ": a later version will refuse the former name");
        entry.name = former->now;
    }
}

void Reader::apply(Source source) {
    use_present_names(source);
    static const std::string k_angle = "material.friction-angle", k_coefficient = "material.friction-coefficient";
    if (source.has(k_angle) && source.has(k_coefficient)) {
        reading_.problems.add({"contradicts material.friction-coefficient: both give the bed friction",
                               source.where(k_angle), "", "", "Keep one of the two"});
    }
    // Both keys specify one quantity: a later source replaces the value that an earlier one gave under the other name.
    if (source.has(k_angle)) reading_.scene.material.friction_coefficient.reset();
    if (source.has(k_coefficient)) reading_.scene.material.friction_angle.reset();

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

void Reader::apply(const Source& source, const IniEntry& entry) {
    const auto second = reading_.written.find(entry.name);
    const std::string where = source.where(second == reading_.written.end() ? entry.name : second->second);
    const Parameter* const parameter = find_parameter(parameters_, entry.name);
    if (parameter == nullptr) {
        const std::string nearest = nearest_name(entry.name, names_of(parameters_));
        reading_.problems.add({"unknown key", where, "", "",
                               nearest.empty() ? "`frana params` lists all keys" : "Did you mean " + nearest + "?"});
        return;
    }
    given_.insert(entry.name);
    if (source.origin == Origin::preset && parameter->section != "material") {
        reading_.problems.add({"a material preset may set only [material]", where, entry.value, "", "Remove the key"});
        return;
    }
    if (entry.value.empty()) {
        reading_.problems.add({"has no value", where, "", parameter->limits, "Give one or remove the key"});
        return;
    }
    if (const auto refusal = parameter->read(reading_.scene, entry.value)) {
        const std::string unit =
            parameter->unit.empty() || parameter->limits.empty() ? "" : " [" + parameter->unit + "]";
        reading_.problems.add({refusal->what, where, entry.value, parameter->limits + unit, refusal->remedy});
        return;
    }
    reading_.scene.origins[entry.name] = source.origin;
    make_paths_absolute(*parameter, where);
}

void Reader::drop_unread_of_preset() {
    const std::vector<const Law*> laws = laws_of(reading_.scene);
    for (const std::string& name : law_keys()) {
        if (reading_.scene.origin_of(name) != Origin::preset || !readers_of(name, laws).empty()) continue;
        find_parameter(parameters_, name)->reset(reading_.scene);
        reading_.scene.origins.erase(name);
        given_.erase(name);
    }
}

/// Whether a text contains line breaks and other characters that a line of a scene file cannot contain.
bool has_control_characters(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return (c < 0x20 && c != '\t') || c == 0x7F; });
}

/// Returns the text with every such character replaced by '?'.
std::string shown(std::string text) {
    for (char& c : text)
        if (has_control_characters({c})) c = '?';
    return text;
}

void Reader::make_paths_absolute(const Parameter& parameter, const std::string& where) {
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
                               where, shown(value), "", "Rename the file or folder, or correct the text"});
    }
}

/// Returns the preset that a scene names, the command line first; none: not named.
std::optional<std::pair<std::string, std::string>> preset_of(const Source& file, const Source& command_line) {
    for (const Source* source : {&command_line, &file})
        for (const IniEntry& entry : source->entries)
            if (entry.name == "material.preset" && !entry.value.empty())
                return std::pair{entry.value, source->where(entry.name)};
    return std::nullopt;
}

std::optional<Source> preset_source(const std::string& name, const std::string& where, const std::string& directory,
                                    Problems& problems) {
    std::vector<std::string> names;
    for (const MaterialPreset& preset : material_presets(directory)) {
        if (preset.name == name) return Source{Origin::preset, preset.file, preset.entries};
        names.push_back(preset.name);
    }
    problems.add({"is not a material preset", where, name, joined(names, ", "), "`frana materials` prints them"});
    return std::nullopt;
}

Source command_line_source(const std::vector<std::string>& overrides, const std::string& label, Problems& problems) {
    Source source{Origin::command_line, "", {}, label};
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

}  // namespace

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
    return files;
}

std::vector<std::string> input_files(const SceneSpec& scene) {
    std::vector<std::string> files{scene.file};
    for (const NamedFile& named : named_files(scene)) files.push_back(named.path);
    return files;
}

SceneReading read_scene(const std::string& path, const std::vector<std::string>& overrides,
                        const std::string& materials_directory, const std::string& override_label) {
    SceneReading reading;
    reading.label = path;
    reading.override_label = override_label;
    const fs::path absolute = fs::absolute(path).lexically_normal();
    reading.scene.file = absolute.string();
    if (has_control_characters(reading.scene.file)) {
        throw Error(ErrorKind::input, Problem{"the scene's path contains a line break or another control character, "
                                              "which the result's own scene file cannot contain",
                                              shown(path), shown(reading.scene.file), "", "Rename the file or folder"});
    }

    const Source file{Origin::scene_file, path, read_ini(path)};
    const Source command_line = command_line_source(overrides, override_label, reading.problems);
    Reader reader(reading, absolute.parent_path().string());
    if (const auto preset = preset_of(file, command_line)) {
        const auto source = preset_source(preset->first, preset->second, materials_directory, reading.problems);
        if (source) reader.apply(*source);
    }
    reader.apply(file);
    reader.apply(command_line);
    reader.drop_unread_of_preset();
    check_scene(reading.scene, reader.given(), path, reading.problems);
    return reading;
}

}  // namespace frana
