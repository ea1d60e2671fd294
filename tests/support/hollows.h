// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>

#include "bench/set_up/setup.h"

namespace frana::test {

/// Ground with vertical walls and what flows there, with room in the hollow for all of it.
struct Hollow {
    GridSpec grid;
    Raster bed;
    std::function<bench::Seed(Point)> flow;
    std::function<bool(Point)> inside;
    double time;  ///< after which nothing more arrives [s]

    [[nodiscard]] ParticleSet seeds(int per_side) const { return bench::fill_lattice(grid, per_side, 0, flow); }
};

/// A film of 30 m/s, 1 m deep and 140 m long, before a basin of 40 m x 10 m across a channel; beyond both the ground
/// falls away for good.
inline Hollow basin(double cell) {
    const GridSpec grid = bench::plain_grid(std::llround(600 / cell), 4, cell);
    return {grid,
            bench::sample_raster(grid,
                                 [](Point p) {
                                     if (p.x > 300 && p.x < 340) return 60.0;
                                     return 70 - 0.3 * std::max({0.0, p.x - 380, 120 - p.x});
                                 }),
            [](Point p) {
                return bench::Seed{p.x > 140 && p.x < 280 ? 1.0 : 0.0, 30};
            },
            [](Point p) { return p.x > 300 && p.x < 340; }, 30};
}

/// 12 000 m3 above a pit of 30 m x 30 m x 40 m at the foot of a slope of 30 degrees.
inline Hollow pit(double cell) {
    const GridSpec grid = bench::plain_grid(std::llround(350 / cell), std::llround(120 / cell), cell);
    const auto inside = [](Point p) { return p.x > 220 && p.x < 250 && p.y > 45 && p.y < 75; };
    return {grid,
            bench::sample_raster(
                grid, [=](Point p) { return inside(p) ? 0 : 40 + std::tan(M_PI / 6) * std::max(0.0, 200 - p.x); }),
            [](Point p) { return bench::Seed{p.x > 20 && p.x < 120 && p.y > 30 && p.y < 90 ? 2.0 : 0.0}; }, inside, 40};
}

/// A film of 18 m/s, 2 m deep and 90 m long, before a dam of 7 m across a channel; inside is what passes it.
inline Hollow dam(double cell) {
    const GridSpec grid = bench::plain_grid(std::llround(700 / cell), 4, cell);
    return {grid,
            bench::sample_raster(grid,
                                 [](Point p) {
                                     if (p.x > 350 && p.x < 360) return 107.0;
                                     return 100 - 0.3 * std::max({0.0, p.x - 430, 200 - p.x});
                                 }),
            [](Point p) {
                return bench::Seed{p.x > 240 && p.x < 330 ? 2.0 : 0.0, 18};
            },
            [](Point p) { return p.x > 360; }, 30};
}

/// The same, 90 m long and 160 m wide, at 18 m/s before a dam at an angle to the grid, with room at both ends.
inline Hollow oblique_dam(double cell, double degrees, double height) {
    const GridSpec grid = bench::plain_grid(std::llround(500 / cell), std::llround(500 / cell), cell);
    const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
    const auto turned = [=](Point p) {
        const double x = p.x - 250, y = p.y - 250;
        return Point{c * x + s * y, c * y - s * x};
    };
    return {grid,
            bench::sample_raster(grid,
                                 [=](Point in_map) {
                                     const Point p = turned(in_map);
                                     if (p.x > 40 && p.x < 50) return 100 + height;
                                     return 100 - 0.3 * std::max({0.0, p.x - 100, -120 - p.x});
                                 }),
            [=](Point in_map) {
                const Point p = turned(in_map);
                const bool flows = p.x > -70 && p.x < 20 && std::abs(p.y) < 80;
                return bench::Seed{flows ? 2.0 : 0.0, 18 * c, 18 * s};
            },
            [=](Point p) { return turned(p).x > 50; }, 12};
}

/// Fraction of the volume of a set of particles that is in the hollow.
inline double fraction_inside(const Hollow& hollow, const ParticleSet& particles) {
    double trapped = 0, all = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double volume = particles[Field::volume][p];
        all += volume;
        if (hollow.inside({particles[Field::x][p], particles[Field::y][p]})) trapped += volume;
    }
    return trapped / all;
}

}  // namespace frana::test
