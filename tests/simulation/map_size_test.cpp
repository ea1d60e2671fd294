// SPDX-License-Identifier: Apache-2.0
// The cost of a flow depends on the flow, not on the size of its map.
#include <gtest/gtest.h>

#include <fstream>

#include "support/cases.h"

namespace frana::test {
namespace {

// A pile that slides from the south-western corner of a map `columns` wide and high. The map falls no further after
// the first 95 columns, which the flow does not cross, so that every map has the same lowest cell.
std::unique_ptr<Flow> pile_on_map(std::int64_t columns) {
    const GridSpec grid = bench::plain_grid(columns, columns, 2);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return 0.2 * std::max(0.0, 190 - p.x); });
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{4 - 0.2 * std::hypot(p.x - 40, p.y - 40)}; });
    return std::make_unique<Flow>(bed, seeds, dry_friction(8),
                                  numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), 1);
}

// Resident memory of this process [bytes].
std::int64_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::int64_t pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * 4096;
}

TEST(MapSize, ChangesNeitherTheFlowNorTheMemoryOfAStep) {
    const auto small = pile_on_map(100), large = pile_on_map(600);
    const std::int64_t before = resident_bytes();
    for (int i = 0; i < 30; ++i) {
        small->advance(1e9);
        large->advance(1e9);
    }
    const std::int64_t grown = resident_bytes() - before;
    EXPECT_EQ(small->time(), large->time());
    EXPECT_EQ(small->reached_tiles(), large->reached_tiles());
    ASSERT_EQ(small->particles().size(), large->particles().size());
    for (std::size_t p = 0; p < small->particles().size(); ++p)
        ASSERT_EQ(small->particles()[Field::x][p], large->particles()[Field::x][p]);
    // The large map's node records would need 36 MB. A page contains 42 nodes of a row: rows of a tile may share none.
    const auto whole = static_cast<std::int64_t>(600 * 600 * large->bytes_per_node());
    EXPECT_LT(grown, whole / 4) << "nodes far from the flow take memory";
}

}  // namespace
}  // namespace frana::test
