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
#include "render/map/inset.h"
#include "render/map/legend.h"
#include "render/map/map_lines.h"
#include "render/map/map_window.h"
#include "render/map/page_plan.h"
#include "render/map/print_scale.h"

namespace frana::render {
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
    const bool has_values = (spec.layer != nullptr && data_bounds(*spec.layer).has_value()) ||
                            (spec.dots != nullptr && !spec.dots->dots.empty());
    if (has_values || for_frames) {
        scale_ = ColourScale({spec.palette, spec.maximum, spec.classes, spec.continuous, spec.categories, spec.layer,
                              for_frames, spec.words});
    }
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
    frame_.window = map_window(spec, frame_.width, frame_.height);
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

        const MapGround& ground = ground_for(spec, frame_, plan.crowding.density, kept);
        PageText text = own_text(spec, scale_);
        text.foot[2] = contour_words(ground.contour_interval, spec.words);
        const std::vector<std::string> foot = plan.foot(spec, text);
        const double bottom = spec.height - plan.style.margin;
        lacking = plan.foot_top - (bottom - foot_height(sheet, plan.style, foot, inner));
        if (lacking > k_pixel_rounding) return lacking;
        ground_ = kept;
        draw_foot(sheet, plan.style, foot, plan.style.margin, bottom, inner);
        furnish(spec, plan, style,
                {plan.column.left, legend_bottom + style.gap, plan.column.right, arrow_top - style.gap}, sheet);
        layout_.texts = sheet.texts();
        layout_.texts.insert(layout_.texts.end(), ground.texts.begin(), ground.texts.end());
        words_ = sheet.take();
        return 0;
    }
    return lacking;
}

void MapPage::furnish(const MapSpec& spec, const PagePlan& plan, const PageStyle& style, const PageBox& free,
                      Sheet& sheet) {
    if (!plan.block.lines.empty() || plan.block.logo.width() > 0)
        layout_.title_block = {plan.column.left, plan.style.margin, plan.column.right,
                               plan.style.margin + plan.block.height};
    layout_.logo = plan.block.logo;
    logo_ =
        plan.block.logo.width() > 0
            ? std::make_shared<const Image>(logo_picture(*spec.block.logo, static_cast<int>(plan.block.logo.width()),
                                                         static_cast<int>(plan.block.logo.height())))
            : nullptr;
    std::optional<MapFrame> inset;
    if (spec.inset && spec.terrain != nullptr)
        inset = inset_frame(spec.terrain->grid.bounds(), frame_.window, style, free);
    if (inset) {
        inset_ = std::make_shared<const Image>(draw_inset(sheet, style, *inset, *spec.terrain, frame_.window));
        layout_.inset = inset->box();
        layout_.inset_window = inset->window;
    }
    if (!scale_.classes().empty() || (spec.layer == nullptr && spec.dots == nullptr)) return;
    TextStyle note = style.heading;
    note.halo_px = std::max(2.0, style.length(4));
    const std::string words = spec.words("nothing to show: the raster has no values");
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
    page.put(std::move(face), frame_.left, frame_.top);
    page.put(ground_->above);
    if (logo_) page.put(logo_, static_cast<int>(layout_.logo.left), static_cast<int>(layout_.logo.top));
    if (layout_.inset) page.put(inset_, static_cast<int>(layout_.inset->left), static_cast<int>(layout_.inset->top));
    page.put(words_);
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

}  // namespace frana::render
