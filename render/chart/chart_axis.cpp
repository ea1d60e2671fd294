// SPDX-License-Identifier: Apache-2.0
#include "render/chart/chart_axis.h"

#include <algorithm>
#include <cmath>

#include "render/canvas/ticks.h"

namespace frana::render {
namespace {

std::string power_of_ten(int exponent) {
    if (exponent >= -3 && exponent <= 4) return number(std::pow(10.0, exponent));
    return exponent < 0 ? "1e\u2212" + std::to_string(-exponent) : "1e" + std::to_string(exponent);
}

}  // namespace

Decades decades_of(const std::vector<double>& values) {
    Decades decades{0, 1};
    bool any = false;
    for (const double value : values) {
        if (!(value > 0) || !std::isfinite(value)) continue;
        const int low = static_cast<int>(std::floor(std::log10(value)));
        const int high = static_cast<int>(std::ceil(std::log10(value)));
        decades = any ? Decades{std::min(decades.low, low), std::max(decades.high, high)} : Decades{low, high};
        any = true;
    }
    if (decades.high == decades.low) ++decades.high;
    return decades;
}

ChartAxis::ChartAxis(Scale scale, const std::vector<double>& values, double from, double to, double room, bool rounded)
    : scale_(scale), from_(from), to_(to) {
    if (scale_ == Scale::decades) {
        const Decades decades = decades_of(values);
        least_ = decades.low;
        most_ = decades.high;
        return;
    }
    if (!values.empty()) {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        least_ = place(*least);
        most_ = place(*most);
    }
    // Values that differ by rounding alone have no ticks between them.
    constexpr double k_alike = 1e-9;
    if (most_ - least_ <= k_alike * std::max(std::abs(least_), std::abs(most_))) most_ = least_ + 1;
    if (scale_ == Scale::logarithmic) return;
    step_ = nice_step_above((most_ - least_) * room / std::abs(to_ - from_));
    if (!rounded) return;
    least_ = std::floor(least_ / step_ + 1e-9) * step_;
    const double highest = most_;
    most_ = std::ceil(most_ / step_ - 1e-9) * step_;
    // A curve along the frame would be mistaken for it.
    if (most_ - highest < 0.02 * (most_ - least_)) most_ += 0.05 * (most_ - least_);
}

bool ChartAxis::has(Scale scale, double value) {
    return std::isfinite(value) && (scale == Scale::linear || value > 0);
}

double ChartAxis::place(double value) const {
    return scale_ == Scale::linear ? value : std::log10(value);
}

double ChartAxis::at(double value) const {
    return from_ + (to_ - from_) * (place(value) - least_) / (most_ - least_);
}

std::vector<Tick> ChartAxis::ticks() const {
    std::vector<Tick> ticks;
    if (scale_ == Scale::linear) {
        for (const double value : multiples(least_, most_, step_)) ticks.push_back({at(value), number(value)});
    } else if (scale_ == Scale::logarithmic) {
        for (double e = std::floor(least_); e <= most_; ++e) {
            for (const double factor : {1.0, 2.0, 5.0}) {
                const double value = factor * std::pow(10.0, e);
                if (place(value) >= least_ && place(value) <= most_) ticks.push_back({at(value), number(value)});
            }
        }
    } else {
        constexpr int k_labels = 5;
        const int low = static_cast<int>(least_), high = static_cast<int>(most_);
        for (int e = low; e < high && high - low < k_labels; ++e)
            for (int k = 2; k < 10; ++k) ticks.push_back({at(k * std::pow(10.0, e)), ""});
        for (int e = low; e <= high; e += std::max(1, (high - low + k_labels - 1) / k_labels))
            ticks.push_back({at(std::pow(10.0, e)), power_of_ten(e)});
    }
    return ticks;
}

}  // namespace frana::render
