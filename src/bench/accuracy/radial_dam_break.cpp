// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/radial_dam_break.h"

#include "bench/exact/radial_reference.h"
#include "particles/seeding.h"

namespace frana::bench {
namespace {

constexpr double k_radial_radius = 60, k_radial_depth = 10, k_radial_time = 6, k_radial_side = 352;
constexpr Point k_radial_middle{0.5 * k_radial_side, 0.5 * k_radial_side};
constexpr double k_reference_extent = 250;  // past the grid's corners
constexpr int k_reference_cells = 6250;     // 40 mm each: a 25th of the finest grid

Ring circle() {
    constexpr int k_corners = 1440;  // its area is within 4e-6 of the circle's
    Ring ring;
    for (int i = 0; i < k_corners; ++i) {
        const double angle = 360.0 * k_degree * i / k_corners;
        ring.push_back({k_radial_middle.x + k_radial_radius * std::cos(angle),
                        k_radial_middle.y + k_radial_radius * std::sin(angle)});
    }
    return ring;
}

// Outermost distance along a direction where the depth, linear between nodes, passes `depth`.
double reach(const Raster& field, double cosine, double sine, double depth) {
    const GridSpec& grid = field.grid;
    const double step = 0.05 * grid.cell_size;
    for (double r = 0.5 * k_radial_side - 2 * grid.cell_size; r > 0; r -= step) {
        const double x = (k_radial_middle.x + r * cosine) / grid.cell_size - 0.5;
        const double y = (k_radial_middle.y + r * sine) / grid.cell_size - 0.5;
        const auto i = static_cast<std::int64_t>(x), j = static_cast<std::int64_t>(y);
        const double a = x - static_cast<double>(i), b = y - static_cast<double>(j);
        const auto h = [&](std::int64_t column, std::int64_t row) { return field.at(grid.rows - 1 - row, column); };
        if ((1 - b) * ((1 - a) * h(i, j) + a * h(i + 1, j)) + b * ((1 - a) * h(i, j + 1) + a * h(i + 1, j + 1)) > depth)
            return r;
    }
    return 0;
}

CaseStatistics run_radial(double cell_size, Scheme scheme, double outside, double front_depth, double mark) {
    Setup setup;
    const std::int64_t cells = std::llround(k_radial_side / cell_size);
    const GridSpec grid = plain_grid(cells, cells, cell_size);
    setup.bed = Raster(grid, 0.0);
    fill_outline(
        {{circle(), {}}}, 0.5 * cell_size, [](Point) { return k_radial_depth; }, setup.seeds);
    if (outside > 0) {
        const Polygon rest{{{0, 0}, {k_radial_side, 0}, {k_radial_side, k_radial_side}, {0, k_radial_side}},
                           {circle()}};
        fill_outline(
            {rest}, 0.5 * cell_size, [&](Point) { return outside; }, setup.seeds);
    }
    setup.material = water();
    setup.numerics = numerics_of(scheme, SlopeCorrection::normal, Boundary::wall);
    TimedFlow run(setup);
    run.advance_to(k_radial_time);
    const RadialReference reference(k_radial_radius, k_radial_depth, outside, k_reference_extent, k_radial_time,
                                    k_reference_cells);
    CaseStatistics statistics = compare_with_exact(run, [&](Point p) {
        const double x = p.x - k_radial_middle.x, y = p.y - k_radial_middle.y, r = std::hypot(x, y);
        const WaterState state = reference.at(r);
        const double q = r > 0 ? state.depth * state.velocity / r : 0;
        return ExactState{state.depth, q * x, q * y};
    });
    const Raster depth = run.flow().nodal_fields().depth;
    const double diagonal = std::sqrt(0.5);
    const double axes = 0.25 * (reach(depth, 1, 0, front_depth) + reach(depth, -1, 0, front_depth) +
                                reach(depth, 0, 1, front_depth) + reach(depth, 0, -1, front_depth));
    const double diagonals =
        0.25 * (reach(depth, diagonal, diagonal, front_depth) + reach(depth, -diagonal, diagonal, front_depth) +
                reach(depth, diagonal, -diagonal, front_depth) + reach(depth, -diagonal, -diagonal, front_depth));
    const double exact = reference.reach(front_depth);
    CaseStatistic l1{"l1_depth", statistics.l1_depth, {}};
    if (cell_size == 2) l1.mark = mark;
    statistics.own = {l1,
                      {"front, axes less diagonals", (axes - diagonals) / exact, 0.02},
                      {"front error along the axes", axes / exact - 1, {}}};
    return statistics;
}

AccuracyCase radial_case(const char* name, const char* what, double outside, double front_depth, double mark) {
    return {name, what, {8, 4, 2, 1}, false, [=](double cell_size, Scheme scheme) {
                return run_radial(cell_size, scheme, outside, front_depth, mark);
            }};
}

}  // namespace

std::vector<AccuracyCase> radial_dam_breaks() {
    return {radial_case("radial-wet", "cylinder of water into 2 m of water, 6 s", 2, 2.5, 0.011),
            radial_case("radial-dry", "cylinder of water on dry ground, 6 s", 0, 0.1, 0.018)};
}

}  // namespace frana::bench
