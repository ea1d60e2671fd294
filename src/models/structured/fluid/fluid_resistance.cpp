// SPDX-License-Identifier: Apache-2.0
#include "models/structured/fluid/fluid_resistance.h"

#include <algorithm>
#include <cmath>

#include "models/structured/fluid/fluid_step.h"
#include "mpm/curvature.h"
#include "physics/friction_sum.h"

namespace frana::structured {

bool has_viscosity(const FluidLaws& laws) {
    return laws.viscosity > 0;
}

bool has_resistance(const FluidLaws& laws) {
    return laws.manning > 0 || laws.viscosity > 0;
}

double kinematic_viscosity(const FluidLaws& laws, double solid_fraction) noexcept {
    if (solid_fraction == 0) return laws.viscosity / laws.density;
    return laws.viscosity * std::exp(laws.viscosity_growth * solid_fraction) / laws.density;
}

namespace {

// Returns V with b V + A V^2 + B max(0, V - c)^2 = left, for left, b > 0 and A, B, c not negative: backward Euler of
// Manning's resistance of both phases together (A) and, in excess of the solids' speed c, by the fluid's own (B).
double speed_over_solids(double left, double b, double total, double own, double c) {
    const double together = left / implicit_divisor(left, b, total);
    if (together <= c || !(own > 0)) return together;
    // Beyond c the sum is one quadratic, and its greater root the only one there.
    const double square = total + own, linear = b - 2 * own * c, constant = own * c * c - left;
    const double root = std::sqrt(linear * linear - 4 * square * constant);
    return linear > 0 ? -2 * constant / (linear + root) : (root - linear) / (2 * square);
}

}  // namespace

void resist(const NodeRange& range, const FluidLaws& laws, const SolidsOnGrid& solid, double dt, FluidState& state) {
    const bool enhanced = solid.u != nullptr && laws.mobility > 0 && laws.viscosity > 0;
    finite_volume::State& now = state.now;
    range.for_each(now.nodes.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
        const double h = now.depth[cell];
        if (!(h > laws.dry) || (laws.manning_in_sweeps && !(solid.depth != nullptr && solid.depth[cell] > 0))) return;
        const BedFrame frame = state.frame(cell);
        const Point start{now.qx[cell] / h, now.qy[cell] / h};  // along the bed
        Point w = start;
        const double solids = solid.solid_fraction != nullptr ? solid.solid_fraction[cell] : 0;
        const double solid_depth = solid.depth != nullptr ? solid.depth[cell] : 0;
        const double total = h + solid_depth;
        // Linear: viscous shear at the bed, damping towards the solids' velocity.
        double linear = 0;
        if (laws.viscosity > 0) {
            Point pull{state.force_x[cell] / h, state.force_y[cell] / h};
            const double nu = kinematic_viscosity(laws, solids);
            linear = laws.velocity_shape * nu / (total * total);
            if (enhanced) {
                const double loose = solid.structured != nullptr ? 1 - solid.structured[cell] : 1;
                const double rate = laws.mobility * nu / std::max(h / total, k_least_free_fraction) *
                                    laws.solids_shape * solids * loose / (total * total);
                linear += rate;
                pull.x += rate * solid.u[cell];
                pull.y += rate * solid.v[cell];
            }
            const Point gain = frame.along_bed(dt * pull.x, dt * pull.y);
            w = {w.x + gain.x, w.y + gain.y};
        }
        // Quadratic: Manning, along the bed. The speed V after the step solves V (1 + dt linear + dt a V) = V*.
        const double speed = std::sqrt(w.x * w.x + w.y * w.y), b = 1 + dt * linear, flat = 1 / frame.root;
        const double own = manning_resistance(dt * laws.gravity, laws.manning, h * flat);
        double kept = 1 / implicit_divisor(speed, b, own);
        if (laws.manning_on_total && solid_depth > 0 && speed > 0) {
            // The solids' velocity along the fluid's, as a part of it; over solids at rest the fluid has its own depth.
            const Point u = frame.in_map(w.x, w.y);
            const double along = (u.x * solid.u[cell] + u.y * solid.v[cell]) / (u.x * u.x + u.y * u.y);
            const double both = dt * column_resistance(laws, solid, cell, h, flat);
            if (along > 0) kept = speed_over_solids(speed, b, both, own - both, along * speed) / speed;
        }
        now.qx[cell] = h * w.x * kept;
        now.qy[cell] = h * w.y * kept;
        if (!(solid_depth > 0) || state.resistance_x.size() == 0) return;
        const Point change = frame.in_map(w.x * kept - start.x, w.y * kept - start.y);
        state.resistance_x[cell] += change.x;
        state.resistance_y[cell] += change.y;
    });
}

