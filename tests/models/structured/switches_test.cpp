// SPDX-License-Identifier: Apache-2.0
// What each choice of the model changes, by value, in what a step computes.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <tuple>

#include "models/structured/coupling/couple_nodes.h"
#include "models/structured/solid/cubic_stencil.h"
#include "models/structured/solid/material_update.h"
#include "solid_cases.h"

namespace frana::structured::test {
namespace {

// The worked stress of 28 degrees and 26.7 kPa, (-200, -20, -60, 50) kPa, which has a closed form where no load is
// known; with the weight's given, the vertical stress is not the particle's.
TEST(YieldCheck, OfTheParticleAloneOrWithTheWeight) {
    ThreadPool pool(1);
    for (const bool alone : {true, false}) {
        Case c(2);
        c.material.cohesion = 26.7e3;
        c.laws.solid.strength_of_particle_stress = alone;
        c.fill(40, 40, 1, 1, [](Point) { return bench::Seed{8}; });
        State state = c.start(flat(50, 50, 2), pool);
        ParticleSet& p = state.solid->particles;
        const std::pair<Field, double> stress[] = {
            {Field::t_xx, -200e3}, {Field::t_yy, -20e3}, {Field::t_zz, alone ? -60e3 : 0}, {Field::t_xy, 50e3}};
        for (const auto& [field, value] : stress) p[field][0] = value;
        deform(state, c.laws.solid, Matrix2d::Zero(), 1e-3);
        if (alone) {  // to a pascal, as the values are given
            EXPECT_NEAR(p[Field::t_xx][0], -158.220e3, 1);
            EXPECT_NEAR(p[Field::t_yy][0], -48.724e3, 1);
            EXPECT_NEAR(p[Field::t_zz][0], -73.056e3, 1);
            EXPECT_NEAR(p[Field::t_xy][0], 30.416e3, 1);
            continue;
        }
        const auto law = DruckerPrager::of(std::tan(28 * k_degree), 26.7e3);
        const double borne = law.uniaxial();  // 53.4 kPa, less than the mean load, 66.7 kPa
        const Stress total{symmetric(p[Field::t_xx][0], p[Field::t_yy][0], p[Field::t_xy][0]), -borne};
        EXPECT_EQ(p[Field::t_zz][0], 0);
        EXPECT_NEAR(law.yield(total), 0, 1e-9 * borne);
        EXPECT_LT(total.xy(), 50e3);
    }
}

// N = g [(1 - f) h_s rho_s + f h_s (rho_s - B rho_f) + (1 - B) h_fc rho_f] of 2 m of solids and 2 m of confined fluid,
// f the structured fraction of intact material, slows a block on a plain down.
TEST(InitialStructuredFraction, SetsTheLoadOnTheBed) {
    ThreadPool pool(1);
    for (const auto& [structured, load] : {std::pair{1.0, 4200 + 1400}, {0.5, 2400 + 2100 + 1400}}) {
        Case c(2);
        c.material.solid_fraction = 0.5;
        c.material.grain_density = 2400;
        c.material.bed_friction = std::tan(12 * k_degree);
        c.laws.solid.initial_structured = structured;
        c.laws.solid.basal.propagation = 0.3;
        c.fill(20, 20, 12, 12, [](Point) { return bench::Seed{4, 5, 0}; });
        State state = c.start(flat(40, 24, 2), pool, true);
        advance_to(state, c.laws, 0.5, pool);
        const double left = 5 - 0.5 * 9.81 * std::tan(12 * k_degree) * load / 6800;
        for (std::size_t i = 0; i < state.solid->particles.size(); ++i)
            EXPECT_NEAR(state.solid->particles[Field::u][i], left, 1e-9);
    }
}

// After one step without forces a particle has (1 - f) of its velocity and f of the nodes'.
TEST(PicFraction, OfTheNodesVelocity) {
    ThreadPool pool(1);
    for (const double fraction : {0.0, 0.3, 1.0}) {
        Case c(2);
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> any(-1, 1);
        c.laws.solid.gravity = 0;
        c.laws.solid.elastic = Elasticity::from_young_and_bulk(1e-15, 1e-15);
        c.laws.solid.pic_fraction = fraction;
        c.fill(20, 20, 12, 12, [&](Point) { return bench::Seed{4, any(random), any(random)}; });
        State state = c.start(flat(24, 24, 2), pool);
        const ParticleSet start = state.solid->particles;
        const SolidNodes& nodes = state.solid->nodes;
        std::vector<double> expected;
        for (std::size_t i = 0; i < start.size(); ++i) {
            const CubicStencil stencil(start[Field::x][i], start[Field::y][i], state.grid, nodes);
            double u = 0;
            for (int b = 0; b < 4; ++b)
                for (int a = 0; a < 4; ++a)
                    u += stencil.weight[b][a] *
                         nodes.u[stencil.first + static_cast<std::size_t>(b * state.grid.stride() + a)];
            expected.push_back((1 - fraction) * start[Field::u][i] + fraction * u);
        }
        step(state, c.laws, 1e-3, pool);
        for (std::size_t i = 0; i < start.size(); ++i)
            ASSERT_NEAR(state.solid->particles[Field::u][i], expected[i], 1e-9);
    }
}

// A wide sheet, 1 m of loose grains of 1 mm and 2400 kg/m3 under 2 m of water.
struct Sheet {
    Sheet() : pool(1), c(2) {
        c.material.cohesion = 0;
        c.material.grain_density = 2400;
        c.laws.solid.gravity = 0;
        c.laws.fluid.wall = true;
        c.fill(0, 0, 60, 60, [](Point) { return bench::Seed{1}; });
        c.laws.coupling.virtual_mass.law = VirtualMassLaw::none;
    }
    void start() {
        state = std::make_unique<State>(c.start(flat(20, 20, 2), pool, true));
        c.laws.coupling.drag.fluid.gravity = 9.81;
        middle = state->grid.index(10, 10);
        for (std::size_t n = 0; n < state->fluid->now.depth.size(); ++n) state->fluid->now.depth[n] = 2;
    }
    // Acceleration of the solids by the fluid over a step.
    double push(double dt) {
        const SolidNodes& nodes = state->solid->nodes;
        for (const std::int64_t tile : nodes.tiles)
            push_solids({tile, nodes.grid, state->grid}, dt, state->grid, c.laws.solid, c.laws.coupling, c.laws.fluid,
                        state->solid->nodes, state->fluid.get());
        return state->solid->nodes.push[middle].ax;
    }
    ThreadPool pool;
    Case c;
    std::unique_ptr<State> state;
    std::size_t middle = 0;
};

// Linear drag of w = 1 m/s: C w h / m_c for a short time. Worked by hand: U = 0.1076 m/s, Re = 107.6, alpha_s = 1/3, F
// = 1.993, K = 0.05 m/s; the exponent M is 2.4, or 4.45 Re^-0.1 = 2.787 by the grains; P is the quotient, 1/2, or
// alpha_s.
TEST(DragLaws, ActOnTheSolids) {
    const std::tuple<RichardsonZaki, DragMixing, double> cases[] = {
        {RichardsonZaki::constant, DragMixing::quotient, 12196.324},
        {RichardsonZaki::by_grains, DragMixing::quotient, 12416.225},
        {RichardsonZaki::constant, DragMixing::solids_fraction, 14385.313},
        {RichardsonZaki::by_grains, DragMixing::solids_fraction, 14797.462}};
    for (const auto& [exponent, mixing, coefficient] : cases) {
        Sheet sheet;
        Drag& drag = sheet.c.laws.coupling.drag;
        drag.exponent = 1;
        drag.exponent_of = exponent;
        drag.mixing = mixing;
        drag.smoothing_velocity = 0.05;
        sheet.start();
        for (std::size_t n = 0; n < sheet.state->fluid->now.qx.size(); ++n) sheet.state->fluid->now.qx[n] = 2;
        constexpr double dt = 1e-7;  // the decay takes lambda dt / 2, 2e-6, of it
        EXPECT_NEAR(sheet.push(dt), coefficient * 1 * 3 / 2400, 2e-5 * coefficient * 3 / 2400);
    }
}

// Fluid that all but the solids accelerate by 1 m/s2 shares it with them: f = m_v / (1 + m_v (1/m_c + 1/m_u)), m_v =
// rho_u h_c C, C = 1.25 (2012) and (10 (0.12 + 1/3) - 1)/(1/2 + 1/2.4) = 3.85455 (2019).
TEST(VirtualMassLaws, ActOnTheSolids) {
    for (const auto& [law, c] : {std::pair{VirtualMassLaw::pudasaini_2012, 1.25},
                                 {VirtualMassLaw::pudasaini_2019, 3.854545454545},
                                 {VirtualMassLaw::none, 0.0}}) {
        Sheet sheet;
        sheet.c.laws.coupling.drags = false;
        sheet.c.laws.coupling.virtual_mass.law = law;
        sheet.start();
        constexpr double dt = 0.1;
        for (std::size_t n = 0; n < sheet.state->fluid->now.qx.size(); ++n) sheet.state->fluid->resistance_x[n] = dt;
        const double m_v = 1000 * c;
        EXPECT_NEAR(sheet.push(dt), m_v / (1 + m_v * (1 / 2400.0 + 1 / 2000.0)) / 2400, 1e-9);
    }
}

}  // namespace
}  // namespace frana::structured::test
