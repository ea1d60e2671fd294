// SPDX-License-Identifier: Apache-2.0
#include "analysis/terrain_sanity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace frana {
namespace {

constexpr std::size_t k_needles_kept = 5;

double median_slope_deg(const Raster& terrain) {
    constexpr double k_samples = 1e6;
    const GridSpec& grid = terrain.grid;
    const auto stride = static_cast<std::int64_t>(
        std::ceil(std::sqrt(std::max(1.0, static_cast<double>(grid.cell_count()) / k_samples))));
    std::vector<double> slopes;
    for (std::int64_t row = 1; row + 1 < grid.rows; row += stride) {
        for (std::int64_t column = 1; column + 1 < grid.columns; column += stride) {
            const double slope = std::hypot(terrain.at(row, column + 1) - terrain.at(row, column - 1),
                                            terrain.at(row + 1, column) - terrain.at(row - 1, column)) /
                                 (2 * grid.cell_size);
            if (!std::isnan(slope)) slopes.push_back(slope);
        }
    }
    if (slopes.empty()) return 0;
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return std::atan(*middle) * 180 / std::numbers::pi;
}

/// Height of a cell above all its neighbours, or below all (negative); 0: neither, or one has no data.
double needle_height(const Raster& terrain, std::int64_t row, std::int64_t column) {
    const double own = terrain.at(row, column);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::int64_t r = row - 1; r <= row + 1; ++r) {
        for (std::int64_t c = column - 1; c <= column + 1; ++c) {
            if (r == row && c == column) continue;
            const double step = own - terrain.at(r, c);
            if (std::isnan(step)) return 0;
            least = std::min(least, step);
            most = std::max(most, step);
        }
    }
    return least > 0 ? least : most < 0 ? most : 0;
}

}  // namespace

TerrainSanity terrain_sanity(const Raster& terrain, double needle) {
    TerrainSanity found;
    found.highest.value = -std::numeric_limits<double>::infinity();
    found.lowest.value = std::numeric_limits<double>::infinity();
    const GridSpec& grid = terrain.grid;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double value = terrain.at(row, column);
            if (value > found.highest.value) found.highest = {row, column, value};
            if (value < found.lowest.value) found.lowest = {row, column, value};
            // For most cells one neighbour suffices to exclude a needle.
            const bool inner = row > 0 && column > 0 && row + 1 < grid.rows && column + 1 < grid.columns;
            if (!inner || !(std::abs(value - terrain.at(row, column - 1)) > needle)) continue;
            const double height = needle_height(terrain, row, column);
            if (!(std::abs(height) > needle)) continue;
            if (++found.needles <= static_cast<std::int64_t>(k_needles_kept))
                found.first_needles.push_back({row, column, height});
        }
    }
    found.median_slope_deg = median_slope_deg(terrain);
    return found;
}

}  // namespace frana
