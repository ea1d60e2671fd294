// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/geometry.h"
#include "render/canvas/image.h"
#include "render/chart/chart.h"

namespace frana::render {

/// A curve; a point whose y is NaN breaks it.
struct Curve {
    std::string label;
    Rgb colour;
    std::vector<Point> points;
    double width_px = 2.2;  ///< on a page 1600 x 1200
    Stroke stroke = Stroke::solid;
    std::vector<double> foot{};  ///< as many as points: the ground between them and the curve is filled palely
};

/// A pair of linear axes of its own.
struct CurvePanel {
    std::string title, x_label, y_label;
    std::vector<Curve> curves;
    bool from_zero = false;          ///< 0 is on the y axis
    bool log_x = false;              ///< points at x of 0 and less are left out
    std::optional<double> mark_x{};  ///< an upright dashed line
    double share = 1;                ///< of the page's height, compared with the panels beside it
};

/// A page of panels, one row below the other, each row `across` panels wide.
struct CurveChart {
    std::string title, subtitle, foot;
    int across = 1;
    std::vector<CurvePanel> panels;
};

/// Draws the page with VTK; `layout`, if given, receives where things are. Panels without a point say so. Throws
/// Error(input) when the page is too small and Error(environment) when fonts or OpenGL fail.
Image draw_curves(const CurveChart& chart, int width, int height, ChartLayout* layout = nullptr);

}  // namespace frana::render
