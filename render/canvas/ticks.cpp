// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/ticks.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace frana::render {
namespace {

constexpr double k_slack = 1e-9;  // of a step: rounding of decimal steps in binary

double step(double value, bool above) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    double below = power;
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        const double candidate = factor * power;
        if (above && candidate >= value * (1 - k_slack)) return candidate;
        if (!above && candidate <= value * (1 + k_slack)) below = candidate;
    }
    return below;
}

}  // namespace

double nice_step_above(double least) {
    return step(least, true);
}

double nice_step_below(double most) {
    return step(most, false);
}

std::vector<double> multiples(double from, double to, double step) {
    std::vector<double> all;
    for (double k = std::ceil(from / step - k_slack); k * step <= to + k_slack * step; k += 1) all.push_back(k * step);
    return all;
}

std::string number(double value) {
    std::array<char, 32> text{};
    // Six digits hide the rounding of decimal steps in binary (0.30000000000000004) and keep every bound that users
    // write.
    std::snprintf(text.data(), text.size(), std::fabs(value) >= 1e5 && std::fabs(value) < 1e12 ? "%.0f" : "%.6g",
                  value + 0.0);
    return text.data();
}

std::string grouped(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.0f", std::fabs(value));
    const std::string digits = text.data();
    std::string result = value < -0.5 ? "\u2212" : "";
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) result += ' ';
        result += digits[i];
    }
    return result;
}

}  // namespace frana::render
