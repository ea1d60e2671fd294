// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/damage_spread.h"

#include <algorithm>
#include <cmath>

#include "models/structured/solid/cubic_stencil.h"

namespace frana::structured {

DamageSpread::DamageSpread(const Bounds& bounds, double length)
    : side_(std::sqrt(1.5) * length),
      west_(CubicSpline::first(bounds.west / side_)),
      south_(CubicSpline::first(bounds.south / side_)),
      columns_(CubicSpline::first(bounds.east / side_) + 4 - west_),
      rows_(CubicSpline::first(bounds.north / side_) + 4 - south_),
      sums_(static_cast<std::size_t>(columns_ * rows_)) {}

template <class Visit>
void DamageSpread::at_nodes(double x, double y, const Visit& visit) {
    double wx[4], wy[4], unused[4];
    // Particles that have just left the terrain act at its edge.
    const std::int64_t i = CubicSpline::evaluate(x / side_, wx, unused) - west_;
    const std::int64_t j = CubicSpline::evaluate(y / side_, wy, unused) - south_;
    Sums* node = sums_.data() + std::clamp<std::int64_t>(j, 0, rows_ - 4) * columns_ +
                 std::clamp<std::int64_t>(i, 0, columns_ - 4);
    for (int b = 0; b < 4; ++b, node += columns_)
        for (int a = 0; a < 4; ++a) visit(node[a], wx[a] * wy[b]);
}

std::vector<std::uint8_t> DamageSpread::operator()(const CellOrder& order, const Fragmentation& law,
                                                   ParticleSet& particles, PairWork& work, ThreadPool& pool) {
    const double *x = work[PairWork::x], *y = work[PairWork::y], *strain = work[PairWork::strain];
    const double* const volume = particles[Field::volume];
    double *ratio = particles[Field::cohesion_ratio], *damage = particles[Field::damage];
    ++call_;
    double* const bonds = work[PairWork::bonds];
    const auto add = [&](ParticleRun run) {
        for (std::size_t p = run.begin; p < run.end; ++p) {
            if (bonds[p] == 0) continue;
            const double w = volume[p] * ratio[p];
            at_nodes(x[p], y[p], [this, w, d = w * strain[p]](Sums& node, double part) {
                if (node.call != call_) node = {0, 0, call_};
                node.weight += part * w;
                node.damage += part * d;
            });
        }
    };
    order.for_each_strip(4 * side_, pool, add);
    std::vector<std::uint8_t> lost(static_cast<std::size_t>(order.rows() * order.columns()), 0);
    const auto lose = [&](ParticleRun run) {
        bool any = false;
        for (std::size_t p = run.begin; p < run.end; ++p) {
            if (!(ratio[p] > 0)) continue;
            Sums mean{1, strain[p]};
            if (bonds[p] > 0) {
                mean = {};
                at_nodes(x[p], y[p], [&](const Sums& node, double part) {
                    mean.weight += part * node.weight;
                    mean.damage += part * node.damage;
                });
            }
            if (!(mean.damage > 0)) continue;
            damage[p] += mean.damage / mean.weight;
            ratio[p] = std::min(ratio[p], law.cohesion_ratio(damage[p]));
            if (ratio[p] == 0) bonds[p] = 0;
            any = true;
        }
        return any;
    };
    pool.for_each(static_cast<std::size_t>(order.rows()), [&](std::size_t r) {
        const auto row = static_cast<std::int64_t>(r);
        for (std::int64_t column = 0; column < order.columns(); ++column)
            lost[static_cast<std::size_t>(row * order.columns() + column)] = lose(order.cell(row, column));
    });
    return lost;
}

}  // namespace frana::structured
