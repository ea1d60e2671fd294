// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/module.h"
#include "core/point_table.h"
#include "render/canvas/canvas.h"
#include "render/canvas/lettering.h"
#include "render/libav/functions.h"
#include "render/vtk/functions.h"

namespace frana::render {

/// Loads VTK and OSMesa when it is first called, which takes longer than the start of the program and what `check`
/// does. Throws Error(environment) if that is not possible.
const VtkFunctions& vtk();

/// The same for the encoders of animations.
const LibavFunctions& libav();

/// Writes VTK XML polydata (.vtp, compressed): one vertex per point, the table's columns as point data, and the time as
/// field data "TimeValue". Written aside and renamed. Throws Error(environment).
/// @param heights z of the points [m], one per point
void write_vtk_points(const std::string& path, const PointTable& table, const std::vector<double>& heights,
                      double time);

/// A page to draw on, in pixels from the upper left corner, independent of the file format: lines and filled shapes,
/// later ones over earlier ones, and texts over all of them.
class Drawing {
  public:
    Drawing() = default;
    virtual ~Drawing() = default;
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    virtual void line(std::span<const Point> points, const LineStyle& style, bool closed = false) = 0;
    /// A filled convex polygon.
    virtual void fill(std::span<const Point> corners, Rgb colour, double opacity = 1) = 0;
    void fill(const PageBox& box, Rgb colour, double opacity = 1);
    virtual void frame(const PageBox& box, const LineStyle& style) = 0;
    virtual void text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) = 0;

    /// Writes lines one below the other, from the capitals' top of the first; returns the y below the last.
    double lines(const std::vector<std::string>& words, Point top, const TextStyle& style, Across across);
    /// Breaks a text into lines no wider than `width`; a single longer word is cut with an ellipsis.
    [[nodiscard]] std::vector<std::string> wrapped(const std::string& words, const TextStyle& style,
                                                   double width) const;
    /// From one line's capitals to the next line's [px].
    [[nodiscard]] static double line_height(const TextStyle& style) { return 1.35 * style.size_px; }
    [[nodiscard]] const Lettering& lettering() const noexcept { return lettering_; }

  private:
    Lettering lettering_;
};

}  // namespace frana::render
