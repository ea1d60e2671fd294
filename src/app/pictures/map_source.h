// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/pictures/map_layer.h"
#include "app/pictures/result_numbers.h"
#include "core/geometry.h"
#include "core/raster.h"
#include "core/words/sentence.h"
#include "params/grammar/value_text.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"

namespace frana::app {

/// Returns a warning that names the letters on the pictures drawn since the last call for which no font is installed;
/// none: there are none.
std::optional<Sentence> letter_warning();

/// Values on every map of a result.
struct MapFacts {
    std::string model;  ///< as material.model
    std::string scheme;
    double simulated_seconds = 0;
    double volume = 0;       ///< released [m3]
    double volume_left = 0;  ///< left through the edges of the domain [m3]
    std::optional<MainStatistics> statistics;
};

std::string map_subtitle(const MapFacts& facts, const Words& words);
std::vector<std::string> map_notes(const MapFacts& facts, const Words& words);

/// Appearance of pictures: the keys output.map-... of a scene, or the options of `frana render`.
struct MapStyle {
    Size size = *size_from_text("auto");
    std::vector<std::string> formats{"png"};  ///< of png, pdf, svg
    std::string background;                   ///< orthophoto or topographic raster; empty: the relief
    std::string context;                      ///< file of the surroundings; empty: none
    std::string attribution;                  ///< of data and author, at the foot
    std::optional<double> scale;              ///< of maps on paper, n of 1 : n
    std::optional<double> turn_deg{};      ///< of maps on their page; none: along the flow where that shows it larger
    std::string author, logo, date;        ///< title block of maps; empty: none
    double exaggeration = 1;               ///< of heights in views
    bool sky = true;                       ///< in views; else white
    std::optional<render::Camera> camera;  ///< of views; none: derived from the flow's path
    Words words{};                         ///< the language of all texts
};

/// Common data of all maps of one result, its texts in the language of its style. Made from a result directory alone.
struct MapSource {
    std::string title;               ///< the scene's name
    std::string subtitle;            ///< model, scheme, simulated time
    std::string scenario;            ///< in its place on maps and views; empty: the subtitle
    std::string one_run{};           ///< what it is, in a sentence; empty: of many runs
    Warnings warnings;               ///< that limit its use: maps are passed on without the report
    std::string terrain_source;      ///< of the elevations; empty: unknown
    std::vector<std::string> notes;  ///< values beside the map
    std::string crs_label;
    double convergence_deg = 0;
    Raster terrain;  ///< no columns: none
    Raster extent;   ///< has values wherever there was flow, release or survey; no columns: unknown
    /// Longitude and latitude of a map point; may be absent.
    std::function<Point(Point)> longitude_latitude;
    MultiPolygon release;
    std::vector<std::string> release_names{};  ///< that its polygons have in the user's file
    MultiPolygon scar;                         ///< empty: none
    MultiPolygon trace{};                      ///< drawn on values of the ground
    std::vector<render::Outline> marks;        ///< surroundings, zones, gauges, sections, profiles
    bool foreign = false;                      ///< computed by another program
    MapStyle style;
};

/// Returns the date on maps: as chosen ("none": no date), else that of the run.
std::string date_on_maps(const std::optional<std::string>& chosen, const std::string& of_run);

/// Returns the scenario; if it is not known, the subtitle. Then the warnings, as far as the page has room.
std::string scenario_line(const MapSource& source);
/// "A.  B"
std::string sentences(const std::string& first, const std::string& second);
/// Returns author and date, those that are known.
std::vector<std::string> block_lines(const MapStyle& style);

/// Returns a page's title: the result's own title, shortened if long, and the quantity shown.
std::string page_title(const MapSource& source, const std::string& shown);
/// Returns sources of data and author, shortened if long.
std::string page_attribution(const MapSource& source);
/// Returns the small print at the foot of a map: sources of terrain, background and data, author, program.
std::string map_sources(const MapSource& source);

/// Returns a map of one raster. The spec borrows the terrain of `source` and the values of `layer`.
render::MapSpec map_spec(const MapSource& source, const MapLayer& layer);
/// Returns it without scale and title block, arranged for itself: for a film.
render::MapSpec unprinted(render::MapSpec spec);
/// The same in perspective.
render::ViewSpec view_spec(const MapSource& source, const MapLayer& layer);

/// A picture in a page of ours (report.html), as the page is printed on A4: as wide as its text, and two have room on a
/// sheet unless too much is beside the map. No letter is smaller than this.
inline constexpr double k_page_picture_width_mm = 180, k_page_picture_heights_mm[] = {91, 115, 200};
inline constexpr double k_page_picture_dpi = 200, k_page_least_points = 6;

/// Returns the map of one raster as it is in a page, which has scenario and values in its text.
render::MapSpec page_map_spec(const MapSource& source, const MapLayer& layer, double height_mm);

/// Returns the function from map points of a CRS to longitude and latitude; absent without CRS.
std::function<Point(Point)> longitude_latitude(const std::string& crs_wkt);

/// Returns the files of a picture in the formats of the style: STEM.png, STEM.pdf, STEM.svg.
std::vector<std::string> picture_files(const MapStyle& style, const std::string& stem);

/// Draws rasters of one result, one after the other: common parts are drawn once.
class LayerDrawer {
  public:
    /// The source must outlive the drawer and not change.
    explicit LayerDrawer(const MapSource& source) : source_(source) {}

    [[nodiscard]] const MapStyle& style() const noexcept { return source_.style; }

    /// From now on also draws each picture for a page, as FOLDER/NAME.png.
    void draw_for_page_too(const std::string& folder) { page_folder_ = folder; }

    /// From now on a map that does not fit at the style's scale has the next round one at which it fits, and `warn`
    /// gets a sentence about it, once for a scale.
    void draw_at_next_scale(std::function<void(const Sentence&)> warn) { warn_ = std::move(warn); }

    /// Draws the map STEM.png (or .pdf, .svg, by the style) or a view, and returns the names of the files. Throws
    /// Error.
    std::vector<std::string> draw(const MapLayer& layer, bool view_3d, const std::string& stem);

  private:
    std::vector<std::string> draw_map(const MapLayer& layer, const std::vector<std::string>& files);
    render::Page map_page(render::MapSpec& spec, render::MapLayout& layout);
    void draw_for_page(const MapLayer& layer, bool view_3d, const std::string& file);

    const MapSource& source_;
    std::string page_folder_;
    std::function<void(const Sentence&)> warn_;  // absent: a scale at which a map does not fit is an error
    std::optional<double> next_scale_;           // in place of the style's
    render::MapSeries maps_;
    render::ViewSeries views_;
    render::MapSeries page_maps_;  // their ground is of another size
};

/// Writes a page without a position on the ground (a chart, a view) in the formats of the style.
std::vector<std::string> write_plain_picture(const render::Page& page, const MapStyle& style, const std::string& title,
                                             const std::string& stem);

}  // namespace frana::app
