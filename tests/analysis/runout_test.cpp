// SPDX-License-Identifier: Apache-2.0
#include "analysis/runout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// 400 m of 30 degrees, then 4 degrees: beta is the slope's angle from the path's start at its foot, whatever lies
// beyond; benches of less than 30 m do not count.
TEST(Beta, IsTheAngleToTheFirstThirtyMetresUnderTenDegrees) {
    GridSpec grid;
    grid.cell_size = 5;
    grid.columns = 160;
    grid.rows = 3;
    grid.north = 15;
    const auto bed_of = [&](double bench) {
        Raster bed(grid);
        for (std::int64_t c = 0; c < grid.columns; ++c) {
            const double x = (static_cast<double>(c) + 0.5) * grid.cell_size,
                         on_bench = std::clamp(x - 200, 0.0, bench), steep = std::min(x, 400.0) - on_bench,
                         gentle = std::max(x - 400, 0.0);
            for (std::int64_t r = 0; r < 3; ++r)
                bed.at(r, c) = 1000 - steep * std::tan(M_PI / 6) - gentle * std::tan(4 * M_PI / 180);
        }
        return bed;
    };
    const Polyline path{{2.5, 7.5}, {600, 7.5}};
    const Raster plain = bed_of(0);
    const double top = plain.at(1, 0);
    EXPECT_NEAR(beta_of(path, plain, top), 30, 0.3);
    EXPECT_GT(beta_of(path, plain, top + 20), 31) << "from the surface of what fails";
    EXPECT_EQ(beta_of({{2.5, 7.5}, {380, 7.5}}, plain, top), 0) << "a path that ends on the slope";
    EXPECT_LT(beta_of(path, bed_of(15), top), 30) << "a short bench makes the way longer";
    EXPECT_GT(beta_of(path, bed_of(15), top), 28);
    const double at_bench = beta_of(path, bed_of(60), top);
    EXPECT_NEAR(at_bench, 30, 0.5) << "a wide one has the 10 degree point";
}

// A slope of 25 degrees that falls to the south: along it there is no 10 degree point, though the path is level.
TEST(Beta, IsNotWhereThePathCrossesASteepSlopeSideways) {
    GridSpec grid;
    grid.cell_size = 5;
    grid.columns = grid.rows = 80;
    grid.north = 400;
    Raster bed(grid);
    for (std::int64_t r = 0; r < grid.rows; ++r)
        for (std::int64_t c = 0; c < grid.columns; ++c)
            bed.at(r, c) = 1000 - 5 * static_cast<double>(r) * std::tan(25 * M_PI / 180);
    const Polyline path{{200, 380}, {200, 250}, {350, 250}, {350, 20}};
    EXPECT_EQ(beta_of(path, bed, 1000), 0);
    for (std::int64_t r = 60; r < grid.rows; ++r)  // below, flat ground
        for (std::int64_t c = 0; c < grid.columns; ++c) bed.at(r, c) = bed.at(60, c);
    const double way = 130 + 150 + 150, fall = 300 * std::tan(25 * M_PI / 180);  // to the foot, 100 m from the south
    EXPECT_NEAR(beta_of(path, bed, 1000), std::atan2(fall, way) * 180 / M_PI, 1);
}

}  // namespace
}  // namespace frana
