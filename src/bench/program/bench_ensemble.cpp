// SPDX-License-Identifier: Apache-2.0
#include "bench/program/bench_output.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>

#include "app/commands/accuracy_search.h"
#include "app/commands/command_line.h"
#include "app/commands/scene_variants.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/store/result_files.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/member_runs.h"
#include "app/study/pool/rounds.h"
#include "app/study/pool/study_result.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "render/canvas/image.h"
#include "render/chart/chart.h"

namespace frana::app {
namespace {

constexpr const char* k_estimate_csv = "estimate.csv";

bool has_none(const ValueEstimate& e) {
    return e.is_zero || !std::isfinite(e.error);
}

/// Estimates from all levels up to one, and true changes against the finest.
struct LevelCheck {
    double cell_size = 0;
    double seconds = 0;  ///< of this level and all coarser ones, and of this one again as the result
    std::vector<ValueEstimate> estimates;
    std::vector<double> changes;  ///< |value - finest's|, as estimates

    [[nodiscard]] bool contains(std::size_t i) const { return changes[i] <= estimates[i].error; }
    /// Number of values with an estimate.
    [[nodiscard]] std::size_t estimated() const {
        std::size_t count = 0;
        for (const ValueEstimate& e : estimates) count += has_none(e) ? 0 : 1;
        return count;
    }
    [[nodiscard]] std::size_t contained() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < changes.size(); ++i) count += !has_none(estimates[i]) && contains(i) ? 1 : 0;
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
                          has_none(e)         ? "  no estimate"
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
                    (has_none(e)         ? ""
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
    const SceneReading reading = read_scene(file, text_options(values, "set"), share_directory());
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

namespace {

namespace fs = std::filesystem;

constexpr const char *k_sampling_csv = "ensemble.csv", *k_sampling_picture = "ensemble.png";

struct Method {
    const char* name;
    study::Sampling sampling;
    std::optional<std::size_t> levels;
    const char* with_polynomials = nullptr;  ///< the same runs with polynomials of the keys beside them
};
constexpr Method k_methods[] = {{"random", study::Sampling::random, {}, "random, polynomials"},
                                {"latin-hypercube", study::Sampling::latin_hypercube, {}},
                                {"sobol", study::Sampling::sobol, {}, "sobol, polynomials"},
                                {"random, levels = 2", study::Sampling::random, 2},
                                {"random, levels = 3", study::Sampling::random, 3},
                                {"sobol, levels = 3", study::Sampling::sobol, 3}};
/// Plain Monte Carlo, with which the others are compared.
constexpr const Method& k_plain = k_methods[0];
constexpr const Method& k_sobol = k_methods[2];
/// The mark: with polynomials of the keys, the error of so many times as many members of `sobol`.
constexpr std::int64_t k_times = 4;

/// How much is computed.
struct Extent {
    std::int64_t reference;
    std::vector<std::int64_t> samples;
    int seeds;
};

/// A folder for records, which disappears with the bench.
class Scratch {
  public:
    void clear() const {
        fs::remove_all(fs::path(folder()) / k_record_folder);
        fs::create_directories(fs::path(folder()) / k_record_folder);
    }
    [[nodiscard]] const std::string& folder() const noexcept { return folder_.path(); }

  private:
    TemporaryFolder folder_;
};

/// The members of a study by one method, as far as they finished.
struct Sample {
    study::StudyResult result;
    double seconds = 0;         ///< in the engine, of all runs
    double particle_steps = 0;  ///< likewise
};

class StoppedBySignal {};

Sample run_study(study::StudyInput& input, const Method& method, std::int64_t samples, std::int64_t seed, int threads,
                 const Scratch& scratch) {
    scratch.clear();
    study::StudySpec& study = input.reading.study;
    study.sampling = method.sampling;
    study.levels = method.levels;
    study.samples = samples;
    study.seed = seed;
    study.until.reset();
    study::redraw(input);
    const auto run_until = [&](std::size_t end) {
        return study::MemberRunner(input, scratch.folder(), threads, true).run_until(end);
    };
    const bool complete = input.level_draws.empty() ? run_until(input.table.size())
                                                    : study::run_levels(input, scratch.folder(), run_until,
                                                                        [](std::size_t) { return false; });
    if (!complete) throw StoppedBySignal();
    Sample sample{study::read_study_result(input, scratch.folder(), input.table.size())};
    if (sample.result.failed() > 0)
        throw Error(ErrorKind::numerical, Problem{std::to_string(sample.result.failed()) + " members failed",
                                                  input.reading.label, "", "", "Change the study so that all finish"});
    for (const study::MemberResult& member : sample.result.members) {
        sample.seconds += member.engine_seconds;
        sample.particle_steps += static_cast<double>(member.particle_steps);
    }
    return sample;
}

/// Probabilities that are neither 0 nor 1 in a large study: where the others are compared with it.
class Reference {
  public:
    Reference(const study::StudyInput& input, const Sample& sample) : events_(study::mapped_events(input.base.spec)) {
        for (const study::MappedEvents& events : events_) {
            std::vector<Raster> maps(events.thresholds.size(), Raster(sample.result.grid));
            const study::MeanEstimate estimate(sample.result.finished, events.quantity, sample.result.grid,
                                               events.thresholds);
            study::for_each_reached_cell(sample.result.finished, events.quantity, sample.result.grid,
                                         [&](std::size_t cell, std::span<const float> values) {
                                             for (std::size_t t = 0; t < maps.size(); ++t) {
                                                 const study::Estimate p =
                                                     estimate.probability(values, events.thresholds[t]);
                                                 if (!(p.value > 0 && p.value < 1)) continue;
                                                 maps[t].values[cell] = p.value;
                                                 squares_ += p.value * p.value;
                                                 said_ += p.error * p.error;
                                                 count_ += 1;
                                             }
                                         });
            maps_.push_back(std::move(maps));
        }
    }
    /// Mean squares over these places.
    struct Squares {
        double error = 0;  ///< of the difference from the reference
        double said = 0;   ///< of the standard error that the study itself states
    };
    /// @param emulation polynomials of the keys beside the runs; null: none
    [[nodiscard]] Squares of(const study::StudyResult& result, const study::Emulation* emulation) const {
        Squares sum{squares_, 0};  // as if nothing were reached
        for (std::size_t e = 0; e < events_.size(); ++e) {
            const study::MeanEstimate estimate(result.finished, events_[e].quantity, result.grid,
                                               events_[e].thresholds);
            std::vector<std::map<std::size_t, study::Estimate>> better(maps_[e].size());
            for (std::size_t t = 0; t < better.size() && emulation != nullptr; ++t) {
                const study::OutlineMaps outlines = study::outline_maps(
                    result.finished, *emulation, events_[e].quantity, events_[e].thresholds[t], result.grid, false);
                for (const auto& one : outlines.cells)
                    if (outlines.pays()) better[t].emplace(one.cell, one.emulated);
            }
            study::for_each_reached_cell(result.finished, events_[e].quantity, result.grid,
                                         [&](std::size_t cell, std::span<const float> values) {
                                             for (std::size_t t = 0; t < maps_[e].size(); ++t) {
                                                 const double exact = maps_[e][t].values[cell];
                                                 if (exact == 0) continue;
                                                 const auto found = better[t].find(cell);
                                                 const study::Estimate p =
                                                     found != better[t].end()
                                                         ? found->second
                                                         : estimate.probability(values, events_[e].thresholds[t]);
                                                 const double value = std::clamp(p.value, 0.0, 1.0);  // as maps have it
                                                 sum.error += (value - exact) * (value - exact) - exact * exact;
                                                 sum.said += p.error * p.error;
                                             }
                                         });
        }
        return {sum.error / count_, sum.said / count_};
    }
    [[nodiscard]] double own_error() const { return std::sqrt(said_ / count_); }
    [[nodiscard]] double places() const noexcept { return count_; }

  private:
    std::vector<study::MappedEvents> events_;
    std::vector<std::vector<Raster>> maps_;
    double squares_ = 0, said_ = 0, count_ = 0;
};

/// A method with one number of members: means over the seeds.
struct Row {
    const Method* method;
    std::int64_t samples = 0;
    std::string name;
    double runs = 0, particle_steps = 0, seconds = 0;
    double error = 0;                             ///< root of the mean square
    double said = 0;                              ///< standard error as the study states it, likewise
    double at_equal_cost = 0, at_equal_time = 0;  ///< error over that of plain Monte Carlo

    /// Plain Monte Carlo's error falls with the root of the cost; these are its error's squares at a cost of 1.
    void compare(double plain_by_cost, double plain_by_time) {
        at_equal_cost = error / std::sqrt(plain_by_cost / particle_steps);
        at_equal_time = error / std::sqrt(plain_by_time / seconds);
    }
};

/// Returns a row of the method, and one of the same runs with polynomials if it has such a name.
std::vector<Row> measure(study::StudyInput& input, const Method& method, std::int64_t samples, const Extent& extent,
                         std::int64_t first_seed, int threads, const Reference& reference, const Scratch& scratch) {
    std::vector<Row> rows{{&method, samples, method.name}};
    if (method.with_polynomials != nullptr) rows.push_back({&method, samples, method.with_polynomials});
    for (int i = 0; i < extent.seeds; ++i) {
        const Sample sample = run_study(input, method, samples, first_seed + 1 + i, threads, scratch);
        const study::Emulation emulation =
            rows.size() > 1 ? study::emulation_of(input, sample.result) : study::Emulation{};
        for (Row& row : rows) {
            const Reference::Squares squares = reference.of(sample.result, &row == &rows[0] ? nullptr : &emulation);
            row.runs += static_cast<double>(sample.result.members.size()) / extent.seeds;
            row.particle_steps += sample.particle_steps / extent.seeds;
            row.seconds += sample.seconds / extent.seeds;
            row.error += squares.error / extent.seeds;
            row.said += squares.said / extent.seeds;
        }
    }
    for (Row& row : rows) {
        row.error = std::sqrt(row.error);
        row.said = std::sqrt(row.said);
    }
    return rows;
}

void compare_with_plain(std::vector<Row>& rows) {
    double by_cost = 0, by_time = 0, count = 0;
    for (const Row& row : rows) {
        if (row.name != k_plain.name) continue;
        by_cost += row.error * row.error * row.particle_steps;
        by_time += row.error * row.error * row.seconds;
        count += 1;
    }
    for (Row& row : rows) row.compare(by_cost / count, by_time / count);
}

std::string table_text(const std::vector<Row>& rows) {
    std::string text =
        "sampling             samples   runs  particle-steps  engine s   error  standard error  against plain at "
        "equal\n"
        "                                                                         as stated        cost     time\n";
    for (const Row& row : rows) {
        char line[200];
        std::snprintf(line, sizeof line, "%-19s %8lld %6.0f  %14.4g %9.1f  %6.4f          %6.4f      %6.2f   %6.2f\n",
                      row.name.c_str(), static_cast<long long>(row.samples), row.runs, row.particle_steps, row.seconds,
                      row.error, row.said, row.at_equal_cost, row.at_equal_time);
        text += line;
    }
    return text;
}

/// The mark: half of plain Monte Carlo's error at equal time, with the most members.
std::string verdict(const std::vector<Row>& rows, std::int64_t samples) {
    std::string text;
    for (const Row& row : rows) {
        if (row.samples != samples || row.name == k_plain.name) continue;
        char line[160];
        std::snprintf(line, sizeof line, "%-19s %.2f of plain Monte Carlo's error at equal time: half is %s\n",
                      row.name.c_str(), row.at_equal_time, row.at_equal_time <= 0.5 ? "reached" : "not reached");
        text += line;
    }
    const auto error_of = [&](const std::string& name, std::int64_t members) {
        const auto found = std::find_if(rows.begin(), rows.end(),
                                        [&](const Row& row) { return row.name == name && row.samples == members; });
        return found == rows.end() ? 0 : found->error;
    };
    char line[200];
    std::snprintf(line, sizeof line, "sobol, %lld members: error %.4f, with polynomials %.4f; of %lld members %.4f\n",
                  static_cast<long long>(samples), error_of(k_sobol.name, samples),
                  error_of(k_sobol.with_polynomials, samples), static_cast<long long>(k_times * samples),
                  error_of(k_sobol.name, k_times * samples));
    return text + line;
}

std::string csv_text(const std::vector<Row>& rows) {
    std::string text =
        "sampling,polynomials,levels,samples,runs,particle_steps,engine_seconds,rms_error,stated_error,ratio_at_equal_"
        "cost,"
        "ratio_at_equal_time\n";
    for (const Row& row : rows)
        text += study::name_of(row.method->sampling) + "," + (row.name == row.method->name ? "0," : "1,") +
                std::to_string(row.method->levels.value_or(1)) + "," + std::to_string(row.samples) + "," +
                shortest_text(row.runs) + "," + shortest_text(row.particle_steps) + "," + shortest_text(row.seconds) +
                "," + shortest_text(row.error) + "," + shortest_text(row.said) + "," +
                shortest_text(row.at_equal_cost) + "," + shortest_text(row.at_equal_time) + "\n";
    return text;
}

render::Image picture(const std::vector<Row>& rows) {
    render::ChartPanel panel{"Error of the probabilities", "time in the engine [s]", "root mean square error [-]", {}};
    panel.x = panel.y = render::Scale::logarithmic;
    constexpr render::Stroke k_strokes[] = {render::Stroke::solid, render::Stroke::dashed, render::Stroke::dotted};
    for (const Method& method : k_methods) {
        const auto index = static_cast<std::size_t>(&method - k_methods);
        render::ChartSeries series{method.name, render::k_chart_colours[index], {}};
        series.stroke = k_strokes[method.levels.value_or(1) - 1];
        series.marker = static_cast<render::Marker>(index % 4);
        for (const Row& row : rows)
            if (row.name == method.name) series.points.push_back({row.seconds, row.error});
        panel.series.push_back(std::move(series));
    }
    return render::draw_chart({"Sampling of a study", "against a large reference", k_sampling_csv, 1, {panel}}, 1600,
                              1200);
}

}  // namespace

int bench_ensemble(const std::string& file, const boost::program_options::variables_map& values) {
    const int threads = thread_count(values);
    const bool quick = values.count("quick") > 0, quiet = values.count("quiet") > 0;
    const Extent extent = quick ? Extent{256, {16, 32}, 2} : Extent{2048, {25, 50, 100}, 4};
    RunLog log(quiet);
    study::StudyInput input = study::prepare_study(study::read_study_texts(file, {}, log), std::nullopt, log);
    if (input.reading.study.sampling == study::Sampling::table)
        throw Error(ErrorKind::input,
                    Problem{"has no distributions to draw from", input.reading.where("study.sampling"), "", "",
                            "Use a study with [vary]"});
    const auto out = bench_output(values, {k_sampling_csv, k_sampling_picture},
                                  {input.reading.study.file, input.reading.study.scene});
    const auto say = [&](const std::string& text) {
        if (!quiet) std::cerr << text << '\n';
    };
    catch_stop_signals();
    const std::int64_t seed = input.reading.study.seed;
    const Scratch scratch;
    std::vector<Row> rows;
    std::string text;
    try {
        say("reference: " + std::to_string(extent.reference) + " members ...");
        const Method sobol{"sobol", study::Sampling::sobol, {}};
        const Reference reference(input, run_study(input, sobol, extent.reference, seed, threads, scratch));
        char line[160];
        std::snprintf(line, sizeof line,
                      "%.0f probabilities between 0 and 1, %d seeds; standard error of the reference at most %.4f\n",
                      reference.places(), extent.seeds, reference.own_error());
        text = line;
        for (const Method& method : k_methods) {
            for (const std::int64_t samples : extent.samples) {
                say(std::string(method.name) + ", " + std::to_string(samples) + " samples ...");
                for (Row& row : measure(input, method, samples, extent, seed, threads, reference, scratch))
                    rows.push_back(std::move(row));
            }
        }
        const std::int64_t most = extent.samples.back(), more = k_times * most;
        say("sobol, " + std::to_string(more) + " samples ...");
        rows.push_back(measure(input, k_sobol, more, extent, seed, threads, reference, scratch).front());
    } catch (const StoppedBySignal&) {
        return static_cast<int>(ExitCode::signal) + stop_signal();
    }
    compare_with_plain(rows);
    if (out) {
        out->begin();
        write_text_file(out->path(k_sampling_csv), csv_text(rows));
        render::write_png(out->path(k_sampling_picture), picture(rows));
        out->list();
    }
    return print_bench(values, "ensemble", text + table_text(rows) + verdict(rows, extent.samples.back()),
                       {{"methods", csv_text(rows)}});
}

}  // namespace frana::app
