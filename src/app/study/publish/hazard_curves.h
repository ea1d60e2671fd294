// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/fragility.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"

namespace frana::app::study {

/// How often a value is exceeded.
struct HazardPoint {
    double value = 0;                      ///< in the quantity's unit
    double rate = 0;                       ///< events a year
    double low = 0, high = 0, median = 0;  ///< its fractiles of 5, 95 and 50 %
};

/// A quantity of hazard curves, whose title and unit are those of a raster.
struct CurveQuantity {
    Quantity quantity;
    const char *key, *raster;
};
inline constexpr CurveQuantity k_curve_quantities[] = {
    {Quantity::depth, "max_depth_m", RasterName::max_depth},
    {Quantity::velocity, "max_velocity_ms", RasterName::max_velocity},
    {Quantity::pressure, "max_pressure_kpa", RasterName::max_pressure},
    {Quantity::momentum, "max_momentum_flux_m3s2", RasterName::max_momentum_flux}};

/// The hazard curve of a place.
struct HazardCurve {
    std::string kind, place;  ///< "gauge" or "object"; its name, or number where it has none
    CurveQuantity quantity{};
    std::vector<HazardPoint> points;  ///< values rise, from 0 to the first that no run exceeds
};

/// Returns the curves of the scene's gauges and, if wanted, exposed objects on the map, of depth, speed and, where it
/// is mapped, pressure. Empty without a frequency. Of an object the greatest value in its cells counts. Fractiles never
/// rise with the value; in the upper one runs count that were cut, left or failed.
std::vector<HazardCurve> hazard_curves(const StudyInput& input, const StudyResult& result, bool with_objects);

/// How often the value at a place exceeds a threshold, of all finished members: the fractiles are those of a gamma
/// distribution with the mean and the standard deviation of AnnualRates. Where none exceeds it the upper one is the
/// margin. It is at least that of all runs if every open one exceeds it.
/// @param values of finished members  @param runs values of all runs
HazardPoint hazard_point(const StudyResult& result, std::span<const float> values, std::span<const float> runs,
                         double threshold);

/// Returns the mean damage by an event, in the interval of 95 %, or with a frequency that of a year, between fractiles
/// of 5 and 95 % as of a hazard_point(). @param damages by finished member, from 0 to `most`  @param runs of all runs
Damage mean_damage(const StudyResult& result, std::span<const double> damages, std::span<const double> runs,
                   double most);

/// Returns disaggregation.csv: by place, quantity and threshold the sources with their part of the rate, and the means
/// of the volume and of the keys that vary, of the events that exceed it. Empty if nothing does.
std::string disaggregation_csv(const StudyInput& input, const StudyResult& result);

/// Returns hazard_curves.csv.
std::string hazard_curves_csv(const std::vector<HazardCurve>& curves);

}  // namespace frana::app::study
