// SPDX-License-Identifier: Apache-2.0
#include "models/structured/coupling/couple_nodes.h"

#include <algorithm>
#include <cmath>

#include "models/structured/fluid/fluid_resistance.h"
#include "mpm/curvature.h"
#include "mpm/ground_slope.h"
#include "physics/friction_sum.h"

namespace frana::structured {
namespace {

/// Pores of what has been given as all solids, a part of its depth: else a film of water would lift a heap (ours; sand
/// and gravel have 0.2 to 0.4).
constexpr double k_least_porosity = 0.2;

// Slope of the fluid's surface h_u + h_c + b between wet cells; dry neighbours do not contribute.
Point surface_gradient(const NodeGrid& grid, const SolidNodes& nodes, const FluidState& fluid, double dry,
                       std::size_t n) {
    const auto stride = static_cast<std::size_t>(grid.stride());
    const auto level = [&](std::size_t k) { return fluid.now.depth[k] + nodes.depth[k] + grid.bed[k]; };
    const double here = level(n), inverse = 0.5 / grid.cell_size();
    const auto beside = [&](std::size_t k) { return fluid.now.depth[k] > dry ? level(k) : here; };
    return {inverse * (beside(n + 1) - beside(n - 1)), inverse * (beside(n + stride) - beside(n - stride))};
}

// Solids under fluid: buoyancy, then virtual mass and drag. Returns the total acceleration of the solids.
Point with_fluid(std::size_t n, double dt, const NodeGrid& grid, double gravity, double flat, Point slope, Point push,
                 const CouplingLaws& laws, const FluidLaws& bed, SolidNodes& nodes, FluidState& fluid) {
    const SolidSums& sums = nodes.sums[n];
    const CouplingSums& more = nodes.coupling[n];
    const double inverse_area = 1 / (grid.cell_size() * grid.cell_size());
    CellPhases cell;
    cell.free = fluid.now.depth[n];
    const SolidsOnGrid solid = fluid_inputs(nodes);
    const double filled = filled_pores(solid, n, cell.free);
    nodes.push[n].submergence = filled;
    if (!(cell.free > laws.dry)) return push;
    const Point surface = surface_gradient(grid, nodes, fluid, laws.dry, n);
    const double weight = gravity * flat, density = laws.drag.fluid.density;
    if (laws.buoyancy) {
        const double ratio = density * (sums.solids + sums.confined) / sums.mass;  // gamma_c
        push.x -= filled * ratio * weight * (surface.x - slope.x);
        push.y -= filled * ratio * weight * (surface.y - slope.y);
    }
    cell.solids = sums.solids * inverse_area;
    cell.confined = sums.confined * inverse_area;
    cell.coupled_mass = sums.mass * inverse_area;
    cell.structured = sums.structured / sums.solids;
    cell.grain_diameter = more.diameter / sums.solids;
    cell.friction = more.friction * inverse_area * flat;
    cell.coupled_velocity = {sums.px / sums.mass, sums.py / sums.mass};
    const Point velocity = fluid.velocity(n);
    cell.free_velocity = {velocity.x, velocity.y};
    if (bed.manning_on_total) {
        const double u = cell.coupled_velocity.x(), v = cell.coupled_velocity.y();
        const double speed = speed_along_bed(u, v, flat < 1 ? slope.x * u + slope.y * v : 0);
        const double braked = dt * column_resistance(bed, solid, n, cell.free, std::sqrt(flat));
        const double taken = (1 - 1 / implicit_divisor(speed, 1.0, braked)) / dt;
        push.x -= taken * u;
        push.y -= taken * v;
    }
    cell.push = {push.x, push.y};
    cell.free_push = {fluid.resistance_x[n] / dt - weight * surface.x, fluid.resistance_y[n] / dt - weight * surface.y};
    const Eigen::Vector2d impulse = exchange(laws, cell, dt);
    fluid.push(n, -impulse.x() / density, -impulse.y() / density);
    const double per_mass = 1 / (cell.coupled_mass * dt);
    return {push.x + impulse.x() * per_mass, push.y + impulse.y() * per_mass};
}

}  // namespace

SolidsOnGrid fluid_inputs(const SolidNodes& n) {
    return {n.depth.data(),      n.u.data(),    n.v.data(),    n.solid_fraction.data(),
            n.structured.data(), n.mass.data(), n.pores.data()};
}

void solids_to_fluid(const NodeRange& range, const NodeGrid& grid, const FluidState* fluid, SolidNodes& nodes) {
    const double inverse_area = 1 / (grid.cell_size() * grid.cell_size());
    range.for_each(grid.stride(), [&](std::size_t n, std::int64_t, std::int64_t) {
        const SolidSums& s = nodes.sums[n];
        if (!(s.mass > 0)) return;
        nodes.depth[n] = (s.solids + s.confined) * inverse_area;
        nodes.u[n] = s.px / s.mass;
        nodes.v[n] = s.py / s.mass;
        const double free = fluid ? fluid->now.depth[n] : 0;
        nodes.solid_fraction[n] = s.solids * inverse_area / (nodes.depth[n] + free);
        nodes.structured[n] = s.structured / s.solids;
        nodes.mass[n] = s.mass * inverse_area;
        nodes.pores[n] =
            fluid ? std::max(nodes.coupling[n].pores * inverse_area, k_least_porosity * nodes.depth[n]) : 0;
    });
}

void push_solids(const NodeRange& range, double dt, const NodeGrid& grid, const SolidLaws& laws,
                 const CouplingLaws& coupling, const FluidLaws& bed, SolidNodes& nodes, FluidState* fluid) {
    const std::int64_t last_column = grid.stride() - 1, last_row = grid.padded_rows() - 1;
    range.for_each(grid.stride(), [&](std::size_t n, std::int64_t i, std::int64_t j) {
        if (i < 1 || j < 1 || i >= last_column || j >= last_row) return;  // a gradient needs the nodes beside
        const SolidSums& sums = nodes.sums[n];
        if (!(sums.mass > 0)) return;
        const Point slope = ground_slope(grid, n);
        const double flatness = 1 / (1 + slope.x * slope.x + slope.y * slope.y), flat = laws.steep ? flatness : 1;
        Point push{-flat * laws.gravity * slope.x, -flat * laws.gravity * slope.y};
        nodes.push[n] = {0, 0, flatness, 0};
        if (fluid) push = with_fluid(n, dt, grid, laws.gravity, flat, slope, push, coupling, bed, nodes, *fluid);
        nodes.push[n].ax = push.x;
        nodes.push[n].ay = push.y;
    });
}

}  // namespace frana::structured
