// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"
#include "render/map/legend.h"
#include "render/map/map2d.h"
#include "render/vtk/functions.h"

namespace frana::render {

/// A window of the ground in whole pixels of a page.
struct MapFrame {
    int left = 0, top = 0, width = 0, height = 0;  ///< [px]
    Bounds window;                                 ///< in coordinates of the page (MapTurn)
    MapTurn turn{};

    [[nodiscard]] double metres_per_pixel() const { return window.width() / width; }
    /// Map coordinates of a pixel's centre.
    [[nodiscard]] Point ground(int column, int row) const {
        return turn.map(
            {window.west + (column + 0.5) * metres_per_pixel(), window.north - (row + 0.5) * metres_per_pixel()});
    }
    /// Pixels of the page, from its upper left corner.
    [[nodiscard]] Point page(Point map) const {
        const Point p = turn.page(map);
        return {left + (p.x - window.west) / metres_per_pixel(), top + (window.north - p.y) / metres_per_pixel()};
    }
    /// The least box of map coordinates that contains the window.
    [[nodiscard]] Bounds ground_bounds() const;
    /// The same window in the corner of a picture of its own.
    [[nodiscard]] MapFrame alone() const { return {0, 0, width, height, window, turn}; }
    [[nodiscard]] PageBox box() const {
        return {static_cast<double>(left), static_cast<double>(top), static_cast<double>(left + width),
                static_cast<double>(top + height)};
    }
};

/// Maps shading (0 to 1) to a light grey behind colours and lines. The range of the visible values is spread over the
/// tones, so that neither sunny nor shady hillsides are flat; level land is not stretched into noise.
class ReliefTones {
  public:
    explicit ReliefTones(const Raster& shade);
    [[nodiscard]] Rgb colour(double shade) const {
        const double fraction = std::clamp((shade - darkest_) / (brightest_ - darkest_), 0.0, 1.0);
        return tones_[static_cast<std::size_t>(std::lround(fraction * k_steps))];
    }

  private:
    /// Sets the range of the values and returns the exponent of the tones.
    double fit(std::vector<double>& values);

    static constexpr int k_steps = 1023;  // four per step of a byte
    double darkest_ = 0, brightest_ = 1;
    std::array<Rgb, k_steps + 1> tones_{};
};

/// Loads VTK and OSMesa when it is first called, which takes longer than the start of the program and what `check`
/// does. Throws Error(environment) if that is not possible.
const VtkFunctions& vtk();

/// Colours of the ground inside a box, north up.
struct GroundTexture {
    Bounds box;
    Image image;
};
/// Shaded relief of the part of a terrain in a window (raster_window), a texel for each cell; pale grey where there is
/// none. Without texels if window and terrain do not overlap.
GroundTexture relief_texture(const Raster& terrain, const Bounds& window, std::int64_t most_cells);

/// Lays a picture of the same size over an image (Background), its colours lighter by a fraction of the way to white.
void lay(Image& under, const std::vector<std::uint8_t>& picture, double lighter);

/// Draws a texture inside a frame, interpolated between texels; pale grey beside it.
Image draw_ground(const MapFrame& frame, const GroundTexture& texture);

/// The ground of a map without its raster: a user's picture, slightly lighter so that lines and colours are visible on
/// it, else the relief; plain without either.
Image ground_picture(const MapFrame& frame, const Raster* terrain, const Background& background);

/// Paints cells in the colours of their classes, lighter and darker as the ground below, which is seen through them. A
/// pixel's class is that of the mean of the cells around it, so that their edges are smooth. The ground within the
/// given number of pixels beside them is darkened: the edge of the palest class must be visible on bright ground and in
/// print without colours.
void paint_cells(Image& page, const MapFrame& frame, const Raster& layer, const ColourScale& scale, int edge_px);

/// Paints particles as dots in the colours of their values' classes.
void paint_dots(Image& page, const MapFrame& frame, const Dots& dots, const ColourScale& scale);

}  // namespace frana::render
