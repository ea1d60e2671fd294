// SPDX-License-Identifier: Apache-2.0
#include "params/keys/scene_parameters.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/words/words.h"
#include "params/keys/declare.h"
#include "params/keys/material_parameters.h"
#include "params/keys/output_parameters.h"
#include "params/keys/parameter.h"
#include "params/keys/plausible.h"
#include "params/keys/result_rasters.h"
#include "params/keys/zone_keys.h"

namespace frana {
namespace {

using declare::number;
using declare::Range;
using declare::text;

void insert(std::vector<Parameter>& list, const Parameter& parameter) {
    const auto last =
        std::find_if(list.rbegin(), list.rend(), [&](const Parameter& p) { return p.section == parameter.section; });
    list.insert(last.base(), parameter);
}

/// Keys that specify how to read an input file that does not specify it itself, each at the end of its section.
void add_input_parameters(std::vector<Parameter>& list) {
    insert(list, number("terrain.nodata-value", FRANA_MEMBER(terrain.nodata_value), "", Range{-1e300, 1e300},
                        "Additional stored value that means no elevation, such as 0 around the edge.",
                        "only what the file declares"));
    constexpr const char* k_filter = "Condition on the attributes, as in SQL: kind = 'scar' AND year > 2000.";
    insert(list, text("release.perimeter-filter", FRANA_MEMBER(release.perimeter_layer.filter), "text", k_filter,
                      "all features"));
    insert(list, text("release.perimeter-crs", FRANA_MEMBER(release.perimeter_layer.crs), "text",
                      "CRS, if the file names none or a wrong one.", "the file's own"));
    insert(list, text("observed.perimeter-filter", FRANA_MEMBER(observed.perimeter_layer.filter), "text", k_filter,
                      "all features"));
    insert(list, text("observed.perimeter-crs", FRANA_MEMBER(observed.perimeter_layer.crs), "text",
                      "CRS, if the file names none or a wrong one.", "the file's own"));
}

// Surveyed data of the site: the ground, the release and inflow, and values by place.

using declare::choice;
using declare::holds;
using declare::on_off;
using declare::option;
using declare::source;
using Given = SourceSpec::Kind;

Parameter bounds_parameter() {
    Parameter result =
        text("terrain.bounds", FRANA_MEMBER(terrain.dtm), "list",
             "Part of the DTM to compute on: west south east north in the working CRS.", "the whole DTM");
    result.unit = "m";
    result.limits = "four numbers, west < east and south < north";
    result.range = NumberRange{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    result.read = [](SceneSpec& scene, const std::string& value) -> std::optional<ValueProblem> {
        std::vector<double> numbers;
        for (const std::string& word : words_of(value)) {
            const auto number = number_from_text(word);
            if (!number) return ValueProblem{"'" + word + "' is not a number", ""};
            numbers.push_back(*number);
        }
        if (numbers.size() != 4) return ValueProblem{"does not have four numbers", ""};
        const Bounds box{numbers[0], numbers[1], numbers[2], numbers[3]};
        if (!(box.west < box.east) || !(box.south < box.north))
            return ValueProblem{"is an empty rectangle", "Write west south east north, in this order"};
        scene.terrain.bounds = box;
        return std::nullopt;
    };
    result.write = [](const SceneSpec& scene) -> std::optional<std::string> {
        if (!scene.terrain.bounds) return std::nullopt;
        const Bounds& box = *scene.terrain.bounds;
        return shortest_text(box.west) + " " + shortest_text(box.south) + " " + shortest_text(box.east) + " " +
               shortest_text(box.north);
    };
    result.reset = [](SceneSpec& scene) { scene.terrain.bounds.reset(); };
    return result;
}

/// "0.5, 50, 7": standard deviation, range, seed.
Parameter error_parameter() {
    constexpr Range k_deviation{0, 100}, k_range{0, 1e5, true};
    Parameter result = declare::parameter(
        "terrain.error", "list", FRANA_MEMBER(terrain.error),
        [=](std::optional<TerrainErrorSpec>& target, const std::string& value) -> std::optional<ValueProblem> {
            const std::vector<std::string> words = words_of(value);
            const ValueProblem not_understood{"is not a standard deviation, a range and a whole number",
                                              "Write for example 0.5, 50, 1"};
            if (words.size() != 3) return not_understood;
            const auto deviation = number_from_text(words[0]), range = number_from_text(words[1]);
            const auto seed = integer_from_text(words[2]);
            if (!deviation || !range || !seed) return not_understood;
            TerrainErrorSpec error{*deviation, *range, seed.value_or(0)};
            if (!k_deviation.has(error.standard_deviation) || !k_range.has(error.range) || error.seed < 0)
                return ValueProblem{"is out of range", ""};
            target = error;
            return std::nullopt;
        },
        [](const TerrainErrorSpec& error) {
            return shortest_text(error.standard_deviation) + ", " + shortest_text(error.range) + ", " +
                   std::to_string(error.seed);
        });
    result.unit = "m";
    result.range = NumberRange{0, std::numeric_limits<double>::max()};
    result.limits = "standard deviation " + k_deviation.text() + ", range " + k_range.text() + ", seed from 0";
    result.meaning =
        "Error added to the elevations of the DTM: a normal random field with this standard deviation, whose "
        "correlation falls to 0.05 at the range; each seed is another field.";
    result.absent = "none";
    return result;
}

void add_terrain(std::vector<Parameter>& list) {
    list.push_back(holds(
        "raster",
        text("terrain.dtm", FRANA_MEMBER(terrain.dtm), "file",
             "Digital terrain model: any raster that GDAL reads, with elevations in its first band.", "required")));
    list.push_back(text("terrain.crs", FRANA_MEMBER(terrain.crs), "text",
                        "Working CRS, projected, in metres (EPSG:32632, WKT, PROJ); auto: the DTM's own if it is "
                        "projected in metres, otherwise the local UTM zone; local: plain metres without a CRS."));
    list.push_back(text("terrain.dtm-crs", FRANA_MEMBER(terrain.dtm_crs), "text",
                        "CRS of the DTM, if its file names none or a wrong one.", "the file's own"));
    list.push_back(declare::decides_map(number("terrain.cell-size", FRANA_MEMBER(terrain.cell_size), "m",
                                               Range{0.01, 1000}, "Cell size of the working grid.", "the DTM's own")));
    list.push_back(bounds_parameter());
    list.push_back(declare::decides_map(
        option("terrain.nodata-policy", FRANA_MEMBER(numerics.nodata), k_nodata_policies,
               "Where the flow reaches ground without elevation: end the run, treat it as a wall, or "
               "interpolate the bed beforehand.")));
    list.push_back(choice("terrain.vertical-unit", FRANA_MEMBER(terrain.vertical_unit),
                          {"auto", "metre", "decimetre", "centimetre", "millimetre", "foot", "us-survey-foot"},
                          "Unit of the DTM's elevations; auto: as stated in the file, otherwise metres."));
    list.push_back(text("terrain.source", FRANA_MEMBER(terrain.source), "text",
                        "Source of the elevations, named on maps: survey, owner, date, licence.",
                        "the DTM's file name"));
    list.push_back(
        holds("polygons",
              text("terrain.friction-zones", FRANA_MEMBER(terrain.friction_zones), "file",
                   "Polygons with different material values, in their own CRS; [zones] names the columns.", "none")));
    list.push_back(holds(
        "polygons", text("terrain.obstacles", FRANA_MEMBER(terrain.obstacles), "file",
                         "Polygons of dams, fills and embankments that raise the bed, in their own CRS.", "none")));
    list.push_back(source("terrain.obstacle-height", FRANA_MEMBER(terrain.obstacle_height), "m", Range{0, 1000, true},
                          {Given::number, Given::attribute}, "Height of the obstacles above the DTM.",
                          "required with terrain.obstacles"));
    list.push_back(holds(
        "polygons", text("terrain.walls", FRANA_MEMBER(terrain.walls), "file",
                         "Polygons of buildings and walls that the flow cannot overtop, in their own CRS.", "none")));
    list.push_back(error_parameter());
}

void add_release(std::vector<Parameter>& list) {
    list.push_back(
        holds("polygons", text("release.perimeter", FRANA_MEMBER(release.perimeter), "file",
                               "Outline of the release area: any polygon layer that OGR reads, in its own CRS; "
                               "FILE|layer=NAME selects a layer.",
                               "required, unless thickness comes from rasters: then where it is positive")));
    list.push_back(thickness_parameter());
    list.push_back(
        source("release.level", FRANA_MEMBER(release.level), "m", Range{-500, 9000}, {Given::number, Given::attribute},
               "Elevation of the still surface of a lake, a reservoir or a tailings pond that is released: it "
               "fills the ground within the perimeter. Instead of release.thickness.",
               "none"));
    list.push_back(declare::decides_map(
        choice("release.thickness-direction", FRANA_MEMBER(release.thickness_direction), {"vertical", "normal"},
               "Direction in which the thickness is measured: vertical, or normal to the slope.")));
    list.push_back(declare::decides_map(
        on_off("release.dtm-contains-release", FRANA_MEMBER(release.dtm_contains_release),
               "on: the DTM is the ground before the failure, and the bed lies under the release; off: the "
               "release lies on top of the DTM.")));
    list.push_back(source(
        "release.volume", FRANA_MEMBER(release.volume), "m3", Range{0, 1e12, true}, {Given::number, Given::attribute},
        "Volume of the release: thicknesses are scaled so that the whole release, or each polygon, has this volume.",
        "from the thickness"));
    list.push_back(source("release.start", FRANA_MEMBER(release.start), "s", Range{0, 1e6},
                          {Given::number, Given::attribute}, "Time of failure.", "0"));
    list.push_back(source("release.velocity", FRANA_MEMBER(release.velocity), "m/s", Range{0, 200},
                          {Given::number, Given::attribute}, "Initial speed along the bed.", "0"));
    list.push_back(source("release.direction", FRANA_MEMBER(release.direction), "degrees", Range{0, 360},
                          {Given::number, Given::attribute}, "Azimuth, clockwise from grid north.",
                          "down the mean slope of each polygon"));
    list.push_back(source(
        "release.slip-depth", FRANA_MEMBER(release.slip_depth), "m", Range{0, 1000, true},
        {Given::number, Given::attribute},
        "Greatest depth of a fitted slip surface below the surface that spans the perimeter; this or release.volume.",
        "from release.volume"));
}

void add_inflow(std::vector<Parameter>& list) {
    list.push_back(holds("lines", text("inflow.line", FRANA_MEMBER(inflow.line), "file",
                                       "Lines of inflow: any layer that OGR reads, in its own CRS.", "none")));
    list.push_back(holds(
        "table", text("inflow.hydrograph", FRANA_MEMBER(inflow.hydrograph), "file",
                      "CSV with the columns time, discharge or volume, and velocity; attribute:NAME: a column of the "
                      "lines with a file for each.",
                      "required with inflow.line")));
    list.push_back(number("inflow.direction", FRANA_MEMBER(inflow.direction), "degrees", Range{0, 360},
                          "Azimuth, clockwise from grid north.", "normal to the line, towards its lower side"));
}

void add_zones(std::vector<Parameter>& list) {
    for (const ZoneKey& key : zone_keys())
        list.push_back(source(
            key.name, [member = key.source](auto& scene) -> auto& { return scene.zones.*member; }, key.unit, key.range,
            {Given::attribute, Given::raster}, "Within the zones, in place of the value elsewhere.",
            "the material's own everywhere"));
}

using declare::word_list;

Parameter particles_per_cell_parameter() {
    Parameter result = declare::parameter(
        "numerics.particles-per-cell", "integer", FRANA_MEMBER(numerics.particles_per_cell),
        [](int& target, const std::string& value) -> std::optional<ValueProblem> {
            const auto count = integer_from_text(value);
            if (!count) return ValueProblem{"is not a whole number", ""};
            if (*count != 1 && *count != 4 && *count != 9 && *count != 16)
                return ValueProblem{"is not a square number from 1 to 16", "4 is a good choice, 9 where fronts matter"};
            target = static_cast<int>(*count);
            return std::nullopt;
        },
        [](int value) { return std::to_string(value); });
    result.limits = "1, 4, 9, 16";
    result.choices = {"1", "4", "9", "16"};
    result.meaning = "Particles per cell of the release at the start.";
    return result;
}

/// "2 %", "2%" or 0.02. Written as a fraction, which reads back as the same number.
Parameter accuracy_parameter() {
    constexpr Range k_range{0.001, 1};
    Parameter result = declare::parameter(
        "numerics.accuracy", "number", FRANA_MEMBER(numerics.accuracy),
        [k_range](std::optional<double>& target, const std::string& value) -> std::optional<ValueProblem> {
            const bool is_percent = value.ends_with('%');
            const auto number = number_from_text(trimmed(is_percent ? value.substr(0, value.size() - 1) : value));
            if (!number) return ValueProblem{"is not a number", "Write for example 5 % or 0.05"};
            const double fraction = is_percent ? *number / 100 : *number;
            if (!k_range.has(fraction))
                return ValueProblem{"is out of range",
                                    !is_percent && *number > 1 ? "Write " + value + " % for percent" : ""};
            target = fraction;
            return std::nullopt;
        },
        [](double value) { return shortest_text(value); });
    result.limits = "0.1 % to 100 %, or 0.001 to 1";
    result.range = k_range;
    result.fits = [k_range](double value) { return k_range.has(value); };
    result.meaning =
        "Error allowed by estimate, as a fraction of each value: coarser cells are computed first and refined only as "
        "far as needed, at most to the scene's own.";
    result.absent = "the scene's own cells at once, without an estimate";
    return result;
}

void add_numerics(std::vector<Parameter>& list) {
    list.push_back(
        option("numerics.scheme", FRANA_MEMBER(numerics.scheme), k_schemes,
               "Numerical scheme: material points, the method as published, or finite volumes without particles."));
    declare::Words<Transfer> transfers;
    for (const TransferRow& row : k_transfers) transfers.emplace_back(row.word, row.transfer);
    list.push_back(option("numerics.transfer", FRANA_MEMBER(numerics.transfer), transfers,
                          "Velocity transfer to the particles; auto: the scheme's (default: apic, paper: pic)."));
    list.push_back(particles_per_cell_parameter());
    list.push_back(number("numerics.cfl", FRANA_MEMBER(numerics.cfl), "", Range{0, 1, true},
                          "Courant number: fraction of the largest stable time step.",
                          shortest_text(default_courant(true)) + "; " + shortest_text(default_courant(false)) +
                              " for scheme paper; " + shortest_text(k_courant_of_sweeps) +
                              " for finite-volume and material.model = structured"));
    list.push_back(on_off("numerics.well-balanced", FRANA_MEMBER(numerics.well_balanced),
                          "Keep still water at rest by a reference level per node (default scheme).",
                          "on for scheme default, off for paper"));
    list.push_back(option("numerics.slope-correction", FRANA_MEMBER(numerics.slope_correction), k_slope_corrections,
                          "Form of the equations on steep ground; auto: none for scheme paper, else normal."));
    list.push_back(
        on_off("numerics.curvature", FRANA_MEMBER(numerics.curvature),
               "Motion along a curved bed: the speed along the bed is kept where the slope changes, with more friction "
               "in hollows and less over edges; off: the speed in map view is kept. Needs a slope correction.",
               "on with a slope correction"));
    list.push_back(on_off("numerics.flight", FRANA_MEMBER(numerics.flight),
                          "Material flies where the bed falls away faster than a free fall; off: it stays on the bed. "
                          "Needs curvature, scheme default and transfer apic.",
                          "on with curvature, scheme default and transfer apic"));
    list.push_back(number("numerics.flight-clearance", FRANA_MEMBER(numerics.flight_clearance), "m", Range{0, 100},
                          "Height above the ground up to which what flies counts in maxima, arrival times, classes of "
                          "intensity and exposure: a house may stand in it."));
    list.push_back(declare::decides_map(
        declare::option("numerics.boundary", FRANA_MEMBER(numerics.boundary),
                        declare::Words<Boundary>{{"open", Boundary::open}, {"wall", Boundary::wall}},
                        "Edge of the working grid: open (outflow is counted) or a wall.")));
    list.push_back(declare::decides_map(
        number("numerics.minimum-depth", FRANA_MEMBER(numerics.minimum_depth), "m", Range{1e-6, 10},
               "Depth above which a cell counts as reached in maxima and arrival time. Film thinner than ten "
               "times it, at most 10 cm, has fewer particles.")));
    list.push_back(accuracy_parameter());
}

Parameter formats_key() {
    return declare::without(
        word_list("output.formats", FRANA_MEMBER(output.formats), {},
                  {"geotiff", "particles-gpkg", "shp", "kmz", "dxf"},
                  "Besides GeoTIFF and GeoPackage: particles-gpkg, the particles of each frame; shp, kmz, dxf, the "
                  "generalised zones of hazard.scheme."),
        {{"netcdf", "Leave it out: gdal_translate -of netCDF makes it of frames/*.tif"},
         {"zarr", "Leave it out: gdal_translate -of Zarr makes it of frames/*.tif"},
         {"ascii", "Leave it out: gdal_translate -of AAIGrid makes it of a GeoTIFF"},
         {"particles-vtp", "Write particles-gpkg in its place"}});
}

void add_rest(std::vector<Parameter>& list) {
    list.push_back(declare::decides_map(
        number("time.end", FRANA_MEMBER(time.end), "s", Range{0, 1e6, true}, "Longest simulated time.")));
    list.push_back(
        on_off("time.stop-when-still", FRANA_MEMBER(time.stop_when_still), "End as soon as all material is at rest."));
    list.push_back(number("time.stop-momentum", FRANA_MEMBER(time.stop_momentum), "", Range{0, 0.5},
                          "End once the momentum, the sum of mass times speed, is below this fraction of its peak; 0: "
                          "off. 0.05 is customary for avalanches."));
    list.push_back(declare::decides_map(
        number("time.stop-change", FRANA_MEMBER(time.stop_change), "", Range{0, 0.5},
               "End once run-out, area and deposit are final: in the last quarter of the time they changed by about "
               "this fraction at most; 0: off.")));
    list.push_back(number("time.frame-interval", FRANA_MEMBER(time.frame_interval), "s", Range{0, 1e6, true},
                          "Simulated time between frames; each is the first state at or after its time.",
                          "by the motion: one after each mean distance that the flow covers"));

    list.push_back(text("output.directory", FRANA_MEMBER(output.directory), "folder",
                        "Result directory; --out overrides it.",
                        "results/NAME beside the scene, with the scene's NAME"));
    std::vector<std::string> maps = map_names();
    maps.insert(maps.begin(), "on");
    list.push_back(
        word_list("output.maps", FRANA_MEMBER(output.maps), {"off"}, maps,
                  "Maps to draw; on: what the flow did, in map view; on, max_depth_3d, mu: more beside it."));
    list.push_back(on_off("output.frames", FRANA_MEMBER(output.frames),
                          "Write depth and velocity at the frame interval as GeoTIFFs."));
    list.push_back(on_off("output.animation", FRANA_MEMBER(output.animation), "Write animation.mp4."));
    list.push_back(formats_key());
    list.push_back(number("output.checkpoint-interval", FRANA_MEMBER(output.checkpoint_interval), "s", Range{0, 1e6},
                          "Wall time between checkpoints for --resume; 0: only at the run's last step."));
    list.push_back(declare::decides_map(
        number("output.trace-threshold", FRANA_MEMBER(output.trace_threshold), "m", Range{1e-6, 100},
               "Depth above which ground counts as covered in outlines, covered area and run-out.")));
    list.push_back(choice("output.depth", FRANA_MEMBER(output.depth), {"vertical", k_normal_depth},
                          "Direction in which the flow's depth is measured in rasters, maps, classes and thresholds: "
                          "vertical, or normal to the bed. Gauges and cross-sections are always vertical."));
    add_pictures(list);
    add_extra_output(list);
    add_hazard(list);
    add_exposure(list);

    list.push_back(declare::holds(
        "polygons", text("observed.perimeter", FRANA_MEMBER(observed.perimeter), "file",
                         "Surveyed outline to compare with: any polygon layer, in its own CRS.", "no comparison")));
    add_survey(list);
    list.push_back(number("observed.threshold", FRANA_MEMBER(observed.threshold), "m", Range{1e-6, 100},
                          "Depth above which ground counts as covered in the comparison.", "output.trace-threshold"));
    list.push_back(number("observed.perimeter-error", FRANA_MEMBER(observed.perimeter_error), "m", Range{1e-3, 1e5},
                          "Calibrations: standard deviation of the survey's outline, across it.",
                          "the best agreement sets the scale"));
    list.push_back(number("observed.perimeter-bias", FRANA_MEMBER(observed.perimeter_bias), "m", Range{1e-3, 1e5},
                          "Calibrations: standard deviation of an offset that the whole outline has, drawn outside as "
                          "likely as inside.",
                          "none"));
    list.push_back(number("observed.deposit-error", FRANA_MEMBER(observed.deposit_error), "m", Range{1e-3, 1e3},
                          "Calibrations: standard deviation of the surveyed thickness of the deposit.",
                          "the best agreement sets the scale"));
    list.push_back(number("observed.error-length", FRANA_MEMBER(observed.error_length), "m", Range{1e-3, 1e6},
                          "Calibrations: length over which the errors of outline and deposit are alike, the integral "
                          "of their correlation from minus to plus infinity.",
                          "ten times perimeter-error, or ten cells"));
}

void add_scene(std::vector<Parameter>& list) {
    Parameter format = declare::parameter(
        "scene.format", "integer", FRANA_MEMBER(format),
        [](std::int64_t& target, const std::string& text) -> std::optional<ValueProblem> {
            const auto value = integer_from_text(text);
            if (!value || *value < 1) return ValueProblem{"is not a format", ""};
            if (*value > k_scene_format)
                return ValueProblem{"the file was written for a newer frana than this one", "Update frana"};
            target = *value;
            return std::nullopt;
        },
        [](std::int64_t value) { return std::to_string(value); });
    format.limits = "1 to " + std::to_string(k_scene_format);
    format.range = NumberRange{1, static_cast<double>(k_scene_format)};
    format.meaning = "Format of the file, written into a result's scene.ini.";
    list.push_back(format);
}

}  // namespace

const std::vector<Parameter>& scene_parameters() {
    // Made once: a study reads a scene for each member.
    static const std::vector<Parameter> k_list = [] {
        std::vector<Parameter> list;
        add_scene(list);
        add_terrain(list);
        add_release(list);
        add_inflow(list);
        add_material(list);
        add_structured(list);
        add_zones(list);
        add_entrainment(list);
        add_numerics(list);
        add_rest(list);
        add_input_parameters(list);
        refuse_implausible(list);
        return list;
    }();
    return k_list;
}

std::vector<Section> scene_sections() {
    return {
        {"scene", worded("Scene file"), "The scene file."},
        {"terrain", worded("Terrain"), "Terrain and working grid."},
        {"release", worded("Release"), "Release area and thickness."},
        {"inflow", worded("Inflow"), "Inflow through lines over time."},
        {"material", worded("Material"), "Material of the flow."},
        {"structured", worded("Structured model"), "Material of the structured model (material.model = structured)."},
        {"zones", worded("Values by place"), "Material values by place, where they differ from [material]."},
        {"entrainment", worded("Erosion and deposition"), "Erosion and deposition."},
        {"numerics", worded("Numerical method"), "Numerical method."},
        {"time", worded("Simulated time"), "Simulated time, stopping and frames."},
        {"output", worded("Output"), "Output files and pictures."},
        {"hazard", worded("Intensity classes"), "Intensity classes."},
        {"exposure", worded("Damage"), "Expected damage of the features of output.exposure."},
        {"observed", worded("Survey"), "The surveyed outline to compare with; [scar] is the same section."}};
}

}  // namespace frana
