// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "mpm/node_grid.h"

namespace frana {

/// Bilinear hat functions (paper, equations 20-21): two nodes per direction, gradient discontinuous at nodes.
struct HatShape {
    static constexpr int width = 2;

    /// Computes weights and derivatives (per node spacing) at position s in node spacings; returns the first node
    /// touched.
    static std::int64_t evaluate(double s, double (&weight)[2], double (&slope)[2]) noexcept {
        const double base = std::floor(s);
        const double f = s - base;
        weight[0] = 1 - f;
        weight[1] = f;
        slope[0] = -1;
        slope[1] = 1;
        return static_cast<std::int64_t>(base);
    }
};

/// Quadratic B-splines: three nodes per direction, continuous gradient, no cell-crossing noise (Steffen, Kirby, Berzins
/// 2008).
struct QuadraticSplineShape {
    static constexpr int width = 3;

    static std::int64_t evaluate(double s, double (&weight)[3], double (&slope)[3]) noexcept {
        const double base = std::floor(s + 0.5);
        const double f = s - base;  // in [-1/2, 1/2)
        weight[0] = 0.5 * (0.5 - f) * (0.5 - f);
        weight[1] = 0.75 - f * f;
        weight[2] = 0.5 * (0.5 + f) * (0.5 + f);
        slope[0] = f - 0.5;
        slope[1] = -2 * f;
        slope[2] = f + 0.5;
        return static_cast<std::int64_t>(base) - 1;
    }
};

/// The nodes that a particle touches: index of the south-western one, weights and gradients per direction, and the
/// vector from the particle to that first node.
template <class Shape>
struct Stencil {
    static constexpr int width = Shape::width;
    std::size_t first;
    double wx[width], wy[width];    // [-]
    double gx[width], gy[width];    // [1/m]
    double to_first_x, to_first_y;  // [m]

    /// @param x, y local metres, inside the grid
    Stencil(double x, double y, const NodeScale& grid) noexcept {
        const std::int64_t i = Shape::evaluate(x * grid.inverse_dx - 0.5, wx, gx);
        const std::int64_t j = Shape::evaluate(y * grid.inverse_dx - 0.5, wy, gy);
        for (int a = 0; a < width; ++a) {
            gx[a] *= grid.inverse_dx;
            gy[a] *= grid.inverse_dx;
        }
        first = grid.index(i, j);
        to_first_x = (static_cast<double>(i) + 0.5) * grid.dx - x;
        to_first_y = (static_cast<double>(j) + 0.5) * grid.dx - y;
    }
};

/// A scalar and its gradient, interpolated from nodes.
struct Interpolated {
    double value, dx, dy;
};

template <class Shape>
Interpolated interpolate(const Stencil<Shape>& s, const double* nodes, std::int64_t stride) noexcept {
    Interpolated r{0, 0, 0};
    for (int b = 0; b < Shape::width; ++b) {
        const double* row = nodes + s.first + b * stride;
        double value = 0, slope = 0;
        for (int a = 0; a < Shape::width; ++a) {
            value += s.wx[a] * row[a];
            slope += s.gx[a] * row[a];
        }
        r.value += s.wy[b] * value;
        r.dx += s.wy[b] * slope;
        r.dy += s.gy[b] * value;
    }
    return r;
}

}  // namespace frana
