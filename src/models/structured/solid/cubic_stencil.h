// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "models/structured/solid/solid_nodes.h"

namespace frana::structured {

/// Cubic B-splines (paper, equation 87), four nodes a direction, x in node spacings from the node:
///     N = |x|^3 / 2 - x^2 + 2/3 for |x| < 1,   (2 - |x|)^3 / 6 for |x| < 2
struct CubicSpline {
    /// First node touched at position s.
    static std::int64_t first(double s) noexcept { return static_cast<std::int64_t>(std::floor(s)) - 1; }
    /// Weights and derivatives (per node spacing) at position s; returns the first node touched.
    static std::int64_t evaluate(double s, double (&weight)[4], double (&slope)[4]) noexcept {
        const double base = std::floor(s), f = s - base, g = 1 - f;
        weight[0] = g * g * g / 6;
        weight[1] = 2.0 / 3 - f * f + 0.5 * f * f * f;
        weight[2] = 2.0 / 3 - g * g + 0.5 * g * g * g;
        weight[3] = f * f * f / 6;
        slope[0] = -0.5 * g * g;
        slope[1] = -2 * f + 1.5 * f * f;
        slope[2] = 2 * g - 1.5 * g * g;
        slope[3] = 0.5 * f * f;
        return static_cast<std::int64_t>(base) - 1;
    }
};

/// The sixteen nodes of a particle: weights, whose sum over the nodes that are inside and not walls is always 1, and
/// gradients [1/m].
struct CubicStencil {
    std::size_t first = 0;
    bool any = true;                          ///< false: no node near; all weights are zero
    double weight[4][4], gx[4][4], gy[4][4];  ///< rows, then columns

    CubicStencil(double x, double y, const NodeGrid& grid, const SolidNodes& nodes) noexcept {
        const NodeScale scale = grid.scale();
        const double inverse = scale.inverse_dx;
        double wx[4], wy[4], sx[4], sy[4];
        const std::int64_t i = CubicSpline::evaluate(x * inverse - 0.5, wx, sx) + scale.origin_x;
        const std::int64_t j = CubicSpline::evaluate(y * inverse - 0.5, wy, sy) + scale.origin_y;
        const bool inside = i >= 0 && j >= 0 && i + 4 <= scale.stride && j + 4 <= grid.padded_rows();
        first = inside ? static_cast<std::size_t>(j * scale.stride + i) : 0;
        for (int b = 0; b < 4; ++b) {
            for (int a = 0; a < 4; ++a) {
                weight[b][a] = wx[a] * wy[b];
                gx[b][a] = inverse * sx[a] * wy[b];
                gy[b][a] = inverse * wx[a] * sy[b];
            }
        }
        const std::uint8_t* const solid = grid.solid();
        // Ghost nodes are not inside the terrain.
        const bool within =
            i >= k_ghost && j >= k_ghost && i + 4 <= scale.stride - k_ghost && j + 4 <= grid.padded_rows() - k_ghost;
        if (within && (solid == nullptr || !any_of_sixteen(solid + first, scale.stride))) return;
        const auto active = [&](std::int64_t a, std::int64_t b) {
            if (i + a < k_ghost || j + b < k_ghost || i + a >= scale.stride - k_ghost ||
                j + b >= grid.padded_rows() - k_ghost)
                return false;
            const std::uint8_t why = solid == nullptr ? 0 : solid[(j + b) * scale.stride + i + a];
            return why != NodeGrid::k_wall && !(nodes.gaps_are_walls && why == NodeGrid::k_gap);
        };
        double sum = 0;
        for (int b = 0; b < 4; ++b) {
            for (int a = 0; a < 4; ++a) {
                if (inside && active(a, b)) {
                    sum += weight[b][a];
                } else {
                    weight[b][a] = gx[b][a] = gy[b][a] = 0;
                }
            }
        }
        any = sum > 0;
        for (auto& row : weight) {
            for (double& w : row) w = any ? w / sum : 0;
        }
    }

  private:
    // Whether any byte of four rows of four is set.
    static bool any_of_sixteen(const std::uint8_t* bytes, std::int64_t stride) noexcept {
        std::uint32_t sum = 0;
        for (int b = 0; b < 4; ++b) {
            std::uint32_t row;
            std::memcpy(&row, bytes + b * stride, sizeof row);
            sum |= row;
        }
        return sum != 0;
    }
};

}  // namespace frana::structured
