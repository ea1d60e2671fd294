// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/similarity.h"

#include "bench/exact/similarity_solution.h"

namespace frana::bench {
namespace {

constexpr double k_cap_slope_deg = 35, k_cap_friction_deg = 25, k_cap_height = 4, k_cap_radius = 80, k_cap_time = 5;
constexpr double k_cap_length = 280, k_cap_width = 220;
constexpr Point k_cap_middle{110, 110};  // of the cap at the start, in slope coordinates

CaseStatistics run_similarity(double cell_size, Scheme scheme, bool map) {
    const double cosine = std::cos(k_cap_slope_deg * k_degree), sine = std::sin(k_cap_slope_deg * k_degree);
    const double scale = map ? cosine : 1;  // map metres per metre along the slope
    const GridSpec grid =
        plain_grid(std::llround(k_cap_length * scale / cell_size), std::llround(k_cap_width / cell_size), cell_size);
    const auto in_slope = [&](Point p) { return Point{p.x / scale - k_cap_middle.x, p.y - k_cap_middle.y}; };
    Setup setup;
    setup.bed = sample_raster(grid, [&](Point p) { return map ? (grid.east() - p.x) * sine / cosine : 0; });
    setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) {
        const Point place = in_slope(p);
        const double r2 = (place.x * place.x + place.y * place.y) / (k_cap_radius * k_cap_radius);
        return Seed{k_cap_height * (1 - r2) / scale};
    });
    setup.material = dry_friction(k_cap_friction_deg);
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::open);
    if (!map) setup.tilt = TiltedGravity{k_gravity * sine, 0, k_gravity * cosine};
    TimedFlow run(setup);
    run.advance_to(k_cap_time);
    const SimilaritySolution exact(k_cap_slope_deg, k_cap_friction_deg, k_cap_height, k_cap_radius, k_cap_time);
    CaseStatistics statistics = compare_with_exact(run, [&](Point p) {
        const ExactState state = exact.at(in_slope(p));
        return ExactState{state.depth / scale, state.qx, state.qy / scale};  // (h / s) (u s), (h / s) v
    });
    CaseStatistic depth{"relative L2 of depth", statistics.l2_depth, {}};
    CaseStatistic momentum{"relative L2 of momentum", statistics.l2_momentum, {}};
    if (cell_size == 5) {
        depth.mark = 0.015;
        momentum.mark = 0.017;
    }
    statistics.own = {depth, momentum};
    return statistics;
}

}  // namespace

std::vector<AccuracyCase> similarities() {
    const std::vector<double> cells{10, 5, 2.5, 1.25};
    return {{"similarity", "Savage-Hutter cap, 35 deg slope, 25 deg friction, tilted gravity", cells, false,
             [](double dx, Scheme scheme) { return run_similarity(dx, scheme, false); }},
            {"similarity-map", "the same in map view", cells, false,
             [](double dx, Scheme scheme) { return run_similarity(dx, scheme, true); }}};
}

}  // namespace frana::bench
