// SPDX-License-Identifier: Apache-2.0
#include "analysis/runout.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace frana {
namespace {

Runout runout(const Raster& bed, const Raster& release, const Raster& trace) {
    return runouts(SeparateFlows(release, trace), bed, release, trace).front();
}

/// A bed that falls 10 m per cell of 10 m to the east, in map coordinates far from zero.
Raster slope() {
    GridSpec grid;
    grid.west = 527000;
    grid.north = 5094000;
    grid.cell_size = 10;
    grid.columns = 6;
    grid.rows = 3;
    Raster bed(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row)
        for (std::int64_t column = 0; column < grid.columns; ++column)
            bed.at(row, column) = 1000 - 10.0 * static_cast<double>(column);
    return bed;
}

TEST(Runout, FromTheTopOfTheReleaseToTheFarthestCell) {
    const Raster bed = slope();
    Raster release(bed.grid), trace(bed.grid);
    release.at(1, 0) = 5;
    release.at(1, 1) = 2;
    for (std::int64_t column = 0; column < 5; ++column) trace.at(1, column) = 1;
    const Runout result = runout(bed, release, trace);
    EXPECT_EQ(result.horizontal_m, 40);
    EXPECT_EQ(result.drop_m, 45);  // 40 m of bed and 5 m of mass above it
    // atan(45/40) = 48.3665 degrees, from tables, to the digits written
    EXPECT_NEAR(result.reach_angle_deg, 48.3665, 1e-4);
    EXPECT_EQ(result.top.x, 527005);
    EXPECT_EQ(result.tip.x, 527045);
    EXPECT_EQ(result.tip.y, 5093985);
}

TEST(Runout, TheSurfaceDecidesTheTopNotTheBed) {
    const Raster bed = slope();
    Raster release(bed.grid), trace(bed.grid);
    release.at(1, 0) = 1;   // surface 1001
    release.at(1, 1) = 20;  // surface 1010
    trace.at(1, 4) = 1;
    EXPECT_EQ(runout(bed, release, trace).horizontal_m, 30);
}

TEST(Runout, EmptyTraceHasNoLength) {
    const Raster bed = slope();
    Raster release(bed.grid);
    release.at(0, 0) = 1;
    const Runout result = runout(bed, release, Raster(bed.grid));
    EXPECT_EQ(result.horizontal_m, 0);
    EXPECT_EQ(result.drop_m, 0);
    EXPECT_EQ(result.reach_angle_deg, 0);
}

TEST(Runout, NothingReleasedIsRefused) {
    const Raster bed = slope();
    EXPECT_THROW(runout(bed, Raster(bed.grid), Raster(bed.grid)), Error);
}

TEST(Runout, DifferentGridsAreRefused) {
    const Raster bed = slope();
    GridSpec moved = bed.grid;
    moved.west += 10;
    EXPECT_THROW(runout(bed, Raster(moved, 1), Raster(bed.grid)), Error);
}

}  // namespace
}  // namespace frana
