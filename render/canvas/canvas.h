// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/geometry.h"
#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"
#include "render/vtk/functions.h"

namespace frana::render {

/// Loads VTK and OSMesa when it is first called, which takes longer than the start of the program and what `check`
/// does. Throws Error(environment) if that is not possible.
const VtkFunctions& vtk();

/// Returns the strokes of a dashed line; `dashes` are lengths of stroke, gap, stroke, gap... in the line's unit.
std::vector<Polyline> dashed(std::span<const Point> points, const std::vector<double>& dashes);

/// Pixels with opacity, colours premultiplied by it (as OpenGL blends over transparent black), from the top; `left` and
/// `top` are the position of the first one on a page.
struct OverlayImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
    int left = 0, top = 0;
};

struct LineStyle {
    double width_px = 1;
    Rgb colour{0, 0, 0};
    double opacity = 1;
    std::vector<double> dashes{};  ///< lengths of stroke, gap, stroke, gap... [px]; empty: solid
};

/// Lines and filled shapes on a transparent page, in pixels from the upper left corner; later ones cover
/// earlier ones. VTK draws them through OSMesa with smooth edges.
class Canvas {
  public:
    Canvas(int width, int height);

    void line(std::span<const Point> points, const LineStyle& style, bool closed = false);
    /// A filled convex polygon.
    void fill(std::span<const Point> corners, Rgb colour, double opacity = 1);
    void fill(const PageBox& box, Rgb colour, double opacity = 1);
    void frame(const PageBox& box, const LineStyle& style);

    /// Draws everything so far, on the part of the page that it covers. Throws Error(environment) if VTK or OpenGL
    /// fails.
    [[nodiscard]] OverlayImage draw() const;

  private:
    using Colour = std::uint32_t;  ///< red, green, blue, opacity from the lowest byte up
    void triangle(Point a, Point b, Point c, Colour colour);
    void stroke(std::span<const Point> points, const LineStyle& style);
    /// The smallest rectangle of whole pixels of the page around everything; empty if there is nothing on it.
    [[nodiscard]] OverlayImage covered() const;

    int width_, height_;
    Triangles triangles_;
};

/// Blends an overlay onto an opaque image, which must contain it, moved to the right and down.
void compose(Image& page, const OverlayImage& overlay, int right = 0, int down = 0);

}  // namespace frana::render
