// SPDX-License-Identifier: Apache-2.0
#include "render/map/legend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "render/canvas/furniture.h"
#include "render/map/map_lines.h"

namespace frana::render {
namespace {

constexpr int k_usual_classes = 8;  // more cannot be distinguished in a legend
constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Light enough that shade and lines of the ground are seen through it, also through the darkest.
Rgb light(Rgb colour) {
    const auto lighter = [](std::uint8_t byte) {
        constexpr double k_white = 0.2;
        return static_cast<std::uint8_t>(std::lround(byte + k_white * (255 - byte)));
    };
    return {lighter(colour.r), lighter(colour.g), lighter(colour.b)};
}

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
    const double top = range.empty() ? 1 : range.greatest;
    if (mostly_small(request.layer, range)) return progressive_classes(top);
    if (range.empty() || range.least >= 0) return nice_classes(top, k_usual_classes);
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
    if (!request.categories.empty() && !request.classes.empty())
        problems.add({"a map's raster has both categories and class bounds", "", "", "", "give one of them"});
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
    const bool unseen = request.for_unseen_values && !request.classes.empty();
    // A raster that is given as well has their greatest values: a class that none is in would change all colours.
    const bool beyond = unseen && range.empty();
    const bool open_below = fixed_open_below || range.least < bounds.front() || (unseen && bounds.front() > 0);
    const bool open_above = fixed_open || range.greatest > bounds.back() || beyond;
    set_bounds(bounds, open_below, open_above, palette(request.palette));
}

void ColourScale::set_categories(const std::vector<ClassLabel>& categories) {
    categorical_ = true;
    for (const ClassLabel& category : categories) {
        classes_.push_back({category.value, category.value, category.label, light(category.colour)});
    }
}

std::string ColourScale::number_of(double bound) const {
    return words_.number(number(bound));
}

void ColourScale::set_bounds(const std::vector<double>& bounds, bool open_below, bool open_above,
                             const Palette& palette) {
    const double first = bounds.front(), end = bounds.back();
    const char* const to = first < 0 ? " \u2026 " : " \u2013 ";  // a dash beside a minus is hard to read
    if (open_below) classes_.push_back({-k_infinity, first, "< " + number_of(first), {}});
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        const double lower = bounds[i], upper = bounds[i + 1];
        classes_.push_back({lower, upper, number_of(lower) + to + number_of(upper), {}});
    }
    if (open_above) classes_.push_back({end, k_infinity, "> " + number_of(end), {}});
    const auto last = static_cast<double>(std::max<std::size_t>(classes_.size() - 1, 1));
    for (std::size_t i = 0; i < classes_.size(); ++i) {
        classes_[i].colour = light(colour_at(palette, static_cast<double>(i) / last));
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

bool has_values(const PictureSpec& spec) {
    return (spec.layer != nullptr && data_bounds(*spec.layer).has_value()) ||
           (spec.dots != nullptr && !spec.dots->dots.empty());
}

ColourScale scale_of(const PictureSpec& spec, bool for_frames) {
    if (!has_values(spec) && !for_frames) return {};
    return ColourScale({spec.palette, spec.classes, spec.categories, spec.layer, for_frames, spec.words});
}

namespace {

constexpr double k_inch = 0.0254;              // m
constexpr double k_least_margin = 0.03;        // of the content's longer side, beside it
constexpr double k_scale_rounding = 1 + 1e-9;  // a scale may be equal to the least

Bounds with_margin(const Bounds& box, double fraction) {
    const double margin = fraction * std::max(box.width(), box.height());
    return {box.west - margin, box.south - margin, box.east + margin, box.north + margin};
}

Bounds centred(const Bounds& on, double metre, int width, int height) {
    const double x = (on.west + on.east) / 2, y = (on.south + on.north) / 2;
    return {x - width * metre / 2, y - height * metre / 2, x + width * metre / 2, y + height * metre / 2};
}

}  // namespace

double metres_per_pixel(double n, double dots_per_inch) {
    return n * k_inch / dots_per_inch;
}

double scale_of(double metres_per_pixel, double dots_per_inch) {
    return metres_per_pixel * dots_per_inch / k_inch;
}

double round_scale_above(double n) {
    double decade = std::pow(10, std::floor(std::log10(n)));
    for (;; decade *= 10) {
        for (const double step : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 8.0}) {
            const double scale = std::round(step * decade);
            if (scale * k_scale_rounding >= n) return scale;
        }
    }
}

double least_scale(const Print& print, const Bounds& required, int width, int height) {
    const Bounds box = with_margin(required, k_least_margin);
    return scale_of(std::max(box.width() / width, box.height() / height), print.dots_per_inch);
}

Bounds window_at_scale(const Print& print, const Bounds& required, const Bounds& free, int width, int height) {
    if (!(print.dots_per_inch > 0)) return free;
    const double least = least_scale(print, required, width, height);
    if (print.scale) {
        if (*print.scale * k_scale_rounding < least) {
            throw Error(
                ErrorKind::input,
                Problem{"the flow does not fit the page at this scale", "", scale_words(*print.scale),
                        "at least " + scale_words(std::ceil(least)), "Take " + scale_words(round_scale_above(least))});
        }
        return centred(required, metres_per_pixel(*print.scale, print.dots_per_inch), width, height);
    }
    return centred(free, metres_per_pixel(round_scale_above(least), print.dots_per_inch), width, height);
}

std::string scale_words(double n, const Words& words) {
    return "1 : " + words.number(grouped(std::round(n)));
}

std::string print_words(const Print& print, double page_width, double page_height, const Words& words) {
    if (!print.sheet.empty()) return words("on {1}", {print.sheet.substr(0, print.sheet.find('-'))});
    const auto centimetres = [&](double pixels) {
        return words.number(number(std::round(1000 * k_inch * pixels / print.dots_per_inch) / 10));
    };
    return words("printed {1} \u00D7 {2} cm", {centimetres(page_width), centimetres(page_height)});
}

namespace {

struct BoxSize {
    double width, height;
};

BoxSize swatch(const PageStyle& style) {
    return {2.0 * style.label.size_px, 1.35 * style.label.size_px};
}

double text_offset(const PageStyle& style) {
    return swatch(style).width + 0.6 * style.label.size_px;
}

std::string full_title(const LegendContent& content) {
    return content.unit.empty() ? content.title : content.title + " [" + content.unit + "]";
}

}  // namespace

std::vector<double> outline_dashes(const Outline& outline, double width_px) {
    if (!outline.dashed) return {};
    return {3.2 * width_px, 2.2 * width_px};
}

double legend_width(const LegendContent& content, const PageStyle& style, const Sheet& sheet, double most) {
    const Lettering& lettering = sheet.lettering();
    double width = 0;
    for (const ColourClass& one : content.scale->classes())
        width = std::max(width, text_offset(style) + lettering.width(one.label, style.label));
    for (const Outline& outline : *content.outlines) {
        width = std::max(width, text_offset(style) + lettering.width(outline.label, style.label));
    }
    for (const std::string& note : *content.notes) width = std::max(width, lettering.width(note, style.label));
    width = std::max(width, lettering.width(full_title(content), style.heading));
    return std::min(most, std::ceil(width) + 2);
}

double draw_legend(const LegendContent& content, const PageStyle& style, Point corner, double width, Sheet& sheet,
                   std::vector<LegendEntry>& entries) {
    const BoxSize size = swatch(style);
    const double line_height = Sheet::line_height(style.label);
    double y = corner.y;
    const auto labelled = [&](const std::string& label, double row_height) {
        // A label of several lines begins where a label of one line would be.
        double line_y = y + row_height / 2;
        for (const std::string& line : sheet.wrapped(label, style.label, width - text_offset(style))) {
            sheet.text(line, {corner.x + text_offset(style), line_y}, style.label, Across::left, Upright::middle);
            line_y += line_height;
        }
        y = std::max(y + row_height, line_y - line_height + row_height / 2);
    };

    const std::vector<ColourClass>& classes = content.scale->classes();
    if (!classes.empty()) {
        y = sheet.lines(sheet.wrapped(full_title(content), style.heading, width), {corner.x, y}, style.heading,
                        Across::left) +
            0.15 * style.heading.size_px;
        const bool apart = content.scale->categorical();  // ranges touch, categories are separated
        std::vector<const ColourClass*> order;
        for (const ColourClass& one : classes) order.push_back(&one);
        if (!apart) std::reverse(order.begin(), order.end());
        for (const ColourClass* one : order) {
            const PageBox box{corner.x, y, corner.x + size.width, y + size.height};
            sheet.fill(box, one->colour);
            sheet.frame(box, {style.line(1), k_ink});
            entries.push_back({one->label, one->colour, box, one->lower, one->upper});
            labelled(one->label, size.height);
            if (apart) y += 0.4 * size.height;
        }
        y += 1.4 * style.gap;
    }
    for (const Outline& outline : *content.outlines) {
        if (outline.label.empty()) continue;
        const double line = style.line(outline.width_px);
        const std::array<Point, 2> ends{
            {{corner.x, y + size.height / 2}, {corner.x + size.width, y + size.height / 2}}};
        if (!outline.polygons.empty() || !outline.lines.empty())
            sheet.line(ends, {line, outline.colour, 1, outline_dashes(outline, line)});
        else
            draw_place(sheet, style, {corner.x + size.width / 2, y + size.height / 2}, outline.colour);
        labelled(outline.label, size.height);
        y += 0.2 * size.height;
    }
    if (!content.outlines->empty()) y += style.gap;
    for (const std::string& note : *content.notes) {
        y = sheet.lines(sheet.wrapped(note, style.label, width), {corner.x, y}, style.label, Across::left);
    }
    return y;
}

}  // namespace frana::render
