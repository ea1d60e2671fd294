// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/lanes.h"
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

    /// Updates `count` nodes from `node` on, those that are `deep`.
    template <class Number>
    [[gnu::always_inline]] void update(std::size_t node, std::size_t count, typename Lanes<Number>::Mask deep,
                                       Number node_depth, Number node_speed, double time) {
        using std::max;
        using L = Lanes<Number>;
        const auto keep = [&](double* to, auto next) __attribute__((always_inline)) {
            const Number before = L::load(to, count);
            L::store(select(deep, next(before), before), to, count);
        };
        keep(
            depth.data() + node, [&](Number before) __attribute__((always_inline)) { return max(before, node_depth); });
        keep(
            speed.data() + node, [&](Number before) __attribute__((always_inline)) { return max(before, node_speed); });
        keep(
            arrival_plus_1.data() + node, [&](Number before) __attribute__((always_inline)) {
                return select(before > 0, before, Number(time + 1));
            });
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

/// The bed at a node (double) or at four in a row (Quad), whatever flows over it.
template <class Number>
struct NodeBed {
    Number slope_x = 0.0, slope_y = 0.0;
    BedCurvatureOf<Number> curvature;  ///< zero unless the slope is Curved
};

/// Driving accelerations of a node.
template <class Number>
struct NodeDrive {
    Number ax = 0.0, ay = 0.0;  ///< acceleration by pressure and slope [m/s2]
    Number n = 1.0;             ///< 1 + |grad Z|^2; 1 without slope correction
    Number load = 0.0;          ///< load of the bed's curvature, at least -g [m/s2]
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

/// Returns the bed at a node.
template <class Slope>
[[gnu::always_inline]] inline NodeBed<double> bed_at(const NodeGrid& nodes, std::size_t i, std::int64_t column,
                                                     std::int64_t row) {
    const Point slope = node_slope(nodes, i, column, row);
    NodeBed<double> bed{slope.x, slope.y, {}};
    if constexpr (Slope::curved) bed.curvature = bed_curvature(nodes, i, column, row);
    return bed;
}

/// Returns the load of a curved bed and n; no acceleration yet.
/// @param u, v velocity in map view [m/s]
template <class Slope, class Number>
[[gnu::always_inline]] inline NodeDrive<Number> load_on(const NodeBed<Number>& bed, Number u, Number v,
                                                        double gravity) {
    using std::max;
    NodeDrive<Number> d;
    if constexpr (Slope::metric) d.n = 1 + bed.slope_x * bed.slope_x + bed.slope_y * bed.slope_y;
    if constexpr (Slope::curved) d.load = max(Number(-gravity), bed.curvature.load(u, v));
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

/// Squared Froude number of the motion up the fall line from which a flow begins to be a surge, and is one: there its
/// pressure is that of a thin flow. Slower, waves outrun it and level its surface.
inline constexpr double k_surge_from = 1, k_surge_full = 4;

/// Depth of a node's flow, its motion up the bed and how far it follows the bed.
template <class Number>
struct NodeFlow {
    Number depth;    ///< [m]
    Number climb;    ///< v . grad Z [m/s]; less than 0 downhill
    Number follows;  ///< 1 - NodeLevel::ponding
};

/// Sets the acceleration of a node with mass. With S = grad(h + Z) and n = 1 + |grad Z|^2:
///     gentle   a = -g S
///     surface  a = -(g/n) S
///     normal   a = -g' S,  g' = g + a . grad Z = g / (1 + S . grad Z)
/// The last is the weight of a flow whose vertical acceleration is that of its bed (Denlinger and Iverson 2004, J.
/// Geophys. Res. 109, F01014). Uniform flow has g' = g / n, a level pool g' = g however steep its walls. Where the
/// surface is steeper than the bed (fronts) only the linear terms in grad h are kept, as in Savage and Hutter (1989):
///     a = -(g/n) [ grad Z + G^-1 grad h ],  G^-1 = I - grad Z grad Z^T / n
/// and so they are in a surge, whose surface leans from the bed's slope towards level or beyond and that climbs the
/// slope faster than waves, F^2 = n (v . grad Z)^2 / (|grad Z|^2 g h) from k_surge_from to k_surge_full: on a plane
/// only this form conserves momentum along the bed, as shocks must. With g' the side of a surge that leans up the slope
/// is pushed several times as hard as the other, and the flow gains energy. Downhill it would let flow stand too deep
/// in gullies. A push up the slope counts at most twice and accelerates upwards by at most 2 g, or as in a thin flow:
/// those who push have their own weight, not that of what they push. The load of the motion over the bed's curvature is
/// not included: see turn_by_bed.
/// @param fx, fy force over mass [m/s2]  @param weight part of gravity that the reference state cancelled in the
/// particles' sum [m/s2]  @param d of load_on
template <class Slope, class Number>
[[gnu::always_inline]] inline void accelerate(const NodeBed<Number>& bed, const NodeFlow<Number>& flow, Number fx,
                                              Number fy, Number weight, const NodeUpdate& k, NodeDrive<Number>& d) {
    using std::max;
    using std::min;
    const Number fall_x = fx - weight * bed.slope_x, fall_y = fy - weight * bed.slope_y;  // -g S
    d.ax = fall_x / d.n;
    d.ay = fall_y / d.n;
    if constexpr (Slope::thin_flow) {
        const Number bearing = 1 - (fall_x * bed.slope_x + fall_y * bed.slope_y) / k.gravity;
        const Number divisor = max(max(Number(0.5), bearing), min(0.5 * (1 - bearing), d.n));
        const Number along = k.gravity * (d.n - bearing) / (d.n * d.n);  // grad Z . (-g grad h) / n^2
        const auto bears = bearing < d.n;
        const Number thin_x = d.ax - bed.slope_x * along, thin_y = d.ay - bed.slope_y * along;
        const Number none(1e-300), steep = bed.slope_x * bed.slope_x + bed.slope_y * bed.slope_y;
        const Number lean = (d.n - bearing) / max(none, steep);  // 0: parallel to the bed, 1: level
        const Number up = max(Number(0.0), flow.climb);
        const Number froude = d.n * up * up / max(none, steep * k.gravity * flow.depth);
        const Number surge =
            flow.follows * smooth_step<Number>(0, 1, lean) * smooth_step<Number>(k_surge_from, k_surge_full, froude);
        d.ax = select(bears, surge * thin_x + (1 - surge) * (fall_x / divisor), thin_x);
        d.ay = select(bears, surge * thin_y + (1 - surge) * (fall_y / divisor), thin_y);
    }
    d.ax += k.gravity_x;
    d.ay += k.gravity_y;
}

/// Returns the acceleration of a node. Reads NodeForces; NodeLevel (if allocated); bed.
template <class Slope>
NodeDrive<double> drive_of(const NodeGrid& nodes, const NodeUpdate& k, std::size_t i, std::int64_t column,
                           std::int64_t row) {
    const NodeForces& node = nodes.forces()[i];
    const NodeBed<double> bed = bed_at<Slope>(nodes, i, column, row);
    NodeDrive<double> d = load_on<Slope, double>(bed, node.px / node.mass, node.py / node.mass, k.gravity);
    const bool levels = nodes.levels.size() != 0;
    const double follows = levels ? 1 - nodes.levels[i].ponding : 1;
    const double weight = levels ? k.gravity * nodes.levels[i].support * follows : 0;
    const NodeFlow<double> flow{node.mass / node.area, (node.px * bed.slope_x + node.py * bed.slope_y) / node.mass,
                                follows};
    accelerate<Slope, double>(bed, flow, node.fx / node.mass, node.fy / node.mass, weight, k, d);
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
            const NodeDrive<double> d = drive_of<Slope>(nodes, k, n, column, row);
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

/// What the update of a node, or of four in a row, reads of its record, levels and bed.
template <class Number>
struct NodeInput {
    Number px, py, fx, fy, mass, area, crowding, held;
    Number ponding, support;  ///< NodeLevel; without reference levels 1, 0
    Number share;             ///< the same; without reference levels 0
    Number follows;           ///< 1 - ponding; without reference levels 1
    Number height;            ///< of the bed [m]
    NodeBed<Number> bed;
};

/// The update of the nodes of a tile, one at a time or four.
template <class Number, class Slope, class Friction>
struct NodeSweep {
    using L = Lanes<Number>;
    using Mask = typename L::Mask;

    const NodeUpdate& k;
    const Friction& friction;
    NodeGrid& nodes;
    Maxima& maxima;
    const double time;

    const double inverse_area = 1 / (nodes.cell_size() * nodes.cell_size());
    Number max_depth = 0.0, max_speed = 0.0, moving = 0.0, thin = 0.0, volume = 0.0, energy = 0.0, kinetic = 0.0,
           levelled = 0.0, sloping = 0.0, dissipated = 0.0;
    typename L::Count covered{}, unsupported{}, moves{};

    /// `count` nodes from i on; those that are not `real` have no mass: only their results are ignored. `ghost`: none
    /// of them is counted.
    [[gnu::always_inline]] void operator()(std::size_t i, std::size_t count, Mask real, Mask held, bool ghost,
                                           const NodeInput<Number>& in) {
        using std::abs;
        using std::max;
        const Number zero(0.0), mass = select(real, in.mass, Number(1.0));
        const MapVector<Number> old{in.px / mass, in.py / mass};
        NodeDrive<Number> drive = load_on<Slope, Number>(in.bed, old.x, old.y, k.gravity);
        const NodeFlow<Number> flow{mass / in.area, old.x * in.bed.slope_x + old.y * in.bed.slope_y, in.follows};
        accelerate<Slope, Number>(in.bed, flow, in.fx / mass, in.fy / mass, k.gravity * in.support * in.follows, k,
                                  drive);
        AlongBedOf<Number> bed{zero, zero};
        if constexpr (Slope::metric) bed = {in.bed.slope_x, in.bed.slope_y};
        BedFrameOf<Number> frame;
        MapVector<Number> driven{old.x + k.dt * drive.ax, old.y + k.dt * drive.ay}, turned = old;
        if constexpr (Slope::curved) {
            frame = BedFrameOf<Number>::of({in.follows * in.bed.slope_x, in.follows * in.bed.slope_y});
            // The slope of the frame of the gathered velocity: a level flow over a lip gains no speed from the slope
            // below.
            bed = {frame.slope_x, frame.slope_y};
            // Half of the force, the rotation, the other half: second order (Strang 1968).
            const double half = 0.5 * k.dt;
            driven = {old.x + half * drive.ax, old.y + half * drive.ay};
            turn_by_bed<Number>(in.bed.curvature, frame, in.follows * k.dt, driven);
            driven = {driven.x + half * drive.ax, driven.y + half * drive.ay};
            turned = {driven.x - k.dt * drive.ax, driven.y - k.dt * drive.ay};
        }
        const Number driven_speed = bed.speed(driven), root = root_of(drive.n);
        const Number slowed = friction.template speed_after<Number>(i, count, bed.speed(turned), driven_speed, held, k,
                                                                    root, k.gravity + drive.load, mass / in.area);
        const Number left = select(held, zero, select(driven_speed > 0, slowed / driven_speed, Number(1.0)));
        const MapVector<Number> after{left * driven.x, left * driven.y};
        // The particles' own mean velocity: the new nodal velocity overshoots at nodes with almost no mass.
        const Number gathered = bed.speed(old);
        if (!ghost) {
            // As high as what presses: volume over the part of the cell that is claimed, on the rim of a thick pile
            // twice the cell's mean. Else it would gain energy as it spreads, 6 % at 20 m on cells of 5 m.
            const Number whole = 0.5 * mass * max(Number(inverse_area), 1 / in.area), more = whole - whole / drive.n;
            count_energy(real, mass, in.height + whole - (1 - in.ponding) * more, bed, old, turned, driven, after);
            const Number weight = select(real, k.gravity * mass * more, zero);
            levelled += in.ponding * weight;
            sloping += (1 - in.ponding) * weight;
            moving += select(real & (gathered > k.moving_speed), mass, zero);
        }
        // However thin: tips fly first.
        if constexpr (Slope::curved) L::add(unsupported, real & L::none(drive.load > -k.gravity));
        const Number depth = shown_depth<Number>(mass, in.area, in.support, in.crowding, inverse_area);
        const Mask shallow = real & (depth < k.minimum_depth), deep = real & L::none(shallow);
        if (!ghost) {  // ghosts mirror nodes inside, which are already counted
            thin += select(shallow, mass, zero);
            L::add(covered, deep);
        }
        if (L::any(deep)) {
            max_depth = select(deep, max(max_depth, depth), max_depth);
            max_speed = select(deep, max(max_speed, gathered), max_speed);
            maxima.update<Number>(i, count, deep, depth, gathered, time);
        }
        L::add(moves, real & L::none(zero >= abs(after.x) + abs(after.y)));
        MapVector<Number> back = after, way = after;
        if constexpr (Slope::curved) {
            back = frame.along_bed(after.x, after.y);
            way = velocity_underway<Number>(in.bed.curvature, frame, in.follows * k.drift, after);
        }
        if (k.kept != 0) {
            MapVector<Number> before = old;
            if constexpr (Slope::curved) before = frame.along_bed(old.x, old.y);
            back = {back.x - k.kept * before.x, back.y - k.kept * before.y};
        }
        for (std::size_t l = 0; k.gathered != nullptr && l < count; ++l) {
            const auto lane = static_cast<int>(l);
            if (L::at(real, lane)) k.gathered[i + l] = {L::at(old.x, lane), L::at(old.y, lane)};
        }
        store(i, count, real, {way.x, way.y, back.x, back.y},
              {mass, in.area * inverse_area, zero, in.support + in.share});
    }

    [[nodiscard, gnu::always_inline]] NodeReport report() const {
        NodeReport r;
        r.max_depth = L::greatest(max_depth);
        r.max_speed = L::greatest(max_speed);
        r.covered = L::total(covered);
        r.unsupported = L::total(unsupported);
        r.moves = L::total(moves) > 0;
        r.moving = L::sum(moving);
        r.thin = L::sum(thin);
        r.volume = L::sum(volume);
        r.energy = L::sum(energy);
        r.kinetic = L::sum(kinetic);
        r.levelled = L::sum(levelled);
        r.sloping = L::sum(sloping);
        r.dissipated = L::sum(dissipated);
        return r;
    }

  private:
    struct Four {
        Number a, b, c, d;
    };
    [[gnu::always_inline]] static Number root_of(Number n) {
        using std::sqrt;
        if constexpr (Slope::metric) return sqrt(n);
        return n;
    }
    // Adds the energy in a step that changes the velocity in map view from `before` (`turned` by the bed) to `driven`
    // by all driving forces and to `after` by friction and walls too. Friction and walls dissipate their change of the
    // velocity times the mean of before and after: a held node does no work.
    // @param height of the middle of the flow [m]
    [[gnu::always_inline]] void count_energy(Mask real, Number mass, Number height, const AlongBedOf<Number>& bed,
                                             const MapVector<Number>& before, const MapVector<Number>& turned,
                                             const MapVector<Number>& driven, const MapVector<Number>& after) {
        const Number zero(0.0), motion = 0.25 * mass * (bed.dot(before, before) + bed.dot(after, after));
        volume += select(real, mass, zero);
        kinetic += select(real, motion, zero);
        energy += select(real, motion + k.gravity * mass * height, zero);
        const Number lost =
            0.5 * mass * bed.dot({driven.x - after.x, driven.y - after.y}, {turned.x + after.x, turned.y + after.y});
        dissipated += select(real, lost, zero);
    }
    [[gnu::always_inline]] void store(std::size_t i, std::size_t count, Mask real, Four first, Four second) {
        double* const to = &nodes.records[i].motion.u;
        L::store_rows(first.a, first.b, first.c, first.d, real, count, to, sizeof(NodeRecord) / sizeof(double));
        L::store_rows(second.a, second.b, second.c, second.d, real, count, to + 4, sizeof(NodeRecord) / sizeof(double));
    }
};

/// Reads a node's input.
template <class Slope>
[[gnu::always_inline]] inline NodeInput<double> input_of(const NodeGrid& nodes, std::size_t i, std::int64_t column,
                                                         std::int64_t row) {
    const NodeForces& f = nodes.records[i].forces;
    const bool levels = nodes.levels.size() != 0;
    const double ponding = levels ? nodes.levels[i].ponding : 1;
    return {f.px,
            f.py,
            f.fx,
            f.fy,
            f.mass,
            f.area,
            f.crowding,
            f.held,
            ponding,
            levels ? nodes.levels[i].support : 0,
            levels ? nodes.levels[i].share : 0,
            levels ? 1 - ponding : 1,
            nodes.bed[i],
            bed_at<Slope>(nodes, i, column, row)};
}

/// Computes new nodal velocities (paper, equations 31-32): driving forces, then bed friction as a cap on the speed
/// along the bed that stops but never reverses. Reads NodeForces, NodeLevel (if allocated), bed; converts the records
/// with mass to NodeMotion. Updates the maxima of every node deeper than the minimum.
template <class Slope, class Friction>
NodeReport update_nodes(const NodeRange& range, const NodeUpdate& k, const Friction& friction, double time,
                        NodeGrid& nodes, Maxima& maxima) {
    NodeSweep<double, Slope, Friction> sweep{k, friction, nodes, maxima, time};
    range.for_each(nodes.stride(), [&](std::size_t i, std::int64_t column, std::int64_t row) {
        if (!(nodes.mass(i) > 0)) return;
        const bool ghost = k.wall && nodes.is_ghost(column, row);
        const NodeInput<double> in = input_of<Slope>(nodes, i, column, row);
        const bool held = (nodes.any_solid() && nodes.solid()[i] != 0) || (friction.keeps_rest() && in.held != 0);
        sweep(i, 1, true, held, ghost, in);
    });
    return sweep.report();
}

}  // namespace frana
