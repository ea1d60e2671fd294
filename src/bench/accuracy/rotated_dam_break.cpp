// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/rotated_dam_break.h"

#include "bench/exact/dam_break.h"
#include "particles/seeding.h"

namespace frana::bench {
namespace {

constexpr double k_rotated_depth = 10, k_rotated_time = 20, k_behind = 720, k_half_width = 245, k_half_strip = 25,
                 k_rotated_stretch = 500;
constexpr double k_rotated_side = 1360;  // of the square grid [m]
constexpr Point k_dam_middle{780, 660};  // the water and its sideways spread remain inside
const double k_cosine = std::cos(30 * k_degree), k_sine = std::sin(30 * k_degree);

// Distance in front of the dam and along it.
Point along_flow(Point p) {
    const double x = p.x - k_dam_middle.x, y = p.y - k_dam_middle.y;
    return {k_cosine * x + k_sine * y, -k_sine * x + k_cosine * y};
}

Point from_flow(double front, double side) {
    return {k_dam_middle.x + k_cosine * front - k_sine * side, k_dam_middle.y + k_sine * front + k_cosine * side};
}

CaseStatistics run_rotated(double cell_size, Scheme scheme) {
    Setup setup;
    const GridSpec grid =
        plain_grid(std::llround(k_rotated_side / cell_size), std::llround(k_rotated_side / cell_size), cell_size);
    setup.bed = Raster(grid, 0.0);
    Polygon water_body;
    water_body.outer = {from_flow(-k_behind, -k_half_width), from_flow(0, -k_half_width), from_flow(0, k_half_width),
                        from_flow(-k_behind, k_half_width)};
    fill_outline(
        {water_body}, 0.5 * cell_size, [](Point) { return k_rotated_depth; }, setup.seeds);
    setup.material = water();
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::open);
    TimedFlow run(setup);
    run.advance_to(k_rotated_time);

    const DamBreak exact(k_rotated_depth, 0, k_gravity);
    CaseStatistics statistics = compare_with_exact(
        run,
        [&](Point p) {
            const WaterState state = exact.at(along_flow(p).x, k_rotated_time);
            const double q = state.depth * state.velocity;
            return ExactState{state.depth, q * k_cosine, q * k_sine};
        },
        [](Point p) {
            const Point place = along_flow(p);
            return std::abs(place.x) <= k_rotated_stretch && std::abs(place.y) <= k_half_strip;
        });
    statistics.own.push_back({"mean depth error [m]", statistics.mean_depth_error, {}});
    return statistics;
}

}  // namespace

AccuracyCase rotated_dam_break() {
    return {"ritter-rotated", "ritter's dam at 30 degrees to the grid", {20, 10, 5, 2.5}, false, run_rotated};
}

}  // namespace frana::bench
