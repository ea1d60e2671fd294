// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "bench/exact/solutions.h"
#include "physics/laws.h"
#include "physics/stress_earth_pressure.h"
#include "support/cases.h"

namespace frana::test {
namespace {

double tangent(double angle_deg) {
    return std::tan(angle_deg * M_PI / 180);
}

TEST(EarthPressure, IsRankinesOnASmoothBed) {
    const auto law = EarthPressureStress::of(tangent(30), 0, 9.81);
    EXPECT_NEAR(law.spreading, 1.0 / 3, 1e-14);  // tan^2(45 - 15 degrees)
    EXPECT_NEAR(law.compressed, 3, 1e-14);       // tan^2(45 + 15 degrees)
}

TEST(EarthPressure, BothAreOneWhereTheBedIsAsRoughAsTheInside) {
    const auto law = EarthPressureStress::of(tangent(33), tangent(33), 9.81);
    const double k = 1 + 2 * tangent(33) * tangent(33);
    EXPECT_NEAR(law.spreading, k, 1e-7);  // the square root of a rounding error
    EXPECT_NEAR(law.compressed, k, 1e-7);
}

TEST(EarthPressure, ChangesWithoutAJump) {
    const auto law = EarthPressureStress::of(tangent(35), tangent(20), 9.81);
    EXPECT_EQ(law.coefficient(1.0), law.spreading);
    EXPECT_EQ(law.coefficient(-1.0), law.compressed);
    EXPECT_EQ(law.coefficient(0.0), 1);
    const double step = 0.01 * law.transition;
    for (int i = -200; i < 200; ++i) {
        EXPECT_LT(std::abs(law.coefficient((i + 1) * step) - law.coefficient(i * step)),
                  0.011 * (law.compressed - law.spreading));
    }
    const PlaneStress<double> dry = law(StrainRate<double>{0.1, 0, 0.1, 1, 0, 0});
    EXPECT_EQ(dry.xx, 0);
}

// Savage and Hutter's parabolic cap, which spreads from the start, under K_act; the same run without the law is wrong.
double depth_error(bool with_law) {
    constexpr double k_slope = 35, k_bed = 20, k_inside = 36, k_height = 4, k_radius = 80, k_time = 5, k_cell = 5;
    const double sine = std::sin(k_slope * M_PI / 180), cosine = std::cos(k_slope * M_PI / 180);
    const GridSpec grid = bench::plain_grid(60, 44, k_cell);
    const auto place = [](Point p) { return Point{p.x - 110, p.y - 110}; };
    const ParticleSet seeds = bench::fill_lattice(grid, 2, 0, [&](Point p) {
        const Point q = place(p);
        return bench::Seed{k_height * (1 - (q.x * q.x + q.y * q.y) / (k_radius * k_radius))};
    });
    Material material = dry_friction(k_bed);
    if (with_law) {
        material.in_plane_stress = EarthPressureStress::word;
        material.of<EarthPressureStress>().internal_friction_angle = k_inside;
    }
    Flow flow(Raster(grid), seeds, material, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), 1,
              TiltedGravity{9.81 * sine, 0, 9.81 * cosine});
    flow.advance_to(k_time);
    const double k = EarthPressureStress::of(tangent(k_inside), tangent(k_bed), 9.81).spreading;
    const bench::SimilaritySolution exact(k_slope, k_bed, k_height, k_radius, k_time, k);
    const Raster depth = flow.nodal_fields().depth;
    double wrong = 0, all = 0;
    for (std::int64_t r = 0; r < grid.rows; ++r) {
        for (std::int64_t c = 0; c < grid.columns; ++c) {
            const Point at = place(grid.local_from_map(grid.cell_centre(r, c)));
            const double h = exact.at(at).depth;
            wrong += (depth.at(r, c) - h) * (depth.at(r, c) - h);
            all += h * h;
        }
    }
    return std::sqrt(wrong / all);
}

TEST(EarthPressure, CapFollowsTheSimilaritySolution) {
    // With K = 1 the limit of the bench's similarity case is 0.015 at this cell size.
    EXPECT_LT(depth_error(true), 0.025);
    EXPECT_GT(depth_error(false), 0.05);
}

}  // namespace
}  // namespace frana::test
