// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"
#include "render/map/legend.h"
#include "render/map/map2d.h"

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

/// Shaded relief of a terrain; pale grey where there is none.
void paint_relief(Image& page, const MapFrame& frame, const Raster& terrain);

/// Paints a user's picture of the ground, slightly lighter so that lines and colours are visible on it.
void paint_background(Image& page, const MapFrame& frame, const Background& background);

/// Paints cells in the pure colours of their classes, each pixel from the cell that contains its centre. The ground
/// within the given number of pixels beside them is darkened: the edge of the palest class must be visible on bright
/// ground and in print without colours.
void paint_cells(Image& page, const MapFrame& frame, const Raster& layer, const ColourScale& scale, int edge_px);

/// Paints particles as dots in the pure colours of their values' classes.
void paint_dots(Image& page, const MapFrame& frame, const Dots& dots, const ColourScale& scale);

}  // namespace frana::render
