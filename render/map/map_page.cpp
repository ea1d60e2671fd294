// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_page.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/error.h"
#include "render/canvas/furniture.h"
#include "render/canvas/page_style.h"
#include "render/canvas/raster_window.h"
#include "render/canvas/sheet.h"
#include "render/canvas/ticks.h"
#include "render/map/graticule.h"
#include "render/map/inset.h"
#include "render/map/legend.h"
#include "render/map/map_lines.h"
#include "render/map/map_window.h"

namespace frana::render {
namespace {

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

/// Parts of the page beside the map frame, measured before anything is placed.
struct Column {
    double left, top, width, bottom;
};

/// Draws scale bar, north arrow and its text upwards from the column's foot; returns the y of their upper edge.
double draw_orientation(Sheet& sheet, const PageStyle& style, const MapSpec& spec, const MapFrame& frame,
                        const Column& column, bool words_at_foot, MapLayout& layout) {
    double y = column.bottom - scale_bar_height(style);
    const ScaleBar bar =
        draw_scale_bar(sheet, style, {column.left, y}, column.width, frame.metres_per_pixel(), spec.words);
    layout.scale_bar = bar.box;
    layout.scale_bar_metres = bar.metres;
    y -= style.gap;
    const std::string words = convergence_words(spec.convergence_deg, spec.words);
    if (!words.empty() && !words_at_foot) {
        const std::vector<std::string> lines = sheet.wrapped(words, style.small, column.width);
        y -= Sheet::line_height(style.small) * static_cast<double>(lines.size());
        sheet.lines(lines, {column.left, y}, style.small, Across::left);
        y -= style.gap / 2;
    }
    const double reach = north_arrow_height(style) / 2;
    y -= 2 * reach;
    layout.north_arrow = draw_north_arrow(sheet, style, {column.left + reach, y + reach}, spec.convergence_deg);
    layout.north_arrow_deg = spec.convergence_deg;
    return y;
}

}  // namespace

MapPage::MapPage(const MapSpec& spec, bool for_frames, std::shared_ptr<const MapGround>& ground) {
    check(spec);
    const bool has_values = (spec.layer != nullptr && data_bounds(*spec.layer).has_value()) ||
                            (spec.dots != nullptr && !spec.dots->dots.empty());
    if (has_values || for_frames) {
        scale_ = ColourScale({spec.palette, spec.maximum, spec.classes, spec.continuous, spec.categories, spec.layer,
                              for_frames, spec.words});
    }
    arrange(spec, for_frames, ground);
}

void MapPage::arrange(const MapSpec& spec, bool for_frames, std::shared_ptr<const MapGround>& kept) {
    const PageBox page{0, 0, static_cast<double>(spec.width), static_cast<double>(spec.height)};
    const std::vector<std::string> nothing;
    // The parts of the page are reduced further until the legend fits above scale bar and arrow.
    double lacking = 0;
    for (const Crowding& crowding : k_crowdings) {
        const double density = crowding.density;
        const bool notes_at_foot = crowding.notes_at_foot;
        const LegendContent content{spec.legend_title, spec.unit, &scale_, &spec.outlines,
                                    notes_at_foot ? &nothing : &spec.side_notes};
        const PageStyle style(spec.width, spec.height, density);
        Sheet sheet(spec.width, spec.height);
        layout_ = MapLayout{};
        layout_.page = page;
        layout_.font_px = style.label.size_px;

        const TitleResult titles = draw_titles(sheet, style, spec.title, spec.subtitle, for_frames,
                                               {style.margin, style.margin}, page.width() - 2 * style.margin);
        subtitle_at_ = titles.subtitle_at;

        constexpr double k_most_of_page = 0.32, k_least_of_page = 0.2;
        // In steps, so that the maps of a series have the same frame although their legends differ slightly.
        const double step = 0.04 * page.width();
        const double wanted = legend_width(content, style, sheet, k_most_of_page * page.width());
        const double column_width =
            std::clamp(step * std::ceil(wanted / step), k_least_of_page * page.width(), k_most_of_page * page.width());
        const double band = tick_band(style), graticule_band = spec.longitude_latitude ? band : 0;
        // The contours' interval is determined later; every interval needs about the same room.
        const auto foot_parts = [&](double interval) {
            const std::string remark =
                interval > 0 ? spec.words("contour interval {1} m", {spec.words.number(number(interval))}) : "";
            std::vector<std::string> parts = notes_at_foot ? spec.side_notes : nothing;
            if (notes_at_foot) parts.push_back(convergence_words(spec.convergence_deg, spec.words));
            parts.insert(parts.end(), {spec.source, spec.crs_label, remark, spec.attribution});
            return parts;
        };
        const double inner = page.width() - 2 * style.margin;
        const bool contours = spec.terrain != nullptr && spec.contours;
        const double foot_top =
            page.bottom - style.margin - foot_height(sheet, style, foot_parts(contours ? 1000 : 0), inner);

        frame_.left = static_cast<int>(std::lround(style.margin + band));
        frame_.top = static_cast<int>(std::lround(titles.bottom + style.gap + graticule_band));
        frame_.width =
            static_cast<int>(page.right - style.margin - column_width - 1.6 * style.gap - graticule_band) - frame_.left;
        frame_.height = static_cast<int>(foot_top - band - style.gap / 2) - frame_.top;
        if (frame_.width < 80 || frame_.height < 60) {
            lacking = 60;
            continue;
        }
        frame_.window = map_window(spec, static_cast<double>(frame_.width) / frame_.height);
        layout_.map = frame_.box();
        layout_.window = frame_.window;
        layout_.metres_per_pixel = frame_.metres_per_pixel();

        // In the last attempts the legend begins beside the coordinates above the frame, where there is slightly more
        // room.
        const bool last = density == std::end(k_crowdings)[-1].density;
        const double column_top = frame_.top - (last ? graticule_band : 0);
        const Column column{page.right - style.margin - column_width, column_top, column_width,
                            static_cast<double>(frame_.top + frame_.height)};
        const double legend_bottom =
            draw_legend(content, style, {column.left, column.top}, column.width, sheet, layout_.legend);
        const double arrow_top = draw_orientation(sheet, style, spec, frame_, column, notes_at_foot, layout_);
        lacking = legend_bottom + style.gap - arrow_top;
        if (lacking > 0) continue;
        const MapGround& ground = ground_for(spec, frame_, density, kept);
        ground_ = kept;
        draw_foot(sheet, style, foot_parts(ground.contour_interval), style.margin, page.bottom - style.margin, inner);
        std::optional<MapFrame> inset;
        if (spec.inset && spec.terrain != nullptr) {
            inset = inset_frame(
                spec.terrain->grid.bounds(), frame_.window, style,
                {column.left, legend_bottom + style.gap, column.left + column_width, arrow_top - style.gap});
        }
        if (inset) {
            inset_ = std::make_shared<const Image>(draw_inset(sheet, style, *inset, *spec.terrain, frame_.window));
            layout_.inset = inset->box();
            layout_.inset_window = inset->window;
        }

        if (scale_.classes().empty() && (spec.layer != nullptr || spec.dots != nullptr)) {
            TextStyle note = style.heading;
            note.halo_px = std::max(2.0, style.length(4));
            const std::string nothing_shown = spec.words("nothing to show: the raster has no values");
            sheet.text(nothing_shown, {frame_.left + frame_.width / 2.0, frame_.top + frame_.height / 2.0},
                       shrunk_to_fit(sheet.lettering(), nothing_shown, note, 0.9 * frame_.width, 0.5), Across::centre,
                       Upright::middle);
        }
        layout_.texts = sheet.texts();
        layout_.texts.insert(layout_.texts.end(), ground.texts.begin(), ground.texts.end());
        words_ = sheet.take();
        return;
    }
    throw Error(ErrorKind::input, Problem{"the page is too small for the map's legend and notes", "",
                                          std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels",
                                          "about " + number(std::ceil(lacking)) + " pixels more in height",
                                          "draw a larger picture, or fewer classes, outlines or notes"});
}

Page MapPage::draw(const Raster* layer, const Dots* dots, const std::string& subtitle) const {
    Page page(static_cast<int>(layout_.page.width()), static_cast<int>(layout_.page.height()));
    const PageStyle style(page.width(), page.height());
    const int edge_px = std::max(1, static_cast<int>(std::lround(style.length(1))));
    Image face = ground_->face;
    if (layer != nullptr) paint_cells(face, frame_.alone(), *layer, scale_, edge_px);
    if (dots != nullptr) paint_dots(face, frame_.alone(), *dots, scale_);
    page.put(std::move(face), frame_.left, frame_.top);
    page.put(ground_->above);
    if (layout_.inset) page.put(inset_, static_cast<int>(layout_.inset->left), static_cast<int>(layout_.inset->top));
    page.put(words_);
    if (!subtitle.empty()) page.put(late_subtitle(page.width(), page.height(), style, subtitle, subtitle_at_));
    return page;
}

}  // namespace frana::render
