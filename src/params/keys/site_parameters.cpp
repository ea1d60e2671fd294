// SPDX-License-Identifier: Apache-2.0
#include "params/keys/site_parameters.h"

#include <limits>

#include "params/keys/zone_keys.h"

namespace frana {
namespace {

using declare::choice;
using declare::holds;
using declare::number;
using declare::on_map;
using declare::on_off;
using declare::Range;
using declare::source;
using declare::text;
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

Parameter thickness_parameter() {
    Parameter result = declare::parameter(
        "release.thickness", "text", FRANA_MEMBER(release.thickness),
        [](std::optional<ThicknessSpec>& target, const std::string& value) -> std::optional<ValueProblem> {
            const auto spec = thickness_from_text(value);
            if (!spec) return ValueProblem{"is not understood", ""};
            if (spec->kind == ThicknessSpec::Kind::number && !(spec->metres > 0))
                return ValueProblem{"is not a thickness", "It must be greater than 0 m"};
            target = spec;
            return std::nullopt;
        },
        [](const ThicknessSpec& thickness) { return text_of(thickness); });
    result.unit = "m";
    result.limits =
        "a number greater than 0, attribute:NAME, raster:FILE, difference:PRE,POST, slip-surface:FILE, "
        "slip-surface, phases:SOLIDS,FLUID";
    result.range = NumberRange{0, std::numeric_limits<double>::max(), true};
    result.choices = {"slip-surface"};
    result.forms = {"attribute:", "raster:", "difference:", "slip-surface:", "phases:"};
    result.meaning =
        "Thickness of the release: one number, a column of the perimeter, a raster, a DTM before minus one after, the "
        "DTM minus a raster of the slip surface's elevation, or minus one fitted to each polygon; structured model: "
        "the sum of two rasters, depths of solids and of fluid.";
    result.absent = "required, unless there is an inflow";
    result.map_files = [](SceneSpec& scene, const FileMap& map) {
        if (!scene.release.thickness) return;
        ThicknessSpec& thickness = *scene.release.thickness;
        if (!thickness.raster.empty()) thickness.raster = map(thickness.raster);
        if (!thickness.post.empty()) thickness.post = map(thickness.post);
    };
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

}  // namespace

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
    list.push_back(number("terrain.cell-size", FRANA_MEMBER(terrain.cell_size), "m", Range{0.01, 1000},
                          "Cell size of the working grid.", "the DTM's own"));
    list.push_back(bounds_parameter());
    list.push_back(choice("terrain.nodata-policy", FRANA_MEMBER(terrain.nodata_policy), {"stop", "wall", "fill"},
                          "Where the flow reaches ground without elevation: end the run, treat it as a wall, or "
                          "interpolate the bed beforehand."));
    list.push_back(choice("terrain.vertical-unit", FRANA_MEMBER(terrain.vertical_unit),
                          {"auto", "metre", "decimetre", "centimetre", "millimetre", "foot", "us-survey-foot"},
                          "Unit of the DTM's elevations; auto: as stated in the file, otherwise metres."));
    list.push_back(choice("terrain.resampling", FRANA_MEMBER(terrain.resampling),
                          {"automatic", "nearest", "bilinear", "cubic", "average"},
                          "Resampling of the DTM to the working grid; automatic: copied if the cells coincide, "
                          "averaged to coarser cells, bilinear to finer ones."));
    list.push_back(text("terrain.source", FRANA_MEMBER(terrain.source), "text",
                        "Source of the elevations, named on maps: survey, owner, date, licence.",
                        "the DTM's file name"));
    list.push_back(on_map(
        holds("polygons",
              text("terrain.friction-zones", FRANA_MEMBER(terrain.friction_zones), "file",
                   "Polygons with different material values, in their own CRS; [zones] names the columns.", "none"))));
    list.push_back(on_map(holds(
        "polygons", text("terrain.obstacles", FRANA_MEMBER(terrain.obstacles), "file",
                         "Polygons of dams, fills and embankments that raise the bed, in their own CRS.", "none"))));
    list.push_back(source("terrain.obstacle-height", FRANA_MEMBER(terrain.obstacle_height), "m", Range{0, 1000, true},
                          {Given::number, Given::attribute}, "Height of the obstacles above the DTM.",
                          "required with terrain.obstacles"));
    list.push_back(on_map(holds(
        "polygons", text("terrain.walls", FRANA_MEMBER(terrain.walls), "file",
                         "Polygons of buildings and walls that the flow cannot overtop, in their own CRS.", "none"))));
    list.push_back(error_parameter());
}

void add_release(std::vector<Parameter>& list) {
    list.push_back(
        holds("polygons", text("release.perimeter", FRANA_MEMBER(release.perimeter), "file",
                               "Outline of the release area: any polygon layer that OGR reads, in its own CRS; "
                               "FILE|layer=NAME selects a layer.",
                               "required, unless thickness comes from rasters: then where it is positive")));
    list.push_back(thickness_parameter());
    list.push_back(choice("release.thickness-direction", FRANA_MEMBER(release.thickness_direction),
                          {"vertical", "normal"},
                          "Direction in which the thickness is measured: vertical, or normal to the slope."));
    list.push_back(on_off("release.dtm-contains-release", FRANA_MEMBER(release.dtm_contains_release),
                          "on: the DTM is the ground before the failure, and the bed lies under the release; off: the "
                          "release lies on top of the DTM."));
    list.push_back(source(
        "release.volume", FRANA_MEMBER(release.volume), "m3", Range{0, 1e12, true}, {Given::number, Given::attribute},
        "Volume of the release: thicknesses are scaled so that the whole release, or each polygon, has this volume.",
        "from the thickness"));
    list.push_back(source("release.start", FRANA_MEMBER(release.start), "s", Range{0, 1e6},
                          {Given::number, Given::attribute}, "Time of failure.", "0"));
    list.push_back(source("release.velocity", FRANA_MEMBER(release.velocity), "m/s", Range{0, 200},
                          {Given::number, Given::attribute}, "Initial speed along the bed.", "0"));
    list.push_back(source("release.direction", FRANA_MEMBER(release.direction), "degrees", Range{0, 360},
                          {Given::number, Given::attribute},
                          "Azimuth of the initial velocity, clockwise from grid north.",
                          "down the mean slope of each polygon"));
    list.push_back(source(
        "release.slip-depth", FRANA_MEMBER(release.slip_depth), "m", Range{0, 1000, true},
        {Given::number, Given::attribute},
        "Greatest depth of a fitted slip surface below the surface that spans the perimeter; this or release.volume.",
        "from release.volume"));
    list.push_back(choice("release.slip-shape", FRANA_MEMBER(release.slip_shape), {"auto", "ellipsoid", "base-level"},
                          "Shape of a fitted slip surface; auto: ellipsoid if the whole perimeter is visible from its "
                          "centroid, otherwise sloping local base level."));
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
                          "Azimuth of the inflow, clockwise from grid north.",
                          "normal to the line, towards its lower side"));
}

void add_zones(std::vector<Parameter>& list) {
    for (const ZoneKey& key : zone_keys())
        list.push_back(source(
            key.name, [member = key.source](auto& scene) -> auto& { return scene.zones.*member; }, key.unit, key.range,
            {Given::attribute, Given::raster}, key.meaning, "the material's own everywhere"));
    list.push_back(
        choice("zones.beyond-dtm", FRANA_MEMBER(zones.beyond_dtm), {"stop", "clip"},
               "Zone polygons that reach beyond the working grid: refuse them, or use the part on the grid."));
}

}  // namespace frana
