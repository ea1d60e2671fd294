// SPDX-License-Identifier: Apache-2.0
// The formulas of the scheme over rows of cells. Included by one source for each set of instructions.
#pragma once

#include <cmath>

#include "core/quad.h"
#include "models/finite_volume/cells.h"
#include "mpm/curvature.h"
#include "mpm/ground_walls.h"
#include "physics/friction_voellmy.h"

namespace frana::finite_volume {
namespace {

/// Differences of the surface towards the neighbours before and after a cell, and the bed's from one to the other; a
/// dry bank above the surface mirrors it.
template <class Number>
struct SurfaceSteps {
    Number before, after, bed;
};
template <class Number>
FRANA_INLINE SurfaceSteps<Number> surface_steps(Number depth, Number bed, Number depth_before, Number bed_before,
                                                Number depth_after, Number bed_after, double dry) {
    using L = Lanes<Number>;
    const Number zero(0.0), surface = depth + bed;
    const auto bank_before = L::none(depth_before > dry) & (bed_before >= surface),
               bank_after = L::none(depth_after > dry) & (bed_after >= surface);
    const auto mirrored = [&](Number down, Number up, Number& before, Number& after) FRANA_INLINE_LAMBDA {
        before = select(bank_before, select(bank_after, zero, up), down);
        after = select(bank_after, select(bank_before, zero, down), up);
    };
    SurfaceSteps<Number> steps{zero, zero, zero};
    Number bed_down = zero, bed_up = zero;
    mirrored(surface - (depth_before + bed_before), depth_after + bed_after - surface, steps.before, steps.after);
    mirrored(bed - bed_before, bed_after - bed, bed_down, bed_up);
    steps.bed = bed_down + bed_up;
    return steps;
}

/// Returns g' = g / (1 + grad(h + Z) . grad Z), the weight of a flow whose vertical acceleration is that of its bed
/// (Denlinger and Iverson 2004, J. Geophys. Res. 109, F01014), at most 2 g. Where the surface is steeper than the bed,
/// as at fronts, that which gives the fall of a thin flow (Savage and Hutter 1989) along the bed's slope:
///     g' S . grad Z = (g / n) (grad Z + G^-1 grad h) . grad Z,  S = grad(h + Z),  G^-1 = I - grad Z grad Z^T / n
template <class Number>
FRANA_INLINE Number weight_of(Number surface_x, Number surface_y, Number slope_x, Number slope_y, Number root,
                              const StepValues& v) {
    using std::max;
    const Number n = root * root, bearing = 1 + surface_x * slope_x + surface_y * slope_y;
    const Number of_bed = v.gravity / n;
    if (v.weight_of_bed) return of_bed;
    const Number thin = of_bed * (1 - (bearing - n) * (n - 1) / (n * max(bearing - 1, Number(1e-300))));
    return select(bearing > n, thin, v.gravity / max(bearing, Number(0.5)));
}

/// What static friction can stop: on these cells, as held in the sum of 3 x 3 cells [m2/s2], and the speed that it
/// stops in a step [m/s].
template <class Number>
struct Stops {
    Number bound, speed;
};
template <class Number>
FRANA_INLINE Stops<Number> stops(const UniformFriction& friction, std::size_t, std::size_t, Number depth, Number n,
                                 Number supported, const NodeUpdate& k) {
    const Number coefficient(friction.law.friction_coefficient);
    return {coefficient * depth * supported / n, k.dt * coefficient * k.gravity};
}
template <class Number, class Excess>
FRANA_INLINE Stops<Number> stops(const SummedFriction<Excess>& friction, std::size_t cell, std::size_t count,
                                 Number depth, Number n, Number, const NodeUpdate& k) {
    using std::sqrt;
    Number yield(0.0);
    for (std::size_t i = 0; i < count; ++i)
        Lanes<Number>::set(yield, static_cast<int>(i), friction.states[cell + i].yield);
    return {depth * yield / sqrt(n), k.dt * yield};
}

/// Where nothing is, and no sweep of this step can bring anything: what prepare_cells would find, without computing it.
/// Returns whether that is so.
template <class Number>
FRANA_INLINE bool prepare_idle(const Cells& c, std::size_t k, std::size_t n, Number root, const StepValues& v) {
    using L = Lanes<Number>;
    using std::max;
    const auto beside = [&](std::int64_t row) FRANA_INLINE_LAMBDA {
        const double* const here = c.depth + static_cast<std::int64_t>(k) + row;
        return max(max(L::load(here - 1, n), L::load(here, n)), L::load(here + 1, n));
    };
    if (L::any(max(max(beside(-c.stride), beside(0)), beside(c.stride)) > 0)) return false;
    L::store(v.gravity / (root * root), c.weight + k, n);
    for (double* const none : {c.slowed_x, c.slowed_y, c.pull_x, c.pull_y, c.bound, c.spare, c.held, c.before})
        L::store(Number(0.0), none + k, n);
    L::store(Number(-1.0), c.start + k, n);
    L::store(Number(-1e30), c.head + k, n);
    return true;
}

/// Before the sweeps: g', half a step of friction for the predictor, pull and bound of friction, energy. Reads the
/// state and the ground of the cells and their four neighbours.
template <class Number, class Friction>
FRANA_INLINE void prepare_cells(const Cells& c, std::size_t k, std::size_t n, const StepValues& v,
                                const Friction& friction) {
    using L = Lanes<Number>;
    using std::max;
    using std::min;
    using std::sqrt;
    const auto at = [&](const double* from, std::int64_t offset = 0)
                        FRANA_INLINE_LAMBDA { return L::load(from + static_cast<std::int64_t>(k) + offset, n); };
    const Number zero(0.0), h = at(c.depth), z = at(c.bed), slope_x = at(c.slope_x), slope_y = at(c.slope_y),
                            root = at(c.root);
    if (prepare_idle<Number>(c, k, n, root, v)) return;
    const auto wet = h > v.dry;
    const Number some = select(wet, h, Number(1.0));
    const Number wx = select(wet, at(c.qx) / some, zero), wy = select(wet, at(c.qy) / some, zero);
    const MapVector<Number> u = in_map<Number>(wx, wy, slope_x, slope_y, root);
    const BedCurvatureOf<Number> curvature{at(c.curvature_xx), at(c.curvature_xy), at(c.curvature_yy), zero, zero};
    const Number supported = v.gravity + max(Number(-v.gravity), curvature.load(u.x, u.y));
    const auto steps_along = [&](std::int64_t next) FRANA_INLINE_LAMBDA {
        return surface_steps<Number>(h, z, at(c.depth, -next), at(c.bed, -next), at(c.depth, next), at(c.bed, next),
                                     v.dry);
    };
    const SurfaceSteps<Number> x = steps_along(1), y = steps_along(c.stride);
    const double inverse_dx = 1 / v.cell_size;
    // The fall of a corner beyond the bed's slope in the cell is no slope of the flow.
    const auto slope_of = [&](const SurfaceSteps<Number>& steps, Number slope) FRANA_INLINE_LAMBDA {
        const Number surface = 0.5 * inverse_dx * (steps.before + steps.after),
                     corner = 0.5 * inverse_dx * steps.bed - slope;
        return surface - select(corner > 0, min(corner, max(surface, zero)), max(corner, min(surface, zero)));
    };
    const Number weight = weight_of<Number>(slope_of(x, slope_x), slope_of(y, slope_y), slope_x, slope_y, root, v);
    const Number sx = limited<Number>(x.before, x.after) * inverse_dx,
                 sy = limited<Number>(y.before, y.after) * inverse_dx;
    const Number fall_x = v.gravity_x - weight * sx, fall_y = v.gravity_y - weight * sy;
    const Number along = (fall_x * slope_x + fall_y * slope_y) / (root + 1);
    const double half = 0.5 * v.dt;
    const Number ax = wx + half * (fall_x + along * slope_x), ay = wy + half * (fall_y + along * slope_y);
    const Number start = sqrt(wx * wx + wy * wy), driven = sqrt(ax * ax + ay * ay);
    const NodeUpdate half_step{.dt = half, .gravity = v.gravity}, step{.dt = v.dt, .gravity = v.gravity};
    const Number slowed =
        friction.template speed_after<Number>(k, n, start, driven, L::none(wet), half_step, root, supported, some);
    const Number lost = select(wet & (driven > 0), slowed / select(driven > 0, driven, Number(1.0)) - 1, zero);
    const Stops<Number> stop = stops<Number>(friction, k, n, h, root * root, supported, step);
    const auto put = [&](Number value, double* to) FRANA_INLINE_LAMBDA { L::store(value, to + k, n); };
    put(weight, c.weight);
    // The fall of the surface is in the predictor of the faces, that of a tilted frame is not.
    put(ax * lost + select(wet, Number(half * v.gravity_x), zero), c.slowed_x);
    put(ay * lost + select(wet, Number(half * v.gravity_y), zero), c.slowed_y);
    // Per time, so that the judgement of what rests is the same, to the last digit, in steps of any length. The surface
    // of a cell between dry ones has no slope: what drives it is the difference of both sides.
    const auto drive = [&](Number fall, double tilt, const SurfaceSteps<Number>& steps,
                           std::int64_t next) FRANA_INLINE_LAMBDA {
        const auto alone = L::none(at(c.depth, -next) > v.dry) & L::none(at(c.depth, next) > v.dry);
        const Number mean = tilt - weight * (0.5 * inverse_dx * (steps.before + steps.after));
        return select(alone, mean, fall);
    };
    put(h * (u.x / v.dt + drive(fall_x, v.gravity_x, x, 1)), c.pull_x);
    put(h * (u.y / v.dt + drive(fall_y, v.gravity_y, y, c.stride)), c.pull_y);
    put(select(wet, stop.bound, zero), c.bound);
    put(select(wet, max(zero, half * stop.bound * root / some - driven), zero), c.spare);
    constexpr double k_slow = 4;
    const Number slow = k_slow * stop.speed;
    // A free side pushes by g' h^2 / 2: what friction on two cells cannot stop collapses, however even its sides are.
    const Number side = min(h, max(max(x.before, -x.after), max(y.before, -y.after)));
    const auto stands = L::none((side > 0) & (weight * side * side > 4 * v.cell_size * stop.bound));
    put(select(wet & stands & L::none(u.x * u.x + u.y * u.y > slow * slow), Number(1.0), zero), c.held);
    put(select(wet, start, Number(-1.0)), c.start);
    put(h, c.before);
    put(select(wet, 0.5 * start * start + v.gravity * (z + 2 * h), Number(-1e30)), c.head);
}

/// Which slow cells friction keeps at rest: those whose 3 x 3 cells it can stop together (mpm/update_nodes.h,
/// find_held_nodes). Reads pull and bound; reads and writes held.
FRANA_INLINE void hold_cells(const Cells& c, std::size_t k, std::size_t n) {
    const Quad held = Lanes<Quad>::load(c.held + k, n);
    if (!any(held > 0)) return;
    const auto sum = [&](const double* from) FRANA_INLINE_LAMBDA {
        const double* const here = from + k;
        const auto row = [&](const double* p)
                             FRANA_INLINE_LAMBDA { return Quad::load(p - 1) + Quad::load(p) + Quad::load(p + 1); };
        return row(here - c.stride) + row(here) + row(here + c.stride);
    };
    const Quad x = sum(c.pull_x), y = sum(c.pull_y), bound = sum(c.bound);
    Lanes<Quad>::store(select((bound > 0) & (bound * bound >= x * x + y * y), held, Quad(0.0)), c.held + k, n);
}

/// The values of a row for a sweep.
FRANA_INLINE void read_cells(const Cells& c, std::size_t k, std::size_t q, std::size_t n, const double* depth,
                             const double* qx, const double* qy, bool along_y, double dry, const CellRow& row) {
    using L = Lanes<Quad>;
    const auto at = [&](const double* from) FRANA_INLINE_LAMBDA { return L::load(from + k, n); };
    const Quad zero(0.0), h = L::load(depth + q, n), slope_x = at(c.slope_x), slope_y = at(c.slope_y),
                          root = at(c.root);
    const auto wet = h > dry;
    const Quad held = at(c.held), some = select(wet, h, Quad(1.0));
    const auto moves = wet & L::none(held > 0.5);
    Quad wx = zero, wy = zero;
    MapVector<Quad> u{zero, zero};
    if (any(moves)) {
        wx = select(moves, L::load(qx + q, n) / some + at(c.slowed_x), zero);
        wy = select(moves, L::load(qy + q, n) / some + at(c.slowed_y), zero);
        u = in_map<Quad>(wx, wy, slope_x, slope_y, root);
    }
    const Quad slope = along_y ? slope_y : slope_x, weight = at(c.weight);
    const auto put = [&](Quad value, double* to) FRANA_INLINE_LAMBDA { L::store(value, to + q, n); };
    put(h, row.depth);
    put(along_y ? u.y : u.x, row.speed);
    put(along_y ? wy : wx, row.normal);
    put(along_y ? wx : wy, row.tangential);
    put(weight, row.weight);
    put(weight * (1 + slope * slope / (root + 1)), row.drive);
    put(at(c.bed), row.bed);
    put(select(wet, held, Quad(1.0)), row.closed);
    put(select(held > 0.5, Quad(1e9), at(c.spare)), row.spare);
}

/// A cell's states at its faces half a step later (MUSCL-Hancock; van Leer 1979, J. Comput. Phys. 32, 101).
///
/// The bed has a slope of its own, which does not change with the flow, and the depth that of the surface less the
/// bed's: with slopes of depth and surface limited each for itself the bed at the face would move with every ripple,
/// and lakes over rough ground would begin to swing.
/// @param a, b, c the cell before, the cell, the cell after
FRANA_INLINE void sides_of(const CellRow& a, const CellRow& b, const CellRow& c, std::size_t q, double half, double dry,
                           const SideRow& before, const SideRow& after) {
    using L = Lanes<Quad>;
    const auto at = [&](const double* from) FRANA_INLINE_LAMBDA { return Quad::load(from + q); };
    const auto none = [](Quad::Mask m) FRANA_INLINE_LAMBDA { return L::none(m); };
    const Quad zero(0.0), h = at(b.depth), u = at(b.speed), wn = at(b.normal), wt = at(b.tangential), z = at(b.bed);
    const Quad ha = at(a.depth), hc = at(c.depth), za = at(a.bed), zc = at(c.bed), surface = h + z;
    if (!any(max(max(ha, h), hc) > 0)) {
        for (const SideRow* const side : {&before, &after}) {
            for (double* const to : {side->depth, side->speed, side->normal, side->tangential}) zero.store(to + q);
            z.store(side->bed + q);
        }
        return;
    }
    const auto bank_a = none(ha > dry) & (za >= surface), bank_c = none(hc > dry) & (zc >= surface);
    const Quad down = select(bank_a, zero, surface - (ha + za)), up = select(bank_c, zero, hc + zc - surface);
    const Quad ua = at(a.speed), uc = at(c.speed), rise = limited<Quad>(down, up), du = limited<Quad>(u - ua, uc - u);
    const Quad dn = limited<Quad>(wn - at(a.normal), at(c.normal) - wn);
    const Quad dt = limited<Quad>(wt - at(a.tangential), at(c.tangential) - wt);
    // Half a step: with the slopes inside the cell; where the surface is flatter than the bed with what passes the
    // faces, or each step over a rough bed would give the waves of a lake some energy.
    const Quad shared_a = max(zero, min(surface, ha + za) - max(z, za)),
               shared_c = max(zero, min(surface, hc + zc) - max(z, zc));
    const auto level = abs(z - za) + abs(zc - z) > 2 * (abs(down) + abs(up));
    // A rough bed has no slope in the cell: what passes the faces is then what the half step above takes.
    const auto rough = abs(zc - 2 * z + za) > 0.1 * (abs(z - za) + abs(zc - z));
    const Quad sloping = min(max(rise - limited<Quad>(z - za, zc - z), -h), h);
    const Quad dh = select(level, select(rough, rise, sloping), limited<Quad>(h - ha, hc - h));
    const Quad gain = half * select(level, 0.5 * (shared_c * (u + uc) - shared_a * (u + ua)), u * dh + h * du);
    // What friction holds is not pulled: it would flow out at the speed of half a step's fall.
    const Quad pull = half * select(at(b.closed) > 0.5, zero,
                                    select(level, 0.5 * (shared_c * up + shared_a * down) / max(h, Quad(dry)), rise));
    const auto put = [&](double side, const SideRow& to) FRANA_INLINE_LAMBDA {
        (max(zero, h + side * dh - gain)).store(to.depth + q);
        (u + side * du - half * u * du - at(b.weight) * pull).store(to.speed + q);
        (wn + side * dn - half * u * dn - at(b.drive) * pull).store(to.normal + q);
        (wt + side * dt - half * (u * dt)).store(to.tangential + q);
        (z + side * (rise - dh)).store(to.bed + q);
    };
    put(-0.5, before);
    put(0.5, after);
}

/// The beds on which the flow of both sides meets at a face.
struct FaceBeds {
    Quad below, above;  ///< [m]
    Quad step;          ///< from one to the other, each of its own cell [m]
    Quad leaps;         ///< 1 where the flow leaps from the higher to the lower, 0 elsewhere
    Quad lands;         ///< 1 where it keeps the energy of its fall, turned by the ground, 0 elsewhere
    Quad meets;         ///< 1 where the flow on the lower side meets a wall, 0 elsewhere
};

/// Flow that goes down, or is fast enough to climb, has one bed at a face where the beds of both cells, each with its
/// own slope, cross: the higher one would dam it. So has thin flow that runs faster than its waves, down or, with the
/// energy for it, up: at a step its energy would be lost, and a sharp corner of the ground would dam it.
FRANA_INLINE FaceBeds beds_of(const CellRow& a, const CellRow& b, const CellRow& c, const CellRow& d, std::size_t q,
                              const StepValues& v, const Quad& bed_below, const Quad& bed_above) {
    using L = Lanes<Quad>;
    const auto at = [&](const double* from) FRANA_INLINE_LAMBDA { return Quad::load(from + q); };
    const Quad hb = at(b.depth), hc = at(c.depth), zb = at(b.bed), zc = at(c.bed), dz = zc - zb, zero(0.0), one(1.0);
    const auto rises = dz > 0;
    const Quad upper = select(rises, hc, hb), lower = select(rises, hb, hc),
               towards = select(rises, at(b.speed), -at(c.speed));
    const auto pours = (upper > v.dry) & ((hc + zc - (hb + zb)) * dz > 0.5 * dz * dz);
    const Quad low = min(zb, zc), high = max(zb, zc), from_below = min(high, max(low, bed_below)),
               from_above = min(high, max(low, bed_above)), middle = 0.5 * (from_below + from_above);
    const Quad from = select(rises, at(c.normal), at(b.normal)), up = select(rises, at(b.normal), -at(c.normal));
    const auto runs = (select(rises, -at(c.speed), at(b.speed)) > 0) & (from * from > v.gravity * upper);
    const Quad step = from_above - from_below, corner = corner_of<Quad>(zb - at(a.bed), dz, at(d.bed) - zc);
    // A wall, or the foot of a cliff: sharper than the flow is thick. It takes what is normal to it.
    const auto sharp = (abs(corner) > k_sharp * v.cell_size) & (abs(dz) > max(hb, hc));
    const auto able = (towards > 0) & (0.5 * up * up > v.gravity * abs(dz)) & L::none(sharp);
    const auto climbs = L::none(upper > v.dry) & able, mounts = able & (up * up > v.gravity * lower);
    const auto passes = pours | climbs | mounts, free = passes & (runs | mounts) & (abs(dz) > max(hb, hc)),
               leaps = free & (corner * dz > 0.5 * dz * dz) & (step * dz > 0), lands = leaps & L::none(sharp),
               one_bed = (passes & (0 > step * dz)) | (free & L::none(leaps));
    return {select(one_bed, middle, from_below),
            select(one_bed, middle, from_above),
            step,
            select(leaps, one, zero),
            select(lands, one, zero),
            select(sharp & (towards > 0) & L::none(passes), one, zero)};
}

/// What a wall takes of the momentum towards it beyond the pressure of the depth, per time: all that arrives, as a
/// plate takes that of a jet; at most all there is.
/// @param speed, normal towards the wall
FRANA_INLINE Quad taken_by_wall(const Quad& depth, const Quad& speed, const Quad& normal, const StepValues& v) {
    const Quad zero(0.0);
    return depth * max(zero, normal) * min(max(zero, speed), Quad(v.cell_size / v.dt));
}

/// Between films, which do not move, and dry cells nothing passes: each keeps its pressure. Returns whether all cells
/// are such; the faces are then those that flow_through would find.
FRANA_INLINE bool faces_rest(const CellRow& b, const CellRow& c, const SideRow& below, const SideRow& above,
                             std::size_t q, double dry, const FaceRow& to) {
    const auto at = [&](const double* from) FRANA_INLINE_LAMBDA { return Quad::load(from + q); };
    if (any(max(at(b.depth), at(c.depth)) > dry)) return false;
    const Quad zb = at(b.bed), zc = at(c.bed), low = min(zb, zc), high = max(zb, zc), hb = at(below.depth),
               hc = at(above.depth);
    for (double* const none : {to.mass, to.normal, to.tangential}) Quad(0.0).store(none + q);
    (0.5 * hb * hb).store(to.pressure_below + q);
    (0.5 * hc * hc).store(to.pressure_above + q);
    (min(high, max(low, at(below.bed))) - zb).store(to.step_below + q);
    (min(high, max(low, at(above.bed))) - zc).store(to.step_above + q);
    return true;
}

/// Faces between the cells of b and c: HLL for mass and normal momentum (Harten, Lax and van Leer 1983), the tangential
/// one carried with the mass; hydrostatic reconstruction (Audusse et al. 2004, SIAM J. Sci. Comput. 25, 2050).
FRANA_INLINE void flow_through(const CellRow& a, const CellRow& b, const CellRow& c, const CellRow& d,
                               const SideRow& row_below, const SideRow& row_above, std::size_t q, const StepValues& v,
                               const FaceRow& to) {
    using L = Lanes<Quad>;
    const auto at = [&](const double* from) FRANA_INLINE_LAMBDA { return Quad::load(from + q); };
    struct Side {
        Quad depth, speed, normal, tangential, bed;
    };
    const auto side = [&](const SideRow& row) FRANA_INLINE_LAMBDA {
        return Side{at(row.depth), at(row.speed), at(row.normal), at(row.tangential), at(row.bed)};
    };
    const Side below = side(row_below), above = side(row_above);
    const Quad zero(0.0), one(1.0), tiny(1e-100);
    const Quad hb = at(b.depth), hc = at(c.depth), zb = at(b.bed), zc = at(c.bed), dz = zc - zb;
    const FaceBeds beds = beds_of(a, b, c, d, q, v, below.bed, above.bed);
    const Quad bed_below = beds.below, bed_above = beds.above, step = beds.step, top = max(bed_below, bed_above);
    const auto leaps = beds.leaps > 0.5;
    const Quad depth_below = max(zero, below.depth - select(leaps, zero, top - bed_below)),
               depth_above = max(zero, above.depth - select(leaps, zero, top - bed_above));
    const auto wet_below = depth_below > v.dry, wet_above = depth_above > v.dry;
    const Quad wave_below = sqrt(v.wave_factor * at(b.weight) * depth_below),
               wave_above = sqrt(v.wave_factor * at(c.weight) * depth_above);
    const Quad ub = select(wet_below, below.speed, above.speed), uc = select(wet_above, above.speed, below.speed);
    const Quad slow =
        min(zero, min(ub - select(wet_below, wave_below, 2 * wave_above), uc - select(wet_above, wave_above, zero)));
    const Quad fast =
        max(zero, max(ub + select(wet_below, wave_below, zero), uc + select(wet_above, wave_above, 2 * wave_below)));
    // Nothing passes between cells at rest, and films do not move.
    const auto open = (L::none(at(b.closed) * at(c.closed) > 0.5)) & (wet_below | wet_above);
    const Quad inverse = select(open, one, zero) / max(fast - slow, Quad(1e-6));
    const Quad mb = depth_below * below.speed, mc = depth_above * above.speed, both = slow * fast;
    const Quad flux = (fast * mb - slow * mc + both * (depth_above - depth_below)) * inverse;
    // No cell gives more than it has: through both faces that it may flow through, by its speed towards this one over
    // that of its waves, together.
    const auto gives = flux > 0;
    const Quad has = select(gives, hb, hc), ahead = select(gives, at(b.speed), -at(c.speed)),
               square = ahead * abs(ahead), waves = v.wave_factor * select(gives, at(b.weight), at(c.weight)) * has;
    const Quad slower = select(square > -waves, Quad(0.49), select(square > -4 * waves, Quad(0.15), Quad(0.01)));
    const Quad most = select(square > waves, select(square > 4 * waves, Quad(0.98), Quad(0.84)), slower);
    // Friction that is left over in a cell also stops what only the difference at the face would move.
    const Quad per_flux = one / max(abs(flux), Quad(1e-300)), spare = has * select(gives, at(b.spare), at(c.spare));
    const Quad given = min(max(zero, 1 - spare * per_flux), (v.cell_size / v.dt) * most * has * per_flux);
    const Quad mass = given * flux;
    const Quad push = 0.5 * inverse * (depth_above * depth_above - depth_below * depth_below);
    const auto put = [&](Quad value, double* where) FRANA_INLINE_LAMBDA { value.store(where + q); };
    put(mass, to.mass);
    // Waves on a pool move it horizontally however steep its bed is: what smooths them there is the difference of the
    // velocities in map view. That of velocities along two different beds would drive them.
    const auto pool = (abs(dz) > 2 * abs(hc + zc - (hb + zb))) & wet_below & wet_above;
    const Quad smoothing = both * inverse * given;
    put((fast * mb * below.normal - slow * mc * above.normal) * inverse * given +
            select(pool, zero, smoothing * (depth_above * above.normal - depth_below * below.normal)),
        to.normal);
    const Quad level = select(pool, smoothing * (depth_above * above.speed - depth_below * below.speed), zero);
    put(mass * select(mass > 0, below.tangential, above.tangential), to.tangential);
    // As each side sees it: above the pressure of its own depth, over the part of the bed that the other does not
    // share. What leaps a step arrives with the energy of its fall.
    const auto forth = mass > 0;
    const Quad leaves = select(forth, below.normal, -above.normal), drop = select(forth, -step, step),
               arrives = sqrt(max(zero, leaves * leaves + 2 * v.gravity * drop));
    const Quad gain = select(beds.lands > 0.5, abs(mass) * (arrives - max(zero, leaves)), zero) /
                      max(select(forth, at(c.drive), at(b.drive)), tiny);
    const Quad weight_below = max(at(b.weight), tiny), weight_above = max(at(c.weight), tiny),
               per_weight = level / (weight_below * weight_above);
    Quad wall_below = zero, wall_above = zero;
    if (const auto meets = beds.meets > 0.5; L::any(meets)) {
        wall_below =
            select(meets & (dz > 0), taken_by_wall(below.depth, below.speed, below.normal, v) / weight_below, zero);
        wall_above = select(meets & (zero > dz),
                            taken_by_wall(above.depth, -above.speed, -above.normal, v) / weight_above, zero);
    }
    put(0.5 * below.depth * below.depth - slow * push + per_weight * weight_above + select(forth, zero, gain) +
            wall_below,
        to.pressure_below);
    put(0.5 * above.depth * above.depth - fast * push + per_weight * weight_below + select(forth, gain, zero) +
            wall_above,
        to.pressure_above);
    put(bed_below - zb, to.step_below);
    put(bed_above - zc, to.step_above);
}

FRANA_INLINE void update_cells(const Cells& c, std::size_t k, std::size_t q, std::size_t n, bool along_y, double rate,
                               const FaceRow& before, const FaceRow& after) {
    using L = Lanes<Quad>;
    const auto change = [&](const double* to, const double* from)
                            FRANA_INLINE_LAMBDA { return L::load(to + q, n) - L::load(from + q, n); };
    const Quad slope_x = L::load(c.slope_x + k, n), slope_y = L::load(c.slope_y + k, n), root = L::load(c.root + k, n);
    const Quad h = L::load(c.depth + k, n);
    const Quad next = max(Quad(0.0), h - rate * change(after.mass, before.mass));
    L::store(0.5 * (L::load(before.mass + q, n) + L::load(after.mass + q, n)), (along_y ? c.pull_y : c.pull_x) + k, n);
    const Quad normal = -rate * change(after.normal, before.normal),
               tangential = -rate * change(after.tangential, before.tangential);
    const Quad force = -rate * L::load(c.weight + k, n) *
                       (change(after.pressure_below, before.pressure_above) +
                        0.5 * (h + next) * change(after.step_below, before.step_above));
    const Quad climb = force * (along_y ? slope_y : slope_x) / (root + 1);
    const Quad dx = (along_y ? tangential : normal + force) + climb * slope_x,
               dy = (along_y ? normal + force : tangential) + climb * slope_y;
    // A held cell whose depth changes is not at rest: those beside it may be set free.
    const Quad start = L::load(c.start + k, n);
    const auto changed = ((next > h) | (h > next)) & (start >= 0);
    L::store(select(changed, max(start, Quad(1e-300)), start), c.start + k, n);
    L::store(next, c.depth + k, n);
    L::store(L::load(c.qx + k, n) + dx, c.qx + k, n);
    L::store(L::load(c.qy + k, n) + dy, c.qy + k, n);
}

/// After the sweeps: the turn of the bed (mpm/curvature.h), friction, the bound of the energy line, maxima and sums.
/// What friction stops within the step counts in the maxima at the speed of what passed the faces. Reads head of 3 x 3
/// cells, start, held.
template <class Number, class Friction>
FRANA_INLINE void finish_cells(const Cells& c, std::size_t k, std::size_t n, const StepValues& v,
                               const Friction& friction, StripTotals& totals) {
    using L = Lanes<Number>;
    using std::abs;
    using std::max;
    using std::min;
    using std::sqrt;
    const auto at = [&](const double* from, std::int64_t offset = 0)
                        FRANA_INLINE_LAMBDA { return L::load(from + static_cast<std::int64_t>(k) + offset, n); };
    const auto highest = [&](std::int64_t offset) FRANA_INLINE_LAMBDA {
        return max(max(at(c.head, offset - 1), at(c.head, offset)), at(c.head, offset + 1));
    };
    const auto first = L::first(n);
    const Number zero(0.0), one(1.0), h = at(c.depth), slope_x = at(c.slope_x), slope_y = at(c.slope_y),
                                      root = at(c.root);
    const auto wet = h > v.dry;
    if (!L::any(L::none(v.dry >= h)) && v.gravity_x == 0 && v.gravity_y == 0) {  // what is no number is looked at
        for (double* const q : {c.qx, c.qy}) L::store(zero, q + k, n);
        return;
    }
    const Number some = select(wet, h, one);
    Number wx = select(wet, at(c.qx) / some, zero), wy = select(wet, at(c.qy) / some, zero);
    const MapVector<Number> u = in_map<Number>(wx, wy, slope_x, slope_y, root);
    const BedCurvatureOf<Number> curvature{at(c.curvature_xx), at(c.curvature_xy), at(c.curvature_yy), zero, zero};
    const Number rise_x = curvature.xx * u.x + curvature.xy * u.y, rise_y = curvature.xy * u.x + curvature.yy * u.y;
    const Number half = 0.5 * v.dt * (slope_x * rise_y - slope_y * rise_x) / (root * (root + 1));
    const Number divisor = 1 + half * half, cosine = (1 - half * half) / divisor, sine = 2 * half / divisor;
    const Number along = (v.gravity_x * slope_x + v.gravity_y * slope_y) / (root + 1);
    const Number tx = cosine * wx - sine * wy + v.dt * (v.gravity_x + along * slope_x),
                 ty = sine * wx + cosine * wy + v.dt * (v.gravity_y + along * slope_y);
    const Number curved = u.x * rise_x + u.y * rise_y, supported = v.gravity + max(Number(-v.gravity), curved);
    const Number driven = sqrt(tx * tx + ty * ty), before = at(c.start);
    const auto held = L::none(wet) | (at(c.held) > 0.5);
    const NodeUpdate step{.dt = v.dt, .gravity = v.gravity};
    const Number began = select(before < 0, driven, before);
    const Number share = friction_share<Number>(at(c.before), some);
    const Number slowed =
        friction.template speed_after<Number>(k, n, began, driven, held, step, root, supported * share, some / share);
    // Friction works over the way of what passes the faces: at a rim waves carry back all that a cell's speed carries.
    const Number fluxed_x = at(c.pull_x), fluxed_y = at(c.pull_y),
                 climb = (fluxed_x * slope_x + fluxed_y * slope_y) / (root + 1);
    const Number passed = max(zero, tx * (fluxed_x + climb * slope_x) + ty * (fluxed_y + climb * slope_y)) /
                          select(driven > 0, driven, one);
    const auto stands = (0.5 * driven > slowed) & (0.01 * some * slowed > passed);
    // No cell is faster than the energy of those around it before the step allows.
    const Number energy = max(max(highest(-c.stride), highest(0)), highest(c.stride)) - v.gravity * at(c.bed);
    const Number speed =
        min(select(stands, zero, slowed),
            sqrt(max(zero, 2 * energy)) + v.dt * (abs(Number(v.gravity_x)) + abs(Number(v.gravity_y))));
    const Number left = select(driven > 0, speed / select(driven > 0, driven, one), zero);
    wx = tx * left;
    wy = ty * left;
    L::store(h * wx, c.qx + k, n);
    L::store(h * wy, c.qy + k, n);
    const MapVector<Number> moved = in_map<Number>(wx, wy, slope_x, slope_y, root);
    const auto deep = first & L::none(v.minimum_depth > h);
    const auto keep = [&](Number value, double* to) FRANA_INLINE_LAMBDA {
        const Number old = L::load(to + k, n);
        L::store(select(deep, max(old, value), old), to + k, n);
    };
    keep(h, c.max_depth);
    // What friction stops within the step came at the speed of what passed the faces.
    keep(select(speed > 0, speed, min(driven, passed / some)), c.max_speed);
    const Number arrival = at(c.arrival_plus_1);
    L::store(select(deep & L::none(arrival > 0), Number(v.time + 1), arrival), c.arrival_plus_1 + k, n);
    const auto to_greatest = [&](Number value, double* lanes) FRANA_INLINE_LAMBDA {
        const Number old = L::load(lanes, 4);
        L::store(max(old, select(first, value, zero)), lanes, 4);
    };
    const auto to_sum = [&](Number value, double* lanes)
                            FRANA_INLINE_LAMBDA { L::store(L::load(lanes, 4) + select(first, value, zero), lanes, 4); };
    to_greatest(select(deep, speed, zero), totals.max_speed);
    to_greatest(select(wet, max(abs(moved.x), abs(moved.y)) + sqrt(v.wave_factor * at(c.weight) * h), zero),
                totals.wave);
    to_sum((driven - slowed) * passed, totals.dissipated);
    to_sum(h * speed, totals.momentum);
    to_sum(select(passed > 0.5 * v.moving_speed * (h + at(c.before)), h, zero), totals.moving);
    to_sum(select(wet & L::none(curved > -v.gravity), one, zero), totals.unsupported);
    to_sum(select((h >= 0) & (1e9 > h + driven), zero, one), totals.not_finite);
}

template <class Friction>
void prepare_row(const Cells& c, std::size_t first, std::size_t count, const StepValues& v, const Friction& friction) {
    for_chunks(0, count, [&](std::size_t q, std::size_t n) FRANA_INLINE_LAMBDA {
        prepare_cells<Quad>(c, first + q, n, v, friction);
    });
}
void hold_row(const Cells& c, std::size_t first, std::size_t count, const StepValues&) {
    for_chunks(0, count, [&](std::size_t q, std::size_t n) FRANA_INLINE_LAMBDA { hold_cells(c, first + q, n); });
}
void read_row(const Cells& c, std::size_t first, std::size_t count, const double* depth, const double* qx,
              const double* qy, bool along_y, double dry, const CellRow& row) {
    for_chunks(0, count, [&](std::size_t q, std::size_t n) FRANA_INLINE_LAMBDA {
        read_cells(c, first + q, q, n, depth, qx, qy, along_y, dry, row);
    });
}
void sides_of_row(const CellRow& a, const CellRow& b, const CellRow& c, std::size_t count, const StepValues& v,
                  const SideRow& before, const SideRow& after) {
    const double half = 0.5 * v.dt / v.cell_size;
    for (std::size_t q = 0; q < count; q += 4) sides_of(a, b, c, q, half, v.dry, before, after);
}
void faces_of_row(const CellRow& a, const CellRow& b, const CellRow& c, const CellRow& d, const SideRow& below,
                  const SideRow& above, std::size_t count, const StepValues& v, const FaceRow& to) {
    for (std::size_t q = 0; q < count; q += 4)
        if (!faces_rest(b, c, below, above, q, v.dry, to)) flow_through(a, b, c, d, below, above, q, v, to);
}
void update_row(const Cells& c, std::size_t first, std::size_t count, bool along_y, const StepValues& v,
                const FaceRow& before, const FaceRow& after) {
    const double rate = v.dt / v.cell_size;
    for_chunks(0, count, [&](std::size_t q, std::size_t n) FRANA_INLINE_LAMBDA {
        update_cells(c, first + q, q, n, along_y, rate, before, after);
    });
}
template <class Friction>
void finish_row(const Cells& c, std::size_t first, std::size_t count, const StepValues& v, const Friction& friction,
                StripTotals& totals) {
    for_chunks(0, count, [&](std::size_t q, std::size_t n) FRANA_INLINE_LAMBDA {
        finish_cells<Quad>(c, first + q, n, v, friction, totals);
    });
}

constexpr RowKernels k_row_kernels{prepare_row<UniformFriction>,
                                   prepare_row<SummedFriction<NoExcess>>,
                                   hold_row,
                                   read_row,
                                   sides_of_row,
                                   faces_of_row,
                                   update_row,
                                   finish_row<UniformFriction>,
                                   finish_row<SummedFriction<NoExcess>>};

}  // namespace
}  // namespace frana::finite_volume
