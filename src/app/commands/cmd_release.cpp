// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "analysis/slope_stability.h"
#include "app/commands/command_line.h"
#include "app/input/prepare_terrain.h"
#include "app/input/prepare_zones.h"
#include "app/store/own_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_out.h"
#include "gis/vector/vector_out.h"
#include "params/grammar/ini_file.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

enum : std::size_t { k_thickness, k_friction, k_cohesion, k_saturation, k_weight, k_from, k_to, k_convexity, k_area };

/// A number that is given; of what slides also a raster.
struct StartQuantity {
    const char *option, *form, *meaning;
    NumberRange range;            ///< of what is no mistake of units
    const char* remedy;           ///< what is confused most often
    std::optional<double> fixed;  ///< default
    bool may_be_zero = false;

    [[nodiscard]] bool has(double value) const { return range.has(value) || (value == 0 && may_be_zero); }
    [[nodiscard]] std::string limits() const { return (may_be_zero ? "0, or " : "") + range.text(); }
};
const StartQuantity k_start_quantities[]{
    {"--thickness", "M", "of what slides, vertical (required)", {0.05, 100}, "In metres: 80 cm is 0.8", {}},
    {"--friction-angle", "DEGREES", "else slope alone decides", {3, 60}, "In degrees: 35, not 0.7 or 0.61", {}, true},
    {"--cohesion", "PA", "with that of roots (default: 0)", {100, 1e6}, "In pascal: 5 kPa is 5000", 0, true},
    {"--saturation", "FRACTION", "water table over thickness (default: 0)", {0, 1}, "A fraction: 50 % is 0.5", 0},
    {"--density", "KG/M3", "with its water (default: 2000)", {50, 3500}, "1.8 g/cm3, or 17.7 kN/m3, is 1800", 2000},
    {"--least-slope", "DEGREES", "on which masses start (default: 0)", {3, 89}, "In degrees: 28, not 0.5", 0, true},
    {"--greatest-slope", "DEGREES", "the same (default: 90)", {3, 90}, "In degrees: 55, not 1.4", 90},
    {"--convexity", "1/M", "greatest, tan(slope) / radius in plan", {0, 1}, "6 per 100 m is 0.06", 1},
    {"--least-area", "M2", "smaller areas are left out (default: 500)", {0, 1e9}, "0.1 ha is 1000", 500},
};

/// What is asked for.
struct StartRequest {
    SourceSpec given[std::size(k_start_quantities)];
    std::optional<Raster> rasters[k_weight + 1];  ///< on the cells of the terrain
    bool has_factor = false;

    [[nodiscard]] double at(std::size_t quantity, std::size_t cell) const {
        return rasters[quantity] ? rasters[quantity]->values[cell] : given[quantity].number;
    }
};

StartRequest read_start_request(const Options& values, Problems& problems) {
    StartRequest request;
    request.has_factor = values.count("friction-angle") > 0;
    for (std::size_t i = 0; i < std::size(k_start_quantities); ++i) {
        const StartQuantity& row = k_start_quantities[i];
        SourceSpec& given = request.given[i];
        given.number = row.fixed.value_or(0);
        const auto text = text_option(values, row.option + 2);
        if (!text) continue;
        const bool is_of_layer = i <= k_weight;
        const auto source = source_from_text(*text);
        const bool is_raster = is_of_layer && source && source->kind == SourceSpec::Kind::raster;
        if (!is_raster && !(source && source->kind == SourceSpec::Kind::number && row.has(source->number)))
            problems.add({"is not plausible", row.option, *text, row.limits() + (is_of_layer ? ", or raster:FILE" : ""),
                          row.remedy});
        if (is_of_layer && i >= k_cohesion && !request.has_factor)
            problems.add({"has no effect without --friction-angle", row.option, *text, "", "Give both, or none"});
        given = source.value_or(given);
    }
    if (values.count("thickness") == 0)
        problems.add({"is required", "--thickness", "", "", "In metres, or raster:FILE"});
    if (!request.has_factor && values.count("least-slope") == 0)
        problems.add({"is required, or --least-slope", "--friction-angle", "", "", "They say where masses start"});
    const SourceSpec &water = request.given[k_saturation], &weight = request.given[k_weight];
    if (water.kind == SourceSpec::Kind::number && weight.kind == SourceSpec::Kind::number &&
        weight.number < k_water_density * water.number)
        problems.add({"is less than that of its water alone", "--density", shortest_text(weight.number),
                      "at least " + shortest_text(k_water_density * water.number) + " kg/m3 at this --saturation",
                      "Give the density with its water"});
    if (!(request.given[k_from].number < request.given[k_to].number))
        problems.add({"is not less than --greatest-slope", "--least-slope", "", "", "Exchange them"});
    return request;
}

