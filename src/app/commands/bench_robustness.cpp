// SPDX-License-Identifier: Apache-2.0
#include "app/commands/bench_robustness.h"

#include <algorithm>
#include <iostream>

#include "app/commands/bench_output.h"
#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/scene_variants.h"
#include "app/process/signals.h"
#include "app/store/scene_identity.h"
#include "app/text/text_file.h"
#include "bench/stability/robustness.h"
#include "core/error.h"

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

}  // namespace

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

}  // namespace frana::app
