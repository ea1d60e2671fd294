// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <boost/program_options/variables_map.hpp>
#include <filesystem>
#include <iostream>
#include <string>

#include "app/commands/command_line.h"
#include "app/commands/run_program.h"
#include "app/commands/scene_variants.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/store/scene_identity.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "bench/accuracy/accuracy.h"
#include "bench/program/bench_output.h"
#include "bench/speed/law_costs.h"
#include "bench/speed/speed.h"
#include "bench/stability/robustness.h"
#include "bench/stability/stability.h"
#include "core/error.h"
#include "gis/raster/raster_in.h"
#include "render/canvas/image.h"

namespace frana::app {
namespace {

constexpr const char *k_robustness_csv = "robustness.csv", *k_robustness_json = "robustness.json";

std::uint64_t seed_of(const boost::program_options::variables_map& values) {
    const std::string text = text_option(values, "seed").value_or("1");
    const auto seed = integer_from_text(text);
    if (!seed || *seed < 0)
        throw Error(ErrorKind::input, Problem{"is not a seed", "--seed", text, "a whole number, 0 or more", ""});
    return static_cast<std::uint64_t>(*seed);
}

/// Runs `frana bench robustness SCENE.ini`: prints the table and writes robustness.csv and robustness.json to --out.
/// Returns the exit code: numerical if a run ended early. Throws Error.
int bench_robustness(const std::string& scene, const boost::program_options::variables_map& values) {
    const bool quiet = values.count("quiet") > 0;
    bench::RobustnessOptions options;
    options.seed = seed_of(values);
    options.only = text_options(values, "case");
    SceneVariants variants(scene, text_options(values, "set"), thread_count(values), quiet);
    const SceneSpec spec = variants.read({}).spec;
    const auto out = bench_output(values, {k_robustness_csv, k_robustness_json}, input_files(spec));
    options.threshold = spec.output.trace_threshold;
    options.scene = [&](const std::vector<std::string>& overrides) { return variants.read(overrides).scene; };
    options.run = [&](const Scene& changed) { return variants.run(changed); };
    options.report = [&](const std::string& line) {
        if (!quiet) std::cerr << line << '\n';
    };
    catch_stop_signals();
    const auto rows = bench::run_robustness(options);
    if (stop_signal() != 0) return static_cast<int>(ExitCode::signal) + stop_signal();
    if (out) {
        out->begin();
        write_text_file(out->path(k_robustness_csv), bench::robustness_csv(rows));
        write_text_file(out->path(k_robustness_json), bench::robustness_json(rows, options, spec.file));
        out->list();
    }
    const bool whole =
        std::all_of(rows.begin(), rows.end(), [](const bench::RobustnessRow& row) { return row.run_problem.empty(); });
    return print_bench(values, "robustness", bench::robustness_table(rows), {{"cases", bench::robustness_csv(rows)}},
                       whole);
}

namespace fs = std::filesystem;

void report_line(const std::string& line) {
    std::cerr << folded(line + '\n', output_width());
}

// Returns the sample's DTM; none if the samples are not installed.
std::optional<Raster> sample_terrain() {
    const fs::path file = fs::path(share_directory()) / "sample_data" / "bindo" / "dtm.tif";
    std::error_code error;
    if (!fs::exists(file, error)) return {};
    return gis::read_result_raster(file.lexically_normal().string());
}

int bench_accuracy(const boost::program_options::variables_map& values) {
    const auto out = bench_output(values, {"accuracy.csv", "accuracy.png"});
    bench::AccuracyOptions options;
    options.quick = values.count("quick") > 0;
    options.only = text_options(values, "case");
    options.sample_terrain = sample_terrain();
    options.report = report_line;
    if (!options.sample_terrain)
        report_line(
            "lake-dtm is left out: the sample's terrain (sample_data/bindo/dtm.tif) is not in the "
            "share folder");
    const auto rows = bench::run_accuracy(options);
    const std::string csv = bench::accuracy_csv(rows);
    if (out) {
        out->begin();
        write_text_file(out->path("accuracy.csv"), csv);
        render::write_png(out->path("accuracy.png"), accuracy_chart(rows));
        out->list();
    }
    return print_bench(values, "accuracy",
                       bench::accuracy_table(rows) + bench::accuracy_verdict(rows) + bench::time_to_error_table(rows),
                       {{"cases", csv}});
}

int bench_stability(const boost::program_options::variables_map& values) {
    const auto out = bench_output(values, {"stability.csv"});
    bench::StabilityOptions options;
    options.only = text_options(values, "case");
    options.threads = thread_count(values);
    options.report = report_line;
    const auto rows = bench::run_stability(options);
    const std::string csv = bench::stability_csv(rows);
    if (out) {
        out->begin();
        write_text_file(out->path("stability.csv"), csv);
        out->list();
    }
    const bool passed =
        std::all_of(rows.begin(), rows.end(), [](const bench::StabilityRow& row) { return row.passed; });
    return print_bench(values, "stability", bench::stability_table(rows), {{"cases", csv}}, passed);
}

int bench_speed(const boost::program_options::variables_map& values) {
    const auto out =
        bench_output(values, {"speed.csv", "speed_stages.csv", "speed_terms.csv", "law_costs.csv", "speed.png"});
    bench::SpeedOptions options;
    options.quick = values.count("quick") > 0;
    options.threads = thread_count(values);
    options.report = report_line;
    const auto result = bench::run_speed(options);
    report_line("cost of each law ...");
    const auto costs = bench::run_law_costs(options.quick ? 2e4 : 1e5, options.quick ? 20 : 50);
    const std::vector<BenchTable> tables{{"speed", bench::speed_csv(result)},
                                         {"speed_stages", bench::speed_stages_csv(result)},
                                         {"speed_terms", bench::speed_terms_csv(result)},
                                         {"law_costs", bench::law_costs_csv(costs)}};
    if (out) {
        out->begin();
        for (const BenchTable& table : tables) write_text_file(out->path(table.name + ".csv"), table.csv);
        render::write_png(out->path("speed.png"), speed_chart(result));
        out->list();
    }
    return print_bench(values, "speed", bench::speed_table(result) + bench::law_costs_table(costs), tables,
                       result.right());
}

int run_bench(Arguments words) {
    const auto values = parse_arguments(bench_form(), {words.begin() + 1, words.end()});
    if (!values) return static_cast<int>(ExitCode::done);
    const auto operands = text_options(*values, "operand");
    const std::string& which = operands.front();
    const bool needs_scene = which == "robustness";
    if (operands.size() > (needs_scene ? 2U : 1U)) {
        throw Error(ErrorKind::input,
                    Problem{"is not expected here", "command line", operands.back(), "", "See frana bench --help"});
    }
    if (which == "accuracy") return bench_accuracy(*values);
    if (which == "stability") return bench_stability(*values);
    if (which == "speed") return bench_speed(*values);
    if (!needs_scene) {
        throw Error(ErrorKind::input, Problem{"no such bench", "command line", which,
                                              "accuracy, stability, speed, robustness", "Give one of these"});
    }
    if (operands.size() < 2) {
        throw Error(ErrorKind::input,
                    Problem{"SCENE.ini is missing", "command line", "", "", "See frana bench --help"});
    }
    return bench_robustness(operands.back(), *values);
}

}  // namespace
}  // namespace frana::app

int main(int count, char** arguments) {
    frana::app::Arguments words{"bench"};  // as in frana's command line
    words.insert(words.end(), arguments + 1, arguments + count);
    return frana::app::run_program(words, frana::app::run_bench);
}
