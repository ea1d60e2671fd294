// SPDX-License-Identifier: Apache-2.0
// What becomes of a column: damage and the water it sets free, and the thrust on its neighbours.
#include <gtest/gtest.h>

#include <cmath>

#include "models/structured/coupling/release.h"
#include "models/structured/solid/material_update.h"
#include "solid_cases.h"

namespace frana::structured::test {
namespace {

// Stretching at a steady rate beyond the yield surface: cohesion falls in line with the strain, and the confined
// fluid with it; what is released has the particle's momentum.
TEST(Fragmentation, ReleasesInProportion) {
    ThreadPool pool(1);
    Case c(2);
    c.material.solid_fraction = 0.5;
    c.material.cohesion = 1e3;
    c.fill(40, 40, 1, 1, [](Point) { return bench::Seed{4, 3, -1}; });
    State state = c.start(flat(50, 50, 2), pool, true);
    ParticleSet& p = state.solid->particles;
    const double confined = p[Field::confined][0], solids = p[Field::volume][0];
    const double eps = c.laws.solid.fragmentation.critical_strain;
    constexpr double dt = 0.01;
    // Its strength bears no more than this fraction of the mean pressure: it holds no more of the water.
    const double tangent = p[Field::friction][0], root = std::sqrt(9 + 12 * tangent * tangent);
    const double uniaxial = 3e3 / root / (1 / std::sqrt(3.0) - tangent / root);
    const double borne = 2 * uniaxial * p[Field::area][0] / (k_standard_gravity * (1700 * solids + 1000 * confined));
    ASSERT_LT(borne, 0.2);
    double opened = 0;
    for (int i = 0; i < 60; ++i) {
        const double before = p[Field::cohesion_ratio][0];
        deform(state, c.laws.solid, 0.315 * Matrix2d::Identity(), dt);
        // What it no longer confines follows the cohesion that it had at the start of the substep.
        EXPECT_NEAR(confined - p[Field::released][0], confined * before * borne, 1e-13 * confined);
        state.solid->spread(state.solid->order, c.laws.solid.fragmentation, p, state.solid->work, pool);
        opened = p[Field::damage][0];
        // The integral of sqrt(2/3 dev e : dev e) = 0.21 per second until all is lost, from the first step on: 8 m of
        // overburden have it at its yield surface.
        EXPECT_NEAR(opened, std::min(i + 1, 48) * dt * 0.21, 1e-12);
        EXPECT_LE(p[Field::cohesion_ratio][0], before);
        EXPECT_NEAR(p[Field::cohesion_ratio][0], std::max(0.0, 1 - opened / (2 * eps)), 1e-14);
        EXPECT_EQ(particle_mass(c.laws.solid, p, 0),
                  1700 * solids + 1000 * confined);  // it goes with the particle till the step's end
    }
    EXPECT_EQ(p[Field::cohesion_ratio][0], 0);
    EXPECT_GE(opened, 2 * eps);
    release_fluid(*state.solid, state.grid, c.laws.fluid, *state.fluid);
    EXPECT_EQ(p[Field::confined][0], 0);
    double x = 0, y = 0;
    for (std::size_t n = 0; n < state.fluid->now.qx.size(); ++n) {
        x += 4 * state.fluid->now.qx[n];
        y += 4 * state.fluid->now.qy[n];
    }
    EXPECT_NEAR(x, 3 * confined, 1e-12 * confined);
    EXPECT_NEAR(y, -confined, 1e-12 * confined);
}

// A column's thrust as the solver computes it: N h / 2 without cohesion, none with much.
TEST(Thrust, OfColumns) {
    ThreadPool pool(1);
    const double load = 1700 * 9.81 * 4;
    const auto thrust = [&](double cohesion) {
        Case c(2);
        c.material.cohesion = cohesion;
        c.fill(40, 40, 1, 1, [](Point) { return bench::Seed{4}; });
        State state = c.start(flat(50, 50, 2), pool);
        const ParticleSet& p = state.solid->particles;
        return cohesion > 0 ? particle_load<SolidKind<true, false>>(c.laws.solid, p, 0).thrust
                            : particle_load<SolidKind<false, false>>(c.laws.solid, p, 0).thrust;
    };
    EXPECT_EQ(thrust(1e6), 0);
    EXPECT_NEAR(thrust(0), 0.5 * load * 4, 1e-9 * load);
}

// However fast loose columns meet, a substep changes no area by so much that it would be left as it is.
TEST(Column, SubstepsAreShortWhereColumnsMeet) {
    ThreadPool pool(1);
    Case c(2);
    c.material.cohesion = 0;
    c.laws.solid.gravity = 1e-3;
    c.fill(30, 40, 6, 1, [](Point p) { return bench::Seed{1, p.x < 32 ? 8.0 : -8.0, 0}; });
    State state = c.start(flat(40, 40, 2), pool);
    for (int i = 0; i < 40; ++i) EXPECT_EQ(step(state, c.laws, 0.05, pool).solids.clamped, 0);
}

// A column that spreads on and on gets no wider than the nodes see a lone particle.
TEST(Column, GetsNoWiderThanTheNodesSeeIt) {
    ThreadPool pool(1);
    Case c(2);
    c.material.cohesion = 0;
    c.material.bed_friction = 0;
    c.laws.solid.gravity = 0;
    c.fill(40, 40, 2, 1, [](Point) { return bench::Seed{4}; });
    State state = c.start(flat(50, 50, 2), pool);
    SolidState& solid = *state.solid;
    const double mean = 0.5 * c.laws.solid.spacing;  // they swing to and fro, drawn apart faster than together
    for (int i = 0; i < 4000; ++i) {
        for (std::size_t p = 0; p < 2; ++p) {
            solid.particles[Field::x][p] = 41 + (p == 0 ? -mean : mean);
            solid.particles[Field::u][p] = p == 0 ? -1 : 1;
        }
        SolidReport seen;
        run_substeps(solid, state.stages, c.laws.solid, state.grid, {&state.grid}, 0.01, seen, pool);
    }
    for (std::size_t p = 0; p < 2; ++p) EXPECT_LE(solid.particles[Field::area][p], 5 * 2 * 2);
}

// A particle that breaks and leaves within one step takes what it set free along.
TEST(Fragmentation, WhatLeavesWithItsFreedFluidIsCounted) {
    ThreadPool pool(1);
    Case c(2);
    c.material.solid_fraction = 0.5;
    c.material.cohesion = 1e3;
    c.fill(40, 40, 2, 1, [](Point) { return bench::Seed{4, -3, 0}; });
    State state = c.start(flat(50, 50, 2), pool, true);
    SolidState& solid = *state.solid;
    ParticleSet& p = solid.particles;
    const double confined = p[Field::confined][0], solids = p[Field::volume][0], freed = 0.25 * confined;
    p[Field::released][0] = freed;
    p[Field::x][0] = -0.1;
    sort_solids(solid, c.laws.solid, state.grid, pool);
    EXPECT_EQ(p.size(), 1U);
    EXPECT_NEAR(solid.left.confined, confined, 1e-12 * confined);
    EXPECT_NEAR(solid.left.mass, 1700 * solids + 1000 * confined, 1e-9 * solids);
    EXPECT_NEAR(solid.left.px, -3 * solid.left.mass, 1e-12 * solid.left.mass);
}

}  // namespace
}  // namespace frana::structured::test
