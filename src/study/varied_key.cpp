// SPDX-License-Identifier: Apache-2.0
#include "study/varied_key.h"

#include <cmath>
#include <set>

#include "core/shortest_text.h"
#include "study/distribution_text.h"

namespace frana::study {
namespace {

constexpr const char* k_error_key = "terrain.error";

/// Whether a distribution of numbers makes sense for it.
bool is_number(const Parameter& key) {
    return key.type == "number" || key.fits || key.name() == "release.thickness";
}

std::string bound_text(double bound) {
    return std::isfinite(bound) ? shortest_text(bound) : bound < 0 ? "minus infinity" : "infinity";
}

/// A cut off or bounded distribution must lie in the range; of an unbounded one the values drawn are checked.
std::optional<ValueProblem> support_refusal(const Parameter& key, const Distribution& distribution) {
    const Support support = support_of(distribution);
    SceneSpec scene;
    for (const double bound : {support.low, support.high}) {
        if (!std::isfinite(bound) || (distribution.law == Law::log_normal && bound == 0)) continue;
        if (!key.read(scene, shortest_text(bound))) continue;
        return ValueProblem{"reaches from " + bound_text(support.low) + " to " + bound_text(support.high) +
                                ", beyond the key's range (" + key.limits + ")",
                            "Choose a distribution inside the range"};
    }
    return std::nullopt;
}

}  // namespace

std::optional<ValueProblem> refusal_to_vary(const Parameter& key) {
    static const std::set<std::string> k_grid{"terrain.cell-size", "terrain.crs", "terrain.bounds"};
    const std::string name = key.name();
    if (k_grid.count(name) > 0)
        return ValueProblem{"cannot vary: all members need the same cells, or their maps could not be combined",
                            "Set it in the scene"};
    if (key.section == "output" || key.section == "observed" || key.section == "hazard" || key.section == "scene")
        return ValueProblem{"cannot vary: it does not change the flow, only what is written of it",
                            "Set it in the scene"};
    if (name == "numerics.accuracy" || name == "time.frame-interval")
        return ValueProblem{"cannot vary: members are computed on the scene's own cells and write no frames",
                            "Remove it"};
    return std::nullopt;
}

std::optional<ValueProblem> refusal_of(const Parameter& key, const Distribution& distribution) {
    SceneSpec scene;
    const bool is_field = distribution.law == Law::gaussian_field;
    if (is_field != (key.name() == k_error_key))
        return ValueProblem{is_field ? "is a field of error, which only terrain.error has"
                                     : "is not a field: terrain.error = gaussian-field(sd, range)",
                            ""};
    if (is_field) {
        const std::string field =
            shortest_text(distribution.numbers[0]) + ", " + shortest_text(distribution.numbers[1]) + ", 0";
        return key.read(scene, field);
    }
    if (distribution.law != Law::choice) {
        if (!is_number(key))
            return ValueProblem{"is a distribution of numbers, and the key is " +
                                    std::string(key.type == "integer" ? "a whole number" : "no number"),
                                "Write choice(value: weight, ...)"};
        return support_refusal(key, distribution);
    }
    for (const std::string& value : distribution.values) {
        const auto refusal = key.read(scene, value);
        if (refusal) return ValueProblem{"has the value " + value + ", which " + refusal->what, refusal->remedy};
    }
    return std::nullopt;
}

}  // namespace frana::study
