// SPDX-License-Identifier: Apache-2.0
#include "app/compare/comparison.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/runout.h"
#include "analysis/trace.h"
#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/geometry.h"
#include "core/json.h"
#include "core/text.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

/// The flows of a result and a survey together, on the same cells, and which of them is compared: that with the longest
/// observed run-out, or the longest simulated one if nothing was observed.
struct ComparedFlow {
    Raster trace;     ///< simulated, of this flow alone
    Raster observed;  ///< of this flow alone
    Runout simulated_end, observed_end;
};

/// Returns the cells of a mask that belong to one flow.
Raster part_of_flow(const Raster& mask, const SeparateFlows& flows, std::size_t flow) {
    Raster part(mask.grid);
    mask.values.for_each_stored([&](std::size_t cell, double inside) {
        if (inside != 0 && flows.flow_of(cell) == flow) part.values[cell] = inside;
    });
    return part;
}

ComparedFlow compared_flow(const ComparisonInput& input, const Raster& observed) {
    const Raster trace = trace_mask(input.depth, input.threshold);
    Raster reached = input.depth;
    observed.values.for_each_stored([&](std::size_t cell, double inside) {
        if (inside != 0 && !(reached.values[cell] > 0)) reached.values[cell] = inside;
    });
    const SeparateFlows flows(*input.release, reached, input.inflows);
    if (flows.count() == 0)
        throw Error(ErrorKind::input, Problem{"nothing is released and nothing flows", "run-out", "", "", ""});
    const std::vector<Runout> simulated = runouts_by_flow(flows, *input.bed, *input.release, trace),
                              surveyed = runouts_by_flow(flows, *input.bed, *input.release, observed);
    std::size_t chosen = 0;
    const auto lengths = [&](std::size_t flow) {
        return std::pair{surveyed[flow].horizontal_m, simulated[flow].horizontal_m};
    };
    for (std::size_t flow = 1; flow < flows.count(); ++flow)
        if (lengths(flow) > lengths(chosen)) chosen = flow;
    return {part_of_flow(trace, flows, chosen), part_of_flow(observed, flows, chosen), simulated[chosen],
            surveyed[chosen]};
}

/// Computes both run-outs on one path: that of the simulated flow, extended to the farthest cell of trace and survey.
PathRunout path_runout(const ComparisonInput& input, const ComparedFlow& flow) {
    const Runout& farthest =
        flow.observed_end.horizontal_m > flow.simulated_end.horizontal_m ? flow.observed_end : flow.simulated_end;
    Raster depth = input.depth;
    flow.observed.values.for_each_stored([&](std::size_t cell, double inside) {
        // A path over surveyed area without flow is preferred to one over area outside both.
        if (inside != 0 && !(input.depth.values[cell] > input.threshold)) depth.values[cell] = input.threshold;
    });
    const Polyline path = flow_path(depth, farthest.top, farthest.tip);
    return {runout_along(path, flow.trace), runout_along(path, flow.observed)};
}

void compare_run_outs(const ComparisonInput& input, const Raster& observed, Comparison& comparison) {
    if (!input.bed || !input.release) return;
    if (!observed.grid.same_cells(input.bed->grid)) {
        comparison.warnings.push_back(
            worded("survey beyond the rasters: no run-out difference; set output.extent = map"));
        return;
    }
    const ComparedFlow flow = compared_flow(input, observed);
    comparison.runout_difference_m = flow.simulated_end.horizontal_m - flow.observed_end.horizontal_m;
    if (maximum(flow.trace) > 0) comparison.path_runout = path_runout(input, flow);
}

FrontComparison compare_front(const gis::NamedLine& front, const LineSet& outline, const InsideTest& inside_trace,
                              double spacing) {
    FrontComparison result;
    result.name = front.name;
    std::vector<double> distances;
    double inside = 0;
    const std::vector<Point> samples = LineSet({front.line}).samples(spacing);
    for (const Point& point : samples) {
        const bool reached = inside_trace(point);
        distances.push_back(outline.distance(point) * (reached ? 1 : -1));
        result.mean_m += distances.back() / static_cast<double>(samples.size());
        inside += reached;
    }
    result.reached_percent = 100 * inside / static_cast<double>(samples.size());
    result.size = distance_statistics(std::move(distances));
    return result;
}

