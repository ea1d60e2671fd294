// SPDX-License-Identifier: Apache-2.0
#include "app/comparison.h"

#include <filesystem>

#include "analysis/runout.h"
#include "analysis/trace.h"
#include "app/number_text.h"
#include "app/text_file.h"
#include "app/version.h"
#include "core/json.h"
#include "gis/raster_out.h"
#include "gis/rasterize.h"
#include "gis/styles.h"

namespace frana::app {
namespace {

struct ClassText {
    Agreement kind;
    const char* label;
    Rgb colour;
};

// Okabe and Ito's colours, safe for the colour-blind: bluish green, orange, sky blue.
constexpr ClassText k_classes[] = {{Agreement::hit, "Hit: simulated and observed", {0, 158, 115}},
                                   {Agreement::false_alarm, "False alarm: simulated only", {230, 159, 0}},
                                   {Agreement::miss, "Miss: observed only", {86, 180, 233}}};

std::optional<double> runout_difference(const ComparisonInput& input, const Raster& observed, RunLog& log) {
    if (!input.bed || !input.release) return std::nullopt;
    if (!observed.grid.same_cells(input.bed->grid)) {
        log.warn(
            "the scar reaches beyond the computed ground, so its run-out is not known: no run-out "
            "difference");
        return std::nullopt;
    }
    const Runout simulated = runout(*input.bed, *input.release, trace_mask(input.depth, input.threshold));
    return simulated.horizontal_m - runout(*input.bed, *input.release, observed).horizontal_m;
}

}  // namespace

Comparison compare_with_scar(const ComparisonInput& input, RunLog& log) {
    const Raster depth = padded_to(input.depth, bounds(input.scar), k_no_data);
    if (!depth.grid.same_cells(input.depth.grid))
        log.warn("the scar reaches beyond the computed ground; its part outside counts as missed");
    const Raster observed = gis::coverage(input.scar, depth.grid);
    Comparison comparison;
    comparison.figures = compare(depth, observed, input.threshold);
    comparison.classes = agreement(depth, observed, input.threshold);
    comparison.runout_difference_m = runout_difference(input, observed, log);
    return comparison;
}

std::string comparison_json(const Comparison& comparison, const ComparisonInput& input) {
    const ComparisonFigures& f = comparison.figures;
    JsonWriter json;
    json.begin_object();
    json.text("program", k_program).text("version", k_version);
    json.text("simulated", input.depth_label).text("observed", input.scar_label);
    json.number("cell_size", input.depth.grid.cell_size).number("threshold_m", f.threshold_m);
    json.number("observed_area_m2", f.observed_area_m2).number("simulated_area_m2", f.simulated_area_m2);
    json.number("area_difference_percent", f.area_difference_percent);
    json.number("hit_m2", f.hit_m2).number("false_alarm_m2", f.false_alarm_m2).number("miss_m2", f.miss_m2);
    json.number("jaccard", f.jaccard).number("dice", f.dice).number("csi", f.csi);
    json.number("true_positive_rate", f.true_positive_rate)
        .number("false_positive_rate", f.false_positive_rate);
    json.number("d2pc", f.d2pc).number("auroc", f.auroc);
    if (comparison.runout_difference_m)
        json.number("runout_difference_m", *comparison.runout_difference_m);
    else
        json.null("runout_difference_m");
    json.text("negatives", "true negatives are five times the observed area less the false alarms");
    json.end_object();
    return json.str();
}

void write_comparison(const Comparison& comparison, const ComparisonInput& input, const std::string& folder) {
    const std::filesystem::path place = folder;
    std::vector<gis::ClassEntry> classes;
    std::vector<gis::ColourStop> stops;
    for (const ClassText& entry : k_classes) {
        classes.push_back({static_cast<std::uint8_t>(entry.kind), entry.label, entry.colour});
        stops.push_back({static_cast<double>(entry.kind), entry.colour, entry.label});
    }
    const std::string raster = (place / "comparison.tif").string();
    gis::write_class_geotiff(raster, comparison.classes, classes,
                             {"comparison",
                              "Simulated trace against the surveyed scar: 1 hit, 2 false alarm, 3 miss",
                              "",
                              {{"PROGRAM", k_program}, {"VERSION", k_version}}});
    gis::write_styles(raster, stops, "", gis::StyleKind::exact);
    write_text_file((place / "comparison.json").string(), comparison_json(comparison, input));
}

void draw_comparison(const Comparison& comparison, MapSource source, const std::string& path) {
    const ComparisonFigures& f = comparison.figures;
    source.notes = {"Deeper than " + figure(f.threshold_m) + " m counts",
                    "Observed " + grouped(f.observed_area_m2) + " m²",
                    "Simulated " + grouped(f.simulated_area_m2) + " m²",
                    "Area difference " + figure(f.area_difference_percent, 3) + " %",
                    "Jaccard " + figure(f.jaccard, 3),
                    "Dice " + figure(f.dice, 3)};
    render::MapSpec spec;
    spec.title = source.title + ": comparison with the scar";
    spec.subtitle = source.subtitle;
    spec.legend_title = "Agreement";
    spec.attribution = std::string("Simulated with ") + k_program + " " + k_version;
    spec.terrain = source.terrain.values.empty() ? nullptr : &source.terrain;
    spec.layer = &comparison.classes;
    for (const ClassText& entry : k_classes)
        spec.categories.push_back({static_cast<double>(entry.kind), entry.label, entry.colour});
    if (!source.release.empty())
        spec.outlines.push_back({"Release", source.release, {20, 20, 20}, 2.5, true});
    spec.outlines.push_back({"Surveyed scar", source.scar, {120, 0, 80}, 3, false});
    spec.side_notes = source.notes;
    spec.convergence_deg = source.convergence_deg;
    spec.crs_label = source.crs_label;
    spec.width = source.size.width;
    spec.height = source.size.height;
    render::write_png(path, render::draw_map(spec));
}

}  // namespace frana::app
