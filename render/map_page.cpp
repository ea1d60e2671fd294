// SPDX-License-Identifier: Apache-2.0
#include "render/map_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/error.h"
#include "render/furniture.h"
#include "render/graticule.h"
#include "render/inset.h"
#include "render/legend.h"
#include "render/map_lines.h"
#include "render/map_window.h"
#include "render/page_style.h"
#include "render/raster_window.h"
#include "render/sheet.h"
#include "render/ticks.h"

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
    if (spec.terrain == nullptr && spec.layer == nullptr && !spec.window) {
        problems.add({"a map needs a terrain, a layer or a window", "", "", "", ""});
    }
    problems.throw_if_any();
}

/// Parts of the page beside the map frame, measured before anything is placed.
struct Column {
    double left, top, width, bottom;
};

void cover_outside(Canvas& canvas, const PageBox& page, const PageBox& map) {
    const Rgb paper{255, 255, 255};
    canvas.fill(PageBox{page.left, page.top, page.right, map.top}, paper);
    canvas.fill(PageBox{page.left, map.bottom, page.right, page.bottom}, paper);
    canvas.fill(PageBox{page.left, map.top, map.left, map.bottom}, paper);
    canvas.fill(PageBox{map.right, map.top, page.right, map.bottom}, paper);
}

/// Draws scale bar, north arrow and its words upwards from the column's foot; returns the y of their upper
/// edge.
double draw_orientation(Sheet& sheet, const PageStyle& style, const MapSpec& spec, const MapFrame& frame,
                        const Column& column, MapLayout& layout) {
    double y = column.bottom - scale_bar_height(style);
    const ScaleBar bar =
        draw_scale_bar(sheet, style, {column.left, y}, column.width, frame.metres_per_pixel());
    layout.scale_bar = bar.box;
    layout.scale_bar_metres = bar.metres;
    y -= style.gap;
    const std::string words = convergence_words(spec.convergence_deg);
    if (!words.empty()) {
        const std::vector<std::string> lines = sheet.wrapped(words, style.small, column.width);
        y -= Sheet::line_height(style.small) * static_cast<double>(lines.size());
        sheet.lines(lines, {column.left, y}, style.small, Across::left);
        y -= style.gap / 2;
    }
    const double reach = north_arrow_height(style) / 2;
    y -= 2 * reach;
    layout.north_arrow =
        draw_north_arrow(sheet, style, {column.left + reach, y + reach}, spec.convergence_deg);
    layout.north_arrow_deg = spec.convergence_deg;
    return y;
}

}  // namespace

MapPage::MapPage(const MapSpec& spec, bool for_frames) {
    check(spec);
    const bool has_values = spec.layer != nullptr && data_bounds(*spec.layer).has_value();
    if (has_values || for_frames) {
        scale_ =
            ColourScale({spec.palette, spec.maximum, spec.classes, spec.continuous, spec.categories, spec.layer,
                         for_frames});
    }
    arrange(spec, for_frames);
}

