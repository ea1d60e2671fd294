// SPDX-License-Identifier: Apache-2.0
// Hard ground: steps, cliffs, walls, holes and gaps.
#include <algorithm>
#include <cmath>

#include "bench/stability/stability.h"

namespace frana::bench {
namespace {

// Returns a fixed number in [0, 1) for a cell; the same on every machine.
double noise(Point p, double cell) {
    auto h =
        static_cast<std::uint64_t>(p.x / cell) * 73856093ULL ^ static_cast<std::uint64_t>(p.y / cell) * 19349663ULL;
    h = (h ^ (h >> 15)) * 0x9e3779b97f4a7c15ULL;
    return static_cast<double>(h >> 40) * 0x1p-24;
}

Setup plane(double slope_deg, double friction_deg) {
    Setup setup = usual_slide_on(2, [=](Point p) { return (160 - p.x) * std::tan(slope_deg * k_degree); });
    setup.material = dry_friction(friction_deg);
    return setup;
}

Setup on(const std::function<double(Point)>& bed) {
    return usual_slide_on(2, bed);
}

Setup with_gaps(const std::function<bool(Point)>& gap) {
    Setup setup = on([&](Point p) { return gap(p) ? k_no_data : usual_slope(p); });
    setup.numerics.nodata = NodataPolicy::wall;
    setup.numerics.boundary = Boundary::wall;
    return setup;
}

// Returns how far the farthest particle is inside a gap, in cells: the distance to the nearest cell with ground. The
// wall is on the gap's outermost nodes, half a cell inside its edge, and velocities between a wall's node and a free
// one are not zero, so up to one cell is expected.
StabilityStatistic into_gaps(const Setup& setup, Flow& flow) {
    const ParticleSet& particles = flow.particles();
    const GridSpec& grid = setup.bed.grid;
    double farthest = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles[Field::x][p] / grid.cell_size, y = particles[Field::y][p] / grid.cell_size;
        const auto i = static_cast<std::int64_t>(x), j = static_cast<std::int64_t>(y);
        double nearest = 3;
        for (std::int64_t n = std::max<std::int64_t>(0, j - 3); n <= std::min(grid.rows - 1, j + 3); ++n) {
            for (std::int64_t m = std::max<std::int64_t>(0, i - 3); m <= std::min(grid.columns - 1, i + 3); ++m) {
                if (std::isnan(setup.bed.at(grid.rows - 1 - n, m))) continue;
                const auto west = static_cast<double>(m), south = static_cast<double>(n);
                nearest = std::min(nearest, std::hypot(std::max({0.0, west - x, x - west - 1}),
                                                       std::max({0.0, south - y, y - south - 1})));
            }
        }
        farthest = std::max(farthest, nearest);
    }
    return {"farthest inside a gap [cells]", farthest, 1};
}

StabilityStatistic remaining_volume(const Setup& setup, Flow& flow) {
    double start = 0;
    for (std::size_t p = 0; p < setup.seeds.size(); ++p) start += setup.seeds[Field::volume][p];
    return {"fraction that has not left", flow.volume() / start, 0.01};
}

}  // namespace

std::vector<HardCase> hard_terrain_cases() {
    return {
        {"step-down", "a step of 4 m down in the bed", 15,
         [] { return on([](Point p) { return usual_slope(p) + (p.x < 60 ? 4 : 0); }); }},
        {"step-up", "a step of 4 m up across the run-out", 15,
         [] { return on([](Point p) { return usual_slope(p) + (p.x > 100 ? 4 : 0); }); }},
        {"slope-60", "a plane of 60 degrees", 10, [] { return plane(60, 20); }},
        {"slope-75", "a plane of 75 degrees", 10, [] { return plane(75, 20); }},
        {"cliff-50", "a vertical cliff of 50 m", 15,
         [] { return on([](Point p) { return usual_slope(p) + (p.x < 70 ? 50 : 0); }); }},
        {"canyon-walls", "a slot 6 m wide between walls of 30 m", 15,
         [] { return on([](Point p) { return usual_slope(p) + (p.x > 60 && std::abs(p.y - 40) > 3 ? 30 : 0); }); }},
        {"gully-45", "a V-shaped gully with sides of 45 degrees and bends", 15,
         [] { return on([](Point p) { return usual_slope(p) + std::abs(p.y - 40 - 8 * std::sin(0.1 * p.x)); }); }},
        {"needle", "a needle of 30 m in the path, one cell wide", 15,
         [] {
             return on(
                 [](Point p) { return usual_slope(p) + (std::abs(p.x - 61) < 1 && std::abs(p.y - 41) < 1 ? 30 : 0); });
         }},
        {"pit", "a hole of 30 m in the path, one cell wide", 15,
         [] {
             return on(
                 [](Point p) { return usual_slope(p) - (std::abs(p.x - 61) < 1 && std::abs(p.y - 41) < 1 ? 30 : 0); });
         }},
        {"rough-cells", "every cell up to 3 m higher or lower than its neighbour", 15,
         [] { return on([](Point p) { return usual_slope(p) + 3 * noise(p, 2); }); }},
        {"integer-dtm", "elevations in whole metres, cells of 12.5 m", 60,
         [] {
             Setup setup = usual_slide();
             const GridSpec grid = plain_grid(60, 40, 12.5);
             setup.bed = sample_raster(grid, [](Point p) { return std::round(std::max(0.0, 0.21 * (500 - p.x))); });
             setup.seeds = fill_lattice(grid, 2, 0, [](Point p) {
                 return Seed{12 * (1 - (std::pow(p.x - 150, 2) + std::pow(p.y - 250, 2)) / (80 * 80))};
             });
             setup.material = dry_friction(6);
             return setup;
         }},
        {"no-data-islands", "three gaps without ground in the path, taken as walls", 20,
         [] {
             return with_gaps([](Point p) {
                 return std::hypot(p.x - 60, p.y - 30) < 5 || std::hypot(p.x - 75, p.y - 50) < 7 ||
                        std::hypot(p.x - 95, p.y - 38) < 4;
             });
         },
         into_gaps},
        {"ragged-edges", "ground with a ragged outline inside the grid, taken as walls", 20,
         [] {
             return with_gaps([](Point p) {
                 return std::abs(p.y - 40) > 28 + 8 * std::sin(0.7 * p.x) || p.x > 130 + 6 * std::sin(1.3 * p.y) ||
                        p.x < 8 + 4 * std::sin(0.9 * p.y);
             });
         },
         into_gaps},
        {"leaves-all-sides", "a smooth cone: all material leaves through all sides", 60,
         [] {
             Setup setup = on([](Point p) { return 60 - 0.6 * std::hypot(p.x - 80, p.y - 40); });
             setup.seeds = fill_lattice(setup.bed.grid, 2, 0,
                                        [](Point p) { return Seed{4 - 0.4 * std::hypot(p.x - 80, p.y - 40)}; });
             setup.material = water();
             return setup;
         },
         remaining_volume},
    };
}

}  // namespace frana::bench
