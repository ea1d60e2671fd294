// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "particles/resample.h"

namespace frana {
namespace {

struct Totals {
    double volume = 0, area = 0, mx = 0, my = 0, moment_x = 0;

    explicit Totals(const ParticleSet& p) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double v = p[Field::volume][i];
            volume += v;
            area += p[Field::area][i];
            mx += v * p[Field::u][i];
            my += v * p[Field::v][i];
            moment_x += v * p[Field::x][i];
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
    get(r, Field::c_yx) = -0.2;
    get(r, Field::area) = length * width;
    get(r, Field::volume) = 0.7 * length * width;
    const double c = std::cos(angle), s = std::sin(angle), a = length * length, b = width * width;
    get(r, Field::q_xx) = a * c * c + b * s * s;
    get(r, Field::q_xy) = (a - b) * c * s;
    get(r, Field::q_yy) = a * s * s + b * c * c;
    return r;
}

constexpr FieldMask k_mask = k_basic_fields | k_affine_fields | k_shape_fields | FieldMask{Field::compression};

ResampleCounts resample_once(ParticleSet& particles, int max_per_cell) {
    ThreadPool pool(2);
    TileOrder order({40, 40, 2, 1.0});
    order.sort(particles, {}, pool);
    ResampleLimits limits;
    limits.max_per_cell = max_per_cell;
    limits.edges = {0, 0, 40, 40};
    return resample(particles, order, limits, {}, pool);
}

TEST(Resample, SplitsALongParticleAlongItsAxisAndKeepsTheBudgets) {
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
    const double dx = particles[Field::x][1] - particles[Field::x][0];
    const double dy = particles[Field::y][1] - particles[Field::y][0];
    EXPECT_NEAR(std::atan2(dy, dx), angle, 1e-12);
    EXPECT_NEAR(std::hypot(dx, dy), 0.6, 1e-12);  // halves of 0.6 m side by side
    // Each half is 0.6 by 0.4 m: determinant of the squared extents.
    const double determinant = particles[Field::q_xx][0] * particles[Field::q_yy][0] -
                               particles[Field::q_xy][0] * particles[Field::q_xy][0];
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

TEST(Resample, MergesCrowdedCellsAndKeepsTheBudgets) {
    ParticleSet particles(k_mask);
    for (int i = 0; i < 30; ++i) {
        particles.push_back(particle(20.05 + 0.03 * i, 20.1 + 0.9 * ((i * 7) % 30) / 30.0, 0.2, 0.2, 0));
    }
    const Totals before(particles);
    const ResampleCounts counts = resample_once(particles, 12);
    EXPECT_EQ(counts.merged, 18);
    EXPECT_EQ(particles.size(), 12u);
    const Totals after(particles);
    EXPECT_NEAR(after.volume, before.volume, 1e-14);
    EXPECT_NEAR(after.area, before.area, 1e-14);
    EXPECT_NEAR(after.mx, before.mx, 1e-13);
    EXPECT_NEAR(after.my, before.my, 1e-13);
    EXPECT_NEAR(after.moment_x, before.moment_x, 1e-12);
}

}  // namespace
}  // namespace frana
