// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/stability/robustness.h"
#include "core/json.h"
#include "core/shortest_text.h"

namespace frana::bench {
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
