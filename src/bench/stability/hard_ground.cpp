// SPDX-License-Identifier: Apache-2.0
// Hard releases: a single cell, a tall column, films, masses that meet.
// Hard ground: steps, cliffs, walls, holes and gaps.
#include <algorithm>
#include <cmath>

#include "bench/stability/usual_slide.h"

namespace frana::bench {
namespace {

// Water at rest up to a level on the bed of the scheme.
Change filled(double level) {
    return [=](Setup& setup) {
        walled(setup);
        as_water(setup);
        const SchemeBed bed(setup.bed, setup.numerics.scheme, Boundary::wall);
        seeded([&](Point p) { return Seed{level - bed(p)}; })(setup);
    };
}

bool in_one_cell(Point p) {
    return std::abs(p.x - 31) < 1 && std::abs(p.y - 41) < 1;
}

Seed one_cell(Point p, double depth) {
    return {in_one_cell(p) ? depth : 0};
}

// On level ground, between walls.
HardCase on_flat(const char* name, const char* what, double end, const std::function<Seed(Point)>& state,
                 const Change& change = as_water) {
    return slide_on(
        name, what, end, [](Point) { return 0.0; }, both(both(walled, seeded(state)), change));
}

// A basin 10 m deep at its far end, filled to 6 m, with a slide above it.
HardCase lake_with_slide() {
    return slide_on(
        "slide-into-lake", "a slide that enters a lake", 30, [](Point p) { return std::abs(p.x - 100) * 0.5; },
        [](Setup& setup) {
            walled(setup);
            setup.material = dry_friction(3);
            const SchemeBed bed(setup.bed, Scheme::standard, Boundary::wall);
            seeded([&](Point p) {
                const double lake = 12 - bed(p), slide = 4 - 0.3 * std::hypot(p.x - 40, p.y - 40);
                return Seed{lake > 0 ? lake : slide};
            })(setup);
        });
}

// Ritter's dam break until its waves are at the ends. Its front is known to some cells, in which 1 - 1/9 of the depth
// at the dam is missing: of 320 m2, 2 % and as much for the diffusion at the other end.
Figure ritter_error(const Setup&, TimedFlow& run) {
    const DamBreak exact(4, 0);
    const Raster depth = run.fields().depth;
    double error = 0, all = 0;
    for (std::int64_t column = 0; column < depth.grid.columns; ++column) {
        const double x = (static_cast<double>(column) + 0.5) * depth.grid.cell_size - 80;
        const double h = exact.at(x, run.model().time()).depth;
        error += std::abs(depth.at(depth.grid.rows / 2, column) - h);
        all += h;
    }
    return {"depth against Ritter's, relative L1 error", error / all, 0.04};
}

}  // namespace

std::vector<HardCase> hard_release_cases() {
    return {
        // What is one cell wide is another thing on other cells, and nodes do not have its energy.
        of(slide("single-cell", "a release of one cell, 2 m deep", 20, seeded([](Point p) { return one_cell(p, 2); })),
           k_one_phase, k_mirror),
        of(slide("single-particle", "a release of one particle", 20, seeded([](Point p) {
                     return Seed{std::abs(p.x - 30.5) < 0.4 && std::abs(p.y - 40.5) < 0.4 ? 1.0 : 0};
                 })),
           k_one_phase, k_mirror),
        of(on_flat(
               "column-100", "a column of 100 m, one cell wide, on level ground", 20,
               [](Point p) { return one_cell(p, 100); }, [](Setup&) {}),
           k_one_phase, k_mirror),
        of(slide("column-100-slope", "the same on a slope, without friction", 10,
                 both(seeded([](Point p) { return one_cell(p, 100); }), as_water)),
           k_one_phase, k_mirror),
        slide("film-1mm-slope", "a film of a millimetre on the slope", 20,
              seeded([](Point p) { return Seed{usual_cap(p) > 0 ? 1e-3 : 0}; })),
        on_flat("film-1mm-flat", "a dam break from a millimetre of water", 20,
                [](Point p) { return Seed{p.x < 80 ? 1e-3 : 0}; }),
        of(on_flat("wave-over-film", "a dam break, 10 m over a film of a millimetre", 8,
                   [](Point p) { return Seed{p.x < 80 ? 10 : 1e-3}; }),
           k_one_phase, k_usual | k_ties),
        of(on_flat("dry-dam-break", "a dam break, 4 m over dry ground", 5,
                   [](Point p) { return Seed{p.x < 80 ? 4.0 : 0}; }),
           k_all, k_usual | k_ties, ritter_error),
        slide("film-1um", "a thin film of a thousandth of a millimetre on the slope", 20,
              seeded([](Point p) { return Seed{usual_cap(p) > 0 ? 1e-6 : 0}; })),
        of(on_flat(
               "collision", "two masses that meet at 20 m/s each", 10,
               [](Point p) {
                   const bool in = std::abs(p.y - 40) < 15 && std::abs(std::abs(p.x - 80) - 25) < 15;
                   return Seed{in ? 4.0 : 0, p.x < 80 ? 20.0 : -20.0, 0};
               },
               [](Setup&) {}),
           k_all, k_usual | k_rest),
        slide("mass-onto-mass", "a mass that slides onto another at rest", 15, seeded([](Point p) {
                  const double resting = 3 - 0.25 * std::hypot(p.x - 100, p.y - 40);
                  return Seed{std::max(usual_cap(p), resting)};
              })),
        of(slide_on(
               "two-flows", "two flows that meet at 45 degrees in a valley", 15,
               [](Point p) { return usual_slope(p) + 0.5 * std::abs(p.y - 40); },
               seeded([](Point p) { return Seed{2 - 0.2 * std::hypot(p.x - 30, std::abs(p.y - 40) - 25)}; })),
           k_all),
        of(lake_with_slide(), k_one_phase, k_usual | k_rest),
        of(on_flat("closed-box", "a dam break that swings in a closed box for two minutes", 120,
                   [](Point p) { return Seed{p.x < 40 ? 5.0 : 1.0}; }),
           k_all, k_usual | k_ties),
        slide("slab-40m", "a slab of 40 m with vertical sides on the slope", 15,
              seeded([](Point p) { return Seed{usual_cap(p) > 0 ? 40.0 : 0}; })),
        slide("fast-release", "a release that already moves at 80 m/s, across the slope", 10, seeded([](Point p) {
                  return Seed{usual_cap(p), 0, 80};
              })),
    };
}

namespace {

// Returns a fixed number in [0, 1) for a cell; the same on every machine.
double noise(Point p, double cell) {
    auto h =
        static_cast<std::uint64_t>(p.x / cell) * 73856093ULL ^ static_cast<std::uint64_t>(p.y / cell) * 19349663ULL;
    h = (h ^ (h >> 15)) * 0x9e3779b97f4a7c15ULL;
    return static_cast<double>(h >> 40) * 0x1p-24;
}

// Most of it has left at the end.
HardCase plane(const char* name, const char* what, double slope_deg) {
    return of(slide_on(
                  name, what, 10, [=](Point p) { return (160 - p.x) * std::tan(slope_deg * k_degree); },
                  [](Setup& setup) { setup.material = dry_friction(20); }),
              k_one_phase, k_energy | k_mirror);
}

// The usual slope with more on it.
HardCase on(const char* name, const char* what, double end, const Surface& more, const Change& change = {}) {
    return slide_on(
        name, what, end, [=](Point p) { return usual_slope(p) + more(p); }, change);
}

// Returns how far the farthest particle is inside a gap, in cells: the distance to the nearest cell with ground. The
// wall is on the gap's outermost nodes, half a cell inside its edge, and velocities between a wall's node and a free
// one are not zero, so up to one cell is expected.
Figure into_gaps(const Setup& setup, TimedFlow& run) {
    const ParticleSet* const solids = run.model().particle_set();
    const ParticleSet& particles = solids != nullptr ? *solids : run.particles();
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

HardCase with_gaps(const char* name, const char* what, const std::function<bool(Point)>& gap, unsigned variants) {
    return of(on(
                  name, what, 20, [=](Point p) { return gap(p) ? k_no_data : 0; },
                  [](Setup& setup) {
                      walled(setup);
                      setup.numerics.nodata = NodataPolicy::wall;
                  }),
              variants, k_usual, into_gaps);
}

Figure remaining_volume(const Setup& setup, TimedFlow& run) {
    double start = 0;
    for (std::size_t p = 0; p < setup.seeds.size(); ++p) start += setup.seeds[Field::volume][p];
    return {"fraction that has not left", run.model().volume() / start, 0.01};
}

// Speed at the lip of a cliff over the greater of its neighbours', at any time: water turns down only beyond it.
Figure lip_speed(const Setup&, TimedFlow& run) {
    const Model& model = run.model();
    const auto fastest = [&](std::int64_t column) { return model.maxima().speed[model.nodes().index(column, 8)]; };
    return {"speed at the lip over its neighbours'", fastest(11) / std::max(fastest(10), fastest(12)), 1.2};
}

// A lake that must not move.
Figure greatest_speed(const Setup&, TimedFlow& run) {
    const ParticleSet& particles = run.particles();
    double greatest = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Point v = run.velocity(p);
        greatest = std::max(greatest, std::hypot(v.x, v.y));
    }
    return {"greatest speed of a still lake [m/s]", greatest, 1e-12};
}

// What it holds must not depend on the cells: 5 m and half of that.
HardCase trap(HardCase one, const std::function<bool(Point)>& where) {
    one.variants = k_all;
    one.figures = k_energy | k_cells;
    one.trap = where;
    return one;
}

/// What flows into, stays in, or lies on rough ground.
std::vector<HardCase> hollows_and_lakes() {
    const auto in_pit = [](Point p) { return std::abs(p.x - 105) < 15 && std::abs(p.y - 40) < 15; };
    const auto in_basin = [](Point p) { return std::abs(p.x - 100) < 20; };
    return {
        trap(slide_on(
                 "wide-pit", "a pit of 30 m x 30 m, 40 m deep, below the slope", 15,
                 [=](Point p) { return usual_slope(p) - (in_pit(p) ? 40 : 0); }, {}, 5),
             in_pit),
        trap(slide_on(
                 "basin", "a flow at 30 m/s over a basin 40 m long and 10 m deep", 15,
                 [=](Point p) { return in_basin(p) ? 0.0 : 10.0; }, both(as_water, seeded([](Point p) {
                                                                             return Seed{p.x < 60 ? 1.0 : 0, 30, 0};
                                                                         })),
                 5),
             in_basin),
        of(on("rough-cells", "every cell up to 3 m higher or lower than its neighbour", 15,
              [](Point p) { return 3 * noise(p, 2); }),
           k_one_phase, k_energy | k_mirror),
        of(slide_on(
               "rough-lake", "a lake in a rough valley, with islands", 30,
               [](Point p) { return 0.5 * std::abs(p.y - 40) + 0.05 * p.x + 6 * noise(p, 6); }, filled(14)),
           k_volumes | k_structured, k_energy | k_rest, greatest_speed),
        of(slide_on(
               "wavy-lake", "a lake in a wavy valley, with islands", 30,
               [](Point p) {
                   constexpr double k = 9 * k_degree;  // hills 40 m apart
                   return 0.5 * std::abs(p.y - 40) + 0.05 * p.x + 3 * std::sin(k * p.x) * std::cos(k * p.y);
               },
               filled(14)),
           k_all, k_energy | k_rest, greatest_speed),
        of(slide_on(
               "integer-dtm", "elevations in whole metres, cells of 12.5 m", 60, [](Point) { return 0.0; },
               [](Setup& setup) {
                   const double cell = 12.5 * setup.bed.grid.cell_size / 2;
                   const GridSpec grid = plain_grid(std::llround(750 / cell), std::llround(500 / cell), cell);
                   setup.bed =
                       sample_raster(grid, [](Point p) { return std::round(std::max(0.0, 0.21 * (500 - p.x))); });
                   setup.seeds = fill_lattice(grid, 2, 0, [](Point p) {
                       return Seed{12 * (1 - (std::pow(p.x - 150, 2) + std::pow(p.y - 250, 2)) / (80 * 80))};
                   });
                   setup.material = dry_friction(6);
               }),
           k_one_phase, k_energy | k_mirror),  // steps of a metre are the steeper the smaller the cells
    };
}

}  // namespace

std::vector<HardCase> hard_terrain_cases() {
    std::vector<HardCase> all{
        on("step-down", "a step of 4 m down in the bed", 15, [](Point p) { return p.x < 60 ? 4 : 0; }),
        on("step-up", "a step of 4 m up across the run-out", 15, [](Point p) { return p.x > 100 ? 4 : 0; }),
        plane("slope-60", "a plane of 60 degrees", 60),
        plane("slope-75", "a plane of 75 degrees", 75),
        on("cliff-50", "a vertical cliff of 50 m", 15, [](Point p) { return p.x < 70 ? 50 : 0; }),
        of(slide_on(
               "lip", "water over a cliff of 50 m, cells of 5 m", 10, [](Point p) { return p.x < 60 ? 50.0 : 0.0; },
               both(as_water, seeded([](Point p) { return Seed{p.x < 40 ? 5.0 : 0}; })), 5),
           k_volumes | k_structured, k_energy | k_mirror, lip_speed),
        of(on("canyon-walls", "a slot 6 m wide between walls of 30 m", 15,
              [](Point p) { return p.x > 60 && std::abs(p.y - 40) > 3 ? 30 : 0; }),
           k_all),
        of(on("slot", "a gap 4 m wide in a wall of 20 m across the run-out", 15,
              [](Point p) { return std::abs(p.x - 92) < 2 && std::abs(p.y - 40) > 2 ? 20 : 0; }),
           k_all),
        // Cells of 1 m: the flow is few metres wide.
        slide_on(
            "gully-45", "a V-shaped gully with sides of 45 degrees and bends", 15,
            [](Point p) { return usual_slope(p) + std::abs(p.y - 40 - 8 * std::sin(0.1 * p.x)); }, {}, 1),
        on("needle", "a needle of 30 m in the path, one cell wide", 15,
           [](Point p) { return std::abs(p.x - 61) < 1 && std::abs(p.y - 41) < 1 ? 30 : 0; }),
        on("pit", "a hole of 30 m in the path, one cell wide", 15,
           [](Point p) { return std::abs(p.x - 61) < 1 && std::abs(p.y - 41) < 1 ? -30 : 0; }),
        with_gaps(
            "no-data-islands", "three gaps without ground in the path, taken as walls",
            [](Point p) {
                return std::hypot(p.x - 60, p.y - 30) < 5 || std::hypot(p.x - 75, p.y - 50) < 7 ||
                       std::hypot(p.x - 95, p.y - 38) < 4;
            },
            k_all),
        with_gaps(
            "ragged-edges", "ground with a ragged outline inside the grid, taken as walls",
            [](Point p) {
                return std::abs(p.y - 40) > 28 + 8 * std::sin(0.7 * p.x) || p.x > 130 + 6 * std::sin(1.3 * p.y) ||
                       p.x < 8 + 4 * std::sin(0.9 * p.y);
            },
            k_one_phase),
        of(slide_on(
               "leaves-all-sides", "a smooth cone: all material leaves through all sides", 60,
               [](Point p) { return 60 - 0.6 * std::hypot(p.x - 80, p.y - 40); },
               both(as_water, seeded([](Point p) { return Seed{4 - 0.4 * std::hypot(p.x - 80, p.y - 40)}; }))),
           k_one_phase, k_energy | k_mirror, remaining_volume),
    };
    for (HardCase& one : hollows_and_lakes()) all.push_back(std::move(one));
    return all;
}

}  // namespace frana::bench
