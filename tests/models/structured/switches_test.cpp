// SPDX-License-Identifier: Apache-2.0
// The virtual mass in what a step computes, by value.
#include <gtest/gtest.h>

#include <memory>

#include "models/structured/coupling/couple_nodes.h"
#include "solid_cases.h"

namespace frana::structured::test {
namespace {

// A wide sheet, 1 m of loose grains of 1 mm and 2400 kg/m3 under 2 m of water.
struct Sheet {
    Sheet() : pool(1), c(2) {
        c.material.cohesion = 0;
        c.material.grain_density = 2400;
        c.laws.solid.gravity = 0;
        c.laws.fluid.wall = true;
        c.fill(0, 0, 60, 60, [](Point) { return bench::Seed{1}; });
        c.laws.coupling.virtual_mass.acts = false;
    }
    void start() {
        state = std::make_unique<State>(c.start(flat(20, 20, 2), pool, true));
        c.laws.coupling.drag.fluid.gravity = 9.81;
        middle = state->grid.index(10, 10);
        std::vector<FluidSource> water;
        for (std::int64_t j = 0; j < 20; ++j)
            for (std::int64_t i = 0; i < 20; ++i) water.push_back({state->grid.index(i, j), 2});
        receive(water, *state->fluid, c.laws.fluid);
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

// Fluid that all but the solids accelerate by 1 m/s2 shares it with them: f = m_v / (1 + m_v (1/m_c + 1/m_u)), m_v =
// rho_u h_c C, C = 1.25.
TEST(VirtualMassLaw, ActsOnTheSolids) {
    for (const double c : {1.25, 0.0}) {
        Sheet sheet;
        sheet.c.laws.coupling.drags = false;
        sheet.c.laws.coupling.virtual_mass.acts = c > 0;
        sheet.start();
        constexpr double dt = 0.1;
        for (std::size_t n = 0; n < sheet.state->grid.size(); ++n) sheet.state->fluid->resistance_x[n] = dt;
        const double m_v = 1000 * c;
        EXPECT_NEAR(sheet.push(dt), m_v / (1 + m_v * (1 / 2400.0 + 1 / 2000.0)) / 2400, 1e-9);
    }
}

}  // namespace
}  // namespace frana::structured::test
