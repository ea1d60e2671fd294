// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/canvas/furniture.h"
#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/map/legend.h"
#include "render/map/map_body.h"
#include "render/map/title_block.h"

namespace frana::render {

/// The texts of a page that determine how much room its frame leaves.
struct PageText {
    std::vector<std::string> titles, subtitles;  ///< the highest pair counts
    std::string legend_title, unit;
    ColourScale scale;
    std::vector<std::string> notes, foot;  ///< `foot`: without the notes
};

std::string contour_words(double interval, const Words& words);

/// The texts of this map.
PageText own_text(const MapSpec& spec, const ColourScale& scale);
/// Texts as long as those of the longest map of its series are expected to be.
PageText series_text(const MapSpec& spec);

/// Places of the parts of a page round the map's frame.
struct PagePlan {
    Crowding crowding;
    PageStyle style;
    double titles_bottom = 0, title_width = 0;
    BlockPlace block;
    PageBox column;  ///< of the legend, beside the frame
    double column_start = 0;
    double foot_top = 0;
    MapFrame frame;  ///< without its window

    /// The small print of a map on this page.
    [[nodiscard]] std::vector<std::string> foot(const MapSpec& spec, const PageText& text) const;
};

/// Plans a page for texts. `subtitle_later`: room for one is left. None if the frame would be too small.
std::optional<PagePlan> plan_page(const MapSpec& spec, const PageText& text, const Crowding& crowding,
                                  bool subtitle_later);

/// Draws scale bar, scale and north arrow upwards from the foot of a column; returns the y of their upper edge.
double draw_orientation(Sheet& sheet, const PageStyle& style, const MapSpec& spec, const MapFrame& frame,
                        const PageBox& column, bool words_at_foot, MapLayout& layout);

/// Draws titles and title block; returns the y below them.
double draw_page_head(Sheet& sheet, const PagePlan& plan, const MapSpec& spec, bool subtitle_later, Point& subtitle_at);

/// Plans the page of a series' map: the first way of reducing its parts in which the legend of its longest map fits
/// beside the frame. None: none does.
std::optional<PagePlan> plan_series_page(const MapSpec& spec, bool subtitle_later);

}  // namespace frana::render
