// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/canvas/map_layout.h"
#include "render/canvas/page.h"
#include "render/map/colour_scale.h"
#include "render/map/map2d.h"
#include "render/map/map_ground.h"
#include "render/map/page_plan.h"

namespace frana::render {

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
    /// Logo, inset in the free part of the column, and the note on an empty map.
    void furnish(const MapSpec& spec, const PagePlan& plan, const PageStyle& style, const PageBox& free, Sheet& sheet);

    ColourScale scale_;
    MapFrame frame_;
    MapLayout layout_;
    std::shared_ptr<const MapGround> ground_;
    Overlay words_;                       ///< title, legend, scale, foot
    std::shared_ptr<const Image> inset_;  ///< null: none
    std::shared_ptr<const Image> logo_;   ///< null: none
    Point subtitle_at_;
};

}  // namespace frana::render
