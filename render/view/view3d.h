// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/raster.h"
#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"
#include "render/map/map2d.h"

namespace frana::render {

/// Where a view is taken from.
struct Camera {
    double azimuth_deg = 0;     ///< direction of looking, clockwise from grid north
    double elevation_deg = 35;  ///< how steeply the camera looks down; 1 to 89
    double zoom = 1;            ///< 1: flow and terrain round it fill the picture; 2: twice as close
};

/// Everything a view in perspective shows; members mean what they mean in MapSpec.
struct ViewSpec {
    std::string title;
    std::string subtitle;
    std::string legend_title;
    std::string unit;
    std::string attribution;
    std::string source;
    std::string palette = "depth";
    std::optional<double> maximum;
    std::vector<double> classes;
    bool continuous = false;
    std::vector<ClassLabel> categories;
    const Raster* terrain = nullptr;  ///< needed
    const Raster* layer = nullptr;    ///< draped over it; may be absent
    /// Has values wherever a layer of the same series of views has some: fixes the part of the terrain shown and the
    /// camera. May be absent: the layer itself.
    const Raster* extent = nullptr;
    const Dots* dots = nullptr;         ///< may be absent
    const Raster* thickness = nullptr;  ///< raises the surface where it has values [m]; may be absent
    std::vector<Outline> outlines;
    std::vector<std::string> side_notes;
    double vertical_exaggeration = 1;
    double convergence_deg = 0;
    Background background;  ///< instead of the relief; may be absent
    std::string crs_label;
    int width = 1600;
    int height = 1200;
    bool sky = true;               ///< behind the terrain; else white
    std::optional<Camera> camera;  ///< default: from the front of the flow, obliquely uphill
};

/// Where things of a view were drawn.
struct ViewLayout {
    PageBox page;
    PageBox picture;             ///< where the terrain is drawn
    PageBox flow;                ///< what the layer's cells cover, from the camera's geometry
    Camera camera;               ///< as used
    double north_arrow_deg = 0;  ///< clockwise from straight up on the page
    std::vector<TextBox> texts;
    std::vector<LegendEntry> legend;
};

/// Draws the terrain in perspective with the layer draped over it. Throws as draw_map does, and Error(input)
/// without terrain.
Image draw_view(const ViewSpec& spec, ViewLayout* layout = nullptr);

struct ViewPlace;

/// Views of one place that differ in layer, legend and words: the terrain is built once. All specs share the
/// terrain, the extent and the background, and the rasters outlive the series.
class ViewSeries {
  public:
    /// The same view as draw_view's; throws as it does.
    Image draw(const ViewSpec& spec, ViewLayout* layout = nullptr);

  private:
    std::shared_ptr<ViewPlace> place_;
};

}  // namespace frana::render
