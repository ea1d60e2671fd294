// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <boost/program_options/value_semantic.hpp>
#include <filesystem>
#include <iostream>

#include "app/bench_chart.h"
#include "app/command_line.h"
#include "app/commands.h"
#include "app/manifest.h"
#include "app/own_files.h"
#include "app/replace_result.h"
#include "app/share_directory.h"
#include "app/text_file.h"
#include "bench/accuracy_report.h"
#include "bench/law_costs.h"
#include "bench/speed.h"
#include "bench/stability.h"
#include "bench/time_to_error.h"
#include "core/error.h"
#include "gis/raster_in.h"
#include "render/image.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

CommandForm bench_form() {
    namespace options = boost::program_options;
    CommandForm form{"frana bench accuracy|stability|speed [options]",
                     "Measures frana itself. accuracy: cases with exact solutions, every scheme, several "
                     "resolutions.\nstability: hard cases. speed: particle-steps a second. Prints the table; "
                     "with --out also writes\naccuracy.csv and accuracy.png, stability.csv or "
                     "speed.csv,\nspeed_stages.csv, speed_terms.csv, law_costs.csv and speed.png.\n"
                     "accuracy takes some ten minutes, with --quick under a minute.",
                     "accuracy|stability|speed",
                     {}};
    form.options.add_options()("out", options::value<std::string>(), "folder for the files")(
        "quick", "accuracy: two resolutions; speed: no more than a million particles")(
        "case", options::value<std::vector<std::string>>(),
        "accuracy, stability: only this case (may be repeated)")(
        "threads", options::value<std::string>(),
        "stability: threads of a run; speed: the most threads (default: all; accuracy always takes one)");
    return form;
}

void report_line(const std::string& line) {
    std::cerr << line << '\n';
}

// The files of a bench, and where they go.
class Output {
  public:
    explicit Output(std::string folder, const std::vector<const char*>& names) : folder_(std::move(folder)) {
        for (const char* name : names) files_.push_back(path(name));
    }
    [[nodiscard]] std::string path(const std::string& name) const { return (fs::path(folder_) / name).string(); }
    [[nodiscard]] const std::string& folder() const noexcept { return folder_; }
    [[nodiscard]] const std::vector<std::string>& files() const noexcept { return files_; }
    void begin() const { begin_own(folder_, files_); }
    void list() const { record_files(files_); }

  private:
    std::string folder_;
    std::vector<std::string> files_;
};

// Made before anything is computed, so that a bad folder costs nothing.
std::optional<Output> output_of(const boost::program_options::variables_map& values,
                                const std::vector<const char*>& names) {
    const auto folder = text_option(values, "out");
    if (!folder) return {};
    Output output(*folder, names);
    Problems problems;
    check_own(*folder, output.files(), "--out", problems);
    problems.throw_if_any();
    std::error_code failure;
    fs::create_directories(*folder, failure);
    if (failure) {
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + failure.message(), "--out", *folder,
                                                    "", "Choose another folder"});
    }
    return output;
}

// The sample's DTM beside the share folder's sources; none where only the program is installed.
std::optional<Raster> sample_terrain() {
    const fs::path file = fs::path(share_directory()) / ".." / "sample_data" / "bindo" / "dtm.tif";
    std::error_code failure;
    if (!fs::exists(file, failure)) return {};
    return gis::read_result_raster(file.lexically_normal().string());
}

int bench_accuracy(const boost::program_options::variables_map& values) {
    const auto out = output_of(values, {"accuracy.csv", "accuracy.png"});
    bench::AccuracyOptions options;
    options.quick = values.count("quick") > 0;
    options.only = text_options(values, "case");
    options.sample_terrain = sample_terrain();
    options.report = report_line;
    if (!options.sample_terrain)
        report_line(
            "lake-dtm is left out: the sample's terrain (sample_data/bindo/dtm.tif) is not beside the "
            "share folder");
    const auto rows = bench::run_accuracy(options);
    std::cout << bench::accuracy_table(rows) << bench::accuracy_verdict(rows)
              << bench::time_to_error_table(rows);
    if (out) {
        out->begin();
        write_text_file(out->path("accuracy.csv"), bench::accuracy_csv(rows));
        render::write_png(out->path("accuracy.png"), accuracy_chart(rows));
        out->list();
    }
    return static_cast<int>(ExitCode::done);
}

int bench_stability(const boost::program_options::variables_map& values) {
    const auto out = output_of(values, {"stability.csv"});
    bench::StabilityOptions options;
    options.only = text_options(values, "case");
    options.threads = thread_count(values);
    options.report = report_line;
    const auto rows = bench::run_stability(options);
    std::cout << bench::stability_table(rows);
    if (out) {
        out->begin();
        write_text_file(out->path("stability.csv"), bench::stability_csv(rows));
        out->list();
    }
    const bool passed =
        std::all_of(rows.begin(), rows.end(), [](const bench::StabilityRow& row) { return row.passed; });
    return static_cast<int>(passed ? ExitCode::done : ExitCode::numerical);
}

int bench_speed(const boost::program_options::variables_map& values) {
    const auto out = output_of(
        values, {"speed.csv", "speed_stages.csv", "speed_terms.csv", "law_costs.csv", "speed.png"});
    bench::SpeedOptions options;
    options.quick = values.count("quick") > 0;
    options.threads = thread_count(values);
    options.report = report_line;
    const auto result = bench::run_speed(options);
    report_line("cost of each law ...");
    const auto costs = bench::run_law_costs(options.quick ? 2e4 : 1e5, options.quick ? 20 : 50);
    std::cout << bench::speed_table(result) << bench::law_costs_table(costs);
    if (out) {
        out->begin();
        write_text_file(out->path("speed.csv"), bench::speed_csv(result));
        write_text_file(out->path("speed_stages.csv"), bench::speed_stages_csv(result));
        write_text_file(out->path("speed_terms.csv"), bench::speed_terms_csv(result));
        write_text_file(out->path("law_costs.csv"), bench::law_costs_csv(costs));
        render::write_png(out->path("speed.png"), speed_chart(result));
        out->list();
    }
    return static_cast<int>(result.right() ? ExitCode::done : ExitCode::numerical);
}

}  // namespace

int cmd_bench(const Arguments& arguments) {
    const auto values = parse_arguments(bench_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const std::string which = (*values)["operand"].as<std::string>();
    if (which == "accuracy") return bench_accuracy(*values);
    if (which == "stability") return bench_stability(*values);
    if (which == "speed") return bench_speed(*values);
    throw Error(ErrorKind::input, Problem{"no such bench", "command line", which,
                                          "accuracy, stability, speed", "Give one of these"});
}

}  // namespace frana::app
