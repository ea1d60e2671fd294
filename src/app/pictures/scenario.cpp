// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/scenario.h"

#include "app/text/number_text.h"
#include "core/utf8.h"
#include "params/grammar/value_text.h"

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
    {"material.friction-angle", "friction angle", "\u00B0", nullptr, "zones.friction-angle"},
    {"material.friction-coefficient", "friction coefficient", "", nullptr, "zones.friction-coefficient"},
    {"material.turbulence", "turbulence", " m/s\u00B2", "no turbulence", "zones.turbulence"},
    {"material.yield-stress", "yield stress", " Pa", nullptr, "", true},
    {"material.density", "density", " kg/m\u00B3", nullptr},
};
constexpr Named k_structured[] = {
    {"structured.cohesion", "cohesion", " Pa", nullptr},
    {"structured.internal-friction-angle", "internal friction angle", "\u00B0", nullptr},
    {"structured.bed-friction-angle", "bed friction angle", "\u00B0", nullptr},
    {"structured.grain-density", "grain density", " kg/m\u00B3", nullptr},
    {"structured.solid-fraction", "solid fraction", "", nullptr},
};

std::string what_fails(const ScenarioFacts& facts) {
    constexpr std::size_t k_most = 4, k_longest = 60;  // names; letters
    std::string words = facts.value("release.thickness") || facts.value("release.perimeter") ? "Release" : "Inflow";
    if (!facts.release_names.empty() && facts.release_names.size() <= k_most)
        words += " " + elided(valid_utf8(joined(facts.release_names, ", ")), k_longest);
    return words;
}

template <class Table>
void add_values(const ScenarioFacts& facts, const Table& table, std::vector<std::string>& parts) {
    for (const Named& one : table) {
        const bool varies = *one.by_place != '\0' && facts.value(one.by_place);
        const auto text = facts.value(one.key);
        const auto number = text ? number_from_text(*text) : std::nullopt;
        if (varies || (text && !number))
            parts.push_back(std::string(one.words) + " by place");
        else if (number && !(one.not_if_zero && *number == 0))
            parts.push_back(std::string(one.words) + " " + number_text(*number) + one.unit);
        else if (!text && one.absent != nullptr)
            parts.emplace_back(one.absent);
    }
}

}  // namespace

std::string scenario_words(const ScenarioFacts& facts) {
    const auto model = facts.value("material.model");
    std::vector<std::string> parts;
    if (!model) {
        parts.emplace_back("model unknown");
    } else if (*model == "structured") {
        parts.emplace_back("structured model");
        add_values(facts, k_structured, parts);
    } else {
        parts.push_back("Voellmy-Bingham, scheme " + facts.value("numerics.scheme").value_or("unknown"));
        const std::string laws = facts.value("material.bed-friction").value_or("voellmy");
        if (laws != "voellmy") parts.push_back("bed friction " + laws);
        add_values(facts, k_voellmy_bingham, parts);
    }
    return what_fails(facts) + ": " + grouped(facts.volume) + " m\u00B3; " + joined(parts, ", ") + "; " +
           number_text(facts.simulated_seconds, 3) + " s simulated";
}

}  // namespace frana::app
