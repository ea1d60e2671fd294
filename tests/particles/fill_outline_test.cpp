// SPDX-License-Identifier: Apache-2.0
// Outlines of many vertices: the particles of the simple method, in less than quadratic time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "particles/seeding.h"
#include "simple_fill.h"

namespace frana {
namespace {

constexpr double k_turn = 2 * std::numbers::pi;

/// Around a centre, the radius random between two bounds; spiky if `wild`.
Ring random_ring(Point centre, double radius, int points, double wild, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(1 - wild, 1);
    Ring ring;
    for (int i = 0; i < points; ++i) {
        const double angle = k_turn * i / points, r = radius * uniform(random);
        ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
    return ring;
}

double thickness(Point p) {
    return 1 + 0.01 * p.x + 0.02 * p.y;
}

void expect_same_bits(const MultiPolygon& outline, double spacing) {
    ParticleSet simple, filled;
    EXPECT_EQ(test::simple_fill(outline, spacing, thickness, simple),
              fill_outline(outline, spacing, thickness, filled));
    spread_slivers(0, spacing, simple);
    ASSERT_EQ(simple.size(), filled.size());
    for (std::size_t p = 0; p < simple.size(); ++p)
        for (const Field field : {Field::x, Field::y, Field::area, Field::volume})
            ASSERT_EQ(simple[field][p], filled[field][p]) << p;
}

TEST(FillOutline, EqualsTheSimpleMethodToTheBit) {
    std::mt19937 random(5);
    for (int k = 0; k < 40; ++k) {
        const double wild = k % 4 * 0.2;
        Polygon polygon{random_ring({60, 55}, 50, 5 + 7 * k, wild, random), {}};
        if (k % 3 == 1)
            polygon.holes = {random_ring({50, 50}, 8, 20, 0.5, random), random_ring({70, 60}, 6, 9, 0, random)};
        MultiPolygon outline{polygon};
        if (k % 5 == 2) outline.push_back({random_ring({90, 60}, 30, 40, 0.5, random), {}});  // overlaps the first
        if (k % 5 == 3) outline.push_back({random_ring({190, 60}, 30, 40, 0.5, random), {}});
        expect_same_bits(outline, k % 2 == 0 ? 2.5 : 1.7);
    }
    // Edges on the lattice's lines and corners.
    expect_same_bits({{{{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}, {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}}}}, 1);
}

// An outline drawn along the cells, or derived from a raster, deviates from their edges by the rounding of coordinates.
TEST(FillOutline, SliversGiveNoParticlesButTheirVolumeIsConserved) {
    const auto one = [](Point) { return 1.0; };
    for (const double over : {1e-8, 3e-7, 1e-6, 9e-6}) {
        ParticleSet particles;
        const double a = -over, b = 10, c = 20 + over;
        const double volume = fill_outline({{{{a, a}, {c, a}, {c, b}, {a, b}}, {}}}, 1, one, particles);
        EXPECT_EQ(particles.size(), 200U) << over;
        EXPECT_NEAR(volume / ((c - a) * (b - a)), 1, 1e-12) << over;  // of 200 roundings
        double area = 0;
        for (std::size_t p = 0; p < particles.size(); ++p) area += particles[Field::area][p];
        EXPECT_NEAR(area / volume, 1, 1e-12);
    }
    // An outline of slivers alone is kept.
    ParticleSet line;
    EXPECT_NEAR(fill_outline({{{{0, 0.5}, {10, 0.5}, {10, 0.5 + 1e-6}, {0, 0.5 + 1e-6}}, {}}}, 1, one, line), 1e-5,
                1e-14);
    EXPECT_EQ(line.size(), 10U);
}

/// Spikes from one circle to another, with the area by the shoelace formula.
Polygon star(Point centre, double inner, double outer, int spikes) {
    Polygon polygon;
    for (int i = 0; i < 2 * spikes; ++i) {
        const double angle = k_turn * i / (2 * spikes), r = i % 2 == 0 ? outer : inner;
        polygon.outer.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
    return polygon;
}

// By strips each of these rows would be divided a thousand million times.
TEST(FillOutline, AStarOfManySpikesKeepsAreaAndCentroid) {
    for (const bool turned : {false, true}) {
        Polygon polygon = star({60, 55}, 5, 50, 100'000);
        polygon.holes.push_back(star({60, 55}, 3, 4, 50'000).outer);
        if (turned) std::reverse(polygon.outer.begin(), polygon.outer.end());
        ParticleSet particles;
        const double volume = fill_outline(
            {polygon}, 2.5, [](Point) { return 1.0; }, particles);
        // Sums of 200 000 pieces, each rounded to 1e-16 of a cell.
        EXPECT_NEAR(volume / area(polygon), 1, 1e-9);
        Point moment;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            moment.x += particles[Field::volume][p] * particles[Field::x][p];
            moment.y += particles[Field::volume][p] * particles[Field::y][p];
        }
        EXPECT_NEAR(moment.x / volume, 60, 1e-8);
        EXPECT_NEAR(moment.y / volume, 55, 1e-8);
    }
}

// Both methods are compared: rows with slightly too many crossings for strips, against the simple method.
TEST(FillOutline, AlongTheEdgesEqualsByStrips) {
    const MultiPolygon outline{star({60.1, 55.2}, 20, 50, 3000)};
    ParticleSet simple, filled;
    const double volume = test::simple_fill(outline, 20, thickness, simple);
    EXPECT_NEAR(fill_outline(outline, 20, thickness, filled) / volume, 1, 1e-12);
    ASSERT_EQ(simple.size(), filled.size());
    bool differs = false;
    for (std::size_t p = 0; p < simple.size(); ++p) {
        for (const Field field : {Field::x, Field::y, Field::area}) {
            EXPECT_NEAR(simple[field][p], filled[field][p], 1e-9) << p;
            differs = differs || simple[field][p] != filled[field][p];
        }
    }
    EXPECT_TRUE(differs) << "both went by strips: nothing was compared";
}

}  // namespace
}  // namespace frana
