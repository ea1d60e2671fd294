// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/text.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// A key that had another name in earlier versions. Scenes may still use that name, with a warning unless it stays.
struct FormerName {
    const char* former;
    const char* now;
    bool stays = false;  ///< a second name that will not be refused
};

/// In the order of the reference; CHANGELOG.md contains the table of those that do not stay (a test compares).
[[nodiscard]] const std::vector<FormerName>& former_names();

/// Returns the entry of a name; null if it is no former name.
[[nodiscard]] const FormerName* former_name(const std::string& name);

/// Returns the present name of a key; `name` itself if it is no former name.
[[nodiscard]] std::string present_name(const std::string& name);

/// The reason why a text is invalid; the reader adds file and key.
struct ValueProblem {
    std::string what;    ///< "is not a number"
    std::string remedy;  ///< what to write instead; may be empty
};

/// Maps a path to another.
using FileMap = std::function<std::string(const std::string&)>;

/// Limits of a number.
struct NumberRange {
    double lowest = 0;
    double highest = 0;
    bool lowest_excluded = false;

    [[nodiscard]] bool has(double value) const {
        return (lowest_excluded ? value > lowest : value >= lowest) && value <= highest;
    }
    [[nodiscard]] std::string text() const {
        return (lowest_excluded ? "greater than " : "") + shortest_text(lowest) +
               (lowest_excluded ? ", at most " : " to ") + shortest_text(highest);
    }
};

/// One key of a scene file. Declared once, in scene_parameters.cpp; the parser, --set, `frana params`, the echo and
/// every message about the key are generated from it.
struct Parameter {
    std::string section;
    std::string key;
    std::string type;    ///< "number", "integer", "on | off", "choice", "file", "folder", "text", "list"
    std::string unit;    ///< empty: none
    std::string limits;  ///< allowed values, for messages
    std::vector<std::string> choices{};  ///< words that are accepted, of a list: for each item
    std::vector<std::string> forms{};    ///< beginnings of other texts that are accepted: "attribute:"
    std::optional<NumberRange> range{};  ///< of a number that is accepted, of a list: of each item
    std::string absent;                  ///< the effect if the key is not given and has no fixed default
    std::string meaning;                 ///< one sentence
    std::string content;  ///< of a file: "raster", "polygons", "lines", "points", "lines or points", "raster or
                          ///< polygons", "table"
    std::function<std::optional<ValueProblem>(SceneSpec&, const std::string&)> read;
    std::function<std::optional<std::string>(const SceneSpec&)> write;  ///< none: not given
    std::function<void(SceneSpec&)> reset;                              ///< restores the default
    std::function<bool(double)> fits;  ///< whether a number is within the limits; empty: not a numeric key
    std::function<void(SceneSpec&, const FileMap&)> map_files;  ///< calls the map for each path in the value; empty:
                                                                ///< none

    bool is_on_map = false;  ///< its file's features must lie on the working grid, also where frana selects that

    /// Whether it can name files that are read.
    [[nodiscard]] bool reads_files() const { return map_files && type != "folder"; }

    [[nodiscard]] std::string name() const { return section + "." + key; }
    /// Returns the default as text; empty if there is no fixed one (see `absent`).
    [[nodiscard]] std::string default_text() const { return write(SceneSpec{}).value_or(""); }
};

}  // namespace frana
