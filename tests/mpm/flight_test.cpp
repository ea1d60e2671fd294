// SPDX-License-Identifier: Apache-2.0
// Flight over an edge: the parabola, the loss at landing, and flows that do not fly.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "mpm/flight.h"
#include "physics/laws.h"
#include "support/cases.h"

namespace frana::test {
namespace {

// A film, thin enough for its own pressure not to matter, that starts around x = 20 m in a walled strip.
struct Strip {
    double cell = 2;
    std::function<double(double)> bed;
    double speed = 20, length = 240;
    bool flight = true;
    double thickness = 0.05, cfl = 0.5;
    double drag = 0, friction = 0;
};

Flow film_on(const Strip& strip) {
    const GridSpec grid = bench::plain_grid(std::llround(strip.length / strip.cell), 8, strip.cell);
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point p) {
        return bench::Seed{std::abs(p.x - 20) < 6 ? strip.thickness : 0, strip.speed, 0};
    });
    Numerics how = numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall);
    how.minimum_depth = 1e-6;
    how.flight = strip.flight;
    how.cfl = strip.cfl;
    how.flight_drag = strip.drag;
    Material material = water();
    material.of<CoulombFriction>().friction_coefficient = strip.friction;
    return Flow(bench::sample_raster(grid, [&](Point p) { return strip.bed(p.x); }), seeds, material, how, 1);
}

constexpr double k_degree = std::numbers::pi / 180;
const JumpRules k_rules{k_gravity, true, 55 * k_degree};

double cliff(double x) {
    return x < 100 ? 50 : 0;
}

class OverACliff : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(OverACliff, LandsWhereTheParabolaDoes) {
    Strip strip{GetParam().first, cliff};
    strip.cfl = GetParam().second;
    Flow flow = film_on(strip);
    const double volume = flow.volume();
    double aloft = 0;
    while (flow.time() < 9) {
        const auto report = flow.advance(9 - flow.time());
        aloft = std::max(aloft, report.aloft);
        ASSERT_NEAR(flow.volume(), volume, 1e-9 * volume);
    }
    EXPECT_GT(aloft, 0.9 * volume);  // 12 m long, it is 60 m in the air
    EXPECT_TRUE(flow.flights().empty());
    const JumpStatistics& jumps = flow.flights().statistics();
    // Waves of the film (0.7 m/s) make its tip faster, by 2 sqrt(g h) at most.
    const double time = std::sqrt(2 * 50 / k_gravity);
    EXPECT_NEAR(jumps.longest, 20 * time, 0.05 * 20 * time + 1.4 * time);
    EXPECT_NEAR(jumps.to.x - 100, 20 * time, 0.05 * 20 * time + 1.4 * time);
    EXPECT_NEAR(jumps.highest, 50, 0.05 * 50);
    EXPECT_NEAR(jumps.volume, volume, 1e-9 * volume);
    EXPECT_EQ(flow.volume_left(), 0);
    // The fall's own speed, 31 m/s, is lost.
    double momentum = 0;
    for (std::size_t p = 0; p < flow.particles().size(); ++p)
        momentum += flow.particles()[Field::volume][p] * flow.map_velocity(p).x;
    EXPECT_NEAR(momentum, 20 * volume, 0.02 * 20 * volume);
}

// Particles take off where the edge is, not where a step happened to end beyond it.
INSTANTIATE_TEST_SUITE_P(CellsAndSteps, OverACliff,
                         testing::Values(std::pair{5.0, 0.2}, std::pair{5.0, 0.5}, std::pair{5.0, 0.9},
                                         std::pair{2.0, 0.5}, std::pair{1.0, 0.5}));

TEST(Flight, ASingleParticleLandsWithinATenthOfACell) {
    const GridSpec grid = bench::plain_grid(48, 8, 5);
    Flow flow = film_on({5, cliff});
    const auto jump = find_jump(flow.nodes(), k_rules, {94.9, 20}, {20, 0}, 0.05, 1);
    ASSERT_TRUE(jump);
    // The splines' bed begins to fall where the edge's cells meet, half a cell before the raster's own edge.
    EXPECT_NEAR(jump->from.x, 95, 1e-6);
    EXPECT_NEAR(jump->climb, 0, 1e-6);
    EXPECT_NEAR(jump->to.x, 95 + 20 * std::sqrt(2 * 50 / k_gravity), 0.5);
    EXPECT_NEAR(jump->landed.x, 20, 1e-9);
    EXPECT_NEAR(jump->height, 50, 2.5);
}

