// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/cases.h"

namespace frana::test {
namespace {

TEST(NoDataWall, RetainsTheFlow) {
    const GridSpec grid = bench::plain_grid(60, 20, 1);
    const Raster bed =
        bench::sample_raster(grid, [](Point p) { return p.x > 40 && p.x < 44 ? k_no_data : 0.3 * (60 - p.x); });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{p.x > 5 && p.x < 15 ? 2.0 : 0.0}; });
    Numerics n = numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall);
    n.nodata = NodataPolicy::wall;
    Flow flow(bed, seeds, dry_friction(5), n, 1);
    flow.advance_to(15);
    for (std::size_t i = 0; i < flow.particles().size(); ++i) ASSERT_LT(flow.particles()[Field::x][i], 41);
}

}  // namespace
}  // namespace frana::test
