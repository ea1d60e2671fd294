// SPDX-License-Identifier: Apache-2.0
#include "app/store/layers.h"

#include <cmath>

#include "core/colour.h"
#include "simulation/raster_of_row.h"

namespace frana::app {

namespace {

// The number of colours distinguishable in a legend.
constexpr int k_classes = 8;

/// Returns the greatest of some factors (rising, the first 1) times a power of ten below a value; with a small
/// tolerance, so that 0.3 is not below 3 tenths.
double round_below(double value, std::initializer_list<double> factors) {
    const double limit = value * (1 - 1e-9);
    const double decade = std::pow(10.0, std::floor(std::log10(limit)));
    double best = decade;
    for (const double factor : factors)
        if (factor * decade < limit) best = factor * decade;
    return best;
}

/// Returns the least round number that is not below a value.
double round_above(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (factor * decade >= value * (1 - 1e-9)) return factor * decade;
    return 10 * decade;
}

/// From a round number above the maximum downwards: 40, 30, 20, 10, then 5, 2, 1, 0.5 ... and finally 0.
std::vector<double> progressive_classes(double maximum) {
    const double top = round_above(maximum);
    const double decade = std::pow(10.0, std::floor(std::log10(top * (1 + 1e-9))));
    std::vector<double> bounds{top};
    while (bounds.size() < k_classes) {
        const double last = bounds.back();
        bounds.push_back(last > decade * (1 + 1e-9) ? round_below(last, {1, 2, 3, 5}) : round_below(last, {1, 2, 5}));
    }
    bounds.push_back(0);
    return {bounds.rbegin(), bounds.rend()};
}

}  // namespace

const Raster* find_raster(const RunResult& result, const ResultRaster& row) {
    return raster_of_row(result, row);
}

std::vector<ResultRaster> main_rasters() {
    std::vector<ResultRaster> rows = result_rasters();
    std::erase_if(rows,
                  [](const ResultRaster& row) { return row.kind != ResultRaster::Kind::flow || !row.when.empty(); });
    return rows;
}

std::vector<double> class_bounds(const ResultRaster& row, const ClassSpec& chosen, double maximum) {
    if (!row.bounds.empty()) return row.bounds;
    if (chosen.fixed && !row.classes.empty()) return fixed_classes(chosen, row.classes);
    return class_bounds(row.progressive, maximum);
}

std::vector<double> class_bounds(bool progressive, double maximum) {
    if (!(maximum > 0)) return nice_classes(0, k_classes);
    return progressive ? progressive_classes(maximum) : nice_classes(maximum, k_classes);
}

}  // namespace frana::app