/// Reads the rasters. Throws Error(input), also for values that are not plausible.
void read_rasters(StartRequest& request, const SceneReading& reading, const TerrainInput& ground, Findings found) {
    Problems problems;
    std::vector<UsedFile> files;
    for (std::size_t i = 0; i <= k_weight; ++i) {
        const StartQuantity& row = k_start_quantities[i];
        if (request.given[i].kind != SourceSpec::Kind::raster) continue;
        const std::string file = absolute_path(request.given[i].name, fs::current_path().string());
        request.rasters[i] = read_zone_raster(reading, &ground, row.option, file, false, files, found, problems);
        if (!request.rasters[i]) continue;
        std::optional<double> wrong;
        request.rasters[i]->values.for_each_stored([&](std::size_t, double value) {
            if (!std::isnan(value) && !row.has(value) && !(value == 0 && i == k_thickness)) wrong = value;
        });
        if (wrong)
            problems.add({"has a value that is not plausible", std::string(row.option) + ": " + request.given[i].name,
                          shortest_text(*wrong), row.limits(), row.remedy});
    }
    problems.throw_if_any();
}

/// Areas of at least the least size, each with what a release layer has.
std::vector<Feature> areas_of(const SlopeScreening& screening, const StartRequest& request) {
    const GridSpec& grid = screening.starts.grid;
    std::vector<Feature> areas;
    for (Polygon& part : gis::polygonise(screening.starts)) {
        if (area(part) < request.given[k_area].number) continue;
        double cells = 0, thickness = 0, factor = 0, least = k_most_factor;
        gis::visit_cells({part}, grid, gis::Cover::centres, [&](std::int64_t row, std::int64_t column) {
            const std::size_t cell = screening.factor.index(row, column);
            cells += 1;
            thickness += request.at(k_thickness, cell);
            factor += screening.factor.values[cell];
            least = std::min(least, screening.factor.values[cell]);
        });
        Feature& one = areas.emplace_back();
        one.texts["name"] = std::to_string(areas.size());
        one.numbers = {{"area_m2", area(part)},
                       {"thickness_vertical_m", thickness / cells},
                       {"volume_m3", thickness * grid.cell_area()}};
        if (request.has_factor) one.numbers.insert({{"least_factor", least}, {"mean_factor", factor / cells}});
        one.shape.areas.push_back(std::move(part));
    }
    return areas;
}

/// Cells of the ground on which a raster says nothing.
std::int64_t cells_without_values(const StartRequest& request, const Raster& terrain) {
    std::int64_t count = 0;
    terrain.values.for_each_stored([&](std::size_t cell, double z) {
        bool is_blank = false;
        for (std::size_t i = 0; i <= k_weight; ++i) is_blank = is_blank || std::isnan(request.at(i, cell));
        count += !std::isnan(z) && is_blank;
    });
    return count;
}

