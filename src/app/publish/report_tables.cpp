// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/input/transform_report.h"
#include "app/text/number_text.h"
#include "core/markup.h"
#include "params/keys/scene_parameters.h"
#include "params/scene/write_scene.h"
#include "render/chart/chart.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

/// A table of two columns or more; cells are text, numbers aligned to the right.
class Table {
  public:
    explicit Table(const std::vector<std::string>& heads = {}) {
        if (heads.empty()) return;
        rows_ += "<tr>";
        for (const std::string& head : heads) rows_ += "<th>" + escaped_markup(head) + "</th>";
        rows_ += "</tr>\n";
    }
    Table& row(const std::vector<std::string>& cells, const std::string& kind = {}) {
        rows_ += kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
        for (const std::string& cell : cells) rows_ += "<td>" + escaped_markup(cell) + "</td>";
        rows_ += "</tr>\n";
        return *this;
    }
    Table& number(const std::string& name, const std::string& value, const std::string& unit) {
        rows_ += "<tr><td>" + escaped_markup(name) + "</td><td class=\"n\">" + escaped_markup(value) + "</td><td>" +
                 escaped_markup(unit) + "</td></tr>\n";
        return *this;
    }
    Table& raw(const std::string& html) {
        rows_ += html;
        return *this;
    }
    [[nodiscard]] std::string html(const std::string& kind = {}) const {
        return (kind.empty() ? "<table>\n" : "<table class=\"" + kind + "\">\n") + rows_ + "</table>\n";
    }

  private:
    std::string rows_;
};

/// Three rows for each raster of maxima. If nothing is deeper than the threshold there is no trace.
void add_peak_statistics(Table& table, const PeakStatistics& high) {
    for (std::size_t i = 0; i < high.size(); ++i) {
        const PeakStatistic& what = k_peak_statistics[i];
        const auto row = [&](const std::string& name, double value) {
            table.number(name + what.title, std::isnan(value) ? "–" : number_text(value, 4), what.row().unit);
        };
        row("Greatest ", std::isnan(high[i].greatest) ? 0 : high[i].greatest);
        row("99.9 % of the area do not exceed: ", high[i].p999);
        row("99 % of the area do not exceed: ", high[i].p99);
    }
}

std::string signed_number_text(double value) {
    return (value > 0 ? "+" : "") + number_text(value, 3);
}

void add_statistics(Table& table, const ComparisonStatistics& f) {
    table.number("Depth that counts as covered", number_text(f.threshold_m), "m")
        .number("Observed area", grouped(f.observed_area_m2), "m²")
        .number("Simulated area", grouped(f.simulated_area_m2), "m²")
        .number("Area difference |simulated − observed| / observed", number_text(f.area_difference_percent, 3), "%")
        .number("Hit", grouped(f.hit_m2), "m²")
        .number("False alarm", grouped(f.false_alarm_m2), "m²")
        .number("Miss", grouped(f.miss_m2), "m²")
        .number("Jaccard index (critical success index), best 1", number_text(f.jaccard, 3), "")
        .number("Dice coefficient, best 1", number_text(f.dice, 3), "")
        .number("True positive rate, best 1", number_text(f.true_positive_rate, 3), "")
        .number("False positive rate, best 0", number_text(f.false_positive_rate, 3), "")
        .number("Distance to perfect classification, best 0", number_text(f.d2pc, 3), "")
        .number("Area under the ROC curve, best 1", number_text(f.auroc, 3), "");
}

/// Returns one panel, as wide as the page's text.
std::string line_chart(const std::string& x_label, const std::string& y_label, std::vector<render::ChartSeries> series,
                       render::Scale x = render::Scale::linear) {
    constexpr int k_width = 560, k_height = 240;
    render::ChartPanel panel{"", x_label, y_label, std::move(series), {0}};
    panel.x = x;
    for (render::ChartSeries& one : panel.series) one.width_px = 3;
    return render::chart_svg({"", "", "", 1, {std::move(panel)}}, k_width, k_height);
}

std::string curve_chart(const std::vector<ComparisonStatistics>& curve) {
    render::ChartSeries jaccard{"Jaccard", render::k_chart_colours[0], {}},
        hit{"true positive rate", render::k_chart_colours[2], {}},
        alarm{"false positive rate", render::k_chart_colours[1], {}};
    for (const ComparisonStatistics& f : curve) {
        jaccard.points.push_back({f.threshold_m, f.jaccard});
        hit.points.push_back({f.threshold_m, f.true_positive_rate});
        alarm.points.push_back({f.threshold_m, f.false_positive_rate});
    }
    return line_chart("depth threshold [m]", "score", {jaccard, hit, alarm}, render::Scale::logarithmic);
}

