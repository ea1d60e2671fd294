// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/raster.h"

namespace frana {

inline constexpr double k_water_density = 1000;  ///< rho_w [kg/m3]

/// What may slide off an infinite slope, on a plane parallel to the ground.
struct SlopeLayer {
    double cohesion = 0;        ///< c [Pa]
    double friction_angle = 0;  ///< phi [degrees]
    double thickness = 0;       ///< d, vertical [m]
    double saturation = 0;      ///< m: height of the water table, which is parallel to the ground, over the thickness
    double density = 0;         ///< rho, with its water [kg/m3]
};

/// Returns the factor of safety of an infinite slope (Skempton and DeLory 1957), resisting over driving stress:
///
///     F = (c + max(0, rho - m rho_w) g d cos^2(s) tan(phi)) / (rho g d sin(s) cos(s))
///
/// The pore pressure is that of seepage along the slope. Infinite on level ground; 0 without any strength; NaN where a
/// value is, without thickness, and without strength on level ground.
/// @param slope_deg s [degrees], 0 to 90
double factor_of_safety(const SlopeLayer& layer, double slope_deg);

/// Ground on which masses may start, as screenings of avalanches limit it.
struct StartingGround {
    double least_slope = 0, greatest_slope = 90;  ///< [degrees], both included
    double greatest_convexity = 1;                ///< across the slope [1/m]; 1: hardly any ground has that
};

struct SlopeScreening {
    Raster starts;  ///< 1 where a mass may start, else 0
    Raster factor;  ///< of safety, at most k_most_factor; NaN where slope or layer has no value
};
inline constexpr double k_most_factor = 10;

/// Returns cells within the limits whose factor of safety is less than 1. Slopes are those of the eight neighbours
/// (slope_deg()), none at the edge; convexity is minus the curvature of ground_shape() over about 20 m.
SlopeScreening screen_slopes(const Raster& terrain, const StartingGround& limits,
                             const std::function<SlopeLayer(std::size_t cell)>& layer_at);

}  // namespace frana
