// SPDX-License-Identifier: Apache-2.0
// Solids and free fluid together: what is kept, and what stays at rest.
#include <gtest/gtest.h>

#include "models/structured/coupling/couple_nodes.h"
#include "solid_cases.h"

namespace frana::structured::test {
namespace {

struct Budget {
    double confined = 0, fluid = 0, solids = 0;
    double px = 0, py = 0, size = 0;  // solids and fluid [kg m/s]

    [[nodiscard]] double water() const { return confined + fluid; }
};

Budget budget(const State& state) {
    Budget b;
    const ParticleSet& p = state.solid->particles;
    const Momentum m = momentum(p, 1000);
    b.px = m.x;
    b.py = m.y;
    b.size = m.size;
    for (std::size_t i = 0; i < p.size(); ++i) {
        b.solids += p[Field::volume][i];
        b.confined += p[Field::confined][i];
    }
    const double area = state.grid.cell_size() * state.grid.cell_size();
    const finite_volume::State& f = state.fluid->now;
    for (std::size_t n = 0; n < f.depth.size(); ++n) {
        if (!(f.depth[n] > 0)) continue;
        const double mass = 1000 * f.depth[n] * area;
        const Point u = state.fluid->velocity(n);
        b.fluid += f.depth[n] * area;
        b.px += mass * u.x;
        b.py += mass * u.y;
        b.size += mass * std::hypot(u.x, u.y);
    }
    return b;
}

// A wet block that slides, breaks on a bend of the terrain and gives its water free.
struct Breaking {
    Breaking() : pool(1), c(2), state(make()) {}

    State make() {
        c.material.solid_fraction = 0.5;
        c.material.grain_density = 2400;
        c.material.cohesion = 5e3;
        c.material.bed_friction = std::tan(12 * k_degree);
        c.laws.solid.elastic = Elasticity::from_young_and_bulk(5e6, 5e6 / 1.5);
        c.laws.fluid.wall = true;
        c.laws.fluid.manning = 0.05;
        c.fill(20, 20, 36, 24, [](Point) { return bench::Seed{6, 0, 0}; });
        const GridSpec grid = bench::plain_grid(70, 32, 2);
        const Raster bed = bench::sample_raster(grid, [](Point p) {
            return p.x < 40 ? 30 - 0.3 * p.x : std::max(18 - 0.6 * (p.x - 40), 0.1 * std::abs(p.y - 30));
        });
        return c.start(bed, pool, true);
    }

