// SPDX-License-Identifier: Apache-2.0
// Thacker (1981): water that swings in a paraboloid, with a moving shoreline; and a smooth flow without one.
#include <gtest/gtest.h>

#include "basin.h"

namespace frana::structured::test {
namespace {

using bench::plain_grid;
using bench::sample_raster;

constexpr double k_gravity = 9.81, k_deep = 10, k_radius = 100, k_swing = 20, k_side = 300;

double thacker_error(std::int64_t cells, double periods) {
    const double w = std::sqrt(2 * k_gravity * k_deep) / k_radius, middle = 0.5 * k_side;
    const auto bed = [&](Point p) {
        const double x = p.x - middle, y = p.y - middle;
        return k_deep * ((x * x + y * y) / (k_radius * k_radius) - 1);
    };
    FluidLaws laws = still_laws();
    laws.dry = 1e-6;
    Basin basin(sample_raster(plain_grid(cells, cells, k_side / static_cast<double>(cells)), bed), laws, 2);
    const double time = periods * 2 * M_PI / w;
    const auto depth = [&](Point p, double t) {
        const double x = p.x - middle - k_swing * std::cos(w * t), y = p.y - middle - k_swing * std::sin(w * t);
        return std::max(0.0, k_deep * (1 - (x * x + y * y) / (k_radius * k_radius)));
    };
    basin.fill([&](Point p) { return Water{depth(p, 0), 0, k_swing * w}; });
    basin.advance(time);
    return basin.l1_depth([&](Point p) { return depth(p, time); });
}

// The surface is a plane and the velocity uniform; what errs is the shoreline, where the scheme is of first order on a
// strip as wide as a cell. Limits: measured errors rounded up to the next half.
TEST(FluidThacker, SwingsForOnePeriod) {
    const double coarse = thacker_error(40, 1), fine = thacker_error(80, 1);
    EXPECT_LT(fine, 0.01);
    EXPECT_GT(std::log2(coarse / fine), 1.2);
}

// Smooth flow: a low wave that runs through a closed basin over a wavy bed. Without an exact solution the order is
// taken from three grids, cell means against cell means (Roache 1998, section 5.3).
TEST(FluidThacker, SmoothFlowConvergesWithSecondOrder) {
    constexpr double k_length = 100;
    const auto depths = [&](std::int64_t cells) {
        const double dx = k_length / static_cast<double>(cells);
        const auto bed = [&](Point p) { return 0.2 * std::cos(2 * M_PI * p.x / k_length); };
        Basin basin(sample_raster(plain_grid(cells, 3, dx), bed), still_laws());
        basin.fill([&](Point p) { return Water{1 + 0.05 * std::cos(M_PI * p.x / k_length) - bed(p)}; });
        basin.advance(8);
        std::vector<double> row;
        for (std::int64_t i = 0; i < cells; ++i) row.push_back(basin.depth(i, 1));
        return row;
    };
    const auto difference = [](const std::vector<double>& coarse, const std::vector<double>& fine) {
        double sum = 0;
        for (std::size_t i = 0; i < coarse.size(); ++i)
            sum += std::abs(coarse[i] - 0.5 * (fine[2 * i] + fine[2 * i + 1]));
        return sum / static_cast<double>(coarse.size());
    };
    const auto a = depths(100), b = depths(200), c = depths(400);
    const double order = std::log2(difference(a, b) / difference(b, c));
    EXPECT_GT(order, 1.7);
    EXPECT_LT(order, 2.5);
}

}  // namespace
}  // namespace frana::structured::test
