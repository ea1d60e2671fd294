// SPDX-License-Identifier: Apache-2.0
#include "analysis/convergence.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace frana {
namespace {

constexpr double k_safety = 1.25, k_caution = 3;
constexpr double k_least_order = 0.5, k_greatest_order = 2;

void require_three(std::size_t levels) {
    if (levels >= 3) return;
    throw Error(ErrorKind::input,
                Problem{"convergence needs three resolutions", "--levels", std::to_string(levels), "3 or more", ""});
}

double limited_order(double order) {
    return std::clamp(order, k_least_order, k_greatest_order);
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
            return "converging";
        case Trend::oscillating:
            return "oscillating";
        case Trend::diverging:
            return "diverging";
        case Trend::settled:
            return "settled";
    }
    return "";
}

GridConvergence grid_convergence(const std::vector<Refinement>& levels) {
    require_three(levels.size());
    const Refinement &coarse = levels[levels.size() - 3], &middle = levels[levels.size() - 2], &fine = levels.back();
    const double ratio = middle.cell_size / fine.cell_size;
    const double before = middle.value - coarse.value, last = fine.value - middle.value;
    GridConvergence result;
    result.extrapolated = fine.value;
    result.observed_order = k_no_data;
    double safety = k_caution, order = 1;
    if (last == 0) {
        result.trend = Trend::settled;
    } else if (before * last < 0) {
        result.trend = Trend::oscillating;
    } else if (std::abs(last) >= std::abs(before)) {
        result.trend = Trend::diverging;
    } else {
        result.trend = Trend::converging;
        result.observed_order = std::log(before / last) / std::log(ratio);
        order = limited_order(result.observed_order);
        safety = k_safety;
        result.extrapolated = fine.value + last / (std::pow(ratio, order) - 1);
    }
    result.error = safety * std::abs(last) / (std::pow(ratio, order) - 1);
    result.index_percent = fine.value != 0 ? 100 * result.error / std::abs(fine.value) : 0;
    return result;
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
    const bool converges = sum_last > 0 && sum_before > sum_last;
    const double order = converges ? limited_order(std::log(sum_before / sum_last) / std::log(ratio)) : 1;
    const double factor = (converges ? k_safety : k_caution) / (std::pow(ratio, order) - 1);
    for (double& value : last.values) value *= factor;
    return last;
}

}  // namespace frana
