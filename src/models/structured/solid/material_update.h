// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/column_state.h"
#include "models/structured/solid/drucker_prager.h"
#include "models/structured/solid/pair_work.h"
#include "particles/cell_order.h"

namespace frana::structured {

/// Stress after dt of the velocity gradient l: turned with the material, elastic trial, return to the yield surface of
/// what the particle carries together with the geostatic stress, -diag(p, p, N / 2). That vertical stress stays as the
/// weight gives it, so the particle's own is zero. p is the column's thrust over its depth or, where that is less than
/// the strength asks for with both sides giving way, the strength's active pressure: the state at rest never yields.
inline Returned next_stress(const SolidLaws& laws, const ParticleLoad& column, double friction,
                            const VelocityGradient& l, double dt, Stress stress) noexcept {
    const auto strength = DruckerPrager::of(friction, column.cohesion);
    const Stress trial = rotated(stress, dt * l.spin()) + laws.elastic.increment(l, dt);
    if (laws.strength_of_particle_stress) return return_by_itself(strength, laws.elastic, laws.sin_dilatancy, trial);
    const double load = 0.5 * column.load;
    const double lateral = std::max(column.thrust / column.depth, strength.active_pressure(load));
    const Returned r = return_under_load(strength, laws.elastic, laws.sin_dilatancy,
                                         {trial.xx - lateral, trial.yy - lateral, -load, trial.xy});
    if (!r.yielded) return {{trial.xx, trial.yy, 0, trial.xy}, false};
    return {{r.stress.xx + lateral, r.stress.yy + lateral, 0, r.stress.xy}, true};
}

/// Stress, strain, damage and release of confined fluid over dt, and what the next sums over neighbours need. Reads the
/// velocity gradients in `w`; writes t_*, e_*, damage, cohesion_ratio, released; mass, density, t, r and resistance in
/// `w`.
template <class Kind>
void update_material(ParticleRun run, double dt, const SolidLaws& laws, ParticleSet& particles, PairWork& w) {
    for (std::size_t p = run.begin; p < run.end; ++p) {
        const VelocityGradient l{w[PairWork::l_xx][p], w[PairWork::l_xy][p], w[PairWork::l_yx][p],
                                 w[PairWork::l_yy][p]};
        if (laws.earth_pressure == EarthPressure::passive) particles[Field::divergence][p] = l.divergence();
        const ParticleLoad column = particle_load<Kind>(laws, particles, p);
        const bool flows = flows_freely(laws, column);
        const Stress old{particles[Field::t_xx][p], particles[Field::t_yy][p], particles[Field::t_zz][p],
                         particles[Field::t_xy][p]};
        const auto [stress, yielded] =
            flows ? Returned{{}, true} : next_stress(laws, column, particles[Field::friction][p], l, dt, old);
        particles[Field::t_xx][p] = stress.xx;
        particles[Field::t_yy][p] = stress.yy;
        particles[Field::t_zz][p] = stress.zz;
        particles[Field::t_xy][p] = stress.xy;
        const Stress strain = rotated(
            {particles[Field::e_xx][p], particles[Field::e_yy][p], 0, particles[Field::e_xy][p]}, dt * l.spin());
        particles[Field::e_xx][p] = strain.xx + dt * l.xx;
        particles[Field::e_yy][p] = strain.yy + dt * l.yy;
        particles[Field::e_xy][p] = strain.xy + dt * l.shear();
        if constexpr (Kind::cohesive) {
            const double before = particles[Field::cohesion_ratio][p];
            if (laws.fractures && yielded && before > 0) {
                const double damage = particles[Field::damage][p] + dt * laws.fragmentation.rate(l);
                const double after = std::min(before, laws.fragmentation.cohesion_ratio(damage));
                particles[Field::damage][p] = damage;
                particles[Field::cohesion_ratio][p] = after;
                if constexpr (Kind::wet) {
                    // It goes with the particle until the step is done: the nodes' push was for both.
                    const double confined = particles[Field::confined][p] - particles[Field::released][p];
                    particles[Field::released][p] += confined * (1 - after / before);
                }
            }
        }
        const double area = particles[Field::area][p], density = column.mass / area;
        const double integrated = column.depth / (density * density);
        const PlaneTensor t{integrated * stress.xx, integrated * stress.yy, integrated * stress.xy};
        const PlaneTensor r = artificial_stress(t, laws.artificial_stress);
        w[PairWork::mass][p] = column.mass;
        w[PairWork::density][p] = density;
        w[PairWork::t_xx][p] = t.xx;
        w[PairWork::t_yy][p] = t.yy;
        w[PairWork::t_xy][p] = t.xy;
        w[PairWork::r_xx][p] = r.xx;
        w[PairWork::r_yy][p] = r.yy;
        w[PairWork::r_xy][p] = r.xy;
        w[PairWork::sound][p] = flows ? std::sqrt(laws.gravity * column.depth) : laws.viscosity.sound;
        w[PairWork::resistance][p] = column.load / density * particles[Field::bed_friction][p] *
                                     (laws.steep ? particles[Field::flatness][p] : 1);
    }
}

}  // namespace frana::structured
