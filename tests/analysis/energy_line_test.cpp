// SPDX-License-Identifier: Apache-2.0
#include "analysis/energy_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frana {
namespace {

constexpr double k_line_gravity = 9.81, k_line_cell = 5, k_line_fall = 40;
constexpr std::int64_t k_line_columns = 41, k_line_rows = 5;

/// A slope of 40 m in 100 m down to the middle column, level ground beyond; material of 1 m in the first column.
struct LineSlope {
    GridSpec grid{0, k_line_rows* k_line_cell, k_line_cell, k_line_columns, k_line_rows, ""};
    Raster bed{grid}, source{grid, k_no_data}, depth{grid, 1}, speed{grid};

    /// @param run_up slope of the ground beyond the middle
    explicit LineSlope(double run_up = 0) {
        for (std::int64_t row = 0; row < k_line_rows; ++row) {
            for (std::int64_t column = 0; column < k_line_columns; ++column) {
                const double x = static_cast<double>(column) * k_line_cell - 100;
                bed.at(row, column) = x < 0 ? -0.4 * x : run_up * x;
            }
            source.at(row, 0) = k_line_fall + 1;
        }
    }
    [[nodiscard]] EnergyLineExcess excess(double friction = 0, double push = 0) const {
        return energy_line_excess(
            {bed, source, depth, speed, [=](std::size_t) { return friction; }, k_line_gravity, push});
    }
};

double speed_of_fall(double fall) {
    return std::sqrt(2 * k_line_gravity * fall);
}

TEST(EnergyLine, FallAndFrictionAreExact) {
    for (const double friction : {0.0, 0.1, 0.3}) {
        LineSlope slope;
        const std::int64_t column = k_line_columns - 1;  // 200 m on a straight way
        const double line = k_line_fall + 1 - friction * 200;
        for (const double above : {-1.0, 4.0}) {
            if (line + above < 0) continue;
            slope.speed.at(2, column) = speed_of_fall(line + above);
            // The way along the grid is taken for up to 1 / 0.923 times the straight one.
            const double allowed = (1 - 0.923) * friction * 200;
            const EnergyLineExcess excess = slope.excess(friction);
            EXPECT_NEAR(excess.height, std::max(0.0, above - allowed), 1e-9) << friction << ", " << above;
        }
    }
}

TEST(EnergyLine, TellsVolumeAndPlace) {
    LineSlope slope;
    slope.depth.at(3, 30) = 2.5;
    slope.speed.at(3, 30) = speed_of_fall(1.1 * (k_line_fall + 1));
    slope.speed.at(1, 30) = speed_of_fall(1.02 * (k_line_fall + 1));  // within the error of cells
    const EnergyLineExcess excess = slope.excess();
    EXPECT_NEAR(excess.of_fall, 0.1, 1e-9);
    EXPECT_NEAR(excess.volume, 2.5 * k_line_cell * k_line_cell, 1e-9);
    EXPECT_EQ(excess.place.x, 30.5 * k_line_cell);
    EXPECT_EQ(excess.place.y, 1.5 * k_line_cell);
}

// What climbs higher than it fell is above the line however slow it is.
TEST(EnergyLine, AFilmThatStandsTooHighIsTold) {
    const LineSlope level(0.405), higher(0.45);  // up to 40.5 and 45 m
    EXPECT_EQ(level.excess().volume, 0);
    EXPECT_NEAR(higher.excess().of_fall, (45 - 41 - 0.5 * 0.45 * k_line_cell) / 41, 1e-9);
    EXPECT_GT(higher.excess().volume, 0);
}

// The front of a dam break: v = 2 sqrt(g h) in level water h deep, which its own fall of h does not explain.
TEST(EnergyLine, PressurePushesAFrontOnce) {
    LineSlope slope;
    slope.bed = Raster(slope.grid);
    slope.source = Raster(slope.grid, k_no_data);
    for (std::int64_t row = 0; row < k_line_rows; ++row) slope.source.at(row, 0) = 10;
    slope.speed.at(2, 20) = 2 * std::sqrt(k_line_gravity * 10);
    EXPECT_NEAR(slope.excess(0, 10).height, 0, 1e-9);
    slope.speed.at(2, 20) *= 1.1;
    EXPECT_NEAR(slope.excess(0, 10).of_fall, 1.1 * 1.1 - 1, 1e-9);
}

// Ground behind dry cells was flown to; the highest source says how much energy there can be.
TEST(EnergyLine, GroundBehindAFlightHasTheHighestLine) {
    LineSlope slope;
    for (std::int64_t row = 0; row < k_line_rows; ++row) slope.depth.at(row, 25) = k_no_data;
    slope.speed.at(2, 30) = speed_of_fall(0.9 * (k_line_fall + 1));
    EXPECT_EQ(slope.excess(0.3).height, 0) << "not less friction";
    slope.speed.at(2, 30) = speed_of_fall(1.2 * (k_line_fall + 1));
    EXPECT_NEAR(slope.excess(0.3).of_fall, 0.2, 1e-9);
}

}  // namespace
}  // namespace frana
