// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "core/error.h"
#include "render/canvas/furniture.h"
#include "render/canvas/image.h"
#include "render/canvas/page.h"
#include "render/map/legend.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"
#include "render/map/map_ground.h"
#include "render/map/map_lines.h"
#include "render/map/map_page.h"

namespace frana::render {
namespace {

constexpr double k_most_of_width = 0.45;  // for the logo
constexpr double k_least_logo = 24;       // px

PageBox logo_box(const Image& logo, const PageBox& place) {
    const double most_wide = k_most_of_width * place.width();
    const double scale = std::min(most_wide / logo.width, place.height() / logo.height);
    const double width = std::floor(logo.width * scale), height = std::floor(logo.height * scale);
    if (width < 1 || height < 1 || std::max(width, height) < k_least_logo) return {};
    const double left = std::floor(place.right - width), top = std::floor(place.top);
    return {left, top, left + width, top + height};
}

}  // namespace

BlockPlace place_title_block(const TitleBlock& block, const PageStyle& style, const Sheet& sheet, Point corner,
                             double width, double most) {
    BlockPlace place;
    double left = width;
    if (block.logo) {
        place.logo = logo_box(*block.logo, {corner.x, corner.y, corner.x + width, corner.y + most});
        if (place.logo.width() > 0) left -= place.logo.width() + style.gap;
        place.height = place.logo.height();
    }
    for (const std::string& line : block.lines)
        for (const std::string& part : sheet.wrapped(line, style.small, left)) place.lines.push_back(part);
    const double height = Sheet::line_height(style.small) * static_cast<double>(place.lines.size());
    if (height > most) {
        place.lines.clear();
        place.lines_at_foot = true;
    } else {
        place.height = std::max(place.height, height);
    }
    return place;
}

void draw_title_block(const BlockPlace& place, const PageStyle& style, Point corner, Sheet& sheet) {
    TextStyle letters = style.small;
    letters.colour = k_ink;
    sheet.lines(place.lines, corner, letters, Across::left);
}

namespace {

constexpr int k_least_frame_width = 80, k_least_frame_height = 60;

/// About as long as the longest name of a quantity, of a raster's file with band and time, and of the time.
constexpr const char* k_long_title = ": Probability of a maximum depth greater than 0.5";
constexpr const char* k_long_source = "frames/cohesion_ratio_0012.tif, band 1, t = 1234.5 s";
constexpr const char* k_long_time = "t = 1234.5 s, ";

/// The legend of the depth, whose classes are as many as those of any other quantity.
ColourScale usual_scale() {
    return ColourScale(
        {"depth", {0, 0.2, 0.5, 1, 2, 5, 10, 20, 50, std::numeric_limits<double>::infinity()}, {}, nullptr, false});
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
    layout.north_arrow_deg = spec.convergence_deg + spec.turn.deg;
    layout.north_arrow = draw_north_arrow(sheet, style, {column.left + reach, y + reach}, layout.north_arrow_deg);
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

namespace {

constexpr double k_pixel_rounding = 0.5;  // of a pixel

void check(const MapSpec& spec) {
    Problems problems;
    if (spec.width < 320 || spec.height < 240 || spec.width > 16384 || spec.height > 16384) {
        problems.add({"the map's size is out of range", "",
                      std::to_string(spec.width) + " x " + std::to_string(spec.height),
                      "320 x 240 to 16384 x 16384 pixels", ""});
    }
    for (const Raster* raster : {spec.terrain, spec.layer}) {
        if (raster == nullptr) continue;
        if (raster->grid.cell_count() < 1 || !(raster->grid.cell_size > 0) ||
            raster->values.size() != static_cast<std::size_t>(raster->grid.cell_count())) {
            problems.add({"a raster to be drawn has no cells", "", "", "", ""});
        }
    }
    if (spec.window && !(spec.window->width() > 0 && spec.window->height() > 0)) {
        problems.add({"the map's window is empty", "", "", "east over west, north over south", ""});
    }
    if (spec.terrain == nullptr && spec.layer == nullptr && spec.extent == nullptr) {
        problems.add({"a map needs a terrain or a raster", "", "", "", ""});
    }
    problems.throw_if_any();
}

}  // namespace

MapPage::MapPage(const MapSpec& spec, bool for_frames, std::shared_ptr<const MapGround>& ground) {
    check(spec);
    scale_ = scale_of(spec, for_frames);
    arrange(spec, for_frames, ground);
}

void MapPage::arrange(const MapSpec& spec, bool for_frames, std::shared_ptr<const MapGround>& kept) {
    if (spec.series) {
        const auto shared = plan_series_page(spec, for_frames);
        if (shared && place(spec, *shared, for_frames, kept) <= 0) return;
    }
    // The parts of the page are reduced further until the legend fits above scale bar and arrow.
    const PageText text = own_text(spec, scale_);
    double lacking = 60;
    for (const Crowding& crowding : k_crowdings) {
        const auto plan = plan_page(spec, text, crowding, for_frames);
        if (!plan) continue;
        lacking = place(spec, *plan, for_frames, kept);
        if (lacking <= 0) return;
    }
    throw Error(ErrorKind::input, Problem{"the page is too small for the map's legend and notes", "",
                                          std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels",
                                          "about " + number(std::ceil(lacking)) + " pixels more in height",
                                          "draw a larger picture, or fewer classes, outlines or notes"});
}

double MapPage::place(const MapSpec& spec, const PagePlan& plan, bool for_frames,
                      std::shared_ptr<const MapGround>& kept) {
    const std::vector<std::string> nothing;
    const bool notes_at_foot = plan.crowding.notes_at_foot;
    const LegendContent content{spec.legend_title, spec.unit, &scale_, &spec.outlines,
                                notes_at_foot ? &nothing : &spec.side_notes};
    const double inner = spec.width - 2 * plan.style.margin;
    frame_ = plan.frame;
    frame_.turn = spec.turn;
    frame_.window = map_window(spec, frame_.width, frame_.height);
    keep_to_ground(spec, frame_);
    double lacking = 0;
    for (const Crowding& crowding : k_crowdings) {
        // The letters of the column become smaller, the rest of the page stays.
        if (crowding.density > plan.crowding.density || crowding.notes_at_foot != notes_at_foot) continue;
        const PageStyle style(spec.width, spec.height, crowding.density, spec.least_letters);
        Sheet sheet(spec.width, spec.height);
        layout_ = MapLayout{};
        layout_.page = {0, 0, static_cast<double>(spec.width), static_cast<double>(spec.height)};
        layout_.map = frame_.box();
        layout_.window = frame_.window;
        layout_.turn = frame_.turn;
        layout_.metres_per_pixel = frame_.metres_per_pixel();
        layout_.font_px = style.label.size_px;
        const double titles_bottom = draw_page_head(sheet, plan, spec, for_frames, subtitle_at_);
        lacking = titles_bottom - plan.titles_bottom;
        if (lacking > k_pixel_rounding) return lacking;

        const bool last = crowding.density == std::end(k_crowdings)[-1].density;
        const double legend_bottom =
            draw_legend(content, style, {plan.column.left, last ? plan.column_start : plan.column.top},
                        plan.column.width(), sheet, layout_.legend);
        const double arrow_top = draw_orientation(sheet, style, spec, frame_, plan.column, notes_at_foot, layout_);
        lacking = legend_bottom + style.gap - arrow_top;
        if (lacking > 0) continue;

        const MapGround& ground = ground_for(spec, frame_, kept);
        PageText text = own_text(spec, scale_);
        text.foot[2] = contour_words(ground.contours.interval, spec.words);
        const std::vector<std::string> foot = plan.foot(spec, text);
        const double bottom = spec.height - plan.style.margin;
        lacking = plan.foot_top - (bottom - foot_height(sheet, plan.style, foot, inner));
        if (lacking > k_pixel_rounding) return lacking;
        ground_ = kept;
        draw_foot(sheet, plan.style, foot, plan.style.margin, bottom, inner);
        furnish(spec, plan, style, sheet);
        Sheet lines(spec.width, spec.height);
        draw_lines(lines, PageStyle(spec.width, spec.height, plan.crowding.density, spec.least_letters), spec, ground);
        lines.append(std::move(sheet));
        layout_.texts = lines.texts();
        above_ = lines.take(for_frames);
        return 0;
    }
    return lacking;
}

void MapPage::furnish(const MapSpec& spec, const PagePlan& plan, const PageStyle& style, Sheet& sheet) {
    if (!plan.block.lines.empty() || plan.block.logo.width() > 0)
        layout_.title_block = {plan.column.left, plan.style.margin, plan.column.right,
                               plan.style.margin + plan.block.height};
    layout_.logo = plan.block.logo;
    logo_ = plan.block.logo.width() > 0 ? spec.block.logo : nullptr;
    if (!scale_.classes().empty() || (spec.layer == nullptr && spec.dots == nullptr)) return;
    TextStyle note = style.heading;
    note.halo_px = std::max(2.0, style.length(4));
    const std::string words = spec.words("no values");
    sheet.text(words, {frame_.left + frame_.width / 2.0, frame_.top + frame_.height / 2.0},
               shrunk_to_fit(sheet.lettering(), words, note, 0.9 * frame_.width, 0.5), Across::centre, Upright::middle);
}

Page MapPage::draw(const Raster* layer, const Dots* dots, const std::string& subtitle) const {
    Page page(static_cast<int>(layout_.page.width()), static_cast<int>(layout_.page.height()));
    const PageStyle style(page.width(), page.height());
    const int edge_px = std::max(1, static_cast<int>(std::lround(style.length(1))));
    Image face = ground_->face;
    if (layer != nullptr) paint_cells(face, frame_.alone(), *layer, scale_, edge_px);
    if (dots != nullptr) paint_dots(face, frame_.alone(), *dots, scale_);
    page.put(std::make_shared<const Image>(std::move(face)), frame_.left, frame_.top);
    page.put(above_);
    if (logo_)
        page.put(logo_, static_cast<int>(layout_.logo.left), static_cast<int>(layout_.logo.top),
                 layout_.logo.width() / logo_->width);
    if (!subtitle.empty()) page.put(late_subtitle(page.width(), page.height(), style, subtitle, subtitle_at_));
    return page;
}

FittingScale fitting_scale(const MapSpec& spec) {
    MapSpec free = spec;
    free.print.scale.reset();
    MapLayout layout;
    std::shared_ptr<const MapGround> ground;
    const MapPage page(free, false, ground);
    const double least = least_scale(spec.print, required_window(spec), static_cast<int>(page.layout().map.width()),
                                     static_cast<int>(page.layout().map.height()));
    return {least, round_scale_above(least)};
}

Page MapSeries::draw(const MapSpec& spec, MapLayout* layout) {
    const MapPage map(spec, false, ground_);
    if (layout != nullptr) *layout = map.layout();
    return map.draw(spec.layer, spec.dots, "");
}

Page map_page(const MapSpec& spec, MapLayout* layout) {
    return MapSeries().draw(spec, layout);
}

Image draw_map(const MapSpec& spec, MapLayout* layout) {
    return map_page(spec, layout).paint();
}

}  // namespace frana::render
