// SPDX-License-Identifier: Apache-2.0
#include "analysis/ground_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/trace.h"
#include "core/error.h"
#include "core/reached_raster.h"

namespace frana {

double percentile(std::vector<double> values, double fraction) {
    if (values.empty()) return k_no_data;
    const double place = fraction * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::ptrdiff_t>(place);
    const auto at = values.begin() + below;
    std::nth_element(values.begin(), at, values.end());
    if (at + 1 == values.end()) return *at;
    const double next = *std::min_element(at + 1, values.end());
    return *at + (place - static_cast<double>(below)) * (next - *at);
}

PeakValues high_values(const Raster& raster, const Raster& mask) {
    std::vector<double> inside;
    raster.values.for_each_stored([&](std::size_t cell, double value) {
        const double marked = mask.values[cell];
        if (marked != 0 && !std::isnan(marked) && !std::isnan(value)) inside.push_back(value);
    });
    return {maximum(raster), percentile(inside, 0.999), percentile(inside, 0.99)};
}

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

namespace {

/// Returns the difference quotient of the existing neighbours; 0 without any.
double gradient(double before, double here, double after, double cell_size) {
    if (!std::isnan(before) && !std::isnan(after)) return (after - before) / (2 * cell_size);
    if (!std::isnan(after)) return (after - here) / cell_size;
    return std::isnan(before) ? 0 : (here - before) / cell_size;
}

template <class Change>
Raster with_slope(const Raster& depth, const Raster& bed, const Change& change) {
    Raster changed = reached_raster(depth.grid, k_no_data);
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
