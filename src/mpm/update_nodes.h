// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mpm/node_grid.h"
#include "mpm/node_tiles.h"
#include "physics/friction_voellmy.h"

namespace frana {

/// How steep terrain enters the map-plane equations (specification, section 5), as compile-time choices.
struct GentleSlope {
    static constexpr bool metric = false, thin_layer = false;
};
struct SurfaceSlope {
    static constexpr bool metric = true, thin_layer = false;
};
struct NormalSlope {
    static constexpr bool metric = true, thin_layer = true;
};

struct NodeUpdate {
    double dt = 0;
    double gravity = 0;             ///< g_z [m/s2]
    double gravity_x = 0, gravity_y = 0;  ///< tilted gravity for verification [m/s2]
    double minimum_depth = 0;       ///< depth from which a node counts in the maxima [m]
};

/// What a tile's nodes showed in a step.
struct NodeReport {
    double max_depth = 0;        ///< [m]
    double max_speed = 0;        ///< along the bed [m/s]
    std::int64_t covered = 0;    ///< nodes deeper than the minimum

    void merge(const NodeReport& r) noexcept {
        max_depth = std::max(max_depth, r.max_depth);
        max_speed = std::max(max_speed, r.max_speed);
        covered += r.covered;
    }
};

/// New nodal velocities (paper, equations 31-32): gravity, pressure, then bed friction as a cap that stops but never
/// reverses. With n = 1 + |grad Z|^2 and G^-1 = I - grad Z grad Z^T / n:
///     gentle   a = -g grad(h + Z)                       friction g tan(phi) ...
///     surface  a = -(g/n) grad(h + Z)                   friction on the bed-parallel speed, g / sqrt(n) tan(phi) ...
///     normal   a = -(g/n) [ grad Z + G^-1 grad h ]      the same; the G^-1 part only where material does not pond
/// Reads NodeSums, NodeLevel (if allocated), bed; writes velocity, share, old velocity and support into NodeSums.
/// Calls observe(node, depth, speed) for every node deeper than the minimum.
template <class Slope, class Observe>
NodeReport update_nodes(const NodeRange& range, const NodeUpdate& k, const VoellmyFriction& friction, NodeGrid& nodes,
                        const Observe& observe) {
    NodeReport report;
    const std::int64_t stride = nodes.stride(), rows = nodes.padded_rows();
    const double inverse_area = 1 / (nodes.cell_size() * nodes.cell_size()), half_inverse_dx = 0.5 / nodes.cell_size();
    const double* bed = nodes.bed.data();
    const std::uint8_t* solid = nodes.solid();
    const NodeLevel* levels = nodes.levels.size() != 0 ? nodes.levels.data() : nullptr;
    NodeSums* sums = nodes.sums.data();

    range.for_each(stride, [&](std::size_t i, std::int64_t column, std::int64_t row) {
        NodeSums& node = sums[i];
        if (!(node.mass > 0)) return;
        const double inverse_mass = 1 / node.mass, depth = node.mass / node.area;
        double slope_x = 0, slope_y = 0;
        if (column > 0 && column < stride - 1) slope_x = (bed[i + 1] - bed[i - 1]) * half_inverse_dx;
        if (row > 0 && row < rows - 1) {
            const auto step = static_cast<std::size_t>(stride);
            slope_y = (bed[i + step] - bed[i - step]) * half_inverse_dx;
        }
        const double n = Slope::metric ? 1 + slope_x * slope_x + slope_y * slope_y : 1;
        const double support = levels ? levels[i].support : 0, ponding = levels ? levels[i].ponding : 0;

        // Acceleration by pressure and slope; `weight` is the part of gravity that the reference state held back.
        const double weight = k.gravity * support * (1 - ponding);
        double ax = node.fx * inverse_mass, ay = node.fy * inverse_mass;
        if constexpr (Slope::thin_layer) {
            const double rest = k.gravity - weight;  // what of -grad Z is still inside ax, ay
            const double pressure_x = ax + rest * slope_x, pressure_y = ay + rest * slope_y;
            const double along = (1 - ponding) * (slope_x * pressure_x + slope_y * pressure_y) / n;
            ax -= slope_x * along;
            ay -= slope_y * along;
        }
        ax = (ax - weight * slope_x) / n + k.gravity_x;
        ay = (ay - weight * slope_y) / n + k.gravity_y;

        const double old_u = node.px * inverse_mass, old_v = node.py * inverse_mass;
        double u = old_u + k.dt * ax, v = old_v + k.dt * ay;
        if (solid && solid[i]) u = v = 0;
        double speed2 = u * u + v * v;
        if constexpr (Slope::metric) {
            const double climb = u * slope_x + v * slope_y;
            speed2 += climb * climb;
        }
        double speed = std::sqrt(speed2);
        if (speed > 0 && friction.active()) {
            const double root = Slope::metric ? std::sqrt(n) : 1;
            const double after = friction.speed_after(speed, k.dt, k.gravity / root, k.gravity, depth / root);
            const double left = after / speed;
            u *= left;
            v *= left;
            speed = after;
        }
        const double cell_depth = shown_depth(node.mass, node.area, support, inverse_area);
        if (cell_depth >= k.minimum_depth) {
            ++report.covered;
            report.max_depth = std::max(report.max_depth, cell_depth);
            report.max_speed = std::max(report.max_speed, speed);
            observe(i, cell_depth, speed);
        }
        node.px = u;
        node.py = v;
        node.area *= inverse_area;
        node.fx = old_u;
        node.fy = old_v;
        node.support = support;
    });
    return report;
}

}  // namespace frana
