// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/scenario.h"

#include <cmath>
#include <limits>

#include "app/text/number_text.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_spec.h"

namespace frana::app {
namespace {

/// A value named in the line.
struct Named {
    const char* key;
    const char* words;
    const char* unit;
    const char* absent;         ///< in its place; null: nothing
    const char* by_place = "";  ///< key of values that replace it by place
    bool not_if_zero = false;
};

constexpr Named k_voellmy_bingham[] = {
    {"material.friction-angle", worded("friction angle"), "\u00B0", nullptr, "zones.friction-angle"},
    {"material.friction-coefficient", worded("friction coefficient"), "", nullptr, "zones.friction-coefficient"},
    {"material.turbulence", worded("turbulence"), " m/s\u00B2", worded("no turbulence"), "zones.turbulence"},
    {"material.yield-stress", worded("yield stress"), " Pa", nullptr, "", true},
    {"material.density", worded("density"), " kg/m\u00B3", nullptr},
};
constexpr Named k_structured[] = {
    {"structured.cohesion", worded("cohesion"), " Pa", nullptr},
    {"structured.internal-friction-angle", worded("internal friction angle"), "\u00B0", nullptr},
    {"structured.bed-friction-angle", worded("bed friction angle"), "\u00B0", nullptr},
    {"structured.grain-density", worded("grain density"), " kg/m\u00B3", nullptr},
    {"structured.solid-fraction", worded("solid fraction"), "", nullptr},
};

/// In groups of three digits where it has more than three, as the volume before it.
std::string value_text(double value) {
    return std::abs(value) < 1000 ? number_text(value) : grouped(value);
}

std::string what_fails(const ScenarioFacts& facts, const Words& words) {
    constexpr std::size_t k_most = 4, k_longest = 60;  // names; letters
    const bool released = facts.value("release.thickness") || facts.value("release.perimeter");
    std::string text = released ? words("Release") : words("Inflow");
    if (!facts.release_names.empty() && facts.release_names.size() <= k_most)
        text += " " + elided(valid_utf8(joined(facts.release_names, ", ")), k_longest);
    return text;
}

template <class Table>
void add_values(const ScenarioFacts& facts, const Table& table, const Words& words, std::vector<std::string>& parts) {
    for (const Named& one : table) {
        const bool varies = *one.by_place != '\0' && facts.value(one.by_place);
        const auto text = facts.value(one.key);
        constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
        const double number = text ? number_from_text(*text).value_or(k_none) : k_none;
        if (varies || (text && std::isnan(number)))
            parts.push_back(words("{1} by place", {words(one.words)}));
        else if (text && !(one.not_if_zero && number == 0))
            parts.push_back(words(one.words) + " " + words.number(value_text(number)) + one.unit);
        else if (!text && one.absent != nullptr)
            parts.push_back(words(one.absent));
    }
}

}  // namespace

std::string voellmy_bingham_words(const std::string& scheme, const Words& words) {
    return scheme.empty() || scheme == word_of(Numerics{}.scheme, k_schemes)
               ? "Voellmy-Bingham"
               : words("Voellmy-Bingham, scheme {1}", {scheme});
}

std::string scenario_words(const ScenarioFacts& facts, const Words& words) {
    const auto model = facts.value("material.model");
    std::vector<std::string> parts;
    if (!model) {
        parts.push_back(words("Model unknown"));
    } else if (*model == "structured") {
        parts.push_back(words("Structured model"));
        add_values(facts, k_structured, words, parts);
    } else {
        parts.push_back(voellmy_bingham_words(facts.value("numerics.scheme").value_or(""), words));
        const std::string laws = facts.value("material.bed-friction").value_or("voellmy");
        if (laws != "voellmy") parts.push_back(words("bed friction {1}", {laws}));
        add_values(facts, k_voellmy_bingham, words, parts);
    }
    const std::string line =
        words.labelled(what_fails(facts, words), words.number(grouped(facts.volume)) + " m\u00B3; ") +
        joined(parts, ", ");
    if (facts.end) return line + ". " + end_sentence(*facts.end, words);
    return words("{1}, {2} s simulated", {line, words.number(number_text(facts.simulated_seconds, 3))});
}

}  // namespace frana::app
