// SPDX-License-Identifier: Apache-2.0
// Sums over neighbours and transfers of the structured solids: what they keep and what they get right.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "models/structured/solid/material_update.h"
#include "models/structured/solid/transfer.h"
#include "solid_cases.h"

namespace frana::structured::test {
namespace {

// A sheet of unevenly placed particles, sorted.
State uneven_sheet(Case& c, ThreadPool& pool, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    c.fill(20, 20, 60, 40, [&](Point) { return bench::Seed{5 + any(random), any(random), any(random)}; });
    for (std::size_t p = 0; p < c.columns.size(); ++p) {
        c.columns[Field::x][p] += 0.2 * c.laws.solid.spacing * any(random);
        c.columns[Field::y][p] += 0.2 * c.laws.solid.spacing * any(random);
    }
    return c.start(flat(50, 40, c.cell_size), pool);
}

template <class Task>
void over_rows(const CellOrder& order, const Task& task) {
    for (std::int64_t row = 0; row < order.rows(); ++row) task(row);
}

TEST(CellOrder, FindsEveryNeighbour) {
    ThreadPool pool(1);
    Case c(2);
    State state = uneven_sheet(c, pool, 4);
    const ParticleSet& p = state.solid->particles;
    const CellOrder& order = state.solid->order;
    std::vector<int> seen(p.size(), 0);
    over_rows(order, [&](std::int64_t row) {
        for (std::int64_t column = 0; column < order.columns(); ++column) {
            const auto runs = order.around(row, column);
            const ParticleRun own = order.cell(row, column);
            for (std::size_t i = own.begin; i < own.end; ++i) {
                for (const ParticleRun& run : runs) {
                    for (std::size_t k = run.begin; k < run.end; ++k) {
                        const double d = std::hypot(p[Field::x][k] - p[Field::x][i], p[Field::y][k] - p[Field::y][i]);
                        seen[i] += d < c.laws.solid.kernel.reach();
                    }
                }
            }
        }
    });
    for (std::size_t i = 0; i < p.size(); ++i) {
        int all = 0;
        for (std::size_t k = 0; k < p.size(); ++k) {
            const double d = std::hypot(p[Field::x][k] - p[Field::x][i], p[Field::y][k] - p[Field::y][i]);
            all += d < c.laws.solid.kernel.reach();
        }
        ASSERT_EQ(seen[i], all) << "particle " << i;
    }
}

TEST(VelocityGradients, RigidTurningIsNoStrain) {
    ThreadPool pool(1);
    Case c(2);
    State state = uneven_sheet(c, pool, 5);
    PairWork& w = state.solid->work;
    constexpr double omega = 0.7;
    const std::size_t n = state.solid->particles.size();
    for (std::size_t p = 0; p < n; ++p) {
        w[PairWork::u][p] = -omega * (w[PairWork::y][p] - 30);
        w[PairWork::v][p] = omega * (w[PairWork::x][p] - 40);
    }
    over_rows(state.solid->order, [&](std::int64_t row) {
        state.stages.pairs->velocity_gradients(state.solid->order, row, c.laws.solid.kernel, w);
    });
    for (std::size_t p = 0; p < n; ++p) {
        const Matrix2d l{{w[PairWork::l_xx][p], w[PairWork::l_xy][p]}, {w[PairWork::l_yx][p], w[PairWork::l_yy][p]}};
        EXPECT_LT(strain_rate(l).cwiseAbs().maxCoeff(), 1e-12 * omega);
        EXPECT_NEAR(spin(l), omega, 1e-12 * omega);
    }
}

TEST(Solids, RigidTranslationStressesNothing) {
    ThreadPool pool(1);
    Case c(2);
    c.laws.solid.gravity = 0;
    c.fill(20, 20, 15, 15, [](Point) { return bench::Seed{5, 3, -2}; });
    State state = c.start(flat(50, 40, c.cell_size), pool);
    advance_to(state, c.laws, 0.5, pool);
    const ParticleSet& p = state.solid->particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        EXPECT_NEAR(p[Field::u][i], 3, 1e-9);
        for (const Field f : {Field::t_xx, Field::t_yy, Field::t_zz, Field::t_xy})
            EXPECT_LT(std::abs(p[f][i]), 1e-10 * c.laws.solid.elastic.bulk);
    }
}

// Random stress and motion: every pair's forces are equal and opposite, so their sum is rounding.
TEST(Accelerations, KeepMomentum) {
    ThreadPool pool(1);
    Case c(2);
    State state = uneven_sheet(c, pool, 6);
    SolidState& solid = *state.solid;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (std::size_t p = 0; p < solid.particles.size(); ++p) {
        for (const Field f : {Field::t_xx, Field::t_yy, Field::t_xy}) solid.particles[f][p] = 1e6 * any(random);
    }
    for (const PairKernels* kernels : {&plain_pair_kernels(), &pair_kernels()}) {
        over_rows(solid.order, [&](std::int64_t row) {
            kernels->velocity_gradients(solid.order, row, c.laws.solid.kernel, solid.work);
            state.stages.update_material(solid.order.whole_rows(row, row), 0, c.laws.solid, solid.particles,
                                         solid.work);
        });
        double approach = 0;
        over_rows(solid.order, [&](std::int64_t row) {
            approach = std::max(approach, kernels->accelerations(solid.order, row, c.laws.solid, solid.work));
        });
        EXPECT_GT(approach, 0.1);
        double x = 0, y = 0, size = 0;
        for (std::size_t p = 0; p < solid.particles.size(); ++p) {
            const double m = solid.work[PairWork::mass][p];
            x += m * solid.work[PairWork::a_x][p];
            y += m * solid.work[PairWork::a_y][p];
            size += m * std::hypot(solid.work[PairWork::a_x][p], solid.work[PairWork::a_y][p]);
        }
        EXPECT_GT(size, 0);
        EXPECT_NEAR(x, 0, 1e-12 * size);
        EXPECT_NEAR(y, 0, 1e-12 * size);
    }
}

TEST(PairKernels, FastAndPlainAgree) {
    if (&pair_kernels() == &plain_pair_kernels()) GTEST_SKIP() << "this processor has no AVX2 and FMA";
    ThreadPool pool(1);
    Case c(2);
    State state = uneven_sheet(c, pool, 8);
    SolidState& solid = *state.solid;
    for (std::size_t p = 0; p < solid.particles.size(); ++p)
        solid.particles[Field::t_xx][p] = 1e5 * std::sin(0.1 * static_cast<double>(p));
    const auto evaluate = [&](const PairKernels& kernels) {
        over_rows(solid.order, [&](std::int64_t row) {
            kernels.velocity_gradients(solid.order, row, c.laws.solid.kernel, solid.work);
            state.stages.update_material(solid.order.whole_rows(row, row), 0, c.laws.solid, solid.particles,
                                         solid.work);
        });
        over_rows(solid.order,
                  [&](std::int64_t row) { kernels.accelerations(solid.order, row, c.laws.solid, solid.work); });
        return solid.work;
    };
    const PairWork plain = evaluate(plain_pair_kernels()), fast = evaluate(pair_kernels());
    for (const auto array :
         {PairWork::l_xx, PairWork::l_xy, PairWork::l_yx, PairWork::l_yy, PairWork::a_x, PairWork::a_y}) {
        double greatest = 0;
        for (std::size_t p = 0; p < solid.particles.size(); ++p)
            greatest = std::max(greatest, std::abs(plain[array][p]));
        // Sums of some thirty terms: a hundred roundings of the largest.
        for (std::size_t p = 0; p < solid.particles.size(); ++p)
            ASSERT_NEAR(fast[array][p], plain[array][p], 100 * 2.2e-16 * greatest);
    }
}

// Two particles alone.
struct Pair {
    double first, second;  // accelerations along the line between them
};
/// @param spacing between the two, in those at the start
Pair pair_of(double approach_speed, double stress, double artificial, double spacing = 1) {
    ThreadPool pool(1);
    Case c(2);
    c.laws.solid.artificial_stress = artificial;
    c.laws.solid.gravity = 0;
    c.fill(40, 40, 2, 1, [&](Point p) { return bench::Seed{1, p.x < 40.5 ? approach_speed : -approach_speed, 0}; });
    State state = c.start(flat(50, 50, 2), pool);
    SolidState& solid = *state.solid;
    for (std::size_t p = 0; p < 2; ++p) solid.particles[Field::t_xx][p] = stress;
    solid.work[PairWork::x][1] += (spacing - 1) * c.laws.solid.spacing;
    over_rows(solid.order, [&](std::int64_t row) {
        for (const auto l : {PairWork::l_xx, PairWork::l_xy, PairWork::l_yx, PairWork::l_yy})
            for (std::size_t p = 0; p < 2; ++p) solid.work[l][p] = 0;
        state.stages.update_material(solid.order.whole_rows(row, row), 0, c.laws.solid, solid.particles, solid.work);
    });
    over_rows(solid.order,
              [&](std::int64_t row) { state.stages.pairs->accelerations(solid.order, row, c.laws.solid, solid.work); });
    return {solid.work[PairWork::a_x][0], solid.work[PairWork::a_x][1]};
}

// Written out, against what the solver's sums make of a pair: dv/dt = m (2 t / Sigma^2 - Pi) dW/dr.
TEST(Accelerations, OfAPairAsSpecified) {
    Case c(2);
    const CubicKernel& kernel = c.laws.solid.kernel;
    const double spacing = c.laws.solid.spacing, depth = 1, density = 1700 * depth, mass = density * spacing * spacing;
    for (const double apart : {0.6, 1.0, 1.9}) {
        const double r = apart * spacing, slope = mass * kernel.derivative(r);
        const double stress = -1e6 * depth / (density * density);
        EXPECT_NEAR(pair_of(0, -1e6, 0, apart).first, -2 * stress * slope, 1e-9 * std::abs(stress * slope)) << apart;
        const double l = kernel.length(), phi = l * (2 * -r) / (r * r + 0.01 * l * l);
        const double sound = std::sqrt((1e8 / 1.5 + 4.0 / 3 * 4e7) / 1700);
        const double pi = (-sound * phi + phi * phi) / density;
        EXPECT_NEAR(pair_of(1, 0, 0, apart).first, pi * slope, 1e-9 * std::abs(pi * slope)) << apart;
    }
}

TEST(Accelerations, OfAPair) {
    const Pair still = pair_of(0, 0, 0.5);
    EXPECT_EQ(still.first, 0);
    const Pair approaching = pair_of(1, 0, 0.5), parting = pair_of(-1, 0, 0.5);
    EXPECT_LT(approaching.first, 0);  // pushed apart
    EXPECT_NEAR(approaching.first + approaching.second, 0, 1e-12 * std::abs(approaching.first));
    EXPECT_EQ(parting.first, 0);
    const Pair pulled = pair_of(0, 1e6, 0), pressed = pair_of(0, -1e6, 0);
    EXPECT_GT(pulled.first, 0);  // tension draws together
    EXPECT_LT(pressed.first, 0);
    EXPECT_NEAR(pulled.first, -pressed.first, 1e-12 * pulled.first);
    // The artificial stress leaves tension alone at the usual spacing and beyond, turns it into repulsion where
    // particles come close, and leaves pressure alone.
    for (const double spacing : {1.0, 1.5})
        EXPECT_NEAR(pair_of(0, 1e6, 0.5, spacing).first, pair_of(0, 1e6, 0, spacing).first, 1e-12 * pulled.first);
    EXPECT_GT(pair_of(0, 1e6, 0, 0.5).first, 0);
    EXPECT_LT(pair_of(0, 1e6, 0.5, 0.5).first, 0);
    EXPECT_EQ(pair_of(0, -1e6, 0.5, 0.5).first, pair_of(0, -1e6, 0, 0.5).first);
}

// A sheet in even tension whose rim is held, every second column of particles out of its place by a thousandth of the
// spacing: the sums do not see such a wave as strain, and tension alone draws the pairs together (Swegle, Hicks &
// Attaway 1995). Returns by how much the wave has grown. Its rate is known from the lattice: the wave's force is
// 0.331 s/rho u/dp^2 without artificial stress, -0.962 with half (kernel of three halves of the spacing).
double growth_in_tension(double artificial) {
    ThreadPool pool(1);
    Case c(3);  // particles 1 m apart
    c.laws.solid.artificial_stress = artificial;
    c.laws.solid.viscosity.linear = c.laws.solid.viscosity.quadratic = 0;
    constexpr int side = 24, rim = 4;
    c.fill(6, 6, side, side, [](Point) { return bench::Seed{2, 0, 0}; });
    State state = c.start(flat(12, 12, 3), pool);
    SolidState& solid = *state.solid;
    PairWork& w = solid.work;
    constexpr double tension = 1.7e6, moved = 1e-3, dt = 1e-3;
    std::vector<double> sign(solid.particles.size());
    for (std::size_t p = 0; p < sign.size(); ++p) {
        const double i = w[PairWork::x][p] - 6, j = w[PairWork::y][p] - 6;
        const bool inside = std::min({i, j, side - i, side - j}) > rim;
        sign[p] = inside ? (static_cast<int>(i) % 2 == 0 ? 1 : -1) : 0;
        w[PairWork::x][p] += moved * sign[p];
        solid.particles[Field::t_xx][p] = solid.particles[Field::t_yy][p] = tension;
    }
    std::vector<double> x0(w[PairWork::x], w[PairWork::x] + sign.size());
    double greatest = 0;
    for (int step = 0; step < 240; ++step) {
        over_rows(solid.order, [&](std::int64_t row) {
            state.stages.pairs->velocity_gradients(solid.order, row, c.laws.solid.kernel, w);
            state.stages.update_material(solid.order.whole_rows(row, row), dt, c.laws.solid, solid.particles, w);
        });
        over_rows(solid.order,
                  [&](std::int64_t row) { state.stages.pairs->accelerations(solid.order, row, c.laws.solid, w); });
        double wave = 0, count = 0;
        for (std::size_t p = 0; p < sign.size(); ++p) {
            if (sign[p] == 0) continue;
            w[PairWork::u][p] += dt * w[PairWork::a_x][p];
            w[PairWork::v][p] += dt * w[PairWork::a_y][p];
            w[PairWork::x][p] += dt * w[PairWork::u][p];
            w[PairWork::y][p] += dt * w[PairWork::v][p];
            wave += sign[p] * (w[PairWork::x][p] - x0[p]) + moved;
            ++count;
        }
        greatest = std::max(greatest, std::abs(wave / count) / moved);
    }
    return greatest;
}

TEST(Accelerations, TensionDoesNotClump) {
    // Without: cosh(0.24 s sqrt(0.331 * 1000) / s) = 39, held back by the rim.
    EXPECT_GT(growth_in_tension(0), 15);
    EXPECT_LT(growth_in_tension(0.5), 1.2);  // it swings
}

// What particles give to the nodes and take back: volumes, momentum, no force in sum; near an edge and a wall
// too.
TEST(Transfer, KeepsVolumeAndMomentum) {
    ThreadPool pool(1);
    Case c(2);
    c.material.cohesion = 0;
    c.laws.fluid.wall = true;
    c.fill(0, 0, 12, 12, [](Point p) { return bench::Seed{5 + 0.1 * p.x, 1 + p.y, -2 + p.x}; });
    State state = c.start(flat(30, 30, 2), pool);
    const SolidNodes& nodes = state.solid->nodes;
    const ParticleSet& p = state.solid->particles;
    double volume = 0, px = 0, py = 0, mass = 0, v = 0;
    for (std::size_t n = 0; n < nodes.sums.size(); ++n) {
        mass += nodes.sums[n].mass;
        px += nodes.sums[n].px;
        py += nodes.sums[n].py;
        v += nodes.sums[n].solids;
    }
    for (std::size_t i = 0; i < p.size(); ++i) volume += p[Field::volume][i];
    const Momentum m = momentum(p, 0);
    EXPECT_NEAR(v, volume, 1e-12 * volume);
    EXPECT_NEAR(mass, 1700 * volume, 1e-12 * mass);
    EXPECT_NEAR(px, m.x, 1e-12 * m.size);
    EXPECT_NEAR(py, m.y, 1e-12 * m.size);
    // Random pushes of the nodes.
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> any(-1, 1);
    double fx = 0;
    for (std::size_t n = 0; n < nodes.sums.size(); ++n) {
        state.solid->nodes.push[n] = {any(random), any(random), 1, 0};
        fx += nodes.sums[n].mass * nodes.push[n].ax;
    }
    state.stages.nodes_to_solids({0, p.size()}, c.laws.solid, 1, state.grid, nodes, state.solid->particles);
    double taken = 0;
    for (std::size_t i = 0; i < p.size(); ++i) taken += 1700 * p[Field::volume][i] * p[Field::push_x][i];
    EXPECT_NEAR(taken, fx, 1e-12 * mass);
}

}  // namespace
}  // namespace frana::structured::test
