// SPDX-License-Identifier: Apache-2.0
// Particle shifting (mpm/shifting.h): irregular particles become even during flow. lake_at_rest_test.cpp tests that
// still water with irregular particles remains at rest, dam_break_test.cpp the effect on errors,
// vector_kernels_test.cpp that shifting changes neither volume nor velocity of any particle.
#include <gtest/gtest.h>

#include "mpm/shifting.h"
#include "support/cases.h"

namespace frana::test {
namespace {

constexpr double k_jitter = 0.8;

// Root mean square of phi - 1 over the nodes of a block of columns, one cell from its sides.
double unevenness(Flow& flow, std::int64_t first, std::int64_t last) {
    flow.nodal_fields();  // gathers on the nodes
    const NodeGrid& nodes = flow.nodes();
    double sum = 0, count = 0;
    for (std::int64_t j = 0; j < nodes.rows(); ++j) {
        for (std::int64_t i = first; i < last; ++i) {
            const double off = nodes.forces()[nodes.index(i, j)].area / (nodes.cell_size() * nodes.cell_size()) - 1;
            sum += off * off;
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

// Water that flows uniformly through a channel: only shifting changes the arrangement of its particles.
TEST(Shifting, MakesIrregularParticlesEven) {
    const GridSpec grid = bench::plain_grid(200, 10, 1);
    const ParticleSet seeds = bench::fill_lattice(grid, 2, k_jitter, [](Point) { return bench::Seed{2, 5, 0}; });
    Flow flow(Raster(grid, 0.0), seeds, water(), numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall),
              1);
    const double before = unevenness(flow, 60, 140);
    EXPECT_GT(before, 0.02);
    flow.advance_to(5);  // 25 cells; the disturbed ends are over 40 cells away
    EXPECT_LT(unevenness(flow, 60, 140), 0.3 * before);
}

// No shift without motion, at a free front, where a cell of the stencil is far from full or particles overlap strongly;
// and never far.
TEST(Shifting, IsBounded) {
    const auto far = [](double courant, double support, double least, double slope, double fraction = 1) {
        return shift_of(k_shift, courant, support, least, fraction, slope, 0.0, 1.0, 0.0, 0.0, 2.0).x;
    };
    EXPECT_EQ(far(0.3, 1, 1, 0.1, k_shift_none), 0);
    EXPECT_NEAR(far(0.3, 1, 1, 0.1, 0.5 * (k_shift_until + k_shift_none)), 0.5 * far(0.3, 1, 1, 0.1), 1e-15);
    EXPECT_EQ(far(0, 1, 1, 0.1), 0);
    EXPECT_EQ(far(0.3, 0.98, 1, 0.1), 0);
    EXPECT_EQ(far(0.3, 1, k_shift_from, 0.1), 0);
    EXPECT_DOUBLE_EQ(far(0.3, 1, 1, 0.1), -k_shift * 2 * 2 * 0.1);
    EXPECT_DOUBLE_EQ(far(0.3, 1, 1, 10), -k_shift_farthest * 2);
    EXPECT_DOUBLE_EQ(far(1e-3, 1, 1, 10), -2 * shift_reach(1e-3));
}

// The depth follows the nodes' depth, here one that increases by a tenth over a metre; phi does not affect it.
TEST(Shifting, AdjustsTheDepthAlongItsGradient) {
    const double phi = 1.1, phi_x = 0.2, depth = 3, depth_x = 0.3;
    const Shift<double> s =
        shift_of(k_shift, 0.3, 1.0, 1.0, phi, phi_x, 0.0, phi * depth, phi_x * depth + phi * depth_x, 0.0, 1.0);
    EXPECT_DOUBLE_EQ(s.x, -k_shift * phi_x);
    EXPECT_NEAR(s.growth, 1 - s.x * depth_x / depth, 1e-14);
}

}  // namespace
}  // namespace frana::test
