// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mpm/curvature.h"
#include "mpm/erodible_bed.h"
#include "mpm/node_grid.h"
#include "mpm/shape.h"
#include "mpm/update_nodes.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"
#include "physics/bed_contact.h"
#include "physics/bed_state.h"
#include "physics/parameters.h"

namespace frana {

/// Sets thickness and support of each node with mass; the laws then add their parts. Reads NodeForces mass, area, px,
/// py (curved only), bed; writes BedState.
template <class Slope>
void fill_bed_states(const NodeRange& range, const NodeUpdate& k, const NodeGrid& nodes, BedState* states) {
    range.for_each(nodes.stride(), [&](std::size_t i, std::int64_t column, std::int64_t row) {
        const NodeForces& node = nodes.forces()[i];
        if (!(node.mass > 0)) return;
        const NodeDrive<double> ground = load_on<Slope, double>(bed_at<Slope>(nodes, i, column, row),
                                                                node.px / node.mass, node.py / node.mass, k.gravity);
        const double root = Slope::metric ? std::sqrt(ground.n) : 1;
        const double pore = k.pore_sums != nullptr ? std::min(1.0, k.pore_sums[i] / node.mass) : 0;
        states[i] = {node.mass / node.area / root, (k.gravity + ground.load) / root, 0, 0, 0, 0, pore};
    });
}

/// A step of the pore pressure of a tile's particles: they advance over `dt`, and the nodes receive their state in the
/// middle, at the time of the forces. Reads x, y, u, v, volume, area; reads and writes pore_pressure and, with
/// dilatancy, solid_fraction; adds w V r to `sums`.
/// @param gravity vertical [m/s2]  @param along_bed whether the particles' velocity is that along the bed
template <class Shape, bool Metric>
void pore_pressure_to_nodes(const ParticleTile& tile, const PorePressure& law, double dt, double gravity,
                            bool along_bed, const NodeGrid& nodes, ParticleSet& particles, double* sums) {
    const NodeScale grid = nodes.scale();
    double *const ratio = particles[Field::pore_pressure], *const solid = particles[Field::solid_fraction];
    for (std::size_t p = tile.begin; p < tile.end; ++p) {
        const double u = particles[Field::u][p], v = particles[Field::v][p], volume = particles[Field::volume][p];
        const Stencil<Shape> s(particles[Field::x][p], particles[Field::y][p], grid);
        double root = 1, climb = 0;
        if constexpr (Metric) {
            const Interpolated z = interpolate(s, nodes.bed.data(), nodes.stride());
            root = std::sqrt(1 + z.dx * z.dx + z.dy * z.dy);
            if (!along_bed) climb = u * z.dx + v * z.dy;
        }
        const double thickness = volume / particles[Field::area][p] / root, speed = speed_along_bed(u, v, climb);
        const auto half_step = [&] {
            const auto after =
                law.after({ratio[p], solid != nullptr ? solid[p] : 0}, thickness, speed, gravity / root, 0.5 * dt);
            ratio[p] = after.ratio;
            if (solid != nullptr) solid[p] = after.solid_fraction;
        };
        half_step();
        for (int b = 0; b < Shape::width; ++b)
            for (int a = 0; a < Shape::width; ++a)
                sums[s.first + static_cast<std::size_t>(b * grid.stride + a)] += s.wx[a] * s.wy[b] * volume * ratio[p];
        half_step();
    }
}

/// Adds one law to the nodes of a tile.
template <class Law>
void add_friction(const NodeRange& range, const Law& law, const NodeGrid& nodes, BedState* states) {
    range.for_each(nodes.stride(), [&](std::size_t i, std::int64_t, std::int64_t) {
        if (nodes.mass(i) > 0) law(states[i], i);
    });
}

/// Computes erosion (or, where nothing is eroded, deposition) at a tile's nodes in this step. Follows update_nodes,
/// whose friction gives the bed resistance. Deposited material can be eroded again. Deposition leaves a least depth of
/// the flow, so that particles keep a volume. Reads NodeMotion mass, velocity, fraction; BedState; bed; reads and
/// writes ErodibleBed. Nodes outside the terrain and solid ones do not exchange.
/// @param density [kg/m3]  @param dt [s]  @param least_depth depth that deposition leaves [m]
template <bool Metric, class Erosion, class Deposition>
void exchange_at_nodes(const NodeRange& range, const Erosion& erosion, const Deposition& deposition, double density,
                       double dt, double least_depth, const BedState* states, const NodeGrid& nodes,
                       ErodibleBed* beds) {
    const double half_inverse_dx = 0.5 / nodes.cell_size(), cell_area = nodes.cell_size() * nodes.cell_size();
    const std::int64_t stride = nodes.stride();
    const std::uint8_t* solid = nodes.solid();
    range.for_each(stride, [&](std::size_t i, std::int64_t column, std::int64_t row) {
        const NodeMotion& node = nodes.motion()[i];
        ErodibleBed& erodible_bed = beds[i];
        erodible_bed.gain = erodible_bed.loss = erodible_bed.change = erodible_bed.held = 0;
        if (!(node.mass > 0) || nodes.is_ghost(column, row) || (solid && solid[i])) return;
        const double climb = Metric ? climb_at(nodes.bed.data() + i, stride, half_inverse_dx, node.u, node.v) : 0;
        const double speed = speed_along_bed(node.u, node.v, climb);
        const BedState& bed = states[i];
        const double mass = density * bed.thickness, fraction = std::min(1.0, node.fraction);
        const BedContact contact{node.mass / (fraction * cell_area),
                                 speed,
                                 mass * bed.resistance,
                                 mass * bed.normal_gravity,
                                 erodible_bed.eroded,
                                 dt};
        const double to_fraction = cell_area / node.mass;
        if constexpr (Erosion::active) {
            const double left =
                erodible_bed.erodible + (erodible_bed.deposited - erodible_bed.kept) - erodible_bed.eroded;
            const double depth = std::min(erosion(contact) * dt * fraction, left);
            if (depth > 0) {
                erodible_bed.eroded += depth;
                erodible_bed.gain = depth * to_fraction;
                erodible_bed.change = -depth;
                return;
            }
        }
        if constexpr (Deposition::active) {
            const double most = node.mass / cell_area - least_depth * fraction;
            const double depth = std::min(deposition(contact) * dt * fraction, most);
            if (depth > 0) {
                erodible_bed.deposited += depth;
                erodible_bed.loss = depth * to_fraction;
                erodible_bed.change = depth;
            }
        }
    });
}

/// Takes from the flow what forest holds in this step, after exchange_at_nodes and beside it, down to the same least
/// depth. Reads NodeMotion mass, velocity, fraction; bed; reads and writes ErodibleBed.
template <bool Metric, class Detrainment>
void detrain_at_nodes(const NodeRange& range, const Detrainment& detrainment, double dt, double least_depth,
                      const NodeGrid& nodes, ErodibleBed* beds) {
    const double half_inverse_dx = 0.5 / nodes.cell_size(), cell_area = nodes.cell_size() * nodes.cell_size();
    const std::int64_t stride = nodes.stride();
    const std::uint8_t* const solid = nodes.solid();
    range.for_each(stride, [&](std::size_t i, std::int64_t column, std::int64_t row) {
        const NodeMotion& node = nodes.motion()[i];
        ErodibleBed& bed = beds[i];
        if (!(bed.forest > 0 && node.mass > 0) || nodes.is_ghost(column, row) || (solid && solid[i])) return;
        const auto climb = [&](double u, double v) {
            return Metric ? climb_at(nodes.bed.data() + i, stride, half_inverse_dx, u, v) : 0;
        };
        const double speed = speed_along_bed(node.u, node.v, climb(node.u, node.v));
        if (!(speed > 0)) return;
        const double stretch = std::sqrt(1 + climb(1, 0) * climb(1, 0) + climb(0, 1) * climb(0, 1));
        const double fraction = std::min(1.0, node.fraction);
        const double most = node.mass / cell_area - least_depth * fraction - std::max(0.0, bed.change);
        const double depth = std::min(detrainment(bed.forest, speed, stretch) * dt * fraction, most);
        if (!(depth > 0)) return;
        bed.held = depth;
        bed.kept += depth;
        bed.deposited += depth;
        bed.loss += depth * cell_area / node.mass;
    });
}

/// Moves the bed; a separate sweep, since slopes are read across tiles.
inline void move_bed(const NodeRange& range, const ErodibleBed* beds, NodeGrid& nodes) {
    range.for_each(nodes.stride(),
                   [&](std::size_t i, std::int64_t, std::int64_t) { nodes.bed[i] += beds[i].change + beds[i].held; });
}

/// Adds to particles what their nodes gained and removes what they lost, in proportion to their volume, area unchanged:
/// the sum over particles equals the sum over nodes exactly. Eroded material is at rest, so the particle's velocity
/// decreases and its momentum is unchanged; deposited material leaves with its momentum. Must precede the motion of the
/// particles. Reads x, y, ErodibleBed; reads and writes volume; writes the fraction of their velocity that particles
/// keep.
template <class Shape>
void exchange_with_particles(std::size_t begin, std::size_t end, const NodeGrid& nodes, const ErodibleBed* beds,
                             ParticleSet& particles, double* kept, double* lost, ExchangeReport& report) {
    const NodeScale grid = nodes.scale();
    double* volume = particles[Field::volume];
    for (std::size_t p = begin; p < end; ++p) {
        const Stencil<Shape> s(particles[Field::x][p], particles[Field::y][p], grid);
        double gain = 0, loss = 0;
        for (int b = 0; b < Shape::width; ++b) {
            const ErodibleBed* row = beds + s.first + b * nodes.stride();
            for (int a = 0; a < Shape::width; ++a) {
                const double w = s.wx[a] * s.wy[b];
                gain += w * row[a].gain;
                loss += w * row[a].loss;
            }
        }
        kept[p] = 1 / (1 + gain);
        lost[p] = loss * volume[p];
        report.eroded += gain * volume[p];
        report.deposited += lost[p];
        volume[p] *= 1 + gain - loss;
    }
}

/// Mixes the particles with the material eroded, after nodes_to_particles: these fractions keep their velocity, the
/// rest has that of the bed, none, and its pore pressure.
inline void mix_particles(std::size_t begin, std::size_t end, const double* kept, const double* lost,
                          const PorePressure::State& bed, ParticleSet& particles, ExchangeReport& report) {
    const auto mix = [&](Field field, double of_bed) {
        double* const values = particles[field];
        if (values == nullptr) return;
        for (std::size_t p = begin; p < end; ++p) values[p] *= kept[p];
        if (of_bed > 0)
            for (std::size_t p = begin; p < end; ++p) values[p] += (1 - kept[p]) * of_bed;
    };
    for (const Field f : {Field::u, Field::v, Field::c_xx, Field::c_xy, Field::c_yx, Field::c_yy}) mix(f, 0);
    mix(Field::pore_pressure, bed.ratio);
    mix(Field::solid_fraction, bed.solid_fraction);
    for (std::size_t p = begin; p < end; ++p) {
        report.momentum_x += lost[p] * particles[Field::u][p];
        report.momentum_y += lost[p] * particles[Field::v][p];
    }
}

}  // namespace frana
