// SPDX-License-Identifier: Apache-2.0
// Hard numerics: few and many particles, long steps, far coordinates, extreme cell sizes, other transfers.
#include <algorithm>
#include <cmath>

#include "bench/stability/stability.h"
#include "simulation/simulation.h"

namespace frana::bench {
namespace {

HardCase particles_per_cell(const char* name, const char* what, int per_side, double jitter) {
    return {name, what, 15, [=] {
                Setup setup = usual_slide();
                setup.numerics.particles_per_cell = per_side * per_side;
                setup.seeds =
                    fill_lattice(setup.bed.grid, per_side, jitter, [](Point p) { return Seed{usual_cap(p)}; });
                return setup;
            }};
}

HardCase with_transfer(const char* name, const char* what, Transfer transfer) {
    return {name, what, 15, [=] {
                Setup setup = usual_slide();
                setup.numerics.transfer = transfer;
                return setup;
            }};
}

HardCase with_cfl(const char* name, const char* what, double cfl) {
    return {name, what, 15, [=] {
                Setup setup = usual_slide();
                setup.numerics.cfl = cfl;
                return setup;
            }};
}

// The usual slide, all lengths times `scale`.
HardCase scaled(const char* name, const char* what, double scale) {
    return {name, what, 15 * std::sqrt(scale), [=] {
                Setup setup = usual_slide();
                const auto inner = [=](Point p) { return Point{p.x / scale, p.y / scale}; };
                const GridSpec grid = plain_grid(80, 40, 2 * scale);
                setup.bed = sample_raster(grid, [&](Point p) { return scale * usual_slope(inner(p)); });
                setup.seeds = fill_lattice(grid, 2, 0, [&](Point p) { return Seed{scale * usual_cap(inner(p))}; });
                setup.numerics.minimum_depth *= scale;
                return setup;
            }};
}

Scene scene_at(double west, double north) {
    Scene scene;
    scene.grid = {west, north, 2, 80, 40, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t row = 0; row < scene.grid.rows; ++row)
        for (std::int64_t column = 0; column < scene.grid.columns; ++column)
            scene.terrain.at(row, column) = usual_slope({2 * static_cast<double>(column) + 1, 0});
    ReleaseArea area;
    area.outline = {
        {{{west + 20, north - 50}, {west + 40, north - 50}, {west + 40, north - 30}, {west + 20, north - 30}}, {}}};
    area.thickness = 3;
    scene.release = {area};
    scene.material = dry_friction(15);
    scene.time.end = 8;
    return scene;
}

// The engine works in metres from the grid's corner, and all coordinates here are whole numbers, so a scene
// far from the origin must give the same bits.
StabilityStatistic far_coordinates(int threads, Soundness& sound) {
    RunOptions options;
    options.threads = threads;
    const RunResult near = run(scene_at(0, 80), options), far = run(scene_at(600000, 5000000), options);
    double greatest = 0;
    for (std::size_t c = 0; c < near.raster("max_depth").values.size(); ++c) {
        const double a = near.raster("max_depth").values[c], b = far.raster("max_depth").values[c];
        if (std::isnan(a) != std::isnan(b)) greatest = std::numeric_limits<double>::infinity();
        if (!std::isnan(a)) greatest = std::max(greatest, std::abs(a - b));
    }
    sound.non_finite = far.hard_events.non_finite;
    sound.volume_error = std::abs(far.volume_final + far.volume_left - far.volume_initial) / far.volume_initial;
    for (const double speed : far.raster("max_velocity").values) {
        const double limit = std::sqrt(2 * k_gravity * 43) + 2 * std::sqrt(k_gravity * 3);
        if (!std::isnan(speed)) sound.speed_ratio = std::max(sound.speed_ratio, speed / limit);
    }
    sound.clamped = far.hard_events.depth_clamped;
    sound.particles = far.particles_peak;
    sound.steps = far.steps;
    sound.wall_seconds = near.engine_seconds + far.engine_seconds;
    return {"greatest difference of max depth [m]", greatest, 0};
}

// A second thread must not change a bit.
StabilityStatistic threads_alike(int threads, Soundness& sound) {
    DepthAgreement agreement;
    for (const int n : {1, 2, 5, std::max(1, threads)}) {
        const Setup setup = usual_slide();
        TimedFlow run(setup, n);
        merge(sound, watch(run, setup, 8));
        agreement.compare(run);
    }
    return agreement.statistic();
}

}  // namespace

std::vector<HardCase> hard_numerics_cases() {
    return {
        particles_per_cell("one-per-cell", "1 particle per cell", 1, 0),
        particles_per_cell("four-per-cell", "4 particles per cell", 2, 0),
        particles_per_cell("sixteen-per-cell", "16 particles per cell", 4, 0),
        particles_per_cell("random-particles", "4 per cell, placed at random", 2, 1),
        with_cfl("cfl-09", "Courant number 0.9", 0.9),
        with_cfl("cfl-005", "Courant number 0.05", 0.05),
        with_transfer("pic", "PIC transfer", Transfer::pic),
        with_transfer("flip", "FLIP transfer", Transfer::flip),
        scaled("centimetres", "all lengths a hundredth: cells of 2 cm", 0.01),
        scaled("hundred-metres", "all lengths times 50: cells of 100 m", 50),
        {"far-coordinates", "a scene at 600 000, 5 000 000 m against one at the origin", 8, {}, {}, far_coordinates},
        {"threads", "1, 2, 5 and all threads", 8, {}, {}, threads_alike},
    };
}

}  // namespace frana::bench
