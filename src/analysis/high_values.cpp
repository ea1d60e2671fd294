// SPDX-License-Identifier: Apache-2.0
#include "analysis/high_values.h"

#include <algorithm>
#include <cmath>

#include "analysis/trace.h"

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

}  // namespace frana
