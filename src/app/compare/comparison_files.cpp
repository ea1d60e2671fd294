// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/compare/comparison.h"
#include "app/pictures/class_words.h"
#include "app/pictures/map_source.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/unit_sign.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/json.h"
#include "core/shortest_text.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_name = "comparison";  // of the raster's row and of the picture

std::string raster_file() {
    return std::string(k_name) + ".tif";
}

std::string tif_stem(const std::string& folder) {
    return (fs::path(folder) / "maps" / k_name).string();
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
                                  {"correlation", depth->correlation}};
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
    json["negatives"] = "true negatives are five times the observed area minus the false alarms";
    return json_text(json);
}

std::string comparison_curve_csv(const Comparison& comparison) {
    std::string text = "threshold_m";
    for (const auto& [name, value] : named({})) text += std::string(",") + name;
    for (const ComparisonStatistics& statistics : comparison.curve) {
        text += "\n" + shortest_text(statistics.threshold_m);
        for (const auto& [name, value] : named(statistics)) text += "," + shortest_text(value);
    }
    return text + "\n";
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
    return picture_files(style, comparison_stem(folder), true, tif_stem(folder));
}

void draw_comparison(const Comparison& comparison, LayerDrawer& drawer, const std::string& folder) {
    const ComparisonStatistics& f = *comparison.statistics;
    MapLayer layer;
    layer.notes_alone = true;
    const Words& words = drawer.style().words;
    const auto area = [&](double value) { return words.number(grouped(value)); };
    const auto score = [&](double value) { return words.number(number_text(value, 3)); };
    layer.notes = {
        words("Deeper than {1} m counts", {words.number(number_text(f.threshold_m))}),
        words("Observed {1} m²", {area(f.observed_area_m2)}),
        words("Simulated {1} m²", {area(f.simulated_area_m2)}),
        words("Area difference {1} %", {words.number(signed_number_text(f.signed_area_difference_percent()))}),
        words("Hit {1} m²", {area(f.hit_m2)}),
        words("False alarm {1} m²", {area(f.false_alarm_m2)}),
        words("Miss {1} m²", {area(f.miss_m2)}),
        words("Jaccard {1}", {score(f.jaccard)}),
        words("Dice {1}", {score(f.dice)})};
    if (comparison.outline) layer.notes.push_back(words("Outlines {1} m apart", {score(comparison.outline->mean_m)}));
    layer.title = words("Comparison with the survey");
    layer.values = comparison.classes;
    layer.source = words("{1}, band {2}", {raster_file(), "1"});
    for (const ClassText& entry : k_classes)
        layer.categories.push_back({static_cast<double>(entry.kind), class_label(entry.label(), words), entry.colour});
    for (const std::string& file : comparison_pictures(drawer.style(), folder))
        make_folder(fs::path(file).parent_path());
    drawer.draw(layer, false, comparison_stem(folder), tif_stem(folder));
}

}  // namespace frana::app
