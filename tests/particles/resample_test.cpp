// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "particles/resample.h"

namespace frana {
namespace {

struct Totals {
    double volume = 0, area = 0, mx = 0, my = 0, moment_x = 0, pore = 0;

    explicit Totals(const ParticleSet& p) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double v = p[Field::volume][i];
            volume += v;
            area += p[Field::area][i];
            mx += v * p[Field::u][i];
            my += v * p[Field::v][i];
            moment_x += v * p[Field::x][i];
            pore += v * (p[Field::pore_pressure][i] + 10 * p[Field::solid_fraction][i]);
        }
    }
};

ParticleRow particle(double x, double y, double length, double width, double angle) {
    ParticleRow r = ParticleSet::initial_row();
    get(r, Field::x) = x;
    get(r, Field::y) = y;
    get(r, Field::u) = 3 + x;
    get(r, Field::v) = -1;
    get(r, Field::c_xx) = 0.5;
    get(r, Field::pore_pressure) = 0.01 * x;
    get(r, Field::solid_fraction) = 0.5 + 0.001 * y;
    get(r, Field::c_yx) = -0.2;
    get(r, Field::area) = length * width;
    get(r, Field::volume) = 0.7 * length * width;
    const double c = std::cos(angle), s = std::sin(angle), a = length * length, b = width * width;
    get(r, Field::q_xx) = a * c * c + b * s * s;
    get(r, Field::q_xy) = (a - b) * c * s;
    get(r, Field::q_yy) = a * s * s + b * c * c;
    return r;
}

constexpr FieldMask k_mask = k_basic_fields | k_affine_fields | k_shape_fields |
                             FieldMask{Field::compression, Field::pore_pressure, Field::solid_fraction};

ResampleCounts resample_with(ParticleSet& particles, ResampleLimits limits, const std::uint8_t* tail = nullptr) {
    ThreadPool pool(2);
    TileOrder order({40, 40, 2, 1.0});
    order.plan(particles, {}, pool);
    limits.edges = {0, 0, 40, 40};
    return resample(particles, order, limits, {}, tail, pool);
}

ResampleCounts resample_once(ParticleSet& particles, int max_per_cell) {
    ResampleLimits limits;
    limits.flow.most = max_per_cell;
    return resample_with(particles, limits);
}

constexpr double k_film_depth = 0.1;

ResampleCounts resample_film(ParticleSet& particles) {
    ResampleLimits limits;
    limits.film_depth = k_film_depth;
    return resample_with(particles, limits);
}

TEST(Resample, AFilmHasFewerParticlesThanAFlow) {
    // Nine in a cell: of 12 cm nothing merges, of 8 cm all but the film's three.
    for (const double depth : {0.12, 0.08}) {
        ParticleSet particles(k_mask);
        for (int i = 0; i < 9; ++i) {
            ParticleRow r = particle(20.2 + 0.3 * (i % 3), 20.2 + 0.3 * (i / 3), 0.3, 0.3, 0);
            get(r, Field::volume) = depth * get(r, Field::area);
            particles.push_back(r);
        }
        const Totals before(particles);
        resample_film(particles);
        EXPECT_EQ(particles.size(), depth > k_film_depth ? 9U : 3U);
        const Totals after(particles);
        EXPECT_NEAR(after.volume, before.volume, 1e-15);
        EXPECT_NEAR(after.area, before.area, 1e-15);
        EXPECT_NEAR(after.mx, before.mx, 1e-14);
    }
}

TEST(Resample, ATailHasFewerParticlesThanAFlow) {
    // Nine in each of two cells, of which one is marked.
    ParticleSet particles(k_mask);
    for (const double x : {20.2, 24.2})
        for (int i = 0; i < 9; ++i) particles.push_back(particle(x + 0.3 * (i % 3), 20.2 + 0.3 * (i / 3), 0.3, 0.3, 0));
    constexpr std::size_t k_row = 40 + 2 * 2;
    std::vector<std::uint8_t> tail(k_row * k_row);
    tail[22 * k_row + 26] = 1;
    const ResampleLimits limits;
    resample_with(particles, limits, tail.data());
    const double* const x = particles[Field::x];
    EXPECT_EQ(std::count_if(x, x + particles.size(), [](double at) { return at > 23; }), limits.tail.most);
    EXPECT_EQ(std::count_if(x, x + particles.size(), [](double at) { return at < 23; }), 9);
}

TEST(Resample, AFilmSplitsLater) {
    for (const double depth : {0.12, 0.08}) {
        ParticleSet particles(k_mask);
        ParticleRow r = particle(20.5, 20.5, 0.9, 0.4, 0);
        get(r, Field::volume) = depth * get(r, Field::area);
        particles.push_back(r);
        EXPECT_EQ(resample_film(particles).split, depth > k_film_depth ? 1 : 0);
    }
}

