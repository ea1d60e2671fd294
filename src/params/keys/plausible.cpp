// SPDX-License-Identifier: Apache-2.0
#include "params/keys/plausible.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/words/number_text.h"
#include "core/words/words.h"
#include "params/grammar/value_text.h"

namespace frana {
namespace {

constexpr double k_any = std::numeric_limits<double>::infinity();
// Marks the readings as an angle of this tangent.
constexpr double k_arc_tangent = 0;
const char* const k_angle = worded("{2} as a coefficient is {1} degrees: use friction-coefficient");
const char* const k_xi = worded("Voellmy's xi is mostly 100 to 4 000 m/s2");
const char* const k_other_unit = worded("if it is in {3}, write {1}");
const char* const k_frictionless = worded("that ground has no friction");

const std::vector<PlausibleRange> k_ranges{
    {"material.friction-angle", 1, k_any, k_angle, k_arc_tangent, true},
    {"zones.friction-angle", 1, k_any, k_angle, k_arc_tangent, true, nullptr, k_frictionless},
    {"zones.friction-coefficient", 0, k_any, nullptr, 1, false, nullptr, k_frictionless},
    {"structured.bed-friction-angle", 1, k_any, k_angle, k_arc_tangent, true},
    {"entrainment.detrainment-coefficient", 1, k_any, "kPa", 1000, true},
    {"zones.detrainment-coefficient", 1, k_any, "kPa", 1000, true},
    {"structured.rain", 0.1, k_any, "m/h", 1000, true},
    {"structured.rain", 1e-3, k_any, "m/s", 3.6e6, true},
    {"structured.soil-conductivity", 0.1, k_any, "cm/s", 36e3, true},
    {"structured.soil-suction", 0, 2, "cm", 0.01, true},
    {"structured.soil-moisture-deficit", 0, 0.9, "%", 0.01, true},
    {"material.density", 50, 3500, "kN/m3", 1000 / 9.81, false, worded("debris has 1 500 to 2 500 kg/m3")},
    {"material.turbulence", 50, 10'000, k_xi},
    {"zones.turbulence", 50, 10'000, k_xi},
    {"material.cohesion", 40, k_any, "kPa", 1000},
    {"zones.cohesion", 40, k_any, "kPa", 1000},
    {"structured.cohesion", 40, k_any, "kPa", 1000},
    {"material.yield-stress", 5, k_any, "kPa", 1000},
    {"material.ramms-yield-stress", 5, k_any, "kPa", 1000},
    {"material.surface-pressure", 0, 50'000, worded("the pressure of the air does not count, write 0")},
    {"material.table-volume", 1000, k_any, "1000 m3", 1000},
    {"entrainment.erodible-depth", 0, 15, "cm", 0.01},
    {"zones.erodible-depth", 0, 15, "cm", 0.01},
    {"release.velocity", 0, 50, "km/h", 1 / 3.6},
    {k_hydrograph_velocity, 0, 30, "km/h", 1 / 3.6},
    {"terrain.obstacle-height", 0, 50, worded("it is a height above the ground, no elevation")},
};

}  // namespace

Sentence PlausibleRange::meant(double value) const {
    const double other = factor == k_arc_tangent ? std::atan(value) * 180 / std::numbers::pi : factor * value;
    const bool is_unit = factor != k_arc_tangent && factor != 1;
    return worded(value == 0 && zero      ? zero
                  : value > most && above ? above
                  : is_unit               ? k_other_unit
                                          : reading,
                  {numeral(number_text(other, 3)), numeral(number_text(value, 4)), is_unit ? reading : ""});
}

const PlausibleRange* plausible_range(const std::string& key) {
    for (const PlausibleRange& range : k_ranges)
        if (key == range.key) return &range;
    return nullptr;
}

const PlausibleRange* range_without(const std::string& key, double value) {
    const PlausibleRange* found = nullptr;
    for (const PlausibleRange& range : k_ranges)  // the widest of a key stands last
        if (key == range.key && !range.has(value)) found = &range;
    return found;
}

std::optional<Sentence> implausible(const std::string& key, double value) {
    const PlausibleRange* const range = range_without(key, value);
    if (range == nullptr) return std::nullopt;
    return worded("{1} = {2} is unusual: {3}", {key, numeral(shortest_text(value)), range->meant(value)});
}

void refuse_implausible(std::vector<Parameter>& parameters) {
    for (const PlausibleRange& range : k_ranges) {
        const auto found = std::find_if(parameters.begin(), parameters.end(),
                                        [&](const Parameter& one) { return one.name() == range.key; });
        if (!range.is_refused || found == parameters.end()) continue;
        Parameter& one = *found;
        if (const std::size_t at = one.limits.find("0 to "); range.least > 0 && at != std::string::npos)
            one.limits.replace(at, 1, "0, or " + shortest_text(range.least));
        one.read = [read = one.read, &range](SceneSpec& scene, const std::string& text) -> std::optional<ValueProblem> {
            const auto value = number_from_text(text);
            if (value && *value > 0 && !range.has(*value))
                return ValueProblem{"is not plausible", range.meant(*value).text()};
            return read(scene, text);
        };
        if (one.fits)
            one.fits = [fits = one.fits, &range](double value) {
                return fits(value) && (value == 0 || range.has(value));
            };
    }
}

}  // namespace frana