    ThreadPool pool;
    Case c;
    State state;
};

TEST(StructuredStep, KeepsEachPhaseThroughFractureAndRelease) {
    Breaking run;
    const Budget start = budget(run.state);
    EXPECT_EQ(start.fluid, 0);
    for (int i = 0; i < 60; ++i) {
        const StepReport report = step(run.state, run.c.laws, 0.1, run.pool);
        ASSERT_EQ(report.solids.non_finite, 0);
        const Budget now = budget(run.state);
        ASSERT_NEAR(now.solids, start.solids, 1e-12 * start.solids);
        ASSERT_NEAR(now.water(), start.water(), 1e-12 * start.water());
        ASSERT_NEAR(run.state.released, now.fluid, 1e-12 * start.water());
    }
    EXPECT_GT(run.state.released, 0.02 * start.water());
    // The same share is gone from cohesion and from the confined fluid of every particle, or more of the fluid from one
    // that has become so thick that its strength does not bear it.
    const ParticleSet& p = run.state.solid->particles;
    std::size_t same = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double left = p[Field::cohesion_ratio][i] * p[Field::volume][i], rounding = 1e-12 * p[Field::volume][i];
        EXPECT_LE(p[Field::confined][i], left + rounding);
        same += std::abs(p[Field::confined][i] - left) <= rounding;
    }
    EXPECT_GT(same, p.size() * 9 / 10);
}

// Fluid of uneven depth and momentum over 20 by 20 cells.
void fill_unevenly(State& state, const Case& c) {
    std::vector<FluidSource> water;
    for (std::int64_t j = 0; j < 20; ++j)
        for (std::int64_t i = 0; i < 20; ++i)
            water.push_back({state.grid.index(i, j), 1 + 0.5 * std::sin(static_cast<double>(i * j)),
                             4 * std::cos(static_cast<double>(i + 2 * j)),
                             -3 * std::sin(static_cast<double>(2 * i + j))});
    receive(water, *state.fluid, c.laws.fluid);
}

// Drag and virtual mass at the nodes, taken over by the particles: what one phase gains the other loses, on any ground.
// Weight, pressure and buoyancy, which they come on top of, change the sum.
TEST(Coupling, ExchangesMomentum) {
    const auto run = [](bool exchanges) {
        ThreadPool pool(1);
        Case c(2);
        c.material.solid_fraction = 0.5;
        c.material.grain_density = 2400;
        c.material.bed_friction = 0;  // which virtual mass sees
        c.laws.fluid.wall = true;
        c.laws.coupling.drags = exchanges;
        if (!exchanges) c.laws.coupling.virtual_mass.acts = false;
        c.fill(4, 4, 30, 30, [](Point p) { return bench::Seed{3 + 0.1 * p.x, std::sin(p.x), std::cos(p.y)}; });
        const Raster bed =
            bench::sample_raster(bench::plain_grid(20, 20, 2), [](Point p) { return 0.4 * p.x + std::sin(0.3 * p.y); });
        State state = c.start(bed, pool, true);
        fill_unevenly(state, c);
        constexpr double dt = 0.2;
        const SolidNodes& nodes = state.solid->nodes;
        for (const std::int64_t tile : nodes.tiles)
            push_solids({tile, nodes.grid, state.grid}, dt, state.grid, c.laws.solid, c.laws.coupling, c.laws.fluid,
                        state.solid->nodes, state.fluid.get());
        ParticleSet& p = state.solid->particles;
        state.stages.nodes_to_solids({0, p.size()}, c.laws.solid, dt, state.grid, nodes, p);
        for (std::size_t i = 0; i < p.size(); ++i) {
            p[Field::u][i] += dt * p[Field::push_x][i];
            p[Field::v][i] += dt * p[Field::push_y][i];
        }
        return std::pair{budget(state), std::vector<double>(p[Field::u], p[Field::u] + p.size())};
    };
    const auto [with, u_with] = run(true);
    const auto [without, u_without] = run(false);
    double moved = 0;
    for (std::size_t i = 0; i < u_with.size(); ++i) moved = std::max(moved, std::abs(u_with[i] - u_without[i]));
    EXPECT_GT(moved, 0.01);
    EXPECT_NEAR(with.px, without.px, 1e-12 * with.size);
    EXPECT_NEAR(with.py, without.py, 1e-12 * with.size);
}

// Still water over uneven ground, out of which a hump and a heap of solids rise: nothing moves.
TEST(Coupling, LakeAtRestOverSolids) {
    ThreadPool pool(1);
    Case c(2);
    c.material.solid_fraction = 0.5;
    c.material.grain_density = 2400;
    c.material.bed_friction = 2;
    c.laws.fluid.wall = true;
    c.laws.solid.elastic = Elasticity::from_young_and_bulk(1e6, 1e6 / 1.5);
    c.fill(20, 20, 20, 16, [](Point) { return bench::Seed{2, 0, 0}; });
    const GridSpec grid = bench::plain_grid(30, 25, 2);
    const Raster bed = bench::sample_raster(grid, [](Point p) {
        return std::sin(0.3 * p.x) * std::cos(0.2 * p.y) +
               8 * std::exp(-0.02 * std::pow(std::hypot(p.x - 45, p.y - 30), 2));
    });
    State state = c.start(bed, pool, true);
    const double level = 3 - state.grid.datum();
    std::vector<FluidSource> water;
    for (std::int64_t j = 0; j < grid.rows; ++j) {
        for (std::int64_t i = 0; i < grid.columns; ++i) {
            const std::size_t n = state.grid.index(i, j);
            const double depth = level - state.grid.bed[n] - state.solid->nodes.depth[n];
            if (depth > 0) water.push_back({n, depth, 0, 0});
        }
    }
    receive(water, *state.fluid, c.laws.fluid);
    const ParticleSet start = state.solid->particles;
    advance_to(state, c.laws, 5, pool);
    const finite_volume::State& f = state.fluid->now;
    for (std::size_t n = 0; n < f.depth.size(); ++n) {
        if (f.depth[n] <= c.laws.fluid.dry) continue;
        ASSERT_LT(std::hypot(f.qx[n], f.qy[n]) / f.depth[n], 1e-10);
    }
    for (std::size_t i = 0; i < start.size(); ++i) {
        ASSERT_EQ(state.solid->particles[Field::u][i], 0);
        ASSERT_EQ(state.solid->particles[Field::x][i], start[Field::x][i]);
    }
}

// A steady stream over solids that the bed holds, without drag: the virtual mass, whose solids and fluid both keep
// their speed, does nothing, and the stream has Manning's of its own depth, whichever depth the bed's resistance has
// where both move.
TEST(Coupling, SteadyStreamOverRestingSolids) {
    ThreadPool pool(1);
    constexpr double manning = 0.4, slope = 0.1, depth = 1;
    const auto manning_speed = [&](double h) { return std::pow(h, 2.0 / 3) * std::sqrt(slope) / manning; };
    for (const bool on_total : {false, true}) {
        Case c(2);
        c.material.solid_fraction = 1;
        c.material.grain_density = 2400;
        c.material.bed_friction = 2;
        c.laws.coupling.drags = false;
        c.laws.solid.elastic = Elasticity::from_young_and_bulk(1e6, 1e6 / 1.5);
        c.laws.fluid.steep = c.laws.solid.steep = false;
        c.laws.fluid.manning = manning;
        c.laws.fluid.manning_on_total = on_total;
        c.fill(0, 0, 150, 30, [](Point) { return bench::Seed{1}; });
        State state = c.start(incline(std::atan(slope) / k_degree, 50, 10, 2), pool, true);
        std::vector<FluidSource> water;
        for (std::int64_t j = 0; j < 10; ++j)
            for (std::int64_t i = 0; i < 50; ++i)
                water.push_back({state.grid.index(i, j), depth, 0.8 * manning_speed(depth) * depth, 0});
        receive(water, *state.fluid, c.laws.fluid);
        // The middle; friction takes a second or two to balance gravity. Its depth falls by a fiftieth meanwhile, since
        // nothing flows in.
        const std::size_t middle = state.grid.index(25, 5);
        advance_to(state, c.laws, 5, pool);
        const double h = state.fluid->now.depth[middle], exact = manning_speed(h);
        EXPECT_NEAR(h, depth, 0.05 * depth);
        EXPECT_NEAR(state.fluid->now.qx[middle] / h, exact, 0.01 * exact);
        EXPECT_EQ(state.solid->particles[Field::u][0], 0);
    }
}

// Loose solids and water that fills their pores slide together on level ground without friction: the bed's stress slows
// both alike, V = V_0/(1 + R V_0 t), R = rho_u g n^2/(d^(1/3) (m_c + m_u)).
TEST(Coupling, TheBedSlowsTheColumnAsOne) {
    ThreadPool pool(1);
    constexpr double manning = 0.1, speed = 8, height = 1, seconds = 2;
    Case c(2);
    c.material.solid_fraction = 0.5;
    c.material.grain_density = 2400;
    c.material.bed_friction = c.material.cohesion = 0;
    c.laws.fluid.manning = manning;
    c.laws.fluid.manning_on_total = true;
    c.fill(20, 0, 240, 60, [](Point) { return bench::Seed{2 * height, speed, 0}; });
    State state = c.start(flat(120, 20, 2), pool, true);
    std::vector<FluidSource> water;
    for (std::int64_t j = 0; j < 20; ++j)
        for (std::int64_t i = 10; i < 90; ++i) water.push_back({state.grid.index(i, j), height, speed * height, 0});
    receive(water, *state.fluid, c.laws.fluid);
    const double mass = 2400 * height + 1000 * height;
    const double rate = 1000 * k_standard_gravity * manning * manning / std::cbrt(2 * height) / mass;
    advance_to(state, c.laws, seconds, pool);
    const std::size_t middle = state.grid.index(56, 10);
    const double exact = speed / (1 + rate * speed * seconds);
    // First order in time: steps of 0.1 s are a hundredth of 1/(R V).
    EXPECT_NEAR(state.solid->nodes.u[middle], exact, 0.01 * exact);
    EXPECT_NEAR(state.fluid->now.qx[middle] / state.fluid->now.depth[middle], exact, 0.01 * exact);
}

// A heap that is all solids collapses under a millimetre of water as it does dry: without pores the film would be as
// much as fills them, and bear a third of its weight.
TEST(Coupling, AFilmDoesNotLiftAHeap) {
    ThreadPool pool(1);
    const auto fastest = [&](double film) {
        Case c(10);
        c.material.solid_fraction = 1;
        c.material.cohesion = 0;
        c.material.bed_friction = std::tan(20 * k_degree);
        c.fill(160, 60, 24, 24, [](Point) { return bench::Seed{12}; });
        State state = c.start(flat(40, 20, 10), pool, true);
        if (film > 0) {
            std::vector<FluidSource> water;
            for (std::int64_t j = 0; j < 20; ++j)
                for (std::int64_t i = 0; i < 40; ++i) water.push_back({state.grid.index(i, j), film, 0, 0});
            receive(water, *state.fluid, c.laws.fluid);
        }
        double greatest = 0;
        for (int k = 1; k <= 20; ++k) {
            advance_to(state, c.laws, 0.5 * k, pool);
            greatest = std::max(greatest, state.solid->last.speed2);
        }
        return std::sqrt(greatest);
    };
    const double dry = fastest(0);
    EXPECT_GT(dry, 1);
    EXPECT_NEAR(fastest(1e-3), dry, 0.05 * dry);
}

// What becomes free in a step keeps its momentum, and the push that the nodes gave for both.
TEST(Coupling, KeepsMomentumWhileWaterIsReleased) {
    ThreadPool pool(1);
    Case c(2);
    c.material.solid_fraction = 0.5;
    c.material.grain_density = 2400;
    c.material.cohesion = 1e3;
    c.laws.fluid.wall = true;
    c.laws.fluid.dry = c.laws.coupling.dry = 1e-12;  // a film under it does not move
    c.laws.solid.gravity = 0;                        // no weight: strength, and exchange with the fluid
    c.fill(16, 16, 24, 24, [](Point p) { return bench::Seed{3, 0.2 * (p.x - 24), 0.2 * (p.y - 24)}; });
    State state = c.start(flat(24, 24, 2), pool, true);
    c.laws.coupling.drag.fluid.gravity = 9.81;
    std::vector<FluidSource> water;
    for (std::int64_t j = 8; j < 16; ++j)
        for (std::int64_t i = 8; i < 16; ++i) water.push_back({state.grid.index(i, j), 1, 6, -3});
    receive(water, *state.fluid, c.laws.fluid);
    for (int i = 0; i < 3; ++i) {
        const Budget before = budget(state);
        const double released = state.released;
        step(state, c.laws, 0.05, pool);
        const Budget after = budget(state);
        EXPECT_GT(state.released, released);
        EXPECT_NEAR(after.px, before.px, 1e-12 * before.size);
        EXPECT_NEAR(after.py, before.py, 1e-12 * before.size);
    }
}

// Drag alone between a wide sheet of solids and the fluid on it follows the exact decay, whatever the step.
TEST(Coupling, DragRelaxes) {
    ThreadPool pool(1);
    for (const int exponent : {1, 2}) {
        Case c(2);
        c.material.cohesion = 0;
        c.material.solid_fraction = 1;
        c.material.grain_density = 2400;
        c.laws.solid.gravity = 0;
        c.laws.fluid.wall = true;
        c.laws.coupling.virtual_mass.acts = false;
        c.laws.coupling.drag.exponent = exponent;
        c.laws.coupling.drag.smoothing_velocity = 10;
        c.fill(0, 0, 60, 60, [](Point) { return bench::Seed{1, 0, 0}; });
        State state = c.start(flat(20, 20, 2), pool, true);
        c.laws.coupling.drag.fluid.gravity = 9.81;
        const std::size_t middle = state.grid.index(10, 10);
        std::vector<FluidSource> water;
        for (std::int64_t j = 0; j < 20; ++j)
            for (std::int64_t i = 0; i < 20; ++i) water.push_back({state.grid.index(i, j), 1, 2, 0});
        receive(water, *state.fluid, c.laws.fluid);
        // The coefficient from the law; what is checked is the cell's way through the step.
        Mixture m;
        m.solids = m.coupled = 0.5;
        m.coupled_density = m.grain_density = 2400;
        const double lambda = 2 * c.laws.coupling.drag(m) * (1 / 2400.0 + 1 / 1000.0);
        double w = 2;
        for (int i = 0; i < 5; ++i) {
            constexpr double dt = 0.4;
            for (const std::int64_t tile : state.solid->nodes.tiles)
                push_solids({tile, state.solid->nodes.grid, state.grid}, dt, state.grid, c.laws.solid, c.laws.coupling,
                            c.laws.fluid, state.solid->nodes, state.fluid.get());
            SolidSums& sums = state.solid->nodes.sums[middle];
            sums.px += dt * sums.mass * state.solid->nodes.push[middle].ax;
            w *= exponent == 1 ? std::exp(-lambda * dt) : 1 / (1 + lambda * w * dt);
            EXPECT_NEAR(state.fluid->now.qx[middle] - sums.px / sums.mass, w, 1e-12);
        }
    }
}

}  // namespace
}  // namespace frana::structured::test
