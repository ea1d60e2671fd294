// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/damage_spread.h"

#include <algorithm>

namespace frana::structured {

void DamageSpread::operator()(const CellOrder& order, const Fragmentation& law, ParticleSet& particles,
                              const SolidWork& work, ThreadPool& pool) {
    const double *x = particles[Field::x], *y = particles[Field::y], *volume = particles[Field::volume];
    const double *strain = work[SolidWork::strain], *bonds = work[SolidWork::bonds];
    double *ratio = particles[Field::cohesion_ratio], *damage = particles[Field::damage];
    lattice_.begin();
    order.for_each_strip(4 * lattice_.side(), pool, [&](ParticleRun run) {
        for (std::size_t p = run.begin; p < run.end; ++p) {
            if (bonds[p] == 0) continue;
            const auto at = lattice_.at(x[p], y[p]);
            at.for_each([&, w = volume[p] * ratio[p], d = strain[p]](auto& node, int a, int b) {
                const double part = at.wx[a] * at.wy[b] * w;
                Sums& sums = lattice_.fresh(node);
                sums.weight += part;
                sums.damage += part * d;
            });
        }
    });
    pool.for_each(static_cast<std::size_t>(order.rows()), [&](std::size_t r) {
        const auto row = static_cast<std::int64_t>(r);
        const ParticleRun run = order.whole_rows(row, row);
        for (std::size_t p = run.begin; p < run.end; ++p) {
            if (!(ratio[p] > 0)) continue;
            Sums mean{1, strain[p]};
            if (bonds[p] > 0) {
                mean = {};
                const auto at = lattice_.at(x[p], y[p]);
                at.for_each([&](const Sums& node, int a, int b) {
                    mean.weight += at.wx[a] * at.wy[b] * node.weight;
                    mean.damage += at.wx[a] * at.wy[b] * node.damage;
                });
            }
            if (!(mean.damage > 0)) continue;
            damage[p] += mean.damage / mean.weight;
            ratio[p] = std::min(ratio[p], law.cohesion_ratio(damage[p]));
        }
    });
}

}  // namespace frana::structured
