// SPDX-License-Identifier: Apache-2.0
#include "render/map/page_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/canvas/ticks.h"
#include "render/map/graticule.h"
#include "render/map/print_scale.h"

namespace frana::render {
namespace {

constexpr int k_least_frame_width = 80, k_least_frame_height = 60;

/// About as long as the longest name of a quantity, of a raster's file with band and time, and of the time.
constexpr const char* k_long_title = ": Probability of a maximum depth greater than 0.5";
constexpr const char* k_long_source = "frames/cohesion_ratio_0012.tif, band 1, t = 1234.5 s";
constexpr const char* k_long_time = "t = 1234.5 s, ";

/// The legend of the depth, whose classes are as many as those of any other quantity.
ColourScale usual_scale() {
    return ColourScale({"depth",
                        std::nullopt,
                        {0, 0.2, 0.5, 1, 2, 5, 10, 20, 50, std::numeric_limits<double>::infinity()},
                        false,
                        {},
                        nullptr,
                        false});
}

LegendContent legend_of(const PageText& text, const MapSpec& spec, const std::vector<std::string>& notes) {
    return {text.legend_title, text.unit, &text.scale, &spec.outlines, &notes};
}

double highest_titles(Sheet& sheet, const PageStyle& style, const PageText& text, double width, bool subtitle_later) {
    double bottom = 0;
    for (std::size_t i = 0; i < text.titles.size(); ++i)
        bottom = std::max(bottom, draw_titles(sheet, style, text.titles[i], text.subtitles[i], subtitle_later,
                                              {style.margin, style.margin}, width)
                                      .bottom);
    return bottom;
}

std::vector<std::string> foot_parts(const MapSpec& spec, const PageText& text, bool notes, bool block) {
    std::vector<std::string> parts;
    if (notes) {
        parts = text.notes;
        parts.push_back(convergence_words(spec.convergence_deg, spec.words));
    }
    parts.insert(parts.end(), text.foot.begin(), text.foot.end());
    if (block) parts.insert(parts.end(), spec.block.lines.begin(), spec.block.lines.end());
    return parts;
}

}  // namespace

std::string contour_words(double interval, const Words& words) {
    return interval > 0 ? words("contour interval {1} m", {words.number(number(interval))}) : "";
}

PageText own_text(const MapSpec& spec, const ColourScale& scale) {
    // The contours' interval is determined later; every interval needs about the same room.
    const double interval = spec.terrain != nullptr && spec.contours ? 1000 : 0;
    return {{spec.title},
            {spec.subtitle},
            spec.legend_title,
            spec.unit,
            scale,
            spec.side_notes,
            {spec.source, spec.crs_label, contour_words(interval, spec.words), spec.attribution}};
}

PageText series_text(const MapSpec& spec) {
    PageText text = own_text(spec, usual_scale());
    const SeriesText& series = *spec.series;
    // A short title is in larger letters than a long one.
    text.titles = {series.title, series.title + k_long_title};
    text.subtitles = {series.subtitle, series.has_notes ? k_long_time + series.subtitle : series.subtitle};
    text.legend_title = "Maximum dynamic pressure";
    text.unit = "kPa";
    constexpr std::size_t k_usual_notes = 8;
    text.notes = series.notes;
    if (series.has_notes) text.notes.resize(std::max(text.notes.size(), k_usual_notes), "Covered 123 456 m\u00B2");
    text.foot.front() = k_long_source;
    return text;
}

std::vector<std::string> PagePlan::foot(const MapSpec& spec, const PageText& text) const {
    return foot_parts(spec, text, crowding.notes_at_foot, block.lines_at_foot);
}

std::optional<PagePlan> plan_page(const MapSpec& spec, const PageText& text, const Crowding& crowding,
                                  bool subtitle_later) {
    const std::vector<std::string> nothing;
    PagePlan plan{
        crowding, PageStyle(spec.width, spec.height, crowding.density, spec.least_letters), 0, 0, {}, {}, 0, 0, {}};
    const PageStyle& style = plan.style;
    Sheet sheet(spec.width, spec.height);
    const double width = spec.width, right = width - style.margin;

    constexpr double k_most_of_page = 0.32, k_least_of_page = 0.2;
    // In steps, so that the maps of a series have the same frame although their legends differ slightly.
    const double step = 0.04 * width;
    const double wanted = legend_width(legend_of(text, spec, crowding.notes_at_foot ? nothing : text.notes), style,
                                       sheet, k_most_of_page * width);
    const double column_width =
        std::clamp(step * std::ceil(wanted / step), k_least_of_page * width, k_most_of_page * width);
    const double column_left = right - column_width;

    const bool block = spec.block.logo != nullptr || !spec.block.lines.empty();
    plan.title_width = (block ? column_left - 2 * style.gap : right) - style.margin;
    plan.titles_bottom = highest_titles(sheet, style, text, plan.title_width, subtitle_later);
    if (block) {
        const double least = 4 * Sheet::line_height(style.small);
        plan.block = place_title_block(spec.block, style, sheet, {column_left, style.margin}, column_width,
                                       std::max(least, plan.titles_bottom - style.margin));
        plan.titles_bottom = std::max(plan.titles_bottom, style.margin + plan.block.height);
    }
    const double inner = width - 2 * style.margin;
    plan.foot_top = spec.height - style.margin - foot_height(sheet, style, plan.foot(spec, text), inner);

    const double band = tick_band(style), graticule_band = spec.longitude_latitude ? band : 0;
    MapFrame& frame = plan.frame;
    frame.left = static_cast<int>(std::lround(style.margin + band));
    frame.top = static_cast<int>(std::lround(plan.titles_bottom + style.gap + graticule_band));
    frame.width = static_cast<int>(column_left - 1.6 * style.gap - graticule_band) - frame.left;
    frame.height = static_cast<int>(plan.foot_top - band - style.gap / 2) - frame.top;
    plan.column = {column_left, static_cast<double>(frame.top), right, static_cast<double>(frame.top + frame.height)};
    // In the last attempts the legend begins beside the coordinates above the frame, where there is slightly more room.
    plan.column_start = plan.column.top - graticule_band;
    if (frame.width < k_least_frame_width || frame.height < k_least_frame_height) return std::nullopt;
    return plan;
}

double draw_page_head(Sheet& sheet, const PagePlan& plan, const MapSpec& spec, bool subtitle_later,
                      Point& subtitle_at) {
    const PageStyle& style = plan.style;
    const TitleResult titles = draw_titles(sheet, style, spec.title, spec.subtitle, subtitle_later,
                                           {style.margin, style.margin}, plan.title_width);
    subtitle_at = titles.subtitle_at;
    draw_title_block(plan.block, style, {plan.column.left, style.margin}, sheet);
    return titles.bottom;
}

double draw_orientation(Sheet& sheet, const PageStyle& style, const MapSpec& spec, const MapFrame& frame,
                        const PageBox& column, bool words_at_foot, MapLayout& layout) {
    double y = column.bottom - scale_bar_height(style);
    const ScaleBar bar =
        draw_scale_bar(sheet, style, {column.left, y}, column.width(), frame.metres_per_pixel(), spec.words);
    layout.scale_bar = bar.box;
    layout.scale_bar_metres = bar.metres;
    y -= style.gap;
    const std::string words = convergence_words(spec.convergence_deg, spec.words);
    if (!words.empty() && !words_at_foot) {
        const std::vector<std::string> lines = sheet.wrapped(words, style.small, column.width());
        y -= Sheet::line_height(style.small) * static_cast<double>(lines.size());
        sheet.lines(lines, {column.left, y}, style.small, Across::left);
        y -= style.gap / 2;
    }
    const double reach = north_arrow_height(style) / 2;
    y -= 2 * reach;
    layout.north_arrow = draw_north_arrow(sheet, style, {column.left + reach, y + reach}, spec.convergence_deg);
    layout.north_arrow_deg = spec.convergence_deg;
    if (spec.print.dots_per_inch > 0) {
        layout.scale = scale_of(frame.metres_per_pixel(), spec.print.dots_per_inch);
        const double left = column.left + 2 * reach + style.gap, width = column.right - left;
        const std::vector<std::string> on =
            sheet.wrapped(print_words(spec.print, spec.width, spec.height, spec.words), style.small, width);
        const double height =
            Sheet::line_height(style.heading) + Sheet::line_height(style.small) * static_cast<double>(on.size());
        const double top = y + std::max(0.0, reach - height / 2);
        const TextStyle heading =
            shrunk_to_fit(sheet.lettering(), scale_words(layout.scale, spec.words), style.heading, width, 0.6);
        sheet.text(scale_words(layout.scale, spec.words), {left, top}, heading, Across::left, Upright::top);
        sheet.lines(on, {left, top + Sheet::line_height(style.heading)}, style.small, Across::left);
    }
    return y;
}

std::optional<PagePlan> plan_series_page(const MapSpec& spec, bool subtitle_later) {
    const PageText text = series_text(spec);
    const std::vector<std::string> nothing;
    for (const Crowding& crowding : k_crowdings) {
        const auto plan = plan_page(spec, text, crowding, subtitle_later);
        if (!plan) continue;
        Sheet sheet(spec.width, spec.height);
        MapLayout layout;
        MapFrame frame = plan->frame;
        frame.window = {0, 0, static_cast<double>(frame.width), static_cast<double>(frame.height)};
        const double bottom =
            draw_legend(legend_of(text, spec, crowding.notes_at_foot ? nothing : text.notes), plan->style,
                        {plan->column.left, plan->column.top}, plan->column.width(), sheet, layout.legend);
        const double top =
            draw_orientation(sheet, plan->style, spec, frame, plan->column, crowding.notes_at_foot, layout);
        if (bottom + plan->style.gap <= top) return plan;
    }
    return std::nullopt;
}

}  // namespace frana::render
