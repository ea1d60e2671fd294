// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/zero_array.h"
#include "mpm/curvature.h"
#include "mpm/node_friction.h"
#include "mpm/node_grid.h"
#include "mpm/node_report.h"
#include "mpm/shown_depth.h"

namespace frana {

/// Maxima of each node over time, updated at every step. Padded as the nodes are.
struct Maxima {
    ZeroArray<double> depth;           ///< [m]; 0: never reached
    ZeroArray<double> speed;           ///< along the bed [m/s]
    ZeroArray<double> arrival_plus_1;  ///< first time reached, plus one so that zero means never [s]

    static constexpr std::size_t k_bytes = 3 * sizeof(double);  ///< per node

    Maxima() = default;
    explicit Maxima(std::size_t size) : depth(size), speed(size), arrival_plus_1(size) {}

    template <class Archive>
    void serialise(Archive& archive) {
        auto& [h, v, arrival] = *this;
        archive(h, v, arrival);
    }

    void update(std::size_t node, double node_depth, double node_speed, double time) noexcept {
        depth[node] = std::max(depth[node], node_depth);
        speed[node] = std::max(speed[node], node_speed);
        if (arrival_plus_1[node] == 0) arrival_plus_1[node] = time + 1;
    }
};

/// Effect of steep terrain in the map-plane equations (share/doc/model.md, "Unknowns"), as compile-time choices.
struct GentleSlope {
    static constexpr bool metric = false, thin_flow = false, curved = false;
};
struct SurfaceSlope {
    static constexpr bool metric = true, thin_flow = false, curved = false;
};
struct NormalSlope {
    static constexpr bool metric = true, thin_flow = true, curved = false;
};
/// With the load of motion over a curved bed (mpm/curvature.h). Particles and nodes then exchange the velocity along
/// the bed (BedFrame), so that material that moves from one slope to another keeps its energy; velocities in map view,
/// transferred from a gentle slope to a steep one, would become faster.
template <class Slope>
struct Curved : Slope {
    static constexpr bool curved = true;  // cppcheck-suppress duplInheritedMember; hides it on purpose
};

/// Driving accelerations of a node, and the slope of its bed.
struct NodeDrive {
    double ax, ay;            ///< acceleration by pressure and slope [m/s2]
    double slope_x, slope_y;  ///< of the bed [-]
    double n;                 ///< 1 + |grad Z|^2; 1 without slope correction
    double load;              ///< load of the bed's curvature, at least -g [m/s2]
    BedCurvature curvature;   ///< zero unless the slope is Curved
};

/// Returns the bed's slope at a node, from its neighbours; 0 across the outermost rings.
inline Point node_slope(const NodeGrid& nodes, std::size_t i, std::int64_t column, std::int64_t row) noexcept {
    const double half_inverse_dx = 0.5 / nodes.cell_size();
    const double* bed = nodes.bed.data();
    Point slope{0, 0};
    if (column > 0 && column < nodes.stride() - 1) slope.x = (bed[i + 1] - bed[i - 1]) * half_inverse_dx;
    if (row > 0 && row < nodes.padded_rows() - 1) {
        const auto step = static_cast<std::size_t>(nodes.stride());
        slope.y = (bed[i + step] - bed[i - step]) * half_inverse_dx;
    }
    return slope;
}

/// Returns the frame of a node's velocity along the bed: that of its slope where material follows the bed, level where
/// it ponds, since waves on still water move it horizontally however steep the ground is.
inline BedFrame node_frame(const NodeGrid& nodes, std::size_t i, std::int64_t column, std::int64_t row) noexcept {
    const Point slope = node_slope(nodes, i, column, row);
    const double follows = nodes.levels.size() != 0 ? 1 - nodes.levels[i].ponding : 1;
    return BedFrame::of({follows * slope.x, follows * slope.y});
}

/// Returns the slope at a node and the load of its curvature; no acceleration yet.
template <class Slope>
NodeDrive ground_of(const NodeGrid& nodes, const NodeUpdate& k, std::size_t i, std::int64_t column, std::int64_t row) {
    const Point slope = node_slope(nodes, i, column, row);
    NodeDrive d{0, 0, slope.x, slope.y, 1, 0, {}};
    if constexpr (Slope::metric) d.n += d.slope_x * d.slope_x + d.slope_y * d.slope_y;
    if constexpr (Slope::curved) {
        const NodeForces& node = nodes.forces()[i];
        d.curvature = bed_curvature(nodes, i, column, row);
        d.load = std::max(-k.gravity, d.curvature.load(node.px / node.mass, node.py / node.mass));
    }
    return d;
}

/// Converts the nodes' momenta along the bed to momenta in map view. Call after all are gathered and before they are
/// used.
inline void momenta_to_map(const NodeRange& range, NodeGrid& nodes) {
    range.for_each(nodes.stride(), [&](std::size_t i, std::int64_t column, std::int64_t row) {
        NodeForces& node = nodes.forces()[i];
        if (!(node.mass > 0)) return;
        const Point momentum = node_frame(nodes, i, column, row).in_map(node.px, node.py);
        node.px = momentum.x;
        node.py = momentum.y;
    });
}

/// Least fraction of g that vertical acceleration may leave as divisor: flow accelerated upwards by its bed has at most
/// twice its weight.
inline constexpr double k_least_bearing = 0.5;

/// Returns the acceleration of a node with mass. With S = grad(h + Z) and n = 1 + |grad Z|^2:
///     gentle   a = -g S
///     surface  a = -(g/n) S
///     normal   a = -g' S,  g' = g + a . grad Z = g / (1 + S . grad Z)
/// The last is the weight of a flow whose vertical acceleration is that of its bed (Denlinger and Iverson 2004, J.
/// Geophys. Res. 109, F01014). Uniform flow has g' = g / n, a level pool g' = g however steep its walls. Where the
/// surface is steeper than the bed (fronts) only the linear terms in grad h are kept, as in Savage and Hutter (1989):
///     a = -(g/n) [ grad Z + G^-1 grad h ],  G^-1 = I - grad Z grad Z^T / n
/// The load of the motion over the bed's curvature is not included: see turn_by_bed.
/// Reads NodeForces; NodeLevel (if allocated); bed.
template <class Slope>
NodeDrive drive_of(const NodeGrid& nodes, const NodeUpdate& k, std::size_t i, std::int64_t column, std::int64_t row) {
    NodeDrive d = ground_of<Slope>(nodes, k, i, column, row);
    // The part of gravity that the reference state cancelled in the particles' sum.
    const double weight =
        nodes.levels.size() != 0 ? k.gravity * nodes.levels[i].support * (1 - nodes.levels[i].ponding) : 0;
    const NodeForces& node = nodes.forces()[i];
    const double fall_x = node.fx / node.mass - weight * d.slope_x;  // -g S
    const double fall_y = node.fy / node.mass - weight * d.slope_y;
    d.ax = fall_x / d.n;
    d.ay = fall_y / d.n;
    if constexpr (Slope::thin_flow) {
        const double bearing = 1 - (fall_x * d.slope_x + fall_y * d.slope_y) / k.gravity;
        if (bearing < d.n) {
            const double divisor = std::max(k_least_bearing, bearing);
            d.ax = fall_x / divisor;
            d.ay = fall_y / divisor;
        } else {
            const double along = k.gravity * (d.n - bearing) / (d.n * d.n);  // grad Z . (-g grad h) / n^2
            d.ax -= d.slope_x * along;
            d.ay -= d.slope_y * along;
        }
    }
    d.ax += k.gravity_x;
    d.ay += k.gravity_y;
    return d;
}

/// Marks the nodes that static friction keeps at rest: NodeForces::held.
///
/// At the edge of a resting mass the outermost nodes have much pressure and little weight: each alone would creep. A
/// node slower than friction can stop in a few steps is therefore judged with its eight neighbours: it stays at rest if
/// friction on all nine can stop all nine within this step.
template <class Slope, class Friction>
void find_held_nodes(const NodeRange& range, const NodeUpdate& k, const Friction& friction, NodeGrid& nodes) {
    constexpr double k_slow = 4;
    const std::int64_t stride = nodes.stride(), rows = nodes.padded_rows();
    // A node's momentum after the step without friction, and its contribution to the bound: used by nine nodes.
    struct Pull {
        double px, py, held;
    };
    constexpr std::int64_t k_side = k_tile + 2;
    std::array<Pull, k_side * k_side> pulls;
    std::array<bool, k_side * k_side> known{};
    const auto pull = [&](std::size_t n, std::int64_t column, std::int64_t row) -> const Pull& {
        const auto place = static_cast<std::size_t>((row - range.j0 + 1) * k_side + column - range.i0 + 1);
        if (!known[place]) {
            const NodeForces& node = nodes.forces()[n];
            const NodeDrive d = drive_of<Slope>(nodes, k, n, column, row);
            pulls[place] = {node.px + k.dt * node.mass * d.ax, node.py + k.dt * node.mass * d.ay,
                            friction.held(node.mass, n, d.n, k.gravity + d.load)};
            known[place] = true;
        }
        return pulls[place];
    };
    range.for_each(stride, [&](std::size_t i, std::int64_t column, std::int64_t row) {
        NodeForces& node = nodes.forces()[i];
        if (!(node.mass > 0)) return;
        const double slow = k_slow * friction.stopped_in_step(i, k);
        if (node.px * node.px + node.py * node.py > slow * slow * node.mass * node.mass) return;
        double px = 0, py = 0, bound = 0;
        for (std::int64_t b = std::max<std::int64_t>(row - 1, 0); b <= std::min(row + 1, rows - 1); ++b) {
            for (std::int64_t a = std::max<std::int64_t>(column - 1, 0); a <= std::min(column + 1, stride - 1); ++a) {
                const auto n = static_cast<std::size_t>(b * stride + a);
                if (!(nodes.mass(n) > 0)) continue;
                const Pull& near = pull(n, a, b);
                px += near.px;
                py += near.py;
                bound += near.held;
            }
        }
        bound *= friction.held_in_step(k);
        node.held = px * px + py * py <= bound * bound ? 1 : 0;
    });
}

/// Computes new nodal velocities (paper, equations 31-32): driving forces, then bed friction as a cap on the speed
/// along the bed that stops but never reverses. Reads NodeForces, NodeLevel (if allocated), bed; converts the records
/// with mass to NodeMotion. Calls observe(node, depth, speed) for every node deeper than the minimum.
template <class Slope, class Friction, class Observe>
NodeReport update_nodes(const NodeRange& range, const NodeUpdate& k, const Friction& friction, NodeGrid& nodes,
                        const Observe& observe) {
    NodeReport report;
    const double inverse_area = 1 / (nodes.cell_size() * nodes.cell_size());
    const std::uint8_t* solid = nodes.solid();
    const NodeLevel* levels = nodes.levels.size() != 0 ? nodes.levels.data() : nullptr;
    const bool keeps_rest = friction.keeps_rest();

    range.for_each(nodes.stride(), [&](std::size_t i, std::int64_t column, std::int64_t row) {
        NodeRecord& record = nodes.records[i];
        const NodeForces node = record.forces;
        if (!(node.mass > 0)) return;
        const NodeDrive drive = drive_of<Slope>(nodes, k, i, column, row);
        const Point old{node.px / node.mass, node.py / node.mass};
        AlongBed bed = Slope::metric ? AlongBed{drive.slope_x, drive.slope_y} : AlongBed{};
        BedFrame frame;
        Point driven{old.x + k.dt * drive.ax, old.y + k.dt * drive.ay}, turned = old;
        const double follows = levels ? 1 - levels[i].ponding : 1;
        if constexpr (Slope::curved) {
            frame = node_frame(nodes, i, column, row);
            // The slope of the frame of the gathered velocity: a level flow over a lip gains no speed from the slope
            // below.
            bed = {frame.slope_x, frame.slope_y};
            // Half of the force, the rotation, the other half: second order (Strang 1968).
            const double half = 0.5 * k.dt;
            driven = {old.x + half * drive.ax, old.y + half * drive.ay};
            turn_by_bed(drive.curvature, frame, follows * k.dt, driven.x, driven.y);
            driven = {driven.x + half * drive.ax, driven.y + half * drive.ay};
            turned = {driven.x - k.dt * drive.ax, driven.y - k.dt * drive.ay};
        }
        const double driven_speed = bed.speed(driven);
        Point after = driven;
        if ((solid && solid[i]) || (keeps_rest && node.held != 0)) {
            if constexpr (Friction::remembers) friction.remember(i, driven_speed, k);
            after = {0, 0};
        } else if (driven_speed > 0 && friction.active()) {
            const double root = Slope::metric ? std::sqrt(drive.n) : 1;
            const double left =
                friction.speed_after(i, driven_speed, k, root, k.gravity + drive.load, node.mass / node.area) /
                driven_speed;
            after = {left * driven.x, left * driven.y};
        }
        const bool ghost = k.wall && (column < k_ghost || row < k_ghost || column >= nodes.stride() - k_ghost ||
                                      row >= nodes.padded_rows() - k_ghost);
        if (!ghost) {
            const double ponding = levels ? levels[i].ponding : 1;
            const double middle = 0.5 * node.mass * inverse_area * (ponding + (1 - ponding) / drive.n);
            report.count_energy(node.mass, nodes.bed[i] + middle, k.gravity, bed, old, turned, driven, after);
        }
        const double support = levels ? levels[i].support : 0;
        const double cell_depth = shown_depth(node.mass, node.area, support, node.crowding, inverse_area);
        // The particles' own mean velocity: the new nodal velocity overshoots at nodes with almost no mass.
        const double gathered = bed.speed(old);
        // Ghosts mirror nodes inside, which are already counted.
        if (!ghost && gathered > k.moving_speed) report.moving += node.mass;
        if constexpr (Slope::curved) report.unsupported += drive.load <= -k.gravity;  // however thin: tips fly first
        if (cell_depth < k.minimum_depth) {
            if (!ghost) report.thin += node.mass;
        } else {
            report.covered += ghost ? 0 : 1;
            report.max_depth = std::max(report.max_depth, cell_depth);
            report.max_speed = std::max(report.max_speed, gathered);
            observe(i, cell_depth, gathered);
        }
        report.moves = report.moves || after.x != 0 || after.y != 0;
        if (k.gathered != nullptr) k.gathered[i] = old;
        Point back = Slope::curved ? frame.along_bed(after.x, after.y) : after;
        if (k.change_only) {
            const Point before = Slope::curved ? frame.along_bed(old.x, old.y) : old;
            back = {back.x - before.x, back.y - before.y};
        }
        const double climb = Slope::curved ? after.x * drive.slope_x + after.y * drive.slope_y : 0;
        Point moves = after;
        if constexpr (Slope::curved) moves = velocity_underway(drive.curvature, frame, follows * k.drift, after);
        record.motion = {moves.x, moves.y, back.x, back.y, node.mass, node.area * inverse_area, climb, support};
    });
    return report;
}

}  // namespace frana
