// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/robustness.h"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "bench/set_up/choose.h"
#include "core/error.h"
#include "simulation/simulation.h"

namespace frana::bench {
namespace {

// Adds white noise of mean 0 to every elevation; the same for a seed on any machine.
void roughen(Raster& terrain, double deviation, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto between_0_and_1 = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
    for (double& elevation : terrain.values) {
        // Box and Muller 1958; drawn for every cell, so that one without data changes no other.
        const double radius = std::sqrt(-2 * std::log(between_0_and_1()));
        elevation += deviation * radius * std::cos(2 * std::numbers::pi * between_0_and_1());
    }
}

PlacedScene disturbed(const Scene& scene, const Disturbance& disturbance, const Numerics& numerics,
                      std::uint64_t seed) {
    const GridPlacement& placement = disturbance.placement;
    const bool moved = placement.shift != 0 || placement.turn_deg != 0;
    PlacedScene placed = moved ? placed_otherwise(scene, placement) : PlacedScene{scene, {}};
    placed.scene.numerics = numerics;
    if (disturbance.noise > 0) roughen(placed.scene.terrain, disturbance.noise, seed);
    return placed;
}

// One planned run, or why it is refused.
struct Planned {
    Disturbance disturbance;
    Numerics numerics;
    std::string refusal;
};

bool same_numerics(const Numerics& a, const Numerics& b) {
    return a.cfl == b.cfl && a.particles_per_cell == b.particles_per_cell;
}

// Keys are validated on the scene before anything is run. Values that the scene already has are not run twice.
std::vector<Planned> plan(const RobustnessOptions& options, const Scene& scene) {
    std::vector<Planned> runs{{{"base", "as it is", {}}, scene.numerics, {}}};
    for (const Disturbance& one : choose(disturbances(), options.only, "robustness")) {
        Planned run{one, scene.numerics, {}};
        if (!one.overrides.empty()) {
            try {
                run.numerics = options.scene(one.overrides).numerics;
                if (same_numerics(run.numerics, scene.numerics)) continue;
            } catch (const Error& error) {
                if (error.kind() != ErrorKind::input) throw;
                run.refusal = error.what();
            }
        }
        runs.push_back(std::move(run));
    }
    return runs;
}

// Returns whether it was run to its end.
bool run_row(const RobustnessOptions& options, const Scene& scene, const Numerics& numerics, RobustnessRow& row) {
    const PlacedScene placed = disturbed(scene, row.disturbance, numerics, options.seed);
    const RunResult result = options.run(placed.scene);
    if (result.stop_reason == StopReason::requested) return false;
    if (!result.run_problems.empty()) row.run_problem = describe(result.stop_reason);
    row.statistics = run_statistics(result, options.threshold, placed.inside);
    row.simulated_seconds = result.simulated_seconds;
    row.steps = result.steps;
    row.particles = result.particles_peak;
    row.wall_seconds = result.engine_seconds;
    return true;
}

}  // namespace

std::vector<Disturbance> disturbances() {
    constexpr double k_noise = 0.1;
    std::vector<Disturbance> all{
        {"shifted", "the grid shifted by half a cell to the east and to the north", {}, {0.5, 0}},
        {"turned-30", "the grid rotated by 30 degrees", {}, {0, 30}},
        {"turned-45", "the grid rotated by 45 degrees", {}, {0, 45}},
        {"turned-90", "the grid rotated by 90 degrees: only rounding may change", {}, {0, 90}, 0, true},
        {"rough", "noise of 10 cm on every elevation", {}, {}, k_noise},
    };
    for (const char* count : {"1", "4", "9", "16"})
        all.push_back({std::string("particles-") + count,
                       std::string(count) + " particles per cell",
                       {std::string("numerics.particles-per-cell=") + count}});
    for (const char* number : {"0.2", "0.35", "0.5", "0.65", "0.8", "0.95"})
        all.push_back({std::string("cfl-") + number,
                       std::string("Courant number ") + number,
                       {std::string("numerics.cfl=") + number}});
    return all;
}

std::vector<RobustnessRow> run_robustness(const RobustnessOptions& options) {
    const Scene scene = options.scene({});
    std::vector<RobustnessRow> rows;
    for (Planned& planned : plan(options, scene)) {
        RobustnessRow row;
        row.disturbance = std::move(planned.disturbance);
        row.refusal = std::move(planned.refusal);
        try {
            if (row.refusal.empty() && !run_row(options, scene, planned.numerics, row)) return rows;
        } catch (const Error& error) {
            // A turned release may be on ground without elevation: the other runs are still useful.
            if (rows.empty() || error.kind() != ErrorKind::input) throw;
            row.refusal = error.what();
        }
        rows.push_back(std::move(row));
        if (options.report) options.report(robustness_line(rows, rows.size() - 1));
    }
    return rows;
}

}  // namespace frana::bench
