// SPDX-License-Identifier: Apache-2.0
#include "analysis/slope_stability.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/friction_table.h"
#include "analysis/ground_statistics.h"
#include "core/default_values.h"

namespace frana {

constexpr double k_radians = std::numbers::pi / 180;
// Spurs between starting zones are some tens of metres wide; smaller forms are roughness.
constexpr double k_convexity_spacing = 20;

double factor_of_safety(const SlopeLayer& layer, double slope_deg) {
    const double sine = std::sin(slope_deg * k_radians), cosine = std::cos(slope_deg * k_radians);
    const double weight = k_standard_gravity * layer.thickness, floating = layer.saturation * k_water_density;
    // max(0, NaN) would be 0.
    const double carried = floating > layer.density ? 0 : layer.density - floating;
    const double friction = carried * weight * cosine * cosine * std::tan(layer.friction_angle * k_radians);
    return (layer.cohesion + friction) / (layer.density * weight * sine * cosine);
}

SlopeScreening screen_slopes(const Raster& terrain, const StartingGround& limits,
                             const std::function<SlopeLayer(std::size_t cell)>& layer_at) {
    const GridSpec& grid = terrain.grid;
    SlopeScreening found{Raster(grid, 0), Raster(grid, k_no_data)};
    const auto step = std::max<std::int64_t>(1, std::lround(k_convexity_spacing / grid.cell_size));
    for (std::int64_t row = 0; row < grid.rows; ++row)
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double slope = slope_deg(terrain, row, column);
            const std::size_t cell = terrain.index(row, column);
            const double factor = factor_of_safety(layer_at(cell), slope);
            if (!std::isnan(factor)) found.factor.values[cell] = std::min(factor, k_most_factor);
            if (factor < 1 && slope >= limits.least_slope && slope <= limits.greatest_slope &&
                -ground_shape(terrain, row, column, step).curvature <= limits.greatest_convexity)
                found.starts.values[cell] = 1;
        }
    return found;
}

}  // namespace frana
