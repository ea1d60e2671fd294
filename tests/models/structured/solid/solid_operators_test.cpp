// SPDX-License-Identifier: Apache-2.0
// The nodes of the stress, and transfers, of the structured solids: what they keep and what they get right.
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

// Adds the momenta of all particles to the nodes of the stress.
void add_momenta(SolidState& solid, const SolidLaws& laws) {
    solid.stress.begin();
    for (std::size_t p = 0; p < solid.particles.size(); ++p)
        solid.stress.add_momentum(solid.particles, p, particle_mass(laws, solid.particles, p), true);
}

// Affine velocities are exact, at edges too: a sheet that turns is not strained and turns on.
TEST(StressNodes, RigidTurningIsNoStrain) {
    ThreadPool pool(1);
    Case c(2);
    State state = uneven_sheet(c, pool, 5);
    SolidState& solid = *state.solid;
    ParticleSet& p = solid.particles;
    constexpr double omega = 0.7;
    for (std::size_t i = 0; i < p.size(); ++i) {
        p[Field::u][i] = -omega * (p[Field::y][i] - 30);
        p[Field::v][i] = omega * (p[Field::x][i] - 40);
        p[Field::c_xy][i] = -omega;
        p[Field::c_yx][i] = omega;
    }
    add_momenta(solid, c.laws.solid);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto at = solid.stress.at(p[Field::x][i], p[Field::y][i]);
        const Matrix2d l = solid.stress.velocity_gradient(at, true);
        EXPECT_LT(strain_rate(l).cwiseAbs().maxCoeff(), 1e-11 * omega);
        EXPECT_NEAR(spin(l), omega, 1e-11 * omega);
        const NodeMotion motion = solid.stress.motion(at, 0.1, true);
        EXPECT_NEAR(motion.u, p[Field::u][i], 1e-12 * 60);
        EXPECT_NEAR(motion.c_xx, 0, 1e-11 * omega);
        EXPECT_NEAR(motion.c_yx, omega, 1e-11 * omega);
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

// Random stress and motion: the nodes' forces sum to zero, and so do those that particles take from them.
TEST(StressNodes, KeepMomentum) {
    ThreadPool pool(1);
    Case c(2);
    State state = uneven_sheet(c, pool, 6);
    SolidState& solid = *state.solid;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (std::size_t p = 0; p < solid.particles.size(); ++p)
        for (const Field f : {Field::t_xx, Field::t_yy, Field::t_xy}) solid.particles[f][p] = 1e6 * any(random);
    add_momenta(solid, c.laws.solid);
    state.stages.update_material({0, solid.particles.size()}, 0, c.laws.solid, solid.stress, solid.particles,
                                 solid.work);
    double x = 0, y = 0, size = 0;
    for (std::size_t p = 0; p < solid.particles.size(); ++p) {
        const auto at = solid.stress.at(solid.particles[Field::x][p], solid.particles[Field::y][p]);
        const NodeMotion motion = solid.stress.motion(at, 0, true);
        const double m = particle_mass(c.laws.solid, solid.particles, p);
        x += m * motion.ax;
        y += m * motion.ay;
        size += m * std::hypot(motion.ax, motion.ay);
    }
    EXPECT_GT(size, 0);
    EXPECT_NEAR(x, 0, 1e-12 * size);
    EXPECT_NEAR(y, 0, 1e-12 * size);
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
