// SPDX-License-Identifier: Apache-2.0
#include "simulation/plane_stress.h"

#include "core/reached_raster.h"
#include "params/keys/result_rasters.h"

namespace frana {

std::vector<NamedRaster> plane_stress_rasters(const voellmy_bingham::PlaneStressLaw& law, double density,
                                              double gravity, const Raster& depth, const Raster& u, const Raster& v) {
    std::vector<NamedRaster> rasters{{RasterName::plane_stress_xx, reached_raster(depth.grid, k_no_data)},
                                     {RasterName::plane_stress_yy, reached_raster(depth.grid, k_no_data)}};
    const GridSpec& grid = depth.grid;
    depth.values.for_each_stored([&](std::size_t cell, double h) {
        if (!(h > 0)) return;
        const auto index = static_cast<std::int64_t>(cell), row = index / grid.columns, column = index % grid.columns;
        const auto value = [&](const Raster& of, std::int64_t r, std::int64_t c) {
            const bool wet = r >= 0 && r < grid.rows && c >= 0 && c < grid.columns && depth.at(r, c) > 0;
            return wet ? of.at(r, c) : of.values[cell];
        };
        const auto in_x = [&](const Raster& of) {
            return (value(of, row, column + 1) - value(of, row, column - 1)) / (2 * grid.cell_size);
        };
        const auto in_y = [&](const Raster& of) {
            return (value(of, row - 1, column) - value(of, row + 1, column)) / (2 * grid.cell_size);
        };
        const StrainRate<double> rate{in_x(u), 0.5 * (in_y(u) + in_x(v)), in_y(v), u.values[cell], v.values[cell], h};
        const PlaneStress<double> sigma = law.law ? law.law(rate) : PlaneStress<double>{};
        rasters[0].values.values[cell] = plane_stress_kpa(density, gravity, h, sigma.xx);
        rasters[1].values.values[cell] = plane_stress_kpa(density, gravity, h, sigma.yy);
    });
    return rasters;
}

}  // namespace frana