void compare_fronts_and_tips(const ComparisonInput& input, Comparison& comparison) {
    const Survey& survey = input.survey;
    if (survey.fronts.empty() && survey.tips.empty()) return;
    const MultiPolygon trace = gis::polygonise(trace_mask(input.depth, input.threshold));
    if (trace.empty()) {
        comparison.warnings.push_back(
            worded("nothing is deeper than {1} m: no front to compare", {numeral(number_text(input.threshold))}));
        return;
    }
    const LineSet outline(trace);
    const InsideTest inside_trace(trace);
    for (const gis::NamedLine& front : survey.fronts)
        comparison.fronts.push_back(compare_front(front, outline, inside_trace, input.depth.grid.cell_size));
    for (const gis::NamedPoint& tip : survey.tips)
        comparison.tips.push_back({tip.name, outline.distance(tip.place) * (inside_trace(tip.place) ? 1 : -1)});
}

void compare_area(const ComparisonInput& input, const Raster& depth, Comparison& comparison) {
    const Raster observed = gis::coverage(input.survey.scar, depth.grid);
    comparison.statistics = compare(depth, observed, input.threshold);
    comparison.curve = score_curve(depth, observed);
    comparison.classes = agreement(depth, observed, input.threshold);
    compare_run_outs(input, observed, comparison);
    const MultiPolygon trace = gis::polygonise(trace_mask(input.depth, input.threshold));
    if (!trace.empty()) {
        comparison.outline = distance_between(LineSet(trace), LineSet(input.survey.scar), input.depth.grid.cell_size);
    }
}

void compare_deposits(const ComparisonInput& input, const Bounds& box, Comparison& comparison) {
    const Survey& survey = input.survey;
    if (survey.deposit.empty() && !survey.elevation_change) return;
    if (!(survey.deposit.empty() ? input.elevation_change : input.final_depth)) {
        comparison.warnings.push_back(worded("no depth at the end to compare with the deposit"));
        return;
    }
    if (!survey.deposit.empty()) {
        const Raster depth = padded_to(*input.final_depth, box, k_no_data);
        comparison.deposit_overlap = compare(depth, gis::coverage(survey.deposit, depth.grid), input.threshold);
    } else {
        comparison.deposit_overlap =
            compare(*input.elevation_change, trace_mask(*survey.elevation_change, input.threshold), input.threshold);
        comparison.deposit_depth = compare_deposit(*input.elevation_change, *survey.elevation_change, input.threshold);
    }
}

}  // namespace

Comparison compare_with_survey(const ComparisonInput& input) {
    Comparison comparison;
    const Bounds box = input.survey.box().value_or(input.depth.grid.bounds());
    if (!input.survey.scar.empty()) {
        const Raster depth = padded_to(input.depth, bounds(input.survey.scar), k_no_data);
        if (!depth.grid.same_cells(input.depth.grid))
            comparison.warnings.push_back(worded("survey beyond the rasters: its part outside counts as missed"));
        compare_area(input, depth, comparison);
    }
    compare_fronts_and_tips(input, comparison);
    compare_deposits(input, box, comparison);
    return comparison;
}

std::string comparison_headline(const Comparison& comparison) {
    std::string text;
    if (comparison.statistics) {
        text = "the area differs from the surveyed one by " +
               signed_number_text(comparison.statistics->signed_area_difference_percent()) + " %, Jaccard " +
               number_text(comparison.statistics->jaccard, 3);
    }
    for (const FrontComparison& front : comparison.fronts)
        text += (text.empty() ? "" : "; ") + std::string("front ") + front.name + ": " + number_text(front.mean_m, 3) +
                " m on average";
    for (const TipComparison& tip : comparison.tips)
        text +=
            (text.empty() ? "" : "; ") + std::string("tip ") + tip.name + ": " + number_text(tip.distance_m, 3) + " m";
    if (comparison.deposit_overlap)
        text += (text.empty() ? "" : "; ") + std::string("deposit: Jaccard ") +
                number_text(comparison.deposit_overlap->jaccard, 3);
    return text;
}

