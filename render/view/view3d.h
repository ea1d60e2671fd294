// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/raster.h"
#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"
#include "render/canvas/page.h"
#include "render/map/map2d.h"

namespace frana::render {

/// The viewpoint of a view.
struct Camera {
    double azimuth_deg = 0;     ///< direction of looking, clockwise from grid north
    double elevation_deg = 35;  ///< angle below the horizontal; 1 to 89
    double zoom = 1;            ///< 1: flow and surrounding terrain fill the picture; 2: twice as close
};

/// Everything in a perspective view; the layer is draped over the terrain.
struct ViewSpec : PictureSpec {
    const Raster* thickness = nullptr;  ///< raises the surface where it has values [m]; may be absent
    double vertical_exaggeration = 1;
    bool sky = true;               ///< behind the terrain; else white
    std::optional<Camera> camera;  ///< default: from the front of the flow, obliquely uphill
};

/// Places of the parts of a view.
struct ViewLayout {
    PageBox page;
    PageBox picture;             ///< area of the terrain
    PageBox flow;                ///< area of the raster's cells, from the camera's geometry
    Camera camera;               ///< as used
    double north_arrow_deg = 0;  ///< clockwise from straight up on the page
    std::vector<TextBox> texts;
    std::vector<LegendEntry> legend;
};

/// Draws the terrain in perspective with the raster draped over it. Throws as draw_map does, and Error(input) without
/// terrain.
Page view_page(const ViewSpec& spec, ViewLayout* layout = nullptr);
/// The same as pixels.
Image draw_view(const ViewSpec& spec, ViewLayout* layout = nullptr);

struct ViewPlace;

/// Views of one place that differ in raster, legend and texts: the terrain is built once. All specs share the terrain,
/// the extent and the background, and the rasters outlive the series.
class ViewSeries {
  public:
    /// Draws the same view as view_page; throws as it does.
    Page draw(const ViewSpec& spec, ViewLayout* layout = nullptr);

  private:
    std::shared_ptr<ViewPlace> place_;
};

}  // namespace frana::render
