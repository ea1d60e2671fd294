// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"

namespace frana::app::study {

/// How often a value is exceeded.
struct HazardPoint {
    double value = 0;          ///< in the quantity's unit
    double rate = 0;           ///< events a year
    double low = 0, high = 0;  ///< its fractiles of 5 and 95 %
};

/// A quantity of hazard curves, whose title and unit are those of a raster.
struct HazardQuantity {
    Quantity quantity;
    const char *key, *raster;
};
inline constexpr HazardQuantity k_hazard_quantities[] = {
    {Quantity::depth, "max_depth_m", RasterName::max_depth},
    {Quantity::velocity, "max_velocity_ms", RasterName::max_velocity},
    {Quantity::pressure, "max_pressure_kpa", RasterName::max_pressure}};

/// The hazard curve of a place.
struct HazardCurve {
    std::string kind, place;  ///< "gauge" or "object"; its name, or number where it has none
    HazardQuantity quantity{};
    std::vector<HazardPoint> points;  ///< values rise, from 0 to the first that no run exceeds
};

/// Returns the curves of the scene's gauges and, if wanted, exposed objects on the map, of depth, speed and, where it
/// is mapped, pressure. Empty without a frequency. Of an object the greatest value in its cells counts.
///
/// The rate r (gamma, see FrequencySpec) times the probability p, whose standard error is e: mean r p, variance
/// (r e)^2 + s^2 (p^2 + e^2); the fractiles are those of a gamma distribution with these. Where no run exceeds a value
/// the upper one is that of r times the margin of a probability of 0. Runs that were cut, left or failed count in it;
/// it never rises with the value.
std::vector<HazardCurve> hazard_curves(const StudyInput& input, const StudyResult& result, bool with_objects);

/// Returns hazard_curves.csv.
std::string hazard_curves_csv(const std::vector<HazardCurve>& curves);

}  // namespace frana::app::study