namespace {

namespace fs = std::filesystem;

constexpr const char* k_name = "comparison";  // of the raster's row and of the picture

std::string raster_file() {
    return std::string(k_name) + ".tif";
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw Error(ErrorKind::environment,
                    Problem{"cannot be made: " + error.message(), folder.string(), "", "", "Check the rights"});
}

struct ClassText {
    Agreement kind;
    const char *name, *meaning;
    Rgb colour;

    [[nodiscard]] std::string label() const { return std::string(name) + ": " + meaning; }
};

// Bluish green, orange and a dark blue: distinguishable for the colour-blind, and by lightness if printed without
// colours.
constexpr ClassText k_classes[] = {
    {Agreement::hit, worded("Hit"), worded("simulated and observed"), {0, 158, 115}},
    {Agreement::false_alarm, worded("False alarm"), worded("simulated only"), {240, 180, 50}},
    {Agreement::miss, worded("Miss"), worded("observed only"), {40, 50, 140}}};

/// Names and values of a comparison, in the order of the file.
std::vector<std::pair<const char*, double>> named(const ComparisonStatistics& f) {
    return {{"observed_area_m2", f.observed_area_m2},
            {"simulated_area_m2", f.simulated_area_m2},
            {"area_difference_percent", f.area_difference_percent},
            {"hit_m2", f.hit_m2},
            {"false_alarm_m2", f.false_alarm_m2},
            {"miss_m2", f.miss_m2},
            {"jaccard", f.jaccard},
            {"dice", f.dice},
            {"csi", f.csi},
            {"true_positive_rate", f.true_positive_rate},
            {"false_positive_rate", f.false_positive_rate},
            {"d2pc", f.d2pc},
            {"auroc", f.auroc}};
}

void add_statistics(Json& json, const std::optional<ComparisonStatistics>& statistics) {
    for (const auto& [name, value] : named(statistics.value_or(ComparisonStatistics{})))
        json[name] = statistics ? Json(value) : Json();
}

void add_distance(Json& json, const LineDistance& distance) {
    json["mean_m"] = distance.mean_m;
    json["percentile_95_m"] = distance.percentile_95_m;
    json["hausdorff_m"] = distance.hausdorff_m;
}

void add_runouts(Json& json, const Comparison& comparison) {
    const auto& difference = comparison.runout_difference_m;
    json["runout_difference_m"] = difference ? Json(*difference) : Json();
    if (const auto& path = comparison.path_runout)
        json["runout_along_path"] = {{"simulated_m", path->simulated_m},
                                     {"observed_m", path->observed_m},
                                     {"difference_m", path->simulated_m - path->observed_m}};
}

void add_fronts(Json& json, const Comparison& comparison) {
    for (const FrontComparison& front : comparison.fronts) {
        Json one{{"name", front.name}, {"mean_signed_m", front.mean_m}};
        add_distance(one, front.size);
        one["reached_percent"] = front.reached_percent;
        json["fronts"].push_back(std::move(one));
    }
    for (const TipComparison& tip : comparison.tips)
        json["tips"].push_back({{"name", tip.name}, {"distance_m", tip.distance_m}});
}

void add_deposit(Json& json, const Comparison& comparison, const Survey& survey) {
    if (!comparison.deposit_overlap) return;
    Json& deposit = json["deposit"] = {{"observed", survey.deposit_label}};
    add_statistics(deposit, comparison.deposit_overlap);
    if (const auto& depth = comparison.deposit_depth)
        deposit["depth_error"] = {{"area_m2", depth->area_m2},
                                  {"observed_volume_m3", depth->observed_volume_m3},
                                  {"simulated_volume_m3", depth->simulated_volume_m3},
                                  {"bias_m", depth->bias_m},
                                  {"mean_absolute_error_m", depth->mean_absolute_error_m},
                                  {"rmse_m", depth->rmse_m},
                                  {"correlation", depth->correlation},
                                  {"observed_raised_m3", depth->observed_raised_m3},
                                  {"observed_lowered_m3", depth->observed_lowered_m3},
                                  {"simulated_raised_m3", depth->simulated_raised_m3},
                                  {"simulated_lowered_m3", depth->simulated_lowered_m3},
                                  {"simulated_raised_beyond_m3", depth->simulated_raised_beyond_m3},
                                  {"change_rmse_m", depth->change_rmse_m}};
}

}  // namespace

