// SPDX-License-Identifier: Apache-2.0
#include "analysis/convergence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/words/words.h"

namespace frana {
namespace {

constexpr double k_safety = 1.25, k_caution = 3;
constexpr double k_least_order = 0.5, k_rounding = 1e-9;

void require_three(std::size_t levels) {
    if (levels >= 3) return;
    throw Error(ErrorKind::input,
                Problem{"convergence needs three resolutions", "--levels", std::to_string(levels), "3 or more", ""});
}

bool is_usable(double order) {
    return order <= k_scheme_order + k_rounding;
}

// Bilinear at a map place; cells without data count as zero, beyond the edge the edge counts.
double sample(const Raster& raster, Point map) {
    const GridSpec& grid = raster.grid;
    const double column = (map.x - grid.west) / grid.cell_size - 0.5, row = (grid.north - map.y) / grid.cell_size - 0.5;
    const double c0 = std::floor(column), r0 = std::floor(row);
    double sum = 0;
    bool reached = false;
    for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) {
            const double weight = (a ? column - c0 : 1 - column + c0) * (b ? row - r0 : 1 - row + r0);
            const auto c = std::clamp<std::int64_t>(static_cast<std::int64_t>(c0) + a, 0, grid.columns - 1);
            const auto r = std::clamp<std::int64_t>(static_cast<std::int64_t>(r0) + b, 0, grid.rows - 1);
            if (!(weight > 0) || !raster.has_data(r, c)) continue;
            sum += weight * raster.at(r, c);
            reached = true;
        }
    }
    return reached ? sum : k_no_data;
}

double zero_if_none(double value) {
    return std::isnan(value) ? 0 : value;
}

}  // namespace

const char* describe(Trend trend) {
    switch (trend) {
        case Trend::converging:
            return worded("converging");
        case Trend::oscillating:
            return worded("oscillating");
        case Trend::diverging:
            return worded("diverging");
        case Trend::settled:
            return worded("settled");
        case Trend::terrain:
            return worded("limited by the terrain's detail");
        case Trend::unknown:
            return worded("too few levels to tell");
    }
    return "";
}

namespace {

constexpr double k_same_size = 1.01;
constexpr double k_shrunk = 0.9;  // a step of a converging value, of the one before: order 0.15

/// Levels on cells of up to `factor` times the finest: range of their values, and range of cell sizes.
struct Window {
    double range = 0;   ///< of the values
    double widest = 1;  ///< coarsest cell size over the finest
    std::size_t count = 0;