/// The separate flows of a result, if it has several.
std::string flows_table(const std::vector<Runout>& run_outs) {
    constexpr std::size_t k_most = 20;  // of hundreds, summary.json has the rest
    if (run_outs.size() < 2) return "";
    Table table({"Flow", "Run-out [m]", "Drop [m]", "Angle of reach [°]", "Area [m²]", "From", "To"});
    const auto place = [](Point p) { return number_text(p.x, 9) + ", " + number_text(p.y, 9); };
    for (std::size_t i = 0; i < std::min(run_outs.size(), k_most); ++i) {
        const Runout& one = run_outs[i];
        table.row({std::to_string(i + 1), grouped(one.horizontal_m), grouped(one.drop_m),
                   number_text(one.reach_angle_deg, 3), grouped(one.covered_area_m2), place(one.top), place(one.tip)});
    }
    return "<p>" + std::to_string(run_outs.size()) +
           " flows never met. Run-out, drop and angle of reach above are those of the longest" +
           (run_outs.size() > k_most ? "; the table has the " + std::to_string(k_most) + " longest" : "") + ".</p>\n" +
           table.html();
}

std::string operation(const gis::TransformInfo& transform) {
    const std::string text = transform_text(transform);
    return text == "none" ? "none needed" : text + "; accuracy " + accuracy_text(transform);
}

}  // namespace

std::string results_table(const ReportInput& input) {
    const RunResult& r = input.result;
    const SummaryFacts& f = input.facts;
    Table table;
    add_peak_statistics(table, f.high);
    table
        .number("Area deeper than " + number_text(input.prepared.spec.output.trace_threshold) + " m at any time",
                grouped(f.statistics.covered_area_m2), "m²")
        .number("Run-out, straight in map view", grouped(f.statistics.run_out().horizontal_m), "m")
        .number("Drop", grouped(f.statistics.run_out().drop_m), "m")
        .number("Angle of reach", number_text(f.statistics.run_out().reach_angle_deg, 3), "°")
        .number("Simulated time (" + std::string(describe(r.stop_reason)) + ")", number_text(r.simulated_seconds, 4),
                "s");
    return table.html() +
           "<p class=\"small\">The greatest value is that of a single cell; the 99.9 % and 99 % values are over the "
           "area deeper than " +
           escaped_markup(number_text(input.prepared.spec.output.trace_threshold)) +
           " m, with the maximum over time in each cell.</p>\n" + flows_table(f.statistics.run_outs);
}

std::string ground_table(const SummaryFacts& facts) {
    Table table({"", "lowest [m]", "highest [m]", "mean slope [°]", "steepest slope [°]"});
    const auto row = [&](const char* where, const std::optional<GroundStatistics>& ground) {
        if (!ground) return;
        table.row({where, number_text(ground->lowest, 5), number_text(ground->highest, 5),
                   number_text(ground->mean_slope_deg, 3), number_text(ground->steepest_slope_deg, 3)});
    };
    row("Release", facts.release_ground);
    row("Path", facts.path_ground);
    return table.html();
}

std::string budget_table(const RunResult& r) {
    Table table;
    table.number("Released, at the start and later", grouped(r.volume_entered - r.volume_inflow), "m³");
    if (r.volume_inflow > 0) table.number("Inflow", grouped(r.volume_inflow), "m³");
    if (r.exchanges)
        table.number("Eroded from the bed", grouped(r.volume_eroded), "m³")
            .number("Deposited on the bed", grouped(r.volume_deposited), "m³");
    if (r.phases)
        table
            .number("Solids: came in, inside at the end, left",
                    grouped(r.phases->entered.solids) + ", " + grouped(r.phases->inside.solids) + ", " +
                        grouped(r.phases->left.solids),
                    "m³")
            .number("Confined water: came in, released, inside at the end, left",
                    grouped(r.phases->entered.confined) + ", " + grouped(r.phases->released) + ", " +
                        grouped(r.phases->inside.confined) + ", " + grouped(r.phases->left.confined),
                    "m³")
            .number("Free water: came in, inside at the end, left",
                    grouped(r.phases->entered.free) + ", " + grouped(r.phases->inside.free) + ", " +
                        grouped(r.phases->left.free),
                    "m³")
            .number("Cohesion left, mean of the solids inside", number_text(r.phases->cohesion_left, 3), "of 1");
    return table.number("Inside at the end", grouped(r.volume_final), "m³")
        .number("Left the computed ground", grouped(r.volume_left), "m³")
        .number("Budget error", number_text(relative_volume_error(r), 2), "of all volume that came in")
        .html();
}

