// SPDX-License-Identifier: Apache-2.0
// Viscous flow down a plane: a given volume released across a slope forgets its shape, and its front follows (Huppert
// 1982, Nature 300, 427)
//
//     x_N = (9 A^2 g_s / (4 nu))^(1/3) t^(1/3),   h = sqrt(nu x / (g_s t)) behind it
//
// A volume per width [m2], g_s gravity along the slope, nu kinematic viscosity. The same law of bed friction spreads
// the source of share/scenes/viscous_source.ini in both directions.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bench/set_up/setup.h"
#include "physics/laws.h"

namespace frana::test {
namespace {

constexpr double k_pull = 3, k_weight = 9, k_viscosity = 0.1;  // [m2/s]

struct Film {
    double front = 0;  // where the depth is half of the exact one at the front, between cells [m]
    double depth = 0;  // at 0.5 x_N over the exact one [-]
};

double exact_front(double area, double time) {
    return std::cbrt(9 * area * area * k_pull / (4 * k_viscosity) * time);
}

Film film_at(bench::TimedFlow& flow, double time, double start, double area) {
    flow.advance_to(time);
    const Raster depth = flow.fields().depth;
    const double front = exact_front(area, time), cell = depth.grid.cell_size;
    const auto exact = [&](double x) { return std::sqrt(k_viscosity * x / (k_pull * time)); };
    const auto at = [&](std::int64_t column) { return depth.at(1, column); };
    std::int64_t column = depth.grid.columns - 1;
    while (column > 0 && at(column) < 0.5 * exact(front)) --column;
    const double over = (at(column) - 0.5 * exact(front)) / (at(column) - at(column + 1));
    const auto middle = static_cast<std::int64_t>((start + 0.5 * front) / cell);
    return {(static_cast<double>(column) + 0.5 + over) * cell - start,
            at(middle) / exact((static_cast<double>(middle) + 0.5) * cell - start)};
}

class ViscousFront : public testing::TestWithParam<Scheme> {};

// The finite start and the rounded nose leave the front 1.4 to 1.9 m behind at both times, on cells of 0.5 and 0.25 m
// alike: 4 % of the late front, and little of the way between. The film is thicker by as much.
TEST_P(ViscousFront, FollowsThePowerLawAndItsPrefactor) {
    constexpr double k_start = 4, k_area = 1;
    Material material = bench::water();
    material.in_plane_stress = "none";
    material.bed_friction = {"bingham"};
    material.of<BinghamStress>().viscosity = k_viscosity * material.density;
    bench::Setup setup{Raster(bench::plain_grid(130, 4, 0.5), 0.0), ParticleSet(), material,
                       bench::numerics_of(GetParam(), SlopeCorrection::normal, Boundary::wall),
                       TiltedGravity{k_pull, 0, k_weight}};
    setup.seeds = bench::fill_lattice(
        setup.bed.grid, 2, 0, [](Point p) { return bench::Seed{p.x > k_start && p.x < k_start + k_area ? 1.0 : 0.0}; });
    bench::TimedFlow flow(setup);
    const Film early = film_at(flow, 250, k_start, k_area), late = film_at(flow, 2000, k_start, k_area);
    const double early_exact = exact_front(k_area, 250), late_exact = exact_front(k_area, 2000);
    EXPECT_NEAR(late.front, late_exact, 0.04 * late_exact);
    EXPECT_NEAR(late.front - early.front, late_exact - early_exact, 0.02 * (late_exact - early_exact));
    EXPECT_NEAR(late.depth, 1, 0.06);
    EXPECT_LT(std::abs(late.depth - 1), std::abs(early.depth - 1));
}

INSTANTIATE_TEST_SUITE_P(Schemes, ViscousFront, testing::Values(Scheme::standard, Scheme::finite_volume),
                         [](const auto& one) { return std::string(one.index == 0 ? "Particles" : "Volumes"); });

}  // namespace
}  // namespace frana::test
