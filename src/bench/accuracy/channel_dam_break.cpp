// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/channel_dam_break.h"

#include <algorithm>

#include "bench/exact/dam_break.h"

namespace frana::bench {
namespace {

constexpr double k_channel_length = 1000, k_channel_width = 50, k_channel_dam = 500, k_channel_left = 10,
                 k_channel_time = 20;

constexpr double k_shown_depth = 0.01;  // depth from which a place counts as reached, here and in frana's maps [m]

// Returns how far beyond the dam the row of nodes is deeper than that [m].
double reach(const Raster& depth) {
    double front = 0;
    for (std::int64_t column = 0; column < depth.grid.columns; ++column)
        if (depth.at(depth.grid.rows / 2, column) > k_shown_depth)
            front = depth.grid.cell_size * (static_cast<double>(column) + 0.5) - k_channel_dam;
    return front;
}

// The same in Ritter's solution: h = (2 c - x / t)^2 / (9 g).
double exact_reach() {
    return k_channel_time * (2 * std::sqrt(k_gravity * k_channel_left) - 3 * std::sqrt(k_gravity * k_shown_depth));
}

double foremost(const ParticleSet& particles) {
    double front = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) front = std::max(front, particles[Field::x][p]);
    return front - k_channel_dam;
}

struct Marks {
    double cell_size, mean_depth_error;
};

CaseStatistics run_channel(double cell_size, Scheme scheme, double right, double jitter, std::optional<Marks> marks) {
    Setup setup;
    const GridSpec grid =
        plain_grid(std::llround(k_channel_length / cell_size), std::llround(k_channel_width / cell_size), cell_size);
    setup.bed = Raster(grid, 0.0);
    setup.seeds =
        fill_lattice(grid, 2, jitter, [&](Point p) { return Seed{p.x < k_channel_dam ? k_channel_left : right}; });
    setup.material = water();
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::wall);
    TimedFlow run(setup);
    run.advance_to(k_channel_time);

    const DamBreak exact(k_channel_left, right, k_gravity);
    CaseStatistics statistics = compare_with_exact(run, [&](Point p) {
        const WaterState state = exact.at(p.x - k_channel_dam, k_channel_time);
        return ExactState{state.depth, state.depth * state.velocity, 0};
    });
    CaseStatistic mean{"mean depth error [m]", statistics.mean_depth_error, {}};
    if (marks && marks->cell_size == cell_size) mean.mark = marks->mean_depth_error;
    statistics.own.push_back(mean);
    if (right == 0) {
        const Raster depth = run.flow().nodal_fields().depth;
        statistics.own.push_back({"front at 0.01 m, error [cells]", (reach(depth) - exact_reach()) / cell_size, 2.0});
        statistics.own.push_back({"foremost particle beyond 2 sqrt(g h) t [m]",
                                  foremost(run.flow().particles()) - exact.front(k_channel_time),
                                  {}});
    }
    return statistics;
}

constexpr double k_jitter = 0.8;  // of the irregular cases, see fill_lattice

AccuracyCase channel_case(const char* name, const char* what, double right, std::optional<Marks> marks = {}) {
    return {name, what, {10, 5, 2.5, 1.25, 0.625}, false, [right, marks](double cell_size, Scheme scheme) {
                return run_channel(cell_size, scheme, right, 0, marks);
            }};
}

AccuracyCase irregular_case(const char* name, const char* what, double right) {
    return {name, what, {10, 5, 2.5, 1.25}, false, [right](double cell_size, Scheme scheme) {
                return run_channel(cell_size, scheme, right, k_jitter, {});
            }};
}

}  // namespace

std::vector<AccuracyCase> channel_dam_breaks() {
    return {channel_case("stoker", "dam break, 10 m over 2 m of water, 20 s", 2, Marks{2.5, 0.015}),
            irregular_case("stoker-irregular", "the same with irregular particles", 2),
            channel_case("stoker-weak", "dam break, 10 m over 5 m of water, 20 s", 5),
            irregular_case("stoker-weak-irregular", "the same with irregular particles", 5),
            channel_case("stoker-thin", "dam break, 10 m over 0.1 m of water, 20 s", 0.1),
            channel_case("ritter", "dam break, 10 m over dry ground, 20 s", 0, Marks{2.5, 0.0105}),
            irregular_case("ritter-irregular", "the same with irregular particles", 0)};
}

}  // namespace frana::bench