int cmd_release(const Options& values) {
    Problems problems;
    const std::string dtm = *text_option(values, "operand"), out = text_option(values, "out").value_or("release.gpkg"),
                      factor = fs::path(out).replace_extension().string() + "_factor.tif";
    StartRequest request = read_start_request(values, problems);
    SceneReading reading;
    reading.label = "command line";
    reading.written["terrain.dtm"] = "DTM";
    SceneReader reader(reading, fs::current_path().string());
    reader.apply({Origin::command_line, "", {{"terrain.dtm", dtm}}});
    reader.apply(override_source(text_options(values, "set"), "--set ", problems));
    for (const std::string& name : reader.given())
        if (!name.starts_with("terrain."))
            problems.add({"is not of the section [terrain]", "--set " + name, "", "", "Only the terrain is used"});
    problems.add(reading.problems);
    if (!out.ends_with(".gpkg"))
        problems.add({"is not a GeoPackage", "--out", out, "", "Choose a name that ends in .gpkg"});
    std::vector<std::string> files{out}, inputs{dtm};
    if (request.has_factor) files.push_back(factor);
    for (const SourceSpec& source : request.given) inputs.push_back(source.name);
    for (const std::string& file : files)
        if (fs::exists(file) && values.count("overwrite") == 0)
            problems.add({"exists already", "--out", file, "", "Choose another name, or add --overwrite"});
    refuse_inputs(files, inputs, "--out", problems);
    RunLog log(false);
    Warnings warnings;
    const Findings found{log, warnings};
    const auto ground = prepare_terrain(reading, found, problems);
    problems.throw_if_any();
    read_rasters(request, reading, *ground, found);
    const StartingGround limits{request.given[k_from].number, request.given[k_to].number,
                                request.given[k_convexity].number};
    const SlopeScreening screening = screen_slopes(ground->terrain, limits, [&](std::size_t cell) {
        const auto at = [&](std::size_t quantity) { return request.at(quantity, cell); };
        return SlopeLayer{at(k_cohesion), at(k_friction), at(k_thickness), at(k_saturation), at(k_weight)};
    });
    const std::vector<Feature> areas = areas_of(screening, request);
    const Words words(process_language());
    gis::ShapeLayer layer{"release", areas, gis::Shape::area, {}, words("Screening of possible releases")};
    gis::AttributeTitles titles = attribute_titles(words);
    titles.emplace_back("least_factor", words("Least factor of safety"));
    titles.emplace_back("mean_factor", words("Mean factor of safety"));
    layer.style = gis::titled(gis::style_of(layer.name, gis::Shape::area, {k_release_colour, 0.6, true, ""}),
                              layer.description, titles);
    gis::write_shapes(out, ground->terrain.grid.crs_wkt, {layer});
    if (request.has_factor)
        gis::write_geotiff(factor, screening.factor,
                           {"factor_of_safety", "Factor of safety of an infinite slope, a screening", "-", {}});
    const auto sum = [&](const char* name) {
        double all = 0;
        for (const Feature& one : areas) all += one.numbers.at(name);
        return grouped(std::round(all));
    };
    if (const std::int64_t blank = cells_without_values(request, ground->terrain); blank > 0)
        std::cerr << "frana: warning: "
                  << number_text(
                         100.0 * static_cast<double>(blank) / static_cast<double>(ground->terrain.grid.cell_count()), 3)
                  << " % of the map has no value of a raster: not screened\n";
    std::cerr << "frana: a screening, not a prediction: each cell alone, one layer, no time\nfrana: areas: "
              << areas.size() << ", " << sum("area_m2") << " m2, " << sum("volume_m3") << " m3\nfrana: wrote "
              << joined(files, " and ") << '\n';
    if (!areas.empty())
        std::cerr << "frana: next: frana new " << dtm << ' ' << out << " --thickness attribute:thickness_vertical_m\n";
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_release() {
    CommandForm form{"frana release DTM --thickness METRES [options]",
                     "Screens where masses may start: cells whose infinite slope has a factor of safety below 1, "
                     "within\nlimits. Writes a layer that a scene takes as its release, and the factor as a GeoTIFF. "
                     "It predicts\nneither whether nor when a slope fails. Thickness to density may be raster:FILE.",
                     "DTM",
                     {}};
    for (const StartQuantity& row : k_start_quantities)
        form.options.add_options()(row.option + 2, one(row.form), row.meaning);
    form.options.add_options()("set", many("KEY=VALUE"), "a key of [terrain], for example terrain.cell-size=5")(
        "out", one("FILE.gpkg"), "polygons to write (default: release.gpkg)")("overwrite", "replace existing files");
    return {"release", "screen where masses may start: a layer of release areas", form, cmd_release};
}

}  // namespace frana::app
