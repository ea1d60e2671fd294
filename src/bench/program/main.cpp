// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>

#include "app/commands/command_line.h"
#include "app/commands/run_program.h"
#include "app/input/share_directory.h"
#include "app/process/terminal.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "bench/accuracy/accuracy.h"
#include "bench/program/bench_output.h"
#include "bench/speed/speed.h"
#include "bench/stability/stability.h"
#include "core/error.h"
#include "gis/raster/raster_in.h"
#include "render/canvas/image.h"

namespace frana::app {
namespace {

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

int bench_accuracy(const Options& values) {
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
    if (out) {
        out->begin();
        write_text_file(out->path("accuracy.csv"), bench::accuracy_csv(rows));
        render::write_png(out->path("accuracy.png"), accuracy_chart(rows));
        out->list();
    }
    return print_bench(bench::accuracy_table(rows));
}

int bench_stability(const Options& values) {
    const auto out = bench_output(values, {"stability.csv"});
    bench::StabilityOptions options;
    options.only = text_options(values, "case");
    options.threads = thread_count(values);
    options.report = report_line;
    const auto rows = bench::run_stability(options);
    if (out) {
        out->begin();
        write_text_file(out->path("stability.csv"), bench::stability_csv(rows));
        out->list();
    }
    const bool passed =
        std::all_of(rows.begin(), rows.end(), [](const bench::StabilityRow& row) { return row.passed; });
    return print_bench(bench::stability_table(rows), passed);
}

int bench_speed(const Options& values) {
    const auto out = bench_output(values, {"speed.csv", "speed.png"});
    bench::SpeedOptions options;
    options.quick = values.count("quick") > 0;
    options.threads = thread_count(values);
    options.report = report_line;
    const auto result = bench::run_speed(options);
    if (out) {
        out->begin();
        write_text_file(out->path("speed.csv"), bench::speed_csv(result));
        render::write_png(out->path("speed.png"), speed_chart(result));
        out->list();
    }
    return print_bench(bench::speed_table(result), result.right());
}

int run_bench(Arguments words) {
    const auto values = parse_arguments(command_bench().form, {words.begin() + 1, words.end()});
    if (!values) return static_cast<int>(ExitCode::done);
    const auto operands = text_options(*values, "operand");
    const std::string& which = operands.front();
    if (which == "robustness" || which == "estimate" || which == "ensemble")
        throw Error(ErrorKind::input,
                    Problem{"is no longer a bench", "command line", which, "accuracy, stability, speed",
                            "`frana converge` shows what cells change, `frana ensemble` what other values do"});
    if (operands.size() > 1) {
        throw Error(ErrorKind::input,
                    Problem{"is not expected here", "command line", operands.back(), "", "See frana bench --help"});
    }
    if (which == "accuracy") return bench_accuracy(*values);
    if (which == "stability") return bench_stability(*values);
    if (which == "speed") return bench_speed(*values);
    throw Error(ErrorKind::input,
                Problem{"no such bench", "command line", which, "accuracy, stability, speed", "Give one of these"});
}

}  // namespace
}  // namespace frana::app

int main(int count, char** arguments) {
    frana::app::Arguments words{"bench"};  // as in frana's command line
    words.insert(words.end(), arguments + 1, arguments + count);
    return frana::app::run_program(words, frana::app::run_bench);
}
