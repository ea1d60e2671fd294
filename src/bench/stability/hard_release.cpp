// SPDX-License-Identifier: Apache-2.0
// Hard releases: a single cell, a tall column, films, masses that meet.
#include <cmath>

#include "bench/stability/stability.h"

namespace frana::bench {
namespace {

Setup seeded(Setup setup, const std::function<Seed(Point)>& state) {
    setup.seeds = fill_lattice(setup.bed.grid, 2, 0, state);
    return setup;
}

bool in_one_cell(Point p) {
    return std::abs(p.x - 31) < 1 && std::abs(p.y - 41) < 1;
}

Setup flat() {
    Setup setup = usual_slide_on(2, [](Point) { return 0.0; });
    setup.numerics.boundary = Boundary::wall;
    return setup;
}

Setup flat_water() {
    Setup setup = flat();
    setup.material = water();
    return setup;
}

// A basin 10 m deep at its far end, filled to 6 m, with a slide above it.
Setup lake_with_slide() {
    Setup setup = usual_slide_on(2, [](Point p) { return std::abs(p.x - 100) * 0.5; });
    setup.numerics.boundary = Boundary::wall;
    setup.material = dry_friction(3);
    const SchemeBed bed(setup.bed, Scheme::standard, Boundary::wall);
    return seeded(setup, [&](Point p) {
        const double lake = 12 - bed(p), slide = 4 - 0.3 * std::hypot(p.x - 40, p.y - 40);
        return Seed{lake > 0 ? lake : slide};
    });
}

}  // namespace

std::vector<HardCase> hard_release_cases() {
    return {
        {"single-cell", "a release of one cell, 2 m deep", 20,
         [] { return seeded(usual_slide(), [](Point p) { return Seed{in_one_cell(p) ? 2.0 : 0}; }); }},
        {"single-particle", "a release of one particle", 20,
         [] {
             return seeded(usual_slide(), [](Point p) {
                 return Seed{std::abs(p.x - 30.5) < 0.4 && std::abs(p.y - 40.5) < 0.4 ? 1.0 : 0};
             });
         }},
        {"column-100", "a column of 100 m, one cell wide, on level ground", 20,
         [] { return seeded(flat(), [](Point p) { return Seed{in_one_cell(p) ? 100.0 : 0}; }); }},
        {"column-100-slope", "the same on a slope, without friction", 10,
         [] {
             Setup setup = seeded(usual_slide(), [](Point p) { return Seed{in_one_cell(p) ? 100.0 : 0}; });
             setup.material = water();
             return setup;
         }},
        {"film-1mm-slope", "a film of a millimetre on the slope", 20,
         [] { return seeded(usual_slide(), [](Point p) { return Seed{usual_cap(p) > 0 ? 1e-3 : 0}; }); }},
        {"film-1mm-flat", "a dam break from a millimetre of water", 20,
         [] { return seeded(flat_water(), [](Point p) { return Seed{p.x < 80 ? 1e-3 : 0}; }); }},
        {"wave-over-film", "a dam break, 10 m over a film of a millimetre", 8,
         [] { return seeded(flat_water(), [](Point p) { return Seed{p.x < 80 ? 10 : 1e-3}; }); }},
        {"film-1um", "a thin film of a thousandth of a millimetre on the slope", 20,
         [] { return seeded(usual_slide(), [](Point p) { return Seed{usual_cap(p) > 0 ? 1e-6 : 0}; }); }},
        {"collision", "two masses that meet at 20 m/s each", 10,
         [] {
             return seeded(flat(), [](Point p) {
                 const bool in = std::abs(p.y - 40) < 15 && std::abs(std::abs(p.x - 80) - 25) < 15;
                 return Seed{in ? 4.0 : 0, p.x < 80 ? 20.0 : -20.0, 0};
             });
         }},
        {"mass-onto-mass", "a mass that slides onto another at rest", 15,
         [] {
             return seeded(usual_slide(), [](Point p) {
                 const double resting = 3 - 0.25 * std::hypot(p.x - 100, p.y - 40);
                 return Seed{std::max(usual_cap(p), resting)};
             });
         }},
        {"slide-into-lake", "a slide that enters a lake", 30, lake_with_slide},
        {"closed-box", "a dam break that swings in a closed box for two minutes", 120,
         [] { return seeded(flat_water(), [](Point p) { return Seed{p.x < 40 ? 5.0 : 1.0}; }); }},
        {"slab-40m", "a slab of 40 m with vertical sides on the slope", 15,
         [] { return seeded(usual_slide(), [](Point p) { return Seed{usual_cap(p) > 0 ? 40.0 : 0}; }); }},
        {"fast-release", "a release that already moves at 80 m/s, across the slope", 10,
         [] { return seeded(usual_slide(), [](Point p) {
                  return Seed{usual_cap(p), 0, 80};
              }); }},
    };
}

}  // namespace frana::bench
