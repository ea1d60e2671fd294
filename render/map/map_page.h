// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/canvas/furniture.h"
#include "render/canvas/map_layout.h"
#include "render/canvas/page.h"
#include "render/map/legend.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"
#include "render/map/map_ground.h"

namespace frana::render {

/// Where the parts of a title block are on a page.
struct BlockPlace {
    std::vector<std::string> lines;  ///< broken to the width left of the logo; empty: none, or at the foot
    bool lines_at_foot = false;      ///< there are too many for their place
    PageBox logo;                    ///< empty: none, or it would be too small to be recognised
    double height = 0;
};

/// Arranges a title block in a place beside the title. It never needs more height than `most`: the logo becomes smaller
/// and is omitted if that would make it smaller than 24 pixels; lines that do not fit go to the foot of the page.
BlockPlace place_title_block(const TitleBlock& block, const PageStyle& style, const Sheet& sheet, Point corner,
                             double width, double most);

/// Writes the lines; the caller puts the logo on the page.
void draw_title_block(const BlockPlace& place, const PageStyle& style, Point corner, Sheet& sheet);

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

/// A map without its raster: ground, legend and texts drawn once, to receive one raster after another.
class MapPage {
  public:
    /// `for_frames`: rasters other than the spec's will follow, each with its own subtitle. `ground` is used if it
    /// fits, else replaced.
    MapPage(const MapSpec& spec, bool for_frames, std::shared_ptr<const MapGround>& ground);

    /// Draws the map with a raster and dots (none if null) and a subtitle; the latter only if the page was made for
    /// frames.
    [[nodiscard]] Page draw(const Raster* layer, const Dots* dots, const std::string& subtitle) const;

    [[nodiscard]] const MapLayout& layout() const noexcept { return layout_; }
    [[nodiscard]] const ColourScale& scale() const noexcept { return scale_; }

  private:
    void arrange(const MapSpec& spec, bool for_frames, std::shared_ptr<const MapGround>& ground);
    /// Draws everything on a planned page; returns the height that is lacking [px], 0 if it fits.
    double place(const MapSpec& spec, const PagePlan& plan, bool for_frames, std::shared_ptr<const MapGround>& ground);
    /// Logo, and the note on an empty map.
    void furnish(const MapSpec& spec, const PagePlan& plan, const PageStyle& style, Sheet& sheet);

    ColourScale scale_;
    MapFrame frame_;
    MapLayout layout_;
    std::shared_ptr<const MapGround> ground_;
    std::shared_ptr<const Overlay> above_;  ///< everything over the picture, title, legend, scale, foot
    std::shared_ptr<const Image> logo_;     ///< null: none
    Point subtitle_at_;
};

}  // namespace frana::render
