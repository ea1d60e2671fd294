// SPDX-License-Identifier: Apache-2.0
#include "analysis/ground_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"

namespace frana {
namespace {

/// Returns the difference quotient of the existing neighbours; 0 without any.
double gradient(double before, double here, double after, double cell_size) {
    if (!std::isnan(before) && !std::isnan(after)) return (after - before) / (2 * cell_size);
    if (!std::isnan(after)) return (after - here) / cell_size;
    return std::isnan(before) ? 0 : (here - before) / cell_size;
}

template <class Change>
Raster with_slope(const Raster& depth, const Raster& bed, const Change& change) {
    Raster changed(depth.grid, k_no_data);
    depth.values.for_each_stored([&](std::size_t cell, double value) {
        if (std::isnan(value)) return;
        const auto place = static_cast<std::int64_t>(cell);
        changed.values[cell] = change(value, bed_cosine(bed, place / depth.grid.columns, place % depth.grid.columns));
    });
    return changed;
}

}  // namespace

double bed_cosine(const Raster& bed, std::int64_t row, std::int64_t column) {
    const GridSpec& grid = bed.grid;
    const auto at = [&](std::int64_t r, std::int64_t c) {
        return r < 0 || c < 0 || r >= grid.rows || c >= grid.columns ? k_no_data : bed.at(r, c);
    };
    const double here = at(row, column);
    if (std::isnan(here)) return 1;
    const double east = gradient(at(row, column - 1), here, at(row, column + 1), grid.cell_size);
    const double north = gradient(at(row + 1, column), here, at(row - 1, column), grid.cell_size);
    return 1 / std::sqrt(1 + east * east + north * north);
}

Raster normal_depth(const Raster& vertical, const Raster& bed) {
    return with_slope(vertical, bed, [](double depth, double cosine) { return depth * cosine; });
}

Raster vertical_depth(const Raster& normal, const Raster& bed) {
    return with_slope(normal, bed, [](double depth, double cosine) { return depth / cosine; });
}

double slope_deg(const Raster& terrain, std::int64_t row, std::int64_t column) {
    const GridSpec& grid = terrain.grid;
    if (row < 1 || column < 1 || row + 1 >= grid.rows || column + 1 >= grid.columns) return k_no_data;
    const auto across = [&](std::int64_t r) { return terrain.at(r, column + 1) - terrain.at(r, column - 1); };
    const auto down = [&](std::int64_t c) { return terrain.at(row + 1, c) - terrain.at(row - 1, c); };
    const double x = across(row - 1) + 2 * across(row) + across(row + 1),
                 y = down(column - 1) + 2 * down(column) + down(column + 1);
    return std::atan(std::hypot(x, y) / (8 * grid.cell_size)) * 180 / std::numbers::pi;
}

void GroundSum::add(std::int64_t row, std::int64_t column) {
    const GridSpec& grid = terrain_.grid;
    if (row < 0 || column < 0 || row >= grid.rows || column >= grid.columns) return;
    const double z = terrain_.at(row, column);
    if (std::isnan(z)) return;
    lowest_ = std::min(lowest_, z);
    highest_ = std::max(highest_, z);
    const double slope = slope_deg(terrain_, row, column);
    if (std::isnan(slope)) return;
    sum_ += slope;
    steepest_ = std::max(steepest_, slope);
    ++slopes_;
}

std::optional<GroundStatistics> GroundSum::statistics() const {
    if (slopes_ == 0) return std::nullopt;
    return GroundStatistics{lowest_, highest_, sum_ / static_cast<double>(slopes_), steepest_};
}

std::optional<GroundStatistics> ground_where(const Raster& terrain, const Raster& mask, double threshold) {
    const GridSpec &all = terrain.grid, &part = mask.grid;
    const auto down = std::llround((all.north - part.north) / all.cell_size),
               right = std::llround((part.west - all.west) / all.cell_size);
    if (part.cell_size != all.cell_size || down < 0 || right < 0 || down + part.rows > all.rows ||
        right + part.columns > all.columns)
        throw Error(ErrorKind::input, Problem{"does not lie on the cells of the terrain", "a mask", "", "", ""});
    GroundSum sum(terrain);
    mask.values.for_each_stored([&](std::size_t cell, double value) {
        if (!(value > threshold)) return;
        const auto at = static_cast<std::int64_t>(cell);
        sum.add(at / part.columns + down, at % part.columns + right);
    });
    return sum.statistics();
}

}  // namespace frana
