// SPDX-License-Identifier: Apache-2.0
#include "simulation/problem_place.h"

#include <cmath>
#include <limits>

#include "simulation/flow.h"
#include "simulation/structured_flow.h"

namespace frana {
namespace {

// Bound of the position of a particle moved by a step; nodes_to_particles leaves non-finite ones where they were.
constexpr double k_finite = 1e9;

Point place(const ParticleSet& particles, std::size_t p) {
    return {particles[Field::x][p], particles[Field::y][p]};
}

Point middle(const NodeGrid& nodes, std::size_t node) {
    const auto index = static_cast<std::int64_t>(node);
    return nodes.middle(index % nodes.stride(), index / nodes.stride());
}

std::optional<Point> non_finite_particle(const ParticleSet& particles) {
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double speed = std::hypot(particles[Field::u][p], particles[Field::v][p]);
        const double depth = particles[Field::volume][p] / particles[Field::area][p];
        const Point at = place(particles, p);
        if (!(speed < k_finite && depth < k_finite)) return at;
    }
    return std::nullopt;
}

std::optional<Point> particle_in_gap(const ParticleSet& particles, const NodeGrid& nodes) {
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Point at = place(particles, p);
        if (nodes.bounds().contains(at.x, at.y) && nodes.is_gap(nodes.scale().node_of(at.x, at.y))) return at;
    }
    return std::nullopt;
}

// The step that first exceeds the bound is the run's last: the place is that of the greatest speed so far.
template <class AnyFlow>
std::optional<Point> fastest(const AnyFlow& flow, const ParticleSet* particles) {
    std::optional<Point> at;
    double greatest = 0;
    flow.for_each_active_node([&](std::size_t node) {
        const double speed = flow.maxima().speed[node];
        if (!(speed > greatest)) return;
        greatest = speed;
        at = middle(flow.nodes(), node);
    });
    for (std::size_t p = 0; particles != nullptr && p < particles->size(); ++p) {
        const double speed = std::hypot((*particles)[Field::u][p], (*particles)[Field::v][p]);
        if (!(speed > greatest)) continue;
        greatest = speed;
        at = place(*particles, p);
    }
    return at;
}

const ParticleSet* particles_of(const StructuredFlow& flow) {
    return flow.state().solid ? &flow.state().solid->particles : nullptr;
}

}  // namespace

std::optional<Point> place_of_non_finite(const Flow& flow) {
    return non_finite_particle(flow.particles());
}

std::optional<Point> place_of_non_finite(const StructuredFlow& flow) {
    std::optional<Point> at;
    if (const ParticleSet* particles = particles_of(flow)) at = non_finite_particle(*particles);
    if (at || !flow.state().fluid) return at;
    const structured::FluidFields& now = flow.state().fluid->now;
    // If all values are finite, the fluid was too fast to be computed further: returns its fastest cell.
    double greatest = 0;
    flow.for_each_active_node([&](std::size_t cell) {
        const bool finite = std::isfinite(now.depth[cell] + now.qx[cell] + now.qy[cell]);
        const double speed = !finite               ? std::numeric_limits<double>::infinity()
                             : now.depth[cell] > 0 ? std::hypot(now.qx[cell], now.qy[cell]) / now.depth[cell]
                                                   : 0;
        if (!(speed > greatest)) return;
        greatest = speed;
        at = middle(flow.nodes(), cell);
    });
    return at;
}

std::optional<Point> place_of_speed(const Flow& flow) {
    return fastest(flow, &flow.particles());
}

std::optional<Point> place_of_speed(const StructuredFlow& flow) {
    return fastest(flow, particles_of(flow));
}

std::optional<Point> place_of_no_data(const Flow& flow) {
    return particle_in_gap(flow.particles(), flow.nodes());
}

std::optional<Point> place_of_no_data(const StructuredFlow& flow) {
    std::optional<Point> at;
    const NodeGrid& nodes = flow.nodes();
    if (const ParticleSet* particles = particles_of(flow)) at = particle_in_gap(*particles, nodes);
    if (at || !flow.state().fluid) return at;
    const structured::FluidState& fluid = *flow.state().fluid;
    const auto stride = static_cast<std::size_t>(nodes.stride());
    flow.for_each_active_node([&](std::size_t cell) {
        if (at || !(fluid.now.depth[cell] > 0)) return;
        for (const std::size_t near : {cell - 1, cell + 1, cell - stride, cell + stride}) {
            if (fluid.cell_kind[near] == structured::k_gap_cell) at = middle(nodes, cell);
        }
    });
    return at;
}

}  // namespace frana
