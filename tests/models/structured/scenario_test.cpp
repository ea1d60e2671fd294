// SPDX-License-Identifier: Apache-2.0
// The paper's numerical scenario 2 at coarse resolution: one block, three cohesions, over a convex break of slope.
#include <gtest/gtest.h>

#include <algorithm>

#include "solid_cases.h"

namespace frana::structured::test {
namespace {

struct Outcome {
    double lost = 0;              // mean loss of cohesion
    double undamaged_strain = 0;  // greatest in the plane, of particles that never yielded while opening
    double length = 0;            // of the block along the slope [m]
};

// 200 m x 100 m x 20 m, half solids and half confined fluid, on 15 degrees above the break and 30 below it; 14 s.
Outcome slide(double cohesion) {
    ThreadPool pool(1);
    Case c(20);
    c.material.solid_fraction = 0.5;
    c.material.grain_density = 2400;
    c.material.cohesion = cohesion;
    c.material.bed_friction = std::tan(12 * k_degree);
    c.laws.fluid.manning = 0.1;
    c.fill(300, 250, 30, 15, [](Point) { return bench::Seed{20}; });
    const Raster bed = bench::sample_raster(bench::plain_grid(60, 30, 20), [](Point p) {
        return 600 - (p.x - 400) * std::tan((p.x < 400 ? 15 : 30) * k_degree);
    });
    State state = c.start(bed, pool, true);
    advance_to(state, c.laws, 14, pool);
    const ParticleSet& p = state.solid->particles;
    Outcome outcome;
    const auto [back, front] = std::minmax_element(p[Field::x], p[Field::x] + p.size());
    outcome.length = *front - *back;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double ratio = p[Field::cohesion_ratio][i];
        outcome.lost += (1 - ratio) / static_cast<double>(p.size());
        const double mean = 0.5 * (p[Field::e_xx][i] + p[Field::e_yy][i]);
        const double radius = std::hypot(0.5 * (p[Field::e_xx][i] - p[Field::e_yy][i]), p[Field::e_xy][i]);
        const double strain = std::abs(mean) + radius;
        if (ratio == 1) outcome.undamaged_strain = std::max(outcome.undamaged_strain, strain);
    }
    return outcome;
}

TEST(Scenario, TheWeakerTheMoreBreaks) {
    const Outcome strong = slide(5e6), middling = slide(2e5), weak = slide(1e4);
    EXPECT_EQ(strong.lost, 0);
    EXPECT_GT(middling.lost, 0);
    EXPECT_GT(weak.lost, 2 * middling.lost);
    EXPECT_GT(weak.lost, 0.1);
    for (const Outcome& outcome : {strong, middling, weak}) EXPECT_LT(outcome.undamaged_strain, 0.01);
    EXPECT_NEAR(strong.length, 29 * 20 / 3.0, 0.01 * 200);  // it keeps its shape
    EXPECT_GT(weak.length, 1.2 * strong.length);
}

}  // namespace
}  // namespace frana::structured::test
