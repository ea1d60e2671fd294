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

/// Everything in a perspective view; members as in MapSpec.
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
    std::vector<ClassLabel> categories;
    const Raster* terrain = nullptr;  ///< required
    const Raster* layer = nullptr;    ///< draped over it; may be absent
    /// Has values wherever a raster of the same series of views has some: defines the visible part of the terrain and
    /// the camera. May be absent: the layer itself.
    const Raster* extent = nullptr;
    const Dots* dots = nullptr;         ///< may be absent
    const Raster* thickness = nullptr;  ///< raises the surface where it has values [m]; may be absent
    std::vector<Outline> outlines;
    std::vector<std::string> side_notes;
    double vertical_exaggeration = 1;
    double convergence_deg = 0;
    Background background;  ///< replaces the relief; may be absent
    std::string crs_label;
    int width = 1600;
    int height = 1200;
    int least_letters = k_least_letters;
    bool sky = true;               ///< behind the terrain; else white
    std::optional<Camera> camera;  ///< default: from the front of the flow, obliquely uphill
    Words words{};
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
