// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/stability.h"

#include <algorithm>
#include <cstdio>

#include "bench/set_up/choose.h"

namespace frana::bench {
namespace {

constexpr double k_volume_limit = 1e-12;  // rounding of sums over some 1e5 particles

StabilityRow run_case(const HardCase& one, int threads) {
    StabilityRow row{one.name, one.what, false, {}, {}};
    if (one.compare) {
        row.statistic = one.compare(threads, row.sound);
    } else {
        const Setup setup = one.make();
        TimedFlow run(setup, threads);
        row.sound = watch(run, setup, one.end);
        row.statistic = one.statistic
                            ? one.statistic(setup, run.flow())
                            : StabilityStatistic{"speed over the highest possible speed", row.sound.speed_ratio, 1};
    }
    row.passed = row.sound.non_finite == 0 && row.sound.volume_error <= k_volume_limit && row.sound.speed_ratio <= 1 &&
                 row.statistic.value <= row.statistic.limit;
    return row;
}

std::string line_of(const StabilityRow& row) {
    char line[320];
    std::snprintf(line, sizeof line,
                  "%-18s %-6s %-48s %10.3g of %-6g  speed %.3f, volume %.1e, non-finite %lld, clamped %lld, "
                  "%lld particles, %lld steps, %.2f s",
                  row.case_name.c_str(), row.passed ? "passed" : "FAILED", row.statistic.name.c_str(),
                  row.statistic.value, row.statistic.limit, row.sound.speed_ratio, row.sound.volume_error,
                  static_cast<long long>(row.sound.non_finite), static_cast<long long>(row.sound.clamped),
                  static_cast<long long>(row.sound.particles), static_cast<long long>(row.sound.steps),
                  row.sound.wall_seconds);
    return line;
}

}  // namespace

std::vector<HardCase> hard_cases() {
    std::vector<HardCase> all;
    for (auto* make : {hard_terrain_cases, hard_release_cases, hard_material_cases, hard_numerics_cases})
        for (HardCase& one : make()) all.push_back(std::move(one));
    return all;
}

std::vector<StabilityRow> run_stability(const StabilityOptions& options) {
    std::vector<StabilityRow> rows;
    for (const HardCase& one : choose(hard_cases(), options.only, "stability")) {
        rows.push_back(run_case(one, options.threads));
        if (options.report) options.report(line_of(rows.back()));
    }
    return rows;
}

std::string stability_csv(const std::vector<StabilityRow>& rows) {
    std::string out = "case,passed,figure,limit\n";
    for (const StabilityRow& row : rows) {
        char line[160];
        std::snprintf(line, sizeof line, "%s,%s,%.6g,%g\n", row.case_name.c_str(), row.passed ? "true" : "false",
                      row.statistic.value, row.statistic.limit);
        out += line;
    }
    return out;
}

std::string stability_table(const std::vector<StabilityRow>& rows) {
    std::string out;
    std::size_t passed = 0;
    for (const StabilityRow& row : rows) {
        out += line_of(row) + "\n";
        passed += row.passed ? 1 : 0;
    }
    char line[96];
    std::snprintf(line, sizeof line, "%zu of %zu hard cases passed\n", passed, rows.size());
    out += line;
    for (const StabilityRow& row : rows)
        if (!row.passed) out += "  failed: " + row.case_name + " (" + row.what + ")\n";
    return out;
}

}  // namespace frana::bench
