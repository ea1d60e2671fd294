// SPDX-License-Identifier: Apache-2.0
#include "app/commands/bench_estimate.h"

#include <cmath>
#include <cstdio>
#include <iostream>

#include "app/commands/accuracy_search.h"
#include "app/commands/bench_output.h"
#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/scene_variants.h"
#include "app/input/share_directory.h"
#include "app/process/signals.h"
#include "app/text/csv_cell.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "core/shortest_text.h"

namespace frana::app {
namespace {

constexpr const char* k_estimate_csv = "estimate.csv";

/// Estimates from all levels up to one, and true changes against the finest.
struct LevelCheck {
    double cell_size = 0;
    double seconds = 0;  ///< of this level and all coarser ones, and of this one again as the result
    std::vector<ValueEstimate> estimates;
    std::vector<double> changes;  ///< |value - finest's|, as estimates

    [[nodiscard]] bool contains(std::size_t i) const { return changes[i] <= estimates[i].error; }
    /// Number of values that are not zero on all levels.
    [[nodiscard]] std::size_t estimated() const {
        std::size_t count = 0;
        for (const ValueEstimate& e : estimates) count += e.is_zero ? 0 : 1;
        return count;
    }
    [[nodiscard]] std::size_t contained() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < changes.size(); ++i) count += !estimates[i].is_zero && contains(i) ? 1 : 0;
        return count;
    }
};

std::vector<LevelCheck> check_levels(const AccuracyRecord& all, const AccuracyLevel& finest) {
    std::vector<LevelCheck> checks;
    AccuracyRecord record = all;
    record.levels.clear();
    double seconds = 0;
    for (const AccuracyLevel& level : all.levels) {
        record.levels.push_back(level);
        seconds += level.wall_seconds;
        if (!level.problem.empty()) continue;
        LevelCheck check{level.cell_size, seconds + level.wall_seconds, value_estimates(record), {}};
        for (std::size_t i = 0; i < check.estimates.size(); ++i)
            check.changes.push_back(std::abs(check.estimates[i].value.value - finest.values.at(i).value));
        if (!check.estimates.empty()) checks.push_back(std::move(check));
    }
    return checks;
}

std::string relative(double error, double value) {
    return value != 0 ? number_text(100 * error / std::abs(value), 2) + " %" : "-";
}

std::string table_text(const std::vector<LevelCheck>& checks, const AccuracyLevel& finest) {
    std::string text;
    char line[200];
    for (const LevelCheck& check : checks) {
        std::snprintf(line, sizeof line,
                      "cells of %s m: %zu of %zu true changes within the estimate, %.2f of the time of %s m\n",
                      number_text(check.cell_size).c_str(), check.contained(), check.estimated(),
                      check.seconds / finest.wall_seconds, number_text(finest.cell_size).c_str());
        text += line;
        for (std::size_t i = 0; i < check.changes.size(); ++i) {
            const ValueEstimate& e = check.estimates[i];
            std::snprintf(line, sizeof line, "  %-32s %10s %-4s estimate %8s  true %8s%s\n", e.value.title.c_str(),
                          number_text(e.value.value).c_str(), e.value.unit.c_str(),
                          relative(e.error, e.value.value).c_str(), relative(check.changes[i], e.value.value).c_str(),
                          e.is_zero           ? "  no estimate"
                          : check.contains(i) ? ""
                                              : "  *");
            text += line;
        }
    }
    return text;
}

std::string csv_text(const std::vector<LevelCheck>& checks, const AccuracyLevel& finest) {
    std::string text = "cell_size_m,time_fraction,value,unit,result,finest,estimated_error,true_change,within\n";
    for (const LevelCheck& check : checks) {
        for (std::size_t i = 0; i < check.changes.size(); ++i) {
            const ValueEstimate& e = check.estimates[i];
            text += shortest_text(check.cell_size) + ',' + shortest_text(check.seconds / finest.wall_seconds) + ',' +
                    csv_cell(e.value.key) + ',' + e.value.unit + ',' + shortest_text(e.value.value) + ',' +
                    shortest_text(finest.values[i].value) + ',' + shortest_text(e.error) + ',' +
                    shortest_text(check.changes[i]) + ',' +
                    (e.is_zero           ? ""
                     : check.contains(i) ? "1"
                                         : "0") +
                    '\n';
        }
    }
    return text;
}

}  // namespace

int bench_estimate(const std::string& file, const boost::program_options::variables_map& values) {
    const bool quiet = values.count("quiet") > 0;
    const SceneVariants runs(file, {}, thread_count(values), quiet);
    const RunLevel run = [&](const Scene& scene) { return runs.run(scene); };
    const SceneReading reading = read_scene(file, text_options(values, "set"), materials_directory());
    RunLog log(quiet);
    Prepared prepared = prepare(reading, log);
    prepared.scene.time.frame_interval = 0;
    const auto out = bench_output(values, {k_estimate_csv}, input_files(prepared.spec));
    catch_stop_signals();
    AccuracyRecord record = begin_record(prepared);
    for (const double size : coarse_cell_sizes(prepared)) {
        const auto level = compute_level(reading, prepared, size, run);
        if (!level) return static_cast<int>(ExitCode::signal) + stop_signal();
        record.levels.push_back(*level);
    }
    const RunResult result = run(prepared.scene);
    if (stop_signal() != 0) return static_cast<int>(ExitCode::signal) + stop_signal();
    const AccuracyLevel finest = level_of(result, prepared, prepared.scene.terrain);
    if (!finest.problem.empty())
        throw Error(ErrorKind::numerical, Problem{"the run on the scene's own cells " + finest.problem, file, "", "",
                                                  "Correct the scene so that `frana run` completes it"});
    const std::vector<LevelCheck> checks = check_levels(record, finest);
    if (out) {
        out->begin();
        write_text_file(out->path(k_estimate_csv), csv_text(checks, finest));
        out->list();
    }
    return print_bench(values, "estimate",
                       level_table(record) + "  cells of " + number_text(finest.cell_size) +
                           " m: " + number_text(finest.wall_seconds, 3) + " s\n" + table_text(checks, finest),
                       {{"values", csv_text(checks, finest)}});
}

}  // namespace frana::app