std::string numerics_table(const ReportInput& input) {
    const RunResult& r = input.result;
    const GridSpec& grid = input.prepared.scene.grid;
    const HardEvents& e = r.hard_events;
    std::string terms;
    for (const std::string& term : r.terms) terms += (terms.empty() ? "" : "; ") + term;
    return Table()
               .number("Cells", grouped(grid.columns) + " × " + grouped(grid.rows),
                       "of " + number_text(grid.cell_size) + " m")
               .number(
                   "Particles: start, end, peak",
                   grouped(r.particles_initial) + ", " + grouped(r.particles_final) + ", " + grouped(r.particles_peak),
                   "")
               .number("Time steps", grouped(r.steps), "")
               .number("Non-finite particles", grouped(e.non_finite), "0 in a good run")
               .number("Depths clamped", grouped(e.depth_clamped), "0 in a good run")
               .number("Particles over ground without elevation", grouped(e.entered_no_data), "0 in a good run")
               .number("Speeds above what the fall allows", grouped(e.impossible_speed), "0 in a good run")
               .number("Steps with a volume error", grouped(e.volume_drift), "0 in a good run")
               .html() +
           "<p class=\"small\">Computed: " + escaped_markup(terms) + "</p>\n";
}

std::string accuracy_tables(const AccuracyRecord& record) {
    Table levels({"cells [m]", "particles", "steps", "time [s]", ""});
    for (const AccuracyLevel& level : record.levels) {
        levels.row({number_text(level.cell_size), grouped(level.particles), grouped(level.steps),
                    number_text(level.wall_seconds, 3), level.problem});
    }
    Table values({"value", "", "estimated error", "trend", "claimed"});
    for (const ValueEstimate& e : value_estimates(record)) {
        values.row({e.value.title, number_text(e.value.value) + " " + e.value.unit,
                    number_text(e.error, 2) + " " + e.value.unit +
                        (e.value.value != 0 ? " (" + number_text(e.percent(), 2) + " %)" : ""),
                    describe(e.convergence.trend),
                    e.is_zero       ? "zero on all levels"
                    : e.is_within() ? "yes"
                                    : "no"});
    }
    return "<p>" + escaped_markup(accuracy_verdict(record)) + ".</p>\n" + values.html() + "<h3>Levels computed</h3>\n" +
           levels.html();
}

std::string release_table(const RunResult& result) {
    Table table({"", "name", "start [s]", "area [m²]", "volume [m³]"});
    for (std::size_t i = 0; i < result.released.size(); ++i) {
        const ReleasedArea& area = result.released[i];
        table.row({std::to_string(i + 1), area.name.empty() ? "–" : area.name, number_text(area.start, 4),
                   grouped(area.area), grouped(area.volume)});
    }
    return table.html();
}

std::string hazard_table(const SceneSpec& spec, const std::vector<HazardArea>& areas) {
    Table table({"class", "", "thresholds", "area [m²]"});
    for (const HazardArea& area : areas) {
        table.raw("<tr><td>" + std::to_string(area.kind.value) +
                  "</td><td><span class=\"swatch\" style=\"background:" + hex(area.kind.colour) + "\"></span> " +
                  (area.kind.name == area.kind.thresholds ? "" : escaped_markup(area.kind.name)) + "</td><td>" +
                  escaped_markup(area.kind.thresholds) + "</td><td class=\"n\">" + grouped(area.area_m2) +
                  "</td></tr>\n");
    }
    return "<p>Scheme " + escaped_markup(*spec.hazard.scheme) + ", after " +
           escaped_markup(hazard_scheme_of(spec.hazard)->source) +
           ". This is the intensity of one scenario; a hazard level also depends on its frequency.</p>\n" +
           table.html();
}

