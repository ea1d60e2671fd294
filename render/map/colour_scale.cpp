// SPDX-License-Identifier: Apache-2.0
#include "render/map/colour_scale.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "render/canvas/ticks.h"

namespace frana::render {
namespace {

constexpr int k_usual_classes = 8;  // more cannot be distinguished in a legend
constexpr int k_slices = 24;        // between two bounds: steps of less than one part in 150 of the whole scale
constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Whether equal classes would put half of all values into the lowest one.
bool mostly_small(const Raster* layer, const ValueRange& range) {
    if (layer == nullptr || range.empty() || range.least < 0) return false;
    std::vector<double> values;
    for (const double value : layer->values) {
        if (!std::isnan(value)) values.push_back(value);
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle < range.greatest / k_usual_classes;
}

/// Returns bounds that widen as 1, 2, 5, 10, 20 ..., the last not below the maximum: 0, 0.2, 0.5, 1, 2, 5, 10, 20 for
/// 17.
std::vector<double> progressive_classes(double maximum) {
    std::vector<double> bounds{nice_step_above(maximum)};
    while (bounds.size() < k_usual_classes - 1) bounds.insert(bounds.begin(), nice_step_below(0.9 * bounds.front()));
    bounds.insert(bounds.begin(), 0);
    return bounds;
}

std::vector<double> usual_bounds(const ScaleRequest& request, const ValueRange& range) {
    if (!request.classes.empty()) return request.classes;
    const double top = request.maximum ? *request.maximum : !range.empty() ? range.greatest : 1;
    if (!request.maximum && mostly_small(request.layer, range)) return progressive_classes(top);
    if (range.empty() || range.least >= 0 || request.maximum) return nice_classes(top, k_usual_classes);
    // Values on both sides of zero (change of height): the same steps both ways, with a bound at zero.
    const double step = nice_step_above((std::max(top, 0.0) - range.least) / k_usual_classes);
    std::vector<double> bounds{std::floor(range.least / step) * step};
    while (bounds.back() < std::max(top, 0.0)) bounds.push_back(std::round(bounds.back() / step + 1) * step);
    return bounds;
}

}  // namespace

ValueRange value_range(const Raster& raster) {
    ValueRange range;
    raster.values.for_each_stored([&](std::size_t, double value) {
        if (std::isnan(value)) return;
        range.least = std::min(range.least, value);
        range.greatest = std::max(range.greatest, value);
    });
    return range;
}

ColourScale::ColourScale(const ScaleRequest& request) : words_(request.words) {
    Problems problems;
    if (!request.categories.empty() && (!request.classes.empty() || request.maximum)) {
        problems.add(
            {"a map's raster has both categories and class bounds or a maximum", "", "", "", "give one of them"});
    }
    if (request.maximum && !(*request.maximum > 0 && std::isfinite(*request.maximum))) {
        problems.add(
            {"the end of a colour scale must be positive", "", number(*request.maximum), "greater than 0", ""});
    }
    const bool rising = std::adjacent_find(request.classes.begin(), request.classes.end(),
                                           [](double a, double b) { return !(a < b); }) == request.classes.end();
    const auto finite = std::count_if(request.classes.begin(), request.classes.end(),
                                      [](double bound) { return std::isfinite(bound); });
    const bool only_open =
        !request.classes.empty() && finite < static_cast<std::ptrdiff_t>(request.classes.size()) && finite < 2;
    if (request.classes.size() == 1 || !rising || only_open) {
        problems.add({"class bounds must be at least two and rise", "", "", "", "for example 0, 0.5, 1, 2, 5"});
    }
    problems.throw_if_any();

    if (!request.categories.empty()) {
        set_categories(request.categories);
        return;
    }
    const ValueRange range = request.layer != nullptr ? value_range(*request.layer) : ValueRange{};
    std::vector<double> bounds = usual_bounds(request, range);
    const bool fixed_open = bounds.back() == k_infinity;
    if (fixed_open) bounds.pop_back();
    const bool fixed_open_below = bounds.front() == -k_infinity;
    if (fixed_open_below) bounds.erase(bounds.begin());
    const bool given = !request.classes.empty() || request.maximum;
    const bool unseen = request.for_unseen_values && given;
    // A raster that is given as well has their greatest values: a class that none is in would change all colours.
    const bool beyond = unseen && range.empty();
    const bool open_below = fixed_open_below || range.least < bounds.front() || (unseen && bounds.front() > 0);
    const bool open_above = fixed_open || range.greatest > bounds.back() || beyond;
    bounds_ = bounds;
    if (request.continuous) slices_ = k_slices;
    set_bounds(open_below, open_above, palette(request.palette));
}

void ColourScale::set_categories(const std::vector<ClassLabel>& categories) {
    categorical_ = true;
    for (const ClassLabel& category : categories) {
        classes_.push_back({category.value, category.value, category.label, category.colour});
    }
}

std::string ColourScale::number_of(double bound) const {
    return words_.number(number(bound));
}

void ColourScale::set_bounds(bool open_below, bool open_above, const Palette& palette) {
    const double first = bounds_.front(), end = bounds_.back();
    const char* const to = first < 0 ? " \u2026 " : " \u2013 ";  // a dash beside a minus is hard to read
    if (open_below) classes_.push_back({-k_infinity, first, "< " + number_of(first), {}});
    for (std::size_t i = 0; i + 1 < bounds_.size(); ++i) {
        const double lower = bounds_[i], upper = bounds_[i + 1];
        if (slices_ == 1) {
            classes_.push_back({lower, upper, number_of(lower) + to + number_of(upper), {}});
            continue;
        }
        const double thick = (upper - lower) / slices_;
        for (int k = 0; k < slices_; ++k)
            classes_.push_back({lower + k * thick, k + 1 == slices_ ? upper : lower + (k + 1) * thick, "", {}});
    }
    if (open_above) classes_.push_back({end, k_infinity, "> " + number_of(end), {}});
    const auto last = static_cast<double>(std::max<std::size_t>(classes_.size() - 1, 1));
    for (std::size_t i = 0; i < classes_.size(); ++i) {
        classes_[i].colour = colour_at(palette, static_cast<double>(i) / last);
    }
}

const ColourClass* ColourScale::find(double value) const noexcept {
    if (std::isnan(value) || classes_.empty()) return nullptr;
    if (categorical_) {
        for (const ColourClass& one : classes_) {
            if (one.lower == value) return &one;
        }
        return nullptr;
    }
    if (value < classes_.front().lower || value > classes_.back().upper) return nullptr;
    // A bound belongs to the class above it; the last bound to the last class that has one.
    const auto next = std::upper_bound(classes_.begin(), classes_.end(), value,
                                       [](double v, const ColourClass& one) { return v < one.lower; });
    const ColourClass* found = &*(next - 1);
    if (found->lower == value && std::isinf(found->upper) && found != &classes_.front()) --found;
    return found;
}

}  // namespace frana::render
