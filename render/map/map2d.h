// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/geometry.h"
#include "core/raster.h"
#include "core/words/words.h"
#include "render/canvas/image.h"
#include "render/canvas/lettering.h"
#include "render/canvas/map_layout.h"
#include "render/canvas/page.h"

namespace frana::render {

/// A place with its name written beside it.
struct NamedPlace {
    std::string name;
    Point place;
};

/// Outlines of areas, lines and places of one kind, drawn over a map, with an entry in its legend. All in map
/// coordinates of the map's CRS.
struct Outline {
    std::string label;
    MultiPolygon polygons;
    Rgb colour{0, 0, 0};
    double width_px = 2.5;  ///< on a page 1200 pixels high; scales with the page
    bool dashed = false;
    std::vector<Polyline> lines{};     ///< open ones
    std::vector<std::string> names{};  ///< of the lines, in their order; empty: none; not in a perspective view
    std::vector<NamedPlace> places{};  ///< small triangles; no names in a perspective view
    bool frames_map = true;            ///< whether the map's extent contains its polygons
};

/// A particle, coloured by a value.
struct Dot {
    Point place;
    double above = 0;  ///< above the bed [m], for views
    double value = 0;
};

/// Particles at one instant.
struct Dots {
    std::vector<Dot> dots;  ///< later ones over earlier ones
    double width_m = 1;     ///< diameter on the ground; at least a pixel is drawn
};

/// Returns the background of a map: `width` x `height` pixels of the ground inside `window`, row by row from the top.
/// Of each red, green and blue, multiplied by the opacity that follows; 0 where there is nothing.
using Background = std::function<std::vector<std::uint8_t>(const Bounds& window, int width, int height)>;

/// One value of a class raster, e.g. 1 "hit".
struct ClassLabel {
    double value = 0;
    std::string label;
    Rgb colour;
};

/// Size of a map when it is printed, from which its scale follows.
struct Print {
    double dots_per_inch = 0;     ///< 0: not printed (a film), no scale is written
    std::string sheet;            ///< "A4": the page is a sheet of paper; empty: it has the size of its pixels
    std::optional<double> scale;  ///< n of 1 : n, exactly; none: a round one
};

/// Who made a map, and when: in the corner above its legend.
struct TitleBlock {
    std::shared_ptr<const Image> logo;  ///< null: none
    std::vector<std::string> lines;     ///< author, date
};

/// What all maps of a series share. The frame leaves room for the other texts of any of them, so that it is the same on
/// all pages of a size.
struct SeriesText {
    std::string title, subtitle;     ///< their common beginning
    std::vector<std::string> notes;  ///< beside most of them
    bool has_notes = true;           ///< room for notes and a time is left
};

/// What maps and views have in common. Rasters are borrowed and must outlive the call; all coordinates are in one CRS.
struct PictureSpec {
    std::string title;
    std::string subtitle;
    std::string legend_title;         ///< "Maximum depth"
    std::string unit;                 ///< "m"; empty: none
    std::string attribution;          ///< small print at the foot
    std::string source;               ///< the same: file, band and time of the raster
    const Raster* terrain = nullptr;  ///< relief and contour lines; may be absent on a map
    const Raster* layer = nullptr;    ///< coloured cells; NaN is transparent; may be absent
    /// Has values wherever a raster of the same series has some: defines the part of the terrain that is shown, and
    /// contours' labels avoid it. May be absent: the layer itself.
    const Raster* extent = nullptr;
    const Dots* dots = nullptr;          ///< over the layer, in the same colours; may be absent
    std::string palette = "depth";       ///< name of a palette in core/colour.h
    std::vector<double> classes;         ///< rising bounds, first and last may be infinite; empty: by the values
    std::vector<ClassLabel> categories;  ///< not empty: the raster's values are classes, exactly these
    std::vector<Outline> outlines;
    std::vector<std::string> side_notes;  ///< lines of values beside the picture, below the legend
    double convergence_deg = 0;           ///< true north from grid north, clockwise positive
    std::string crs_label;                ///< "EPSG:32632 (WGS 84 / UTM zone 32N)"
    int width = 1600;                     ///< pixels
    int height = 1200;
    int least_letters = k_least_letters;  ///< font size of the smallest [px]
    Background background;                ///< replaces the relief; may be absent
    Words words{};                        ///< of the furniture; the texts above are in its language already
};

/// Everything on a map.
struct MapSpec : PictureSpec {
    bool layer_frames_map = true;  ///< the layer's values must be visible, not the extent's alone
    MapTurn turn{};                ///< of the map on its page
    Print print;
    TitleBlock block;
    std::optional<SeriesText> series;  ///< none: the page is arranged for its own texts alone
    std::optional<Bounds> window;      ///< must be visible; default: flow and outlines with a margin
    bool contours = true;
    /// Longitude and latitude in degrees of a map point, for the labels on the upper and right side; may be absent.
    std::function<Point(Point)> longitude_latitude;
};

/// Returns the turn with which the longer principal axis of the flow's cells lies level, or `upright`, none: whichever
/// is nearer; grid north as far up as possible. In whole degrees.
MapTurn turn_along_content(const MapSpec& spec, std::optional<bool> upright);

/// The scales at which a map's content fits its frame.
struct FittingScale {
    double least = 0;  ///< the content fits with a small margin at this n of 1 : n and all greater ones
    double round = 0;  ///< the least round one of these
};
/// Returns them for a spec with `print.dots_per_inch`. Throws as map_page does, but not for a scale that does not fit.
FittingScale fitting_scale(const MapSpec& spec);

/// Draws a map on a page of width x height pixels: relief, seen through cells in the legend's colours, outlines, frame
/// with coordinates, legend, scale bar, north arrow. An empty raster is drawn with a note. Fills `layout`, if given.
/// Throws Error(input) if the spec contradicts itself or the page is too small for its texts or for the content at its
/// scale, and Error(environment) if
/// the picture cannot be drawn (missing font, broken OpenGL).
Page map_page(const MapSpec& spec, MapLayout* layout = nullptr);
/// The same as pixels.
Image draw_map(const MapSpec& spec, MapLayout* layout = nullptr);

struct MapGround;

/// Maps of one place that differ in raster, legend and texts: relief, lines and coordinates are drawn once if the frame
/// is the same. All specs share the terrain, the extent, the background and `longitude_latitude`, and the rasters
/// outlive the series.
class MapSeries {
  public:
    /// Draws the same map as map_page; throws as it does.
    Page draw(const MapSpec& spec, MapLayout* layout = nullptr);

  private:
    std::shared_ptr<const MapGround> ground_;
};

}  // namespace frana::render