std::string series_charts(const ReportInput& input) {
    const std::string seconds = "time [s]";
    std::string charts;
    const auto add = [&](const char* label, std::size_t colour, double SeriesRow::*value) {
        render::ChartSeries series{"", render::k_chart_colours[colour], {}};
        for (const SeriesRow& row : input.result.series) series.points.push_back({row.time, row.*value});
        charts += line_chart(seconds, label, {series});
    };
    add("front from the release [m]", 0, &SeriesRow::front_distance);
    add("greatest speed [m/s]", 1, &SeriesRow::max_speed);
    add("greatest depth [m]", 2, &SeriesRow::max_depth);
    const auto named = [](const auto& places) {
        std::vector<render::ChartSeries> series;
        for (const auto& place : places)
            series.push_back(
                {place.name, render::k_chart_colours[series.size() % std::size(render::k_chart_colours)], {}});
        return series;
    };
    const Recording& recording = input.prepared.scene.recording;
    std::vector<render::ChartSeries> gauges = named(recording.gauges), sections = named(recording.sections);
    for (const GaugeRow& row : input.result.gauges) gauges[row.gauge].points.push_back({row.time, row.depth});
    for (const SectionRow& row : input.result.sections)
        sections[row.section].points.push_back({row.time, row.discharge});
    if (!gauges.empty()) charts += "<h3>Gauges</h3>\n" + line_chart(seconds, "depth [m]", gauges);
    if (!sections.empty()) charts += "<h3>Cross-sections</h3>\n" + line_chart(seconds, "discharge [m³/s]", sections);
    return charts;
}

std::string comparison_tables(const Comparison& c) {
    Table table;
    if (c.statistics) add_statistics(table, *c.statistics);
    if (c.outline) {
        table.number("Distance of the outlines, mean", number_text(c.outline->mean_m, 3), "m")
            .number("Distance of the outlines, 95 %", number_text(c.outline->percentile_95_m, 3), "m")
            .number("Distance of the outlines, greatest (Hausdorff)", number_text(c.outline->hausdorff_m, 3), "m");
    }
    if (c.runout_difference_m)
        table.number("Run-out, simulated minus observed, straight", signed_number_text(*c.runout_difference_m), "m");
    if (c.path_runout) {
        table.number("Run-out along the flow path, simulated", grouped(c.path_runout->simulated_m), "m")
            .number("Run-out along the flow path, observed", grouped(c.path_runout->observed_m), "m");
    }
    for (const FrontComparison& front : c.fronts) {
        table
            .number("Front " + front.name + ": mean distance, + beyond, − short", signed_number_text(front.mean_m), "m")
            .number("Front " + front.name + ": reached", number_text(front.reached_percent, 3), "% of its length");
    }
    for (const TipComparison& tip : c.tips)
        table.number("Tip " + tip.name + ": distance, + beyond, − short", signed_number_text(tip.distance_m), "m");
    std::string html = table.html();
    if (!c.curve.empty()) html += "<h3>Scores over the depth threshold</h3>\n" + curve_chart(c.curve);
    if (c.deposit_overlap) {
        Table deposit;
        add_statistics(deposit, *c.deposit_overlap);
        if (const auto& d = c.deposit_depth) {
            deposit.number("Volume of the deposit, observed", grouped(d->observed_volume_m3), "m³")
                .number("Volume of the deposit, simulated", grouped(d->simulated_volume_m3), "m³")
                .number("Mean error of depth", signed_number_text(d->bias_m), "m")
                .number("Mean absolute error of depth", number_text(d->mean_absolute_error_m, 3), "m")
                .number("Root mean square error of depth", number_text(d->rmse_m, 3), "m")
                .number("Correlation of the depths", number_text(d->correlation, 3), "");
        }
        html += "<h3>Deposit</h3>\n" + deposit.html();
    }
    return html;
}

std::string inputs_table(const Prepared& p) {
    Table table({"input", "file", "content", "CRS", "operation to the working CRS"});
    for (const UsedFile& file : p.files) {
        table.row({file.role + (file.resampling.empty() ? "" : " (" + file.resampling + ")"), file.path, file.content,
                   file.crs_label, file.crs_label.empty() ? "" : operation(file.transform)});
    }
    return "<p>Working CRS: " + escaped_markup(p.ground.crs_label) + "; extent " +
           escaped_markup(extent_text(p.scene.grid.bounds())) + "; " + grouped(p.ground.nodata_cells) +
           " cells without elevation" +
           (p.ground.filled_cells > 0 ? ", " + grouped(p.ground.filled_cells) + " filled" : "") + ".</p>\n" +
           table.html();
}

std::string parameters_table(const Prepared& p) {
    Table table({"key", "value", "unit", "origin", "meaning"});
    for (const Parameter& parameter : scene_parameters()) {
        const std::string name = parameter.name();
        const Origin origin = p.spec.origin_of(name);
        std::string value = parameter.write(p.spec).value_or("");
        if (value.empty()) value = "(" + parameter.absent + ")";
        const auto chosen = p.resolved.find(name);
        if (chosen != p.resolved.end() && chosen->second != value) value += " → " + chosen->second;
        table.row({name, value, parameter.unit, describe(origin), parameter.meaning},
                  origin == Origin::default_value ? "" : "given");
    }
    return table.html("keys");
}

}  // namespace frana::app
