// SPDX-License-Identifier: Apache-2.0
#include "bench/program/bench_output.h"

#include <algorithm>
#include <iostream>

#include "app/commands/command_line.h"
#include "app/process/terminal.h"
#include "app/store/own_files.h"
#include "app/text/text_table.h"
#include "bench/accuracy/accuracy.h"
#include "core/error.h"
#include "render/chart/chart.h"

namespace frana::app {
namespace {

constexpr Rgb k_default{0, 90, 181}, k_paper{213, 94, 0}, k_volumes{0, 130, 90};

render::ChartPanel panel_of(const std::string& title, const std::string& x_label, const std::string& y_label) {
    render::ChartPanel panel{title, x_label, y_label, {}};
    panel.x = panel.y = render::Scale::decades;
    return panel;
}

// Distinguishable without colours, too: depth by solid and dash-dotted lines, momentum by dashed and dotted ones.
render::ChartSeries series_of(const std::vector<bench::AccuracyRow>& rows, const std::string& name, Scheme scheme,
                              bool momentum) {
    struct Look {
        Rgb colour;
        render::Marker marker;
        render::Stroke depth, momentum;
    };
    using enum render::Stroke;
    const Look look = scheme == Scheme::paper           ? Look{k_paper, render::Marker::square, dash_dot, dotted}
                      : scheme == Scheme::finite_volume ? Look{k_volumes, render::Marker::triangle, solid, dashed}
                                                        : Look{k_default, render::Marker::circle, solid, dashed};
    render::ChartSeries series{
        std::string("scheme = ") + bench::name_of(scheme) + (momentum ? ", momentum" : ", depth"), look.colour, {}};
    series.marker = momentum ? render::Marker::diamond : look.marker;
    series.stroke = momentum ? look.momentum : look.depth;
    for (const bench::AccuracyRow& row : rows) {
        if (row.case_name != name || row.scheme != scheme) continue;
        const double error = momentum ? row.statistics.l1_momentum : row.statistics.l1_depth;
        // Zero except for rounding: would only stretch the axis.
        constexpr double k_nothing = 1e-18;
        if (error > k_nothing) series.points.push_back({row.statistics.cpu_seconds, error});
    }
    return series;
}

}  // namespace

render::Image accuracy_chart(const std::vector<bench::AccuracyRow>& rows) {
    render::Chart chart{
        "Error against time",
        "One point per resolution, coarse to fine; one thread. The curve of a converging scheme falls to the right.",
        "",
        5,
        {},
        true};
    for (const bench::AccuracyRow& row : rows) {
        if (!chart.panels.empty() && chart.panels.back().title == row.case_name) continue;
        render::ChartPanel panel = panel_of(row.case_name, "processor time of the engine [s]", "relative L1 error [-]");
        panel.note = "no error: exact to the last bit";
        for (const Scheme scheme : bench::k_schemes)
            for (const bool momentum : {false, true})
                panel.series.push_back(series_of(rows, row.case_name, scheme, momentum));
        chart.panels.push_back(std::move(panel));
    }
    chart.across = std::min<int>(5, static_cast<int>(chart.panels.size()));
    return render::draw_chart(chart, 2000, 1500);
}

render::Image speed_chart(const bench::SpeedResult& result) {
    render::Chart chart{"Speed of the engine",
                        "Horizontal lines: the time per particle-step does not depend on the number of particles.",
                        "",
                        2,
                        {},
                        true};
    for (const bench::SpeedRow& row : result.rows) {
        if (chart.panels.empty() || chart.panels.back().title != row.case_name)
            chart.panels.push_back(panel_of(row.case_name, "particles", "million particle-steps per second"));
        auto& lines = chart.panels.back().series;
        const std::string label = std::to_string(row.threads) + (row.threads == 1 ? " thread" : " threads");
        auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& one) { return one.label == label; });
        if (line == lines.end()) {
            const bool one = row.threads == 1;
            line = lines.insert(line, {label, one ? k_paper : k_default, {}});
            line->marker = one ? render::Marker::square : render::Marker::circle;
        }
        line->points.push_back({static_cast<double>(row.particles), row.particle_steps_per_second / 1e6});
    }
    return render::draw_chart(chart, 1600, 900);
}

namespace fs = std::filesystem;

std::optional<BenchOutput> bench_output(const Options& values, const std::vector<const char*>& names) {
    const auto folder = text_option(values, "out");
    if (!folder) return {};
    BenchOutput output(*folder, names);
    Problems problems;
    check_own(*folder, output.files(), "--out", {}, problems);
    problems.throw_if_any();
    std::error_code error;
    fs::create_directories(*folder, error);
    if (error) {
        throw Error(ErrorKind::environment,
                    Problem{"cannot be made: " + error.message(), "--out", *folder, "", "Choose another folder"});
    }
    return output;
}

int print_bench(const std::string& text, bool good) {
    std::cout << folded(text, output_width());
    return static_cast<int>(good ? ExitCode::done : ExitCode::numerical);
}

}  // namespace frana::app