namespace {

// Values of a cell that the stress at a face depends on.
struct Cell {
    double depth = 0, u = 0, v = 0;  // of the fluid
    double fraction = 0;             // alpha_c
    double wu = 0, wv = 0;           // velocity relative to the solids
    double nu_n = 0, nu_a = 0;       // [m2/s]
    bool wet = false;
};

struct Gradient {
    double u, v, fraction;
};

}  // namespace

void shear(const NodeRange& range, const FluidLaws& laws, const SolidsOnGrid& solid, FluidState& state) {
    const NodeGrid& nodes = state.now.nodes;
    const double dx = nodes.cell_size();
    const std::int64_t stride = nodes.stride(), rows = nodes.padded_rows();
    const auto cell_at = [&](std::int64_t i, std::int64_t j) {
        Cell c;
        if (i < 0 || j < 0 || i >= stride || j >= rows) return c;
        const auto k = static_cast<std::size_t>(j * stride + i);
        c.depth = state.now.depth[k];
        c.wet = c.depth > laws.dry;
        if (!c.wet) return c;
        const Point velocity = state.velocity(k);
        c.u = velocity.x;
        c.v = velocity.y;
        c.nu_n = kinematic_viscosity(laws, solid.solid_fraction != nullptr ? solid.solid_fraction[k] : 0);
        if (solid.u != nullptr && solid.depth[k] > 0) {
            const double total = c.depth + solid.depth[k];
            c.fraction = solid.depth[k] / total;
            c.wu = c.u - solid.u[k];
            c.wv = c.v - solid.v[k];
            c.nu_a = laws.mobility * c.nu_n / std::max(1 - c.fraction, k_least_free_fraction);
        }
        return c;
    };
    // Derivative across a face's direction: the mean of the two cells' central differences, where wet.
    const auto along_face = [&](const Cell& below, const Cell& here, const Cell& above) {
        const Cell& low = below.wet ? below : here;
        const Cell& high = above.wet ? above : here;
        const int steps = below.wet + above.wet;
        const double inverse = steps > 0 ? 1 / (steps * dx) : 0;
        return Gradient{(high.u - low.u) * inverse, (high.v - low.v) * inverse,
                        (high.fraction - low.fraction) * inverse};
    };
    // Force per length of the face between cell (i, j) and its upper neighbour, along x or along y [m3/s2].
    struct Force {
        double x = 0, y = 0;
    };
    const auto face = [&](std::int64_t i, std::int64_t j, bool x_face) {
        const std::int64_t a = x_face ? 1 : 0, b = 1 - a;
        const Cell low = cell_at(i, j), high = cell_at(i + a, j + b);
        if (!low.wet || !high.wet) return Force{};
        const double depth = std::min(low.depth, high.depth);
        const double nu_n = 0.5 * (low.nu_n + high.nu_n), nu_a = 0.5 * (low.nu_a + high.nu_a);
        const double wu = 0.5 * (low.wu + high.wu), wv = 0.5 * (low.wv + high.wv);
        const Gradient normal{(high.u - low.u) / dx, (high.v - low.v) / dx, (high.fraction - low.fraction) / dx};
        const Gradient l = along_face(cell_at(i - b, j - a), low, cell_at(i + b, j + a));
        const Gradient h = along_face(cell_at(i + a - b, j + b - a), high, cell_at(i + a + b, j + b + a));
        const Gradient tangent{0.5 * (l.u + h.u), 0.5 * (l.v + h.v), 0.5 * (l.fraction + h.fraction)};
        const Gradient& gx = x_face ? normal : tangent;
        const Gradient& gy = x_face ? tangent : normal;
        const double xy = nu_n * (gy.u + gx.v) - nu_a * (gx.fraction * wv + gy.fraction * wu);
        if (x_face) return Force{depth * (2 * nu_n * gx.u - 2 * nu_a * gx.fraction * wu), depth * xy};
        return Force{depth * xy, depth * (2 * nu_n * gy.v - 2 * nu_a * gy.fraction * wv)};
    };
    range.for_each(stride, [&](std::size_t cell, std::int64_t i, std::int64_t j) {
        const Force east = face(i, j, true), west = face(i - 1, j, true);
        const Force north = face(i, j, false), south = face(i, j - 1, false);
        state.force_x[cell] = (east.x - west.x + north.x - south.x) / dx;
        state.force_y[cell] = (east.y - west.y + north.y - south.y) / dx;
    });
}

}  // namespace frana::structured
