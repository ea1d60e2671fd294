// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy_case.h"

#include <algorithm>

#include "bench/exact/solutions.h"
#include "particles/seeding.h"

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
        const Raster depth = run.fields().depth;
        statistics.own.push_back({"front at 0.01 m, error [cells]", (reach(depth) - exact_reach()) / cell_size, 2.0});
        statistics.own.push_back({"foremost particle beyond 2 sqrt(g h) t [m]",
                                  foremost(run.particles()) - exact.front(k_channel_time),
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

/// Frictionless dam breaks in a walled channel of 1000 m x 50 m with the dam at 500 m, at t = 20 s, against
/// Stoker's and Ritter's solutions (bench/exact). Cells of 10 to 0.625 m are 100 to 1600 along the channel.
///   stoker       10 m over 2 m: rarefaction and shock
///   stoker-weak  10 m over 5 m
///   stoker-thin  10 m over 0.1 m: water a hundred times as deep as what it meets
///   ritter       10 m over dry ground
/// Own values: mean depth error in metres, as other codes publish it; for ritter the error of the position of the 0.01
/// m depth, in cells (mark 2), and that of the foremost particle.
std::vector<AccuracyCase> channel_dam_breaks() {
    return {channel_case("stoker", "dam break, 10 m over 2 m of water, 20 s", 2, Marks{2.5, 0.015}),
            irregular_case("stoker-irregular", "the same with irregular particles", 2),
            channel_case("stoker-weak", "dam break, 10 m over 5 m of water, 20 s", 5),
            irregular_case("stoker-weak-irregular", "the same with irregular particles", 5),
            channel_case("stoker-thin", "dam break, 10 m over 0.1 m of water, 20 s", 0.1),
            channel_case("ritter", "dam break, 10 m over dry ground, 20 s", 0, Marks{2.5, 0.0105}),
            irregular_case("ritter-irregular", "the same with irregular particles", 0)};
}

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

/// Ritter's dam break (bench/exact) with the dam at 30 degrees to the grid, 10 m over dry ground, t = 20 s.
///
/// Walls at 30 degrees are not possible, so the water is a rectangle so large (720 m behind the dam, 490 m along it)
/// that disturbances of its free sides, spreading at sqrt(g h) = 9.9 m/s, do not reach the strip that is compared: 50 m
/// wide about the middle, 500 m to either side of the dam, the same length as ritter's channel. The rectangle is filled
/// like a release perimeter, with the particles' areas clipped by its outline.
AccuracyCase rotated_dam_break() {
    return {"ritter-rotated", "ritter's dam at 30 degrees to the grid", {20, 10, 5, 2.5}, false, run_rotated};
}

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
    const Raster depth = run.fields().depth;
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

/// A cylinder of water 10 m high and 60 m in radius collapses, t = 6 s, no friction, against a converged
/// radial solution (bench/exact).
///   radial-wet  into 2 m of water
///   radial-dry  on dry ground
/// Own values: how much farther the front is along the grid's axes than along its diagonals, over the
/// reference's reach (outermost depth of 2.5 m in the wet case, 0.1 m in the dry one); mark 2 %.
std::vector<AccuracyCase> radial_dam_breaks() {
    return {radial_case("radial-wet", "cylinder of water into 2 m of water, 6 s", 2, 2.5, 0.011),
            radial_case("radial-dry", "cylinder of water on dry ground, 6 s", 0, 0.1, 0.018)};
}

}  // namespace frana::bench