    [[nodiscard]] bool reaches(double factor) const { return widest * k_same_size >= factor; }
    [[nodiscard]] double first_order() const { return widest > 1 ? range / (widest - 1) : 0; }
};

Window window(const std::vector<Refinement>& levels, double factor) {
    const Refinement& fine = levels.back();
    double least = fine.value, greatest = fine.value;
    Window result;
    for (const Refinement& level : levels) {
        const double ratio = level.cell_size / fine.cell_size;
        if (ratio > factor * k_same_size) continue;
        ++result.count;
        result.widest = std::max(result.widest, ratio);
        least = std::min(least, level.value);
        greatest = std::max(greatest, level.value);
    }
    result.range = greatest - least;
    return result;
}

/// The value on cells `factor` times the finest; NaN without such a level.
double value_at(const std::vector<Refinement>& levels, double factor) {
    for (const Refinement& level : levels)
        if (std::abs(level.cell_size / (factor * levels.back().cell_size) - 1) < k_same_size - 1) return level.value;
    return k_no_data;
}

/// Applies to the levels on cells of up to four times the finest.
bool changes_in_one_direction(const std::vector<Refinement>& levels) {
    bool up = true, down = true;
    for (std::size_t k = 1; k < levels.size(); ++k) {
        if (levels[k - 1].cell_size > 4 * k_same_size * levels.back().cell_size) continue;
        up &= levels[k].value >= levels[k - 1].value;
        down &= levels[k].value <= levels[k - 1].value;
    }
    return up || down;
}

/// Trend, order and extrapolated value.
GridConvergence trend_of(const std::vector<Refinement>& levels, double detail) {
    const double f1 = levels.back().value, f2 = value_at(levels, 2), f4 = value_at(levels, 4);
    const double before = f2 - f4, last = f1 - f2;
    GridConvergence result;
    result.extrapolated = f1;
    result.observed_order = k_no_data;
    if (window(levels, 4).range == 0) {
        result.trend = Trend::settled;
    } else if (detail > 1) {
        result.trend = Trend::terrain;
    } else if (std::isnan(before) || std::isnan(last)) {
        result.trend = Trend::unknown;
    } else if (!changes_in_one_direction(levels)) {
        result.trend = Trend::oscillating;
    } else if (std::abs(last) > k_shrunk * std::abs(before)) {
        result.trend = Trend::diverging;
    } else {
        result.trend = Trend::converging;
        const double order = std::log2(before / last);
        if (is_usable(order)) {
            result.observed_order = order;
            result.extrapolated = f1 + last / (std::pow(2.0, std::max(order, k_least_order)) - 1);
        }
    }
    return result;
}

/// S of a value.
double first_order_change(const std::vector<Refinement>& levels) {
    const Window half = window(levels, 2), quarter = window(levels, 4);
    require_three(half.reaches(2) ? quarter.count : 0);
    return std::max(half.first_order(), quarter.reaches(4) ? quarter.first_order() : 0.0);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

bool enough_levels(const std::vector<double>& cell_sizes) {
    std::vector<Refinement> levels;
    for (const double size : cell_sizes) levels.push_back({size, 0});
    return !levels.empty() && !std::isnan(value_at(levels, 2)) && !std::isnan(value_at(levels, 4));
}

std::vector<GridConvergence> grid_convergence(const std::vector<std::vector<Refinement>>& values, double detail) {
    constexpr double k_by_chance = 0.1;
    std::vector<double> changes, relative;
    for (const std::vector<Refinement>& levels : values) {
        changes.push_back(first_order_change(levels));
        const double finest = std::abs(levels.back().value);
        if (finest > 0) relative.push_back(changes.back() / finest);
    }
    const double usual = median(relative);
    std::vector<GridConvergence> results;
    for (std::size_t i = 0; i < values.size(); ++i) {
        GridConvergence result = trend_of(values[i], detail);
        const double finest = std::abs(values[i].back().value);
        result.error = k_safety * changes[i] * std::sqrt(std::max(1.0, detail));
        if (finest > 0) {
            const double own = std::max(changes[i] / finest, k_by_chance * usual);
            result.error = k_safety * finest * std::sqrt(own * usual * std::max(1.0, detail));
            result.index_percent = 100 * result.error / finest;
        }
        if (result.trend == Trend::diverging)  // its changes grow: they bound nothing
            result.error = result.index_percent = std::numeric_limits<double>::infinity();
        results.push_back(result);
    }
    return results;
}

double unseen_detail(double curvature_now, double curvature_finest) {
    constexpr double k_flat = 1e-4;  // [1/m]
    const double now = std::max(curvature_now, k_flat), finest = std::max(curvature_finest, k_flat);
    return std::max(0.0, 2 * (finest / now - 1));
}

double ground_curvature(const Raster& terrain, const Raster& depth, double threshold) {
    const GridSpec &grid = terrain.grid, &wet = depth.grid;
    const double ratio = wet.cell_size / grid.cell_size, area = grid.cell_area();
    const double offset_x = (wet.west - grid.west) / grid.cell_size - 0.5,
                 offset_y = (grid.north - wet.north) / grid.cell_size - 0.5;
    // The first terrain cell whose centre is beyond an edge of a wet cell, except cells of the terrain's border.
    const auto first = [](double edge, std::int64_t count) {
        return static_cast<std::int64_t>(std::max(1.0, std::min(std::ceil(edge), static_cast<double>(count - 1))));
    };
    double sum = 0;
    std::int64_t count = 0;
    const auto add = [&](std::int64_t row, std::int64_t column) {
        const double middle = 2 * terrain.at(row, column);
        const double along = (terrain.at(row, column - 1) + terrain.at(row, column + 1) - middle) / area;
        const double across = (terrain.at(row - 1, column) + terrain.at(row + 1, column) - middle) / area;
        if (std::isnan(along + across)) return;
        sum += along * along + across * across;
        count += 2;
    };
    depth.values.for_each_stored([&](std::size_t cell, double value) {
        if (!(value > threshold)) return;
        const auto r = static_cast<double>(static_cast<std::int64_t>(cell) / wet.columns),
                   c = static_cast<double>(static_cast<std::int64_t>(cell) % wet.columns);
        const std::int64_t row_end = first(offset_y + (r + 1) * ratio, grid.rows),
                           column_end = first(offset_x + (c + 1) * ratio, grid.columns);
        for (std::int64_t row = first(offset_y + r * ratio, grid.rows); row < row_end; ++row)
            for (std::int64_t column = first(offset_x + c * ratio, grid.columns); column < column_end; ++column)
                add(row, column);
    });
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

Raster field_uncertainty(const std::vector<Raster>& levels) {
    require_three(levels.size());
    const Raster &coarse = levels[levels.size() - 3], &middle = levels[levels.size() - 2], &fine = levels.back();
    const double ratio = middle.grid.cell_size / fine.grid.cell_size;
    Raster last(fine.grid, k_no_data);
    double sum_before = 0, sum_last = 0;
    for (std::int64_t row = 0; row < fine.grid.rows; ++row) {
        for (std::int64_t column = 0; column < fine.grid.columns; ++column) {
            const Point place = fine.grid.cell_centre(row, column);
            const double f1 = fine.at(row, column), f2 = sample(middle, place), f3 = sample(coarse, place);
            if (std::isnan(f1) && std::isnan(f2)) continue;
            last.at(row, column) = std::abs(zero_if_none(f1) - zero_if_none(f2));
            sum_last += last.at(row, column);
            sum_before += std::abs(zero_if_none(f2) - zero_if_none(f3));
        }
    }
    const double observed =
        sum_last > 0 && sum_before > sum_last ? std::log(sum_before / sum_last) / std::log(ratio) : 0;
    const bool converges = observed > 0 && is_usable(observed);
    const double order = converges ? std::max(observed, k_least_order) : 1;
    const double factor = (converges ? k_safety : k_caution) / (std::pow(ratio, order) - 1);
    for (double& value : last.values) value *= factor;
    return last;
}

}  // namespace frana