TEST(Landing, KeepsThePartAlongTheBed) {
    // From a ledge onto a slope of 45 degrees that falls away: v along it after landing is (u + |climb|) / sqrt(2).
    const Strip ledge{2, [](double x) { return x < 60 ? 200 - 0.0 * x : 190 - (x - 60); }};
    Flow flow = film_on(ledge);
    const auto jump = find_jump(flow.nodes(), k_rules, {58, 8}, {20, 0}, 0.05, 1);
    ASSERT_TRUE(jump);
    const double fallen = k_gravity * jump->duration;
    EXPECT_NEAR(std::hypot(jump->landed.x, jump->landed.y), (20 + fallen) / std::sqrt(2.0), 1e-6 * fallen);
}

TEST(Flight, AnEdgeThatIsTooGentleOrTooLowThrowsNothing) {
    // 20 m/s: a radius of 60 m needs 6.7 m/s2; steps of 10 cm are under a tenth of a cell.
    const auto gentle = [](double x) { return x < 60 ? 0.0 : -std::min(x - 60, 20.0) * std::min(x - 60, 20.0) / 120; };
    const auto low = [](double x) { return x < 100 ? 0.1 : 0; };
    for (const Strip& strip : {Strip{2, gentle}, Strip{2, low}}) {
        Flow flow = film_on(strip);
        flow.advance_to(4);
        EXPECT_EQ(flow.flights().statistics().volume, 0);
    }
    // A flow bridges a step that is low against its thickness; a film does not.
    Flow flow = film_on({2, [](double x) { return x < 100 ? 6.0 : 0; }});
    double flown[2];
    for (const int thick : {0, 1}) {
        const auto jump = find_jump(flow.nodes(), k_rules, {98, 8}, {20, 0}, thick == 1 ? 2 : 0.05, 1);
        ASSERT_TRUE(jump);
        flown[thick] = jump->fraction;
    }
    EXPECT_GT(flown[0], 0.5);
    EXPECT_EQ(flown[1], 0);
}

// What leaves the bed over a wall 40 m high grows with the wall's angle without a threshold, and what the particles
// lose at the edge is that part, whatever the length of the steps.
TEST(Flight, APartThatGrowsWithTheAngleOfTheWallLeavesTheBed) {
    double last = 0;
    for (double angle = 20; angle <= 85; angle += 5) {
        const double steep = std::tan(angle * k_degree);
        const Strip strip{2, [=](double x) { return 40 - std::clamp((x - 100) * steep, 0.0, 40.0); }, 40};
        Flow flow = film_on(strip);
        const auto jump = find_jump(flow.nodes(), k_rules, {98, 8}, {40, 0}, 0.05, 1);
        const double part = jump ? jump->fraction : 0;
        EXPECT_GE(part, last) << angle;
        EXPECT_LT(part - last, 0.3) << angle;  // the steepest of a smooth step is 1.5 / 30 degrees
        last = part;
        if (angle != 50) continue;
        for (const double cfl : {0.2, 0.5, 0.9}) {
            Strip same = strip;
            same.cfl = cfl;
            Flow flown = film_on(same);
            flown.advance_to(3.5);
            // Ends of the film are faster and slower by 1.4 m/s, and so is what they lose.
            EXPECT_NEAR(flown.flights().statistics().volume, part * flown.volume(), 0.06 * flown.volume()) << cfl;
        }
    }
    EXPECT_EQ(last, 1);
}

// Heights of cliffs that throw none, half and all of a film (share/doc/model.md, "Flight").
TEST(Flight, AFilmLeavesACliffOfTwoToFiveCells) {
    struct Heights {
        double cell, none, half, all;
    };
    for (const auto& [cell, none, half, all] : {Heights{10, 20, 30, 50}, {5, 7, 12, 20}, {2.5, 3, 6, 10}}) {
        const auto part = [cell = cell](double height) {
            Flow flow = film_on({cell, [=](double x) { return x < 100 ? height : 0.0; }});
            const auto jump =
                find_jump(flow.nodes(), k_rules, {100 - 1.5 * cell, 3 * cell}, {20, 0}, 0.1, 2 * cell / 20);
            return jump ? jump->fraction : 0;
        };
        EXPECT_LT(part(none), 0.05) << cell;
        EXPECT_NEAR(part(half), 0.5, 0.15) << cell;  // heights are given to 1 or 2 digits
        EXPECT_EQ(part(all), 1) << cell;
    }
}

