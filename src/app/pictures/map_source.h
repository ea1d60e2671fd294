// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/map_layer.h"
#include "app/store/main_statistics.h"
#include "core/geometry.h"
#include "core/raster.h"
#include "params/grammar/picture_text.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"

namespace frana::app {

/// Values that stand on every map of a result.
struct MapFacts {
    std::string model;  ///< as material.model
    std::string scheme;
    double simulated_seconds = 0;
    double volume = 0;       ///< released [m3]
    double volume_left = 0;  ///< that left the computed ground [m3]
    double last_speed = 0;   ///< greatest speed at the end [m/s]
    std::optional<MainStatistics> statistics;
};

std::string map_subtitle(const MapFacts& facts);
std::vector<std::string> map_notes(const MapFacts& facts);

/// Whether a flow whose fastest part moves so fast must be called moving [m/s].
inline constexpr double k_moving_speed = 0.1;

/// How pictures are made: the keys output.map-... of a scene, or the options of `frana render`.
struct MapStyle {
    Size size{1600, 1200};
    std::vector<std::string> formats{"png"};  ///< of png, pdf, tif
    bool continuous = false;                  ///< legend
    std::string background;                   ///< orthophoto or topographic raster; empty: the relief
    std::string attribution;                  ///< of data and author, at the foot
    double exaggeration = 1;                  ///< of heights in views
    bool sky = true;                          ///< in views; else white
    std::optional<render::Camera> camera;     ///< of views; none: found from the flow's path
};

/// What all maps of one result share. Made from a result directory alone.
struct MapSource {
    std::string title;               ///< the scene's name
    std::string subtitle;            ///< model, scheme, simulated time
    std::vector<std::string> notes;  ///< values beside the map
    std::string crs_label;
    double convergence_deg = 0;
    Raster terrain;  ///< no columns: none
    Raster extent;   ///< has values wherever the flow came, was released or surveyed; no columns: not known
    /// Longitude and latitude of a map point; may be absent.
    std::function<Point(Point)> longitude_latitude;
    MultiPolygon release;
    MultiPolygon scar;                   ///< empty: none
    std::vector<render::Outline> marks;  ///< zones, gauges, sections, profiles
    bool foreign = false;                ///< another program computed it
    MapStyle style;
};

/// A page's title: what is shown, after the result's own title, which is cut where it is long.
std::string page_title(const MapSource& source, const std::string& shown);
/// Sources of data and author, cut where they are long.
std::string page_attribution(const MapSource& source);

/// A map of one layer. The spec borrows the terrain of `source` and the values of `layer`.
render::MapSpec map_spec(const MapSource& source, const MapLayer& layer);
/// The same in perspective.
render::ViewSpec view_spec(const MapSource& source, const MapLayer& layer);

/// Where a map point of a CRS lies on the globe; absent without CRS.
std::function<Point(Point)> longitude_latitude(const std::string& crs_wkt);

/// The files that a picture becomes, as the style asks: STEM.png, STEM.pdf, and STEM.tif of what lies on the ground.
/// @param tif_stem instead of STEM, where a raster has that name
std::vector<std::string> picture_files(const MapStyle& style, const std::string& stem, bool is_on_ground,
                                       const std::string& tif_stem = "");

/// Draws layers of one result, one after the other: what they share is drawn once.
class LayerDrawer {
  public:
    /// The source must outlive the drawer and stay as it is.
    explicit LayerDrawer(const MapSource& source) : source_(source) {}

    [[nodiscard]] const MapStyle& style() const noexcept { return source_.style; }

    /// From now on each picture also as PNG in this folder, where the style asks for other formats only: a
    /// page for a browser takes no others.
    void draw_for_page_too(const std::string& folder) { page_folder_ = folder; }

    /// Draws the map STEM.png (or .pdf, .tif, as the style asks) or a view, and returns the names of the files. A view
    /// is no GeoTIFF; `tif_stem` as in picture_files. Throws Error.
    std::vector<std::string> draw(const MapLayer& layer, bool view_3d, const std::string& stem,
                                  const std::string& tif_stem = "");

  private:
    std::vector<std::string> draw_map(const MapLayer& layer, const std::vector<std::string>& files);
    [[nodiscard]] std::string page_picture(const std::string& stem) const;

    const MapSource& source_;
    std::string page_folder_;
    render::MapSeries maps_;
    render::ViewSeries views_;
};

/// Writes a picture that lies nowhere on the ground (a chart, a view) as PNG, and as PDF where the style asks.
std::vector<std::string> write_plain_picture(const render::Image& image, const MapStyle& style,
                                             const std::string& title, const std::string& stem);

}  // namespace frana::app
