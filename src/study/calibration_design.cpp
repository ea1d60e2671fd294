// SPDX-License-Identifier: Apache-2.0
#include "study/calibration_design.h"

#include <algorithm>
#include <cmath>

#include "study/calibration_posterior.h"
#include "study/openturns/functions.h"

namespace frana::study {
namespace {

constexpr double k_prior_part = 0.2, k_least_width = 0.02;

/// Width of the kernels along each key.
std::vector<double> kernel_widths(const Places& design, const std::vector<double>& weights) {
    const std::size_t keys = design.front().size();
    const double shrink = std::pow(effective_count(weights), -1.0 / (static_cast<double>(keys) + 4));
    std::vector<double> widths;
    for (std::size_t k = 0; k < keys; ++k) {
        double mean = 0, variance = 0;
        for (std::size_t i = 0; i < design.size(); ++i) mean += weights[i] * design[i][k];
        for (std::size_t i = 0; i < design.size(); ++i)
            variance += weights[i] * (design[i][k] - mean) * (design[i][k] - mean);
        widths.push_back(std::max(k_least_width, std::sqrt(variance) * shrink));
    }
    return widths;
}

}  // namespace

RefinedPlaces refined_places(const Places& design, const std::vector<double>& weights, std::size_t count,
                             std::int64_t seed) {
    return openturns().refined(design, weights, kernel_widths(design, weights), k_prior_part, count, seed);
}

}  // namespace frana::study
