// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/session.h"
#include "core/words/sentence.h"
#include "params/grammar/ini_file.h"
#include "params/keys/parameter.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// A scene as far as it could be read, with all its problems.
struct SceneReading {
    SceneSpec scene;
    Session session;
    Problems problems;
    std::vector<Sentence> warnings;  ///< of implausible values
    std::string label;               ///< the scene file as the user named it
    std::string override_label;      ///< before the name of a key that was overridden: "--set "

    /// The DTM is read where the flow comes, however small it is: for many runs, each on a small part of it.
    bool reads_on_demand = false;

    std::map<std::string, std::string> written;  ///< by the key's name: the second name under which it was given

    /// Returns where a key was given, for messages, in the words of the user: "scene.ini: terrain.dtm" or "--set
    /// terrain.dtm".
    [[nodiscard]] Place where(const std::string& name) const {
        const auto second = written.find(name);
        const std::string& key = second == written.end() ? name : second->second;
        return scene.origin_of(name) == Origin::command_line ? Place::given(override_label, key) : Place(label, key);
    }
};

/// Reads a scene: defaults, then the material preset it names, then the file, then `overrides` ("section.key=value", as
/// on the command line). Relative paths are relative to the scene file's folder and become absolute. Every problem is
/// collected: unknown keys (with the nearest known), values, missing keys, contradictions. Throws Error(input) only if
/// the file itself cannot be read as INI.
/// @param share folder with the presets (materials) and the hazard schemes (schemes)
/// @param override_label before the names of overridden keys in messages
SceneReading read_scene(const std::string& path, const std::vector<std::string>& overrides, const std::string& share,
                        const std::string& override_label = "--set ");

/// Returns overrides ("section.key=value") with others in place of those of the same keys.
std::vector<std::string> overridden(std::vector<std::string> all, const std::vector<std::string>& more);

/// Returns the input files of a scene, the scene file first.
std::vector<std::string> input_files(const SceneSpec& scene);
/// A file named by a key.
struct NamedFile {
    std::string key, path;
    bool of_program = false;  ///< in the share folder, by a name without a path
};
/// Returns the files named by keys, in the order of the keys, then a friction table of the share folder; without the
/// scene file itself.
std::vector<NamedFile> named_files(const SceneSpec& scene);

/// Reads a scene without a file: its keys alone, "section.key=value", named in messages as they are. `label` stands for
/// the scene where a key is missing. `given` are keys whose data the caller has in another form.
SceneReading read_scene_keys(const std::vector<std::string>& keys, const std::vector<std::string>& given,
                             const std::string& share, const std::string& label);

/// Returns the problem of one key alone; none: read_scene_keys() takes it.
std::optional<Problem> problem_of_key(const std::string& name, const std::string& value);

/// The reference of all keys, generated from their declarations.
std::string reference_ini();  ///< a scene file with every key commented out at its default
/// An array of objects: name, type, unit, default, limits; titles and meanings in a language; the place in a dialogue.
std::string reference_json(Language language = Language::english);
std::string reference_markdown();  ///< one table per section

/// Entries of one source; a later source overrides an earlier one.
struct KeySource {
    Origin origin;
    std::string file;  ///< for messages; empty: overrides
    std::vector<IniEntry> entries;
    std::string label{};  ///< of overrides

    [[nodiscard]] Place where(const std::string& name) const {
        return file.empty() ? Place::given(label, name) : Place(file, name);
    }
    [[nodiscard]] bool has(const std::string& name) const {
        return std::any_of(entries.begin(), entries.end(), [&](const IniEntry& e) { return e.name == name; });
    }
};

/// Returns the source of overrides, "section.key=value".
KeySource override_source(const std::vector<std::string>& overrides, const std::string& label, Problems& problems);

/// Applies sources to a scene and collects the problems.
class SceneReader {
  public:
    SceneReader(SceneReading& reading, std::string directory);

    void apply(KeySource source);
    /// Applies the preset that a source names, the first before the second.
    void apply_preset(const KeySource& first, const KeySource& second, const std::string& share);
    /// Restores the default of a key.
    void forget(const std::string& name);
    /// Reads the hazard scheme and the friction table that the scene names.
    void resolve_files(const std::string& share);
    /// Drops values of a preset for laws that the scene does not select.
    void drop_unread_of_preset();
    [[nodiscard]] const std::set<std::string>& given() const { return given_; }

  private:
    void apply(const KeySource& source, const IniEntry& entry);
    void use_present_names(KeySource& source);
    void make_paths_absolute(const Parameter& parameter, const Place& where);

    SceneReading& reading_;
    std::string directory_;
    const std::vector<Parameter>& parameters_;
    std::set<std::string> given_;  ///< by the preset, the file or the command line, valid or not
};

/// Returns the problem of a key that does not exist.
Problem unknown_key(const std::vector<Parameter>& parameters, const std::string& name, const Place& where);

/// Stores a value in the scene, or returns why not.
std::optional<Problem> read_value(const Parameter& parameter, const Place& where, const std::string& value,
                                  SceneSpec& scene);

/// Whether a text contains line breaks and other characters that a line of a scene file cannot contain.
bool has_control_characters(const std::string& text);
/// Returns the text with every such character replaced by '?'.
std::string without_control_characters(std::string text);

}  // namespace frana
