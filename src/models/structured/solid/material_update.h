// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/column_state.h"
#include "models/structured/solid/solid_laws.h"
#include "models/structured/solid/solid_work.h"
#include "models/structured/solid/stress_nodes.h"
#include "particles/cell_order.h"

namespace frana::structured {

/// Stress after a rotation R and a strain in the plane (both of one substep): rotation with the material, elastic
/// trial, return to the yield surface of the sum with the geostatic stress, -diag(p, p, N / 2). That vertical stress is
/// given by the weight, so the particle's own is zero. The excess of the load over the strength q is hydrostatic:
/// p = N / 2 - q in all three directions adds no friction inside, as in material without cohesion, and the check is
/// that of the rest, -diag(0, 0, q). So a column that does not bear itself has the thrust p also while it yields, and
/// both tend to those of broken material with the cohesion.
inline Returned next_stress(const SolidLaws& laws, const ParticleLoad& column, double friction, const Matrix2d& turn,
                            const Matrix2d& strain, const Stress& stress) noexcept {
    const auto strength = DruckerPrager::of(friction, column.cohesion - column.lost);
    const Stress trial = Stress{rotated(stress.plane, turn), stress.zz} + laws.elastic.increment(strain);
    const Returned r = return_under_load(strength, laws.elastic, laws.sin_dilatancy, {trial.plane, -column.borne});
    if (!r.yielded) return {{trial.plane, 0}, false};
    return {{r.stress.plane, 0}, true};
}

/// Stress, strain, damage and release of confined fluid over dt, and the forces of stress and thrust on the nodes.
/// Reads the momenta there; writes t_*, e_*, released; opening, sound, strain, resistance in `w`. Runs that share no
/// node may be computed concurrently.
template <class Kind>
void update_material(ParticleRun run, double dt, const SolidLaws& laws, StressNodes& nodes, ParticleSet& particles,
                     SolidWork& w) {
    for (std::size_t p = run.begin; p < run.end; ++p) {
        const StressNodes::Stencil at = nodes.at(particles[Field::x][p], particles[Field::y][p]);
        const Matrix2d l = nodes.velocity_gradient(at, w[SolidWork::bonds][p] > 0);
        const Matrix2d turn = rotation(dt * spin(l)), strain = dt * strain_rate(l);
        const ParticleLoad column = particle_load<Kind>(laws, particles, p);
        const bool flows = flows_freely(column);
        const Stress old{symmetric(particles[Field::t_xx][p], particles[Field::t_yy][p], particles[Field::t_xy][p]),
                         particles[Field::t_zz][p]};
        const auto [stress, yielded] =
            flows ? Returned{{}, true} : next_stress(laws, column, particles[Field::friction][p], turn, strain, old);
        particles[Field::t_xx][p] = stress.xx();
        particles[Field::t_yy][p] = stress.yy();
        particles[Field::t_zz][p] = stress.zz;
        particles[Field::t_xy][p] = stress.xy();
        const Matrix2d total =
            rotated(symmetric(particles[Field::e_xx][p], particles[Field::e_yy][p], particles[Field::e_xy][p]), turn) +
            strain;
        particles[Field::e_xx][p] = total(0, 0);
        particles[Field::e_yy][p] = total(1, 1);
        particles[Field::e_xy][p] = total(0, 1);
        if constexpr (Kind::cohesive) {
            const bool loses = laws.fractures && yielded && particles[Field::cohesion_ratio][p] > 0;
            w[SolidWork::strain][p] = loses ? laws.fragmentation.increment(strain) : 0;
            if constexpr (Kind::wet) {
                // Released fluid moves with the particle until the end of the step: the nodes' push was for both.
                double& released = particles[Field::released][p];
                released = std::max(released,
                                    particles[Field::confined][p] - particles[Field::confined_start][p] * column.held);
            }
        }
        const double area = particles[Field::area][p];
        const double thrust = column.thrust * (laws.steep ? particles[Field::flatness][p] : 1);
        StressNodes::add_force(at, area * (column.depth * stress.plane - thrust * Matrix2d::Identity()), nodes.side());
        w[SolidWork::opening][p] = l.trace();
        w[SolidWork::sound][p] = flows ? std::sqrt(laws.gravity * column.depth) : laws.wave_speed;
        w[SolidWork::resistance][p] = bed_resistance(laws, column, column.mass / area,
                                                     particles[Field::bed_friction][p], particles[Field::flatness][p]);
    }
}

}  // namespace frana::structured
