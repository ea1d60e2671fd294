// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/text.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// Returns the present name of a key of a scene: [scar] is [observed].
[[nodiscard]] std::string present_name(const std::string& name);

/// The reason why a text is invalid; the reader adds file and key.
struct ValueProblem {
    std::string what;    ///< "is not a number"
    std::string remedy;  ///< what to write instead; may be empty
};

/// Maps a path to another.
using FileMap = std::function<std::string(const std::string&)>;

/// One key of a file, as a member of what is read from it: of a scene, in scene_parameters.cpp, of a study, a region or
/// a calibration in `src/study`. Declared once; the parser, --set, `frana params`, the echo and every message about the
/// key are generated from it.
template <class Spec>
struct ParameterOf {
    std::string section;
    std::string key;
    std::string type;    ///< "number", "integer", "on | off", "choice", "file", "folder", "text", "list"
    std::string unit;    ///< empty: none
    std::string limits;  ///< allowed values, for messages
    std::vector<std::string> choices{};  ///< words that are accepted, of a list: for each item
    std::optional<NumberRange> range{};  ///< of a number that is accepted, of a list: of each item
    std::string absent;                  ///< the effect if the key is not given and has no fixed default
    std::string meaning;                 ///< one sentence
    std::string called{};                ///< in the report; empty: as in scene files
    std::string content;  ///< of a file: "raster", "polygons", "lines", "points", "lines or points", "raster or
                          ///< polygons", "table"
    std::function<std::optional<ValueProblem>(Spec&, const std::string&)> read;
    std::function<std::optional<std::string>(const Spec&)> write;  ///< none: not given
    std::function<void(Spec&)> reset;                              ///< restores the default
    std::function<bool(double)> fits;  ///< whether a number is within the limits; empty: not a numeric key
    std::function<void(Spec&, const FileMap&)> map_files;  ///< calls the map for each path in the value; empty:
                                                           ///< none

    bool decides_map = false;  ///< its default decides a number on the map: told where a user left it alone

    /// Whether it can name files that are read.
    [[nodiscard]] bool reads_files() const { return map_files && type != "folder"; }

    [[nodiscard]] std::string name() const { return section + "." + key; }
    /// Returns the default as text; empty if there is no fixed one (see `absent`).
    [[nodiscard]] std::string default_text() const { return write(Spec{}).value_or(""); }
};

/// A key of a scene file.
using Parameter = ParameterOf<SceneSpec>;

/// Returns the parameter "section.key"; null if there is none.
template <class Spec>
const ParameterOf<Spec>* find_parameter(const std::vector<ParameterOf<Spec>>& parameters, const std::string& name) {
    for (const ParameterOf<Spec>& one : parameters)
        if (one.name() == name) return &one;
    return nullptr;
}

/// Returns "section.key" of every parameter.
template <class Spec>
std::vector<std::string> names_of(const std::vector<ParameterOf<Spec>>& parameters) {
    std::vector<std::string> names;
    for (const ParameterOf<Spec>& one : parameters) names.push_back(one.name());
    return names;
}

}  // namespace frana