void MapPage::arrange(const MapSpec& spec, bool for_frames) {
    const PageBox page{0, 0, static_cast<double>(spec.width), static_cast<double>(spec.height)};
    const LegendContent content{spec.legend_title, spec.unit, &scale_, &spec.outlines, &spec.side_notes};
    constexpr double k_last_density = 0.66;
    // Letters are made smaller until the legend fits above scale bar and arrow.
    double lacking = 0;
    for (const double density : {1.0, 0.88, 0.77, k_last_density}) {
        const PageStyle style(spec.width, spec.height, density);
        Sheet sheet(spec.width, spec.height);
        layout_ = MapLayout{};
        layout_.page = page;
        layout_.font_px = style.label.size_px;

        const TitleResult titles = draw_titles(sheet, style, spec.title, spec.subtitle, for_frames,
                                               {style.margin, style.margin}, page.width() - 2 * style.margin);
        subtitle_at_ = titles.subtitle_at;

        constexpr double k_most_of_page = 0.32, k_least_of_page = 0.15;
        const double column_width =
            std::max(k_least_of_page * page.width(),
                     legend_width(content, style, sheet, k_most_of_page * page.width()));
        const double band = tick_band(style), graticule_band = spec.longitude_latitude ? band : 0;
        // The foot's height is known only by setting it; contour and grid remarks join it below, on the final
        // sheet.
        std::string remark;
        const auto foot_parts = [&] {
            return std::vector<std::string>{spec.source, spec.crs_label, remark, spec.attribution};
        };
        if (spec.terrain != nullptr && spec.contours) remark = "contour interval 1000 m";
        Sheet trial(spec.width, spec.height);
        const double foot_top = draw_foot(trial, style, foot_parts(), style.margin,
                                          page.bottom - style.margin, page.width() - 2 * style.margin);

        frame_.left = static_cast<int>(std::lround(style.margin + band));
        frame_.top = static_cast<int>(std::lround(titles.bottom + style.gap + graticule_band));
        frame_.width = static_cast<int>(page.right - style.margin - column_width - 1.6 * style.gap - graticule_band) -
                       frame_.left;
        frame_.height = static_cast<int>(foot_top - band - style.gap / 2) - frame_.top;
        if (frame_.width < 80 || frame_.height < 60) {
            lacking = 60;
            continue;
        }
        frame_.window = map_window(spec, static_cast<double>(frame_.width) / frame_.height);
        layout_.map = frame_.box();
        layout_.window = frame_.window;
        layout_.metres_per_pixel = frame_.metres_per_pixel();

        // On the last try the legend begins beside the coordinates above the frame, where there is a little more room.
        const double column_top = frame_.top - (density == k_last_density ? graticule_band : 0);
        const Column column{page.right - style.margin - column_width, column_top, column_width,
                            static_cast<double>(frame_.top + frame_.height)};
        Canvas& canvas = sheet.canvas();
        draw_place_names(sheet, style, frame_, spec.outlines);
        double interval = 0;
        if (spec.terrain != nullptr && spec.contours) {
            interval = draw_contours(sheet, style, frame_, *spec.terrain, spec.layer, spec.outlines);
        }
        draw_outlines(sheet, style, frame_, spec.outlines);
        cover_outside(canvas, page, frame_.box());
        const bool projected = !(spec.layer != nullptr ? spec.layer : spec.terrain)->grid.crs_wkt.empty();
        draw_coordinates(sheet, style, frame_, projected);
        if (spec.longitude_latitude) draw_graticule(sheet, style, frame_, spec.longitude_latitude);
        canvas.frame(frame_.box(), {style.line(2), k_ink, 1, {}});
        remark = interval > 0 ? "contour interval " + number(interval) + " m" : "";
        draw_foot(sheet, style, foot_parts(), style.margin, page.bottom - style.margin,
                  page.width() - 2 * style.margin);

        const double legend_bottom =
            draw_legend(content, style, {column.left, column.top}, column.width, sheet, layout_.legend);
        const double arrow_top = draw_orientation(sheet, style, spec, frame_, column, layout_);
        lacking = legend_bottom + style.gap - arrow_top;
        if (lacking > 0) continue;
        std::optional<MapFrame> inset;
        if (spec.inset && spec.terrain != nullptr) {
            inset = inset_frame(spec.terrain->grid.bounds(), frame_.window, style,
                                {column.left, legend_bottom + style.gap, column.left + column_width,
                                 arrow_top - style.gap});
        }
        if (inset) {
            inset_ = draw_inset(style, *inset, *spec.terrain, frame_.window);
            layout_.inset = inset->box();
            layout_.inset_window = inset->window;
        }

        if (scale_.classes().empty() && spec.layer != nullptr) {
            TextStyle note = style.heading;
            note.halo_px = std::max(2.0, style.length(4));
            sheet.text("nothing to show: the layer has no values",
                       {frame_.left + frame_.width / 2.0, frame_.top + frame_.height / 2.0},
                       shrunk_to_fit(sheet.lettering(), "nothing to show: the layer has no values", note,
                                     0.9 * frame_.width, 0.5),
                       Across::centre, Upright::middle);
        }
        layout_.texts = sheet.texts();
        above_ = sheet.draw();
        ground_ = Image(spec.width, spec.height);
        for (int row = frame_.top; row < frame_.top + frame_.height; ++row) {
            for (int x = frame_.left; x < frame_.left + frame_.width; ++x) {
                std::uint8_t* p = ground_.pixel(x, row);
                p[0] = k_no_terrain.r;
                p[1] = k_no_terrain.g;
                p[2] = k_no_terrain.b;
            }
        }
        if (spec.background) {
            paint_background(ground_, frame_, spec.background);
        } else if (spec.terrain != nullptr) {
            paint_relief(ground_, frame_, *spec.terrain);
        }
        return;
    }
    throw Error(ErrorKind::input,
                Problem{"the page is too small for the map's legend and notes", "",
                        std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels",
                        "about " + number(std::ceil(lacking)) + " pixels more in height",
                        "draw a larger picture, or fewer classes, outlines or notes"});
}

Image MapPage::draw(const Raster* layer, const std::string& subtitle) const {
    Image image = ground_;
    if (layer != nullptr) paint_cells(image, frame_, *layer, scale_);
    compose(image, above_);
    if (layout_.inset) {
        for (int row = 0; row < inset_.height; ++row) {
            std::memcpy(image.pixel(static_cast<int>(layout_.inset->left), static_cast<int>(layout_.inset->top) + row),
                        inset_.pixel(0, row), 3 * static_cast<std::size_t>(inset_.width));
        }
    }
    if (!subtitle.empty()) {
        const PageStyle style(image.width, image.height);
        const Lettering lettering;
        const double width = image.width - 2 * style.margin;
        lettering.write(image, subtitle, subtitle_at_,
                        shrunk_to_fit(lettering, subtitle, style.subtitle, width, 0.5), Across::left,
                        Upright::top);
    }
    return image;
}

}  // namespace frana::render