// A fall with the drag of the air, against the equation of motion in steps of 0.1 ms.
TEST(Flight, TheAirSlowsDownWhatFlies) {
    JumpRules rules = k_rules;
    rules.drag = 0.5 * 1.2 / 200;
    Flow flow = film_on({5, cliff});
    const double thickness = 0.5;
    const auto jump = find_jump(flow.nodes(), rules, {94.9, 20}, {20, 0}, thickness, 1);
    ASSERT_TRUE(jump);
    double x = jump->from.x, z = 50, u = 20, w = 0, time = 0;
    for (constexpr double dt = 1e-4; z > 0; time += dt) {
        const double drag = rules.drag / thickness * std::hypot(u, w);
        x += dt * u;
        z += dt * w;
        u -= dt * drag * u;
        w -= dt * (k_gravity + drag * w);
    }
    EXPECT_LT(u, 18);
    // Its steps are a fourth of a cell, 1.25 m: second order.
    EXPECT_NEAR(jump->duration, time, 2e-3 * time);
    EXPECT_NEAR(jump->to.x - jump->from.x, x - jump->from.x, 2e-3 * (x - jump->from.x));
    EXPECT_NEAR(jump->landed.x, u, 2e-3 * u);
}

// The bed's impulse at landing has friction: 31 m/s into level ground with mu = 0.3 takes 9.4 of 20 m/s.
TEST(Landing, HasFriction) {
    JumpRules rules = k_rules;
    rules.friction = {0.3};
    Flow flow = film_on({5, cliff});
    const auto jump = find_jump(flow.nodes(), rules, {94.9, 20}, {20, 0}, 0.05, 1);
    ASSERT_TRUE(jump);
    EXPECT_NEAR(jump->landed.x, 20 - 0.3 * k_gravity * jump->duration, 1e-7);  // bisection of its end
    rules.friction = {2};
    EXPECT_EQ(find_jump(flow.nodes(), rules, {94.9, 20}, {20, 0}, 0.05, 1)->landed.x, 0);
}

// Where it flies lower than a house is high, it counts in the maxima.
TEST(Flight, CountsInTheMaximaWhereItIsLow) {
    for (const double clearance : {0.0, 10.0}) {
        Numerics how = numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall);
        how.minimum_depth = 1e-6;
        how.flight_drag = 0;
        how.flight_clearance = clearance;
        const GridSpec grid = bench::plain_grid(120, 8, 2);
        const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point p) {
            return bench::Seed{std::abs(p.x - 20) < 6 ? 0.05 : 0, 20, 0};
        });
        Flow flow(bench::sample_raster(grid, [](Point p) { return cliff(p.x); }), seeds, water(), how, 1);
        flow.advance_to(9);
        const double fall = std::sqrt(2 * 50 / k_gravity), landing = 100 + 20 * fall;
        const auto at = [&](double x) { return flow.flights().low().speed[flow.nodes().scale().node_of(x, 9)]; };
        EXPECT_EQ(at(125), 0);  // 42 m above the ground
        // 4 m above the ground, at 28 m/s downwards; the film lands within 6 m, so that there is none of it.
        if (clearance > 0)
            EXPECT_NEAR(at(landing - 9), std::hypot(20, 27.6), 1.5);
        else
            EXPECT_EQ(at(landing - 12), 0);
    }
}

// A level flow over the lip is not accelerated by the steepness of the face below, and material that has spread in the
// air covers more ground.
TEST(Flight, AThickFilmIsNoFasterAtTheLipAndShowsItsVolumeAfterwards) {
    Strip strip{5, cliff, 20, 400};
    strip.thickness = 1;
    Flow flow = film_on(strip);
    const double volume = flow.volume();
    double fastest = 0;
    while (flow.time() < 9) fastest = std::max(fastest, flow.advance(9 - flow.time()).nodes.max_speed);
    EXPECT_LT(fastest, 20 + 2 * std::sqrt(k_gravity * 1));  // the tip of a dam break
    EXPECT_GT(flow.flights().statistics().volume, 0.5 * volume);
    double shown = 0;
    for (const double depth : flow.snapshot().depth.values) shown += std::isnan(depth) ? 0 : depth * 25;
    EXPECT_NEAR(shown, volume, 0.1 * volume);  // without the stretch in the air a third more
}

TEST(Flight, AMovingFilmBetweenWallsIsNoMoreThanItsVolume) {
    Flow flow = film_on({2, [](double) { return 0.0; }});
    flow.set_moving_speed(0.1);
    const auto report = flow.advance(0.1);
    EXPECT_NEAR(report.nodes.moving, flow.volume(), 1e-9 * flow.volume());
}

