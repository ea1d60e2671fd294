// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "core/words/sentence.h"

namespace frana {

/// What a reader must know before relying on a result: a value, which travels with the result and is made a sentence
/// where it is shown.
struct Warning {
    Warning() = default;
    /// @param text a sentence, a pattern of the catalogues, or a message of another program
    template <class Text>
    Warning(Text text, bool limits = false, std::optional<Point> where = {})
        : words(std::move(text)), limits_use(limits), place(where) {}

    Sentence words;                ///< its kind, which is the pattern, and its numbers
    bool limits_use = false;       ///< changes how a map may be used (cut, a lower bound): it stands on maps, in tags
    std::optional<Point> place{};  ///< map coordinates; none: of the result as a whole

    bool operator==(const Warning& other) const { return words == other.words; }
};
using Warnings = std::vector<Warning>;

template <class Archive>
void serialise(Archive& archive, Warning& warning) {
    bool is_placed = warning.place.has_value();
    archive(warning.words, warning.limits_use, is_placed);
    if (!is_placed) return warning.place.reset();
    if (!warning.place) warning.place.emplace();
    archive(warning.place->x, warning.place->y);
}

inline Warnings& operator+=(Warnings& all, const Warnings& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Returns those that are not known already.
Warnings without(Warnings all, const Warnings& known);
/// Returns those that limit the use of maps.
Warnings limits_of_use(const Warnings& all);
/// Returns their English sentences.
std::vector<std::string> texts_of(const Warnings& all);

}  // namespace frana