std::string comparison_stem(const std::string& folder) {
    return (fs::path(folder) / k_name).string();
}

std::string comparison_json(const Comparison& comparison, const ComparisonInput& input) {
    const Survey& survey = input.survey;
    Json json{{"program", k_program},
              {"version", k_version},
              {"simulated", input.depth_label},
              {"observed", survey.scar.empty() ? survey.front_label : survey.scar_label},
              {"cell_size", input.depth.grid.cell_size},
              {"threshold_m", input.threshold}};
    add_statistics(json, comparison.statistics);
    add_runouts(json, comparison);
    if (comparison.outline) add_distance(json["outline_distance"], *comparison.outline);
    add_fronts(json, comparison);
    add_deposit(json, comparison, survey);
    json["warnings"] = texts_of(comparison.warnings);
    json["negatives"] = "true negatives are five times the observed area minus the false alarms";
    return json_text(json);
}

std::string comparison_curve_csv(const Comparison& comparison) {
    std::vector<std::string> cells{"threshold_m"};
    for (const auto& [name, value] : named({})) cells.emplace_back(name);
    std::string text = csv_line(cells);
    for (const ComparisonStatistics& statistics : comparison.curve) {
        cells = {shortest_text(statistics.threshold_m)};
        for (const auto& [name, value] : named(statistics)) cells.push_back(shortest_text(value));
        text += csv_line(cells);
    }
    return text;
}

void write_comparison(const Comparison& comparison, const ComparisonInput& input, const std::string& folder) {
    const fs::path place = folder;
    write_text_file((place / k_comparison_file).string(), comparison_json(comparison, input));
    if (!comparison.statistics) return;
    write_text_file((place / k_comparison_curve).string(), comparison_curve_csv(comparison));
    std::vector<gis::ClassEntry> classes;
    std::vector<gis::ColourStop> stops;
    for (const ClassText& entry : k_classes) {
        classes.push_back({static_cast<std::uint8_t>(entry.kind), entry.label(), entry.colour});
        stops.push_back({static_cast<double>(entry.kind), entry.colour, class_label(entry.label(), input.words)});
    }
    const std::string raster = (place / raster_file()).string();
    gis::write_class_geotiff(raster, comparison.classes, classes,
                             {k_name, find_result_raster(k_name)->description, "", input.metadata});
    gis::write_styles(raster, stops, "", gis::StyleKind::exact, input.words(find_result_raster(k_name)->title));
}

std::vector<std::string> comparison_files(const std::string& folder) {
    std::vector<std::string> files;
    for (const ResultFile& file : result_files())
        if (file.written_by == "compare" && !file.is_drawn())
            files.push_back((fs::path(folder) / file.pattern).string());
    return files;
}

std::vector<std::string> comparison_pictures(const MapStyle& style, const std::string& folder) {
    return picture_files(style, comparison_stem(folder));
}

void draw_comparison(const Comparison& comparison, LayerDrawer& drawer, const std::string& folder) {
    const ComparisonStatistics& f = *comparison.statistics;
    MapLayer layer;
    layer.notes_alone = true;
    const Words& words = drawer.style().words;
    const auto area = [&](double value) { return words.number(grouped(value)) + " m²"; };
    const auto score = [&](double value) { return words.number(number_text(value, 3)); };
    layer.notes = {words.labelled(words("Depth threshold"), score(f.threshold_m) + " m"),
                   words.labelled(words("Observed area"), area(f.observed_area_m2)),
                   words.labelled(words("Simulated area"), area(f.simulated_area_m2)),
                   words.labelled(words("Area difference"),
                                  words.number(signed_number_text(f.signed_area_difference_percent())) + " %"),
                   words.labelled(words("Hit"), area(f.hit_m2)),
                   words.labelled(words("False alarm"), area(f.false_alarm_m2)),
                   words.labelled(words("Miss"), area(f.miss_m2)),
                   words.labelled("Jaccard", score(f.jaccard)),
                   words.labelled("Dice", score(f.dice))};
    if (comparison.outline)
        layer.notes.push_back(
            words.labelled(words("Distance of the outlines, mean"), score(comparison.outline->mean_m) + " m"));
    layer.title = words("Comparison with the survey");
    layer.values = comparison.classes;
    layer.source = raster_file();
    for (const ClassText& entry : k_classes)
        layer.categories.push_back({static_cast<double>(entry.kind), class_label(entry.label(), words), entry.colour});
    make_folder(folder);
    drawer.draw(layer, false, comparison_stem(folder));
}