// On random ground, no bed within reach of a step is more convex than its bound.
TEST(Flight, NoGroundIsMoreConvexThanItsBound) {
    std::mt19937 random(1);
    const auto uniform = [&](double from, double to) { return from + (to - from) * 0x1p-32 * random(); };
    constexpr double cell = 5;
    for (int terrain = 0; terrain < 20; ++terrain) {
        const double roughness = uniform(0, 6), slope = uniform(-2, 2), wall = uniform(-40, 40);
        const GridSpec grid = bench::plain_grid(24, 24, cell);
        const NodeGrid nodes(bench::sample_raster(
            grid, [&](Point p) { return slope * p.x + (p.x + 0.3 * p.y > 75 ? wall : 0) + uniform(0, roughness); }));
        for (int start = 0; start < 500; ++start) {
            const Point place{uniform(30, 90), uniform(30, 90)};
            const double direction = uniform(0, 6.3), way = uniform(0, 1.25 * cell);
            const Point e{std::cos(direction), std::sin(direction)};
            const auto height = [&](double ahead) {
                const Point p{place.x + ahead * e.x, place.y + ahead * e.y};
                return interpolate(Stencil<QuadraticSplineShape>(p.x, p.y, nodes.scale()), nodes.bed.data(),
                                   nodes.stride())
                    .value;
            };
            constexpr double k_near = 1e-3;
            const double bend = (2 * height(way) - height(way - k_near) - height(way + k_near)) / (k_near * k_near);
            const auto node = [](double at) { return static_cast<std::int64_t>(at / cell) + k_ghost; };
            double bound = 0;
            greatest_convexity({node(place.x), node(place.x) + 1, node(place.y), node(place.y) + 1}, nodes, &bound);
            EXPECT_GE(bound, bend - 1e-6);  // rounding of heights
        }
    }
}

// The nodes that are looked at: on random ground with walls, what flies does so where one of them is near an edge.
TEST(Flight, NoJumpIsFarFromAnEdge) {
    std::mt19937 random(2);
    const auto uniform = [&](double from, double to) { return from + (to - from) * 0x1p-32 * random(); };
    constexpr double cell = 5, margin = 5 * k_degree;
    int jumps = 0, missed = 0;
    for (int terrain = 0; terrain < 30; ++terrain) {
        const double roughness = uniform(0, 4), slope = uniform(-1, 1), wall = uniform(5, 40), width = uniform(1, 40);
        const double turn = uniform(0, 6.3);
        const GridSpec grid = bench::plain_grid(40, 40, cell);
        const NodeGrid nodes(bench::sample_raster(grid, [&](Point p) {
            const double across = std::cos(turn) * (p.x - 100) + std::sin(turn) * (p.y - 100);
            return slope * p.x - wall * std::clamp(across / width, 0.0, 1.0) + uniform(0, roughness);
        }));
        for (int start = 0; start < 2000; ++start) {
            const Point place{uniform(60, 140), uniform(60, 140)}, along{uniform(-40, 40), uniform(-40, 40)};
            const double thickness = uniform(0.05, 3), reach = cell / std::hypot(along.x, along.y);
            const auto jump = find_jump(nodes, k_rules, place, along, thickness, reach);
            if (!jump || jump->duration == 0) continue;
            ++jumps;
            const auto node = [](double at) { return static_cast<std::int64_t>(at / cell) + k_ghost; };
            unsigned edges = 0;
            for (const std::int64_t b : {-2, -1, 0, 1, 2})
                for (const std::int64_t a : {-2, -1, 0, 1, 2})
                    edges |=
                        edges_at(nodes, node(place.x) + a, node(place.y) + b, k_rules.angle - k_half_ramp - margin);
            missed += (edges & directions_near(along)) == 0 ? 1 : 0;
        }
    }
    EXPECT_GT(jumps, 1000);
    EXPECT_EQ(missed, 0);
}

TEST(Flight, OffKeepsParticlesOnTheBedAndCostsNothing) {
    Strip strip{2, cliff};
    strip.flight = false;
    Flow flow = film_on(strip);
    flow.advance_to(6);
    EXPECT_EQ(flow.flights().statistics().volume, 0);
    EXPECT_EQ(flow.flights().heights().size(), 0U);
}

TEST(Flight, ParticlesAcrossAnOpenEdgeHaveLeft) {
    const GridSpec grid = bench::plain_grid(60, 8, 2);
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point p) {
        return bench::Seed{std::abs(p.x - 20) < 6 ? 0.05 : 0, 20, 0};
    });
    Numerics how = numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open);
    how.minimum_depth = 1e-6;
    Flow flow(bench::sample_raster(grid, [](Point p) { return p.x < 100 ? 50 : 0; }), seeds, water(), how, 1);
    const double volume = flow.volume();
    while (flow.time() < 10 && !flow.empty()) flow.advance(10 - flow.time());
    EXPECT_TRUE(flow.empty());
    EXPECT_NEAR(flow.volume_left(), volume, 1e-9 * volume);
}

TEST(Flight, ParticlesThatMeetAWallFallDownIt) {
    Flow flow = film_on({2, cliff, 20, 130});
    const double volume = flow.volume();
    flow.advance_to(8);
    EXPECT_TRUE(flow.flights().empty());
    EXPECT_NEAR(flow.volume(), volume, 1e-9 * volume);
    EXPECT_NEAR(flow.flights().statistics().to.x, 130, 2);
}

}  // namespace
}  // namespace frana::test
