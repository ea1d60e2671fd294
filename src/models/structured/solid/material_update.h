// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/column_state.h"
#include "models/structured/solid/pair_work.h"
#include "models/structured/solid/solid_laws.h"
#include "particles/cell_order.h"

namespace frana::structured {

/// Stress after a rotation R and a strain in the plane (both of one substep): rotation with the material, elastic
/// trial, return to the yield surface of the sum with the geostatic stress, -diag(p, p, N / 2). That vertical stress is
/// given by the weight, so the particle's own is zero. p is the column's thrust over its depth or, where that is less,
/// the strength's active pressure for yielding in both directions: the state at rest never yields.
///
/// If the excess of the load over the strength q is hydrostatic, p = N / 2 - q in all three directions adds no friction
/// inside, as in material without cohesion: the check is that of the rest, -diag(0, 0, q). So a column that does not
/// bear itself has the thrust p also while it yields, and both tend to those of broken material with the cohesion.
inline Returned next_stress(const SolidLaws& laws, const ParticleLoad& column, double friction, const Matrix2d& turn,
                            const Matrix2d& strain, const Stress& stress) noexcept {
    const auto strength = DruckerPrager::of(friction, column.cohesion);
    const Stress trial = Stress{rotated(stress.plane, turn), stress.zz} + laws.elastic.increment(strain);
    if (laws.strength_of_particle_stress) return return_by_itself(strength, laws.elastic, laws.sin_dilatancy, trial);
    const double load = column.borne;
    const double pressure =
        excess_is_hydrostatic(laws) ? 0 : std::max(column.thrust / column.depth, strength.active_pressure(load));
    const Matrix2d lateral = pressure * Matrix2d::Identity();
    const Returned r = return_under_load(strength, laws.elastic, laws.sin_dilatancy, {trial.plane - lateral, -load});
    if (!r.yielded) return {{trial.plane, 0}, false};
    return {{r.stress.plane + lateral, 0}, true};
}

/// Stress, strain, damage and release of confined fluid over dt, and the inputs of the next sums over neighbours. Reads
/// the velocity gradients in `w`; writes t_*, e_*, damage, cohesion_ratio, released; mass, density, t, r and resistance
/// in `w`.
template <class Kind>
void update_material(ParticleRun run, double dt, const SolidLaws& laws, ParticleSet& particles, PairWork& w) {
    for (std::size_t p = run.begin; p < run.end; ++p) {
        const Matrix2d l =
            tensor(w[PairWork::l_xx][p], w[PairWork::l_xy][p], w[PairWork::l_yx][p], w[PairWork::l_yy][p]);
        const Matrix2d turn = rotation(dt * spin(l)), strain = dt * strain_rate(l);
        if (laws.earth_pressure == EarthPressure::passive) particles[Field::divergence][p] = l.trace();
        const ParticleLoad column = particle_load<Kind>(laws, particles, p);
        const bool flows = flows_freely(laws, column);
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
            w[PairWork::strain][p] = loses ? laws.fragmentation.increment(strain) : 0;
            if constexpr (Kind::wet) {
                // Released fluid moves with the particle until the end of the step: the nodes' push was for both.
                double& released = particles[Field::released][p];
                released = std::max(released,
                                    particles[Field::confined][p] - particles[Field::confined_start][p] * column.held);
            }
        }
        const double area = particles[Field::area][p], density = column.mass / area;
        const Matrix2d t = column.depth / (density * density) * stress.plane;
        const Matrix2d r = artificial_stress(t, laws.artificial_stress);
        w[PairWork::mass][p] = column.mass;
        w[PairWork::density][p] = density;
        w[PairWork::t_xx][p] = t(0, 0);
        w[PairWork::t_yy][p] = t(1, 1);
        w[PairWork::t_xy][p] = t(0, 1);
        w[PairWork::r_xx][p] = r(0, 0);
        w[PairWork::r_yy][p] = r(1, 1);
        w[PairWork::r_xy][p] = r(0, 1);
        w[PairWork::sound][p] = flows ? std::sqrt(laws.gravity * column.depth) : laws.viscosity.sound;
        w[PairWork::resistance][p] =
            bed_resistance(laws, column, density, particles[Field::bed_friction][p], particles[Field::flatness][p]);
    }
}

}  // namespace frana::structured