ComparisonInput surveyed(const Prepared& prepared) {
    ComparisonInput input;
    input.survey = prepared.extra.survey;
    if (prepared.scar) {
        input.survey.scar = parts_of(prepared.scar->features);
        input.survey.scar_label = prepared.spec.observed.perimeter.value();
    }
    if (input.survey.empty()) return input;
    input.threshold = observed_threshold(prepared.spec);
    input.depth_label = "max_depth.tif";
    input.metadata = provenance(prepared);
    input.words = words_of(prepared.spec);
    return input;
}

namespace {

/// Rows of name, value and what the value means.
class Scores {
  public:
    void add(const std::string& name, const std::string& value, const std::string& meaning) {
        table_.row({name, value, meaning});
    }
    void add_areas(const ComparisonStatistics& f, const std::string& what) {
        add("observed " + what, grouped(f.observed_area_m2) + " m2", "");
        add("simulated " + what, grouped(f.simulated_area_m2) + " m2",
            signed_number_text(f.signed_area_difference_percent()) + " % in size, wherever they lie");
        add("Jaccard index", number_text(f.jaccard, 3), "common ground of all covered: 1 agrees everywhere");
        add("hits", number_text(100 * f.true_positive_rate, 3) + " %", "of the observed ground is covered");
        add("false alarms", grouped(f.false_alarm_m2) + " m2", "covered, not observed");
        add("misses", grouped(f.miss_m2) + " m2", "observed, not covered");
        add("D2PC", number_text(f.d2pc, 3), "distance to perfect classification: 0 is perfect");
        add("AUROC", number_text(f.auroc, 3), "over all depth thresholds: 1 is perfect");
    }
    [[nodiscard]] std::string text(std::size_t width) const { return table_.text(width, {{30}, {18, true}, {56}}); }

  private:
    Table table_{{"score", "value", "meaning"}};
};

}  // namespace

std::string comparison_table(const Comparison& comparison, const ComparisonInput& input, std::size_t width) {
    Scores scores;
    if (comparison.statistics) scores.add_areas(*comparison.statistics, "area");
    if (const auto& outline = comparison.outline) {
        scores.add("outline, mean distance", number_text(outline->mean_m, 3) + " m", "");
        scores.add("outline, 95 % within", number_text(outline->percentile_95_m, 3) + " m",
                   "at most " + number_text(outline->hausdorff_m, 3) + " m");
    }
    if (comparison.runout_difference_m)
        scores.add("run-out", signed_number_text(*comparison.runout_difference_m) + " m", "simulated minus observed");
    if (const auto& path = comparison.path_runout)
        scores.add(
            "run-out along the path", signed_number_text(path->simulated_m - path->observed_m) + " m",
            number_text(path->simulated_m, 4) + " m simulated, " + number_text(path->observed_m, 4) + " m observed");
    for (const FrontComparison& front : comparison.fronts)
        scores.add("front " + front.name, signed_number_text(front.mean_m) + " m",
                   "mean; " + number_text(front.reached_percent, 3) + " % of the line was reached");
    for (const TipComparison& tip : comparison.tips)
        scores.add("tip " + tip.name, signed_number_text(tip.distance_m) + " m", "greater than 0: reached beyond it");
    if (comparison.deposit_overlap) scores.add_areas(*comparison.deposit_overlap, "deposit");
    if (const auto& depth = comparison.deposit_depth)
        scores.add("depth of the deposit", signed_number_text(depth->bias_m) + " m",
                   "mean error; root mean square " + number_text(depth->rmse_m, 3) + " m");
    return "Covered: deeper than " + shortest_text(input.threshold) + " m\n\n" + scores.text(width);
}

}  // namespace frana::app