TEST(Resample, SplitsALongParticleAlongItsAxisAndConservesTheBudgets) {
    ParticleSet particles(k_mask);
    const double angle = 0.6;
    particles.push_back(particle(20.5, 20.5, 1.2, 0.4, angle));
    const Totals before(particles);
    EXPECT_EQ(resample_once(particles, 12).split, 1);
    ASSERT_EQ(particles.size(), 2u);
    const Totals after(particles);
    EXPECT_NEAR(after.volume, before.volume, 1e-15);
    EXPECT_NEAR(after.area, before.area, 1e-15);
    EXPECT_NEAR(after.mx, before.mx, 1e-14);
    EXPECT_NEAR(after.my, before.my, 1e-14);
    EXPECT_NEAR(after.moment_x, before.moment_x, 1e-13);
    EXPECT_NEAR(after.pore, before.pore, 1e-13);
    const double dx = particles[Field::x][1] - particles[Field::x][0];
    const double dy = particles[Field::y][1] - particles[Field::y][0];
    EXPECT_NEAR(std::atan2(dy, dx), angle, 1e-12);
    EXPECT_NEAR(std::hypot(dx, dy), 0.6, 1e-12);  // halves of 0.6 m side by side
    // Each half is 0.6 by 0.4 m: determinant of the squared extents.
    const double determinant =
        particles[Field::q_xx][0] * particles[Field::q_yy][0] - particles[Field::q_xy][0] * particles[Field::q_xy][0];
    EXPECT_NEAR(determinant, 0.36 * 0.16, 1e-12);
}

TEST(Resample, LeavesShortAndThinParticlesAlone) {
    ParticleSet particles(k_mask);
    particles.push_back(particle(20.5, 20.5, 0.6, 0.6, 0));
    ParticleRow film = particle(10.5, 10.5, 2, 0.5, 0);
    get(film, Field::volume) = 1e-5;
    particles.push_back(film);
    EXPECT_EQ(resample_once(particles, 12).split, 0);
    EXPECT_EQ(particles.size(), 2u);
}

// Positions, volumes and shapes of the remaining particles of a crowd the given number of cells to the east and north,
// moved to 0; by place.
std::vector<std::array<double, 5>> remaining_of_crowd(int east, int north) {
    ParticleSet particles(k_mask);
    std::uint64_t random = 1;
    const auto next = [&](int below) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        return static_cast<int>((random >> 33) % static_cast<std::uint64_t>(below));
    };
    for (int cell = 0; cell < 18 * 18; ++cell) {  // a chessboard of crowded cells and of cells with long particles
        const int i = cell % 18, j = cell / 18;
        const bool crowded = (i + j) % 2 == 0;
        for (int k = 0; k < (crowded ? 12 : 2); ++k) {
            // on 1024ths of a cell, so that moving them rounds nothing
            const double x = 4 + i + next(1024) / 1024.0, y = 4 + j + next(1024) / 1024.0;
            ParticleRow r = crowded ? particle(x, y, 0.25, 0.25, 0) : particle(x, y, 1.5, 0.25, 0.5);
            get(r, Field::x) += east;
            get(r, Field::y) += north;
            particles.push_back(r);
        }
    }
    const ResampleCounts counts = resample_once(particles, 10);
    EXPECT_GT(counts.split, 10);
    EXPECT_GT(counts.merged, 100);
    std::vector<std::array<double, 5>> left;
    for (std::size_t p = 0; p < particles.size(); ++p)
        left.push_back({particles[Field::x][p] - east, particles[Field::y][p] - north, particles[Field::volume][p],
                        particles[Field::q_xx][p], particles[Field::q_yy][p]});
    std::sort(left.begin(), left.end());
    return left;
}

// As many overlapping release areas: comparing all pairs for each merge would take the cube of that, hours.
TEST(Resample, MergesACrowdInLinearTime) {
    ParticleSet particles(k_mask);
    for (int i = 0; i < 50'000; ++i)
        particles.push_back(particle(20.25 + 0.5 * (i % 2), 20.25 + 0.5 * (i / 2 % 2), 0.5, 0.5, 0));
    const Totals before(particles);
    const ResampleCounts counts = resample_once(particles, 10);
    EXPECT_EQ(counts.merged, 50'000 - static_cast<std::int64_t>(particles.size()));
    EXPECT_LE(particles.size(), 10U);
    const Totals after(particles);
    EXPECT_NEAR(after.volume / before.volume, 1, 1e-12);  // 50 000 roundings
    EXPECT_NEAR(after.area / before.area, 1, 1e-12);
    EXPECT_NEAR(after.mx / before.mx, 1, 1e-12);
    EXPECT_NEAR(after.my / before.my, 1, 1e-12);
    EXPECT_NEAR(after.moment_x / before.moment_x, 1, 1e-12);
    EXPECT_NEAR(after.pore / before.pore, 1, 1e-12);
}

TEST(Resample, DoesNotDependOnThePositionOfTheTiles) {
    const auto here = remaining_of_crowd(0, 0);
    for (const auto& [east, north] : {std::array{1, 0}, std::array{0, 5}, std::array{7, 11}}) {
        const auto there = remaining_of_crowd(east, north);
        ASSERT_EQ(here.size(), there.size()) << east << " cells to the east, " << north << " to the north";
        for (std::size_t i = 0; i < here.size(); ++i)
            for (std::size_t k = 0; k < 5; ++k) ASSERT_NEAR(here[i][k], there[i][k], 1e-12) << i;
    }
}

}  // namespace
}  // namespace frana
