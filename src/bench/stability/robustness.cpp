// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/robustness.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <utility>

#include "bench/set_up/setup.h"
#include "core/error.h"
#include "core/json.h"
#include "core/text.h"
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

bool same_numerics(const Numerics& a, const Numerics& b, const Material& material) {
    return courant_number(a, material) == courant_number(b, material) && a.particles_per_cell == b.particles_per_cell;
}

// Keys are validated on the scene before anything is run. Values that the scene already has are not run twice.
std::vector<Planned> plan(const RobustnessOptions& options, const Scene& scene) {
    std::vector<Planned> runs{{{"base", "as it is", {}}, scene.numerics, {}}};
    for (const Disturbance& one : choose(disturbances(), options.only, "robustness")) {
        Planned run{one, scene.numerics, {}};
        if (!one.overrides.empty()) {
            try {
                run.numerics = options.scene(one.overrides).numerics;
                if (same_numerics(run.numerics, scene.numerics, scene.material)) continue;
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

namespace {

bool marked(std::optional<double> change) {
    return change && std::abs(*change) > k_robust_change;
}

// Formats "12.34  +1.2 %  ", with a star after a marked change.
std::string cell(const std::vector<RobustnessRow>& rows, std::size_t row, const RunStatistic& statistic) {
    char text[64];
    const double value = statistic.of(rows[row].statistics);
    if (std::isnan(value)) return "        -           ";
    if (row == 0) {
        std::snprintf(text, sizeof text, "%9.4g           ", value);
        return text;
    }
    const auto change = relative_change(rows, row, statistic);
    if (!change) {
        std::snprintf(text, sizeof text, "%9.4g      -    ", value);
    } else if (rows[row].disturbance.only_rounding && std::abs(*change) < 5e-4) {
        std::snprintf(text, sizeof text, "%9.4g %+8.0e  ", value, *change);
    } else {
        std::snprintf(text, sizeof text, "%9.4g %+6.1f %%%s ", value, 100 * *change, marked(change) ? "*" : " ");
    }
    return text;
}

const char* k_heads[] = {"depth [m]", "99.9 %",    "99 %",        "speed [m/s]",   "99.9 %",
                         "99 %",      "area [m2]", "run-out [m]", "in final_depth"};
static_assert(std::size(k_heads) == std::size(k_run_statistics));

}  // namespace

std::optional<double> relative_change(const std::vector<RobustnessRow>& rows, std::size_t row,
                                      const RunStatistic& statistic) {
    if (!rows[row].refusal.empty()) return {};
    const double base = statistic.of(rows.front().statistics), value = statistic.of(rows[row].statistics);
    const double change = value == base ? 0 : (value - base) / base;
    if (!std::isfinite(change)) return {};
    return change;
}

std::string robustness_line(const std::vector<RobustnessRow>& rows, std::size_t row) {
    const RobustnessRow& one = rows[row];
    char name[32];
    std::snprintf(name, sizeof name, "%-13s", one.disturbance.name.c_str());
    if (!one.refusal.empty()) return name + std::string("not run: ") + one.refusal;
    std::string line = name;
    for (const RunStatistic& statistic : k_run_statistics) line += cell(rows, row, statistic);
    char cost[96];
    std::snprintf(cost, sizeof cost, "%7.1f s %7lld steps %6.1f s", one.simulated_seconds,
                  static_cast<long long>(one.steps), one.wall_seconds);
    line += cost;
    if (!one.run_problem.empty()) line += "  ended early: " + one.run_problem;
    return line;
}

std::string robustness_table(const std::vector<RobustnessRow>& rows) {
    std::string table = "             ";
    for (const char* head : k_heads) {
        char text[64];
        std::snprintf(text, sizeof text, "%-20s",
                      (std::string(head).size() < 9 ? "   " + std::string(head) : head).c_str());
        table += text;
    }
    table += "simulated    steps  engine\n";
    for (std::size_t row = 0; row < rows.size(); ++row) table += robustness_line(rows, row) + "\n";
    table += "\nchanges against the first row; * more than 5 %\n";
    for (const RunStatistic& statistic : k_run_statistics) {
        double most = 0;
        std::string where;
        int count = 0;
        for (std::size_t row = 1; row < rows.size(); ++row) {
            const auto change = relative_change(rows, row, statistic);
            count += marked(change) ? 1 : 0;
            if (!change || std::abs(*change) <= std::abs(most)) continue;
            most = *change;
            where = " (" + rows[row].disturbance.name + ")";
        }
        char text[160];
        std::snprintf(text, sizeof text, "%-22s changes by %+.2g %% at most%s; more than 5 %% in %d of %zu\n",
                      statistic.title, 100 * most, where.c_str(), count, rows.size() - 1);
        table += text;
    }
    return table;
}

std::string robustness_csv(const std::vector<RobustnessRow>& rows) {
    std::string text = "disturbance";
    for (const RunStatistic& statistic : k_run_statistics)
        text += std::string(",") + statistic.key + "," + statistic.key + "_change";
    text += ",simulated_seconds,steps,particles,wall_seconds,state\n";
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const RobustnessRow& one = rows[row];
        const bool run = one.refusal.empty();
        text += one.disturbance.name;
        for (const RunStatistic& statistic : k_run_statistics) {
            const double value = statistic.of(one.statistics);
            const auto change = relative_change(rows, row, statistic);
            text += "," + (run && !std::isnan(value) ? shortest_text(value) : "") + "," +
                    (change ? shortest_text(*change) : "");
        }
        if (run) {
            text += "," + shortest_text(one.simulated_seconds) + "," + std::to_string(one.steps) + "," +
                    std::to_string(one.particles) + "," + shortest_text(one.wall_seconds);
        } else {
            text += ",,,,";
        }
        text += std::string(",") + (!run ? "refused" : one.run_problem.empty() ? "done" : "ended early") + "\n";
    }
    return text;
}

std::string robustness_json(const std::vector<RobustnessRow>& rows, const RobustnessOptions& options,
                            const std::string& scene) {
    Json json{{"scene", scene},
              {"trace_threshold_m", options.threshold},
              {"seed", options.seed},
              {"marked_beyond", k_robust_change},
              {"runs", Json::array()}};
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const RobustnessRow& one = rows[row];
        Json& run =
            json["runs"].emplace_back(Json{{"disturbance", one.disturbance.name}, {"what", one.disturbance.what}});
        if (!one.refusal.empty()) {
            run["refused"] = one.refusal;
            continue;
        }
        for (const RunStatistic& statistic : k_run_statistics) {
            const auto change = relative_change(rows, row, statistic);
            Json& value = run[statistic.key] = {{"value", statistic.of(one.statistics)}};
            if (!change) continue;
            value["relative_change"] = *change;
            value["marked"] = marked(change);
        }
        run["simulated_seconds"] = one.simulated_seconds;
        run["steps"] = one.steps;
        run["particles"] = one.particles;
        if (!one.run_problem.empty()) run["ended_early"] = one.run_problem;
    }
    return json_text(json);
}

}  // namespace frana::bench
