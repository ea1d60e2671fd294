// SPDX-License-Identifier: Apache-2.0
#include "params/scene_parameters.h"

#include "params/declare.h"
#include "params/material_parameters.h"

namespace frana {
namespace {

using declare::choice;
using declare::number;
using declare::on_off;
using declare::Range;
using declare::text;
using declare::word_list;

/// A key that is known but whose feature does not exist yet: refused, never ignored.
template <class Member>
Parameter unavailable(const std::string& name, Member member, const std::string& meaning) {
    Parameter result = text(name, member, "file", meaning, "none");
    result.limits = "not available in this version";
    result.read = [](SceneSpec&, const std::string&) {
        return Refusal{"is not available in this version", "Remove the key"};
    };
    return result;
}

Parameter bounds_parameter() {
    Parameter result =
        text("terrain.bounds", FRANA_MEMBER(terrain.dtm), "list",
             "Part of the DTM to compute on: west south east north in the working CRS.", "the whole DTM");
    result.unit = "m";
    result.limits = "four numbers, west < east and south < north";
    result.read = [](SceneSpec& scene, const std::string& value) -> std::optional<Refusal> {
        std::vector<double> numbers;
        for (const std::string& word : words_of(value)) {
            const auto number = number_from_text(word);
            if (!number) return Refusal{"'" + word + "' is not a number", ""};
            numbers.push_back(*number);
        }
        if (numbers.size() != 4) return Refusal{"does not have four numbers", ""};
        const Bounds box{numbers[0], numbers[1], numbers[2], numbers[3]};
        if (!(box.west < box.east) || !(box.south < box.north))
            return Refusal{"is an empty rectangle", "Write west south east north, in this order"};
        scene.terrain.bounds = box;
        return std::nullopt;
    };
    result.write = [](const SceneSpec& scene) -> std::optional<std::string> {
        if (!scene.terrain.bounds) return std::nullopt;
        const Bounds& box = *scene.terrain.bounds;
        return shortest_text(box.west) + " " + shortest_text(box.south) + " " + shortest_text(box.east) +
               " " + shortest_text(box.north);
    };
    result.reset = [](SceneSpec& scene) { scene.terrain.bounds.reset(); };
    return result;
}

Parameter thickness_parameter() {
    Parameter result = declare::parameter(
        "release.thickness", "text", FRANA_MEMBER(release.thickness),
        [](std::optional<ThicknessSpec>& target, const std::string& value) -> std::optional<Refusal> {
            const auto spec = thickness_from_text(value);
            if (!spec) return Refusal{"is not understood", ""};
            if (spec->kind == ThicknessSpec::Kind::slip_surface)
                return Refusal{"is not available in this version",
                               "Give a number, attribute:NAME, raster:FILE or difference:PRE,POST"};
            if (spec->kind == ThicknessSpec::Kind::number && !(spec->metres > 0))
                return Refusal{"is not a thickness", "It must be greater than 0 m"};
            target = spec;
            return std::nullopt;
        },
        [](const ThicknessSpec& thickness) { return text_of(thickness); });
    result.unit = "m";
    result.limits =
        "a number greater than 0, attribute:NAME, raster:FILE, difference:PRE,POST (not available yet: "
        "slip-surface)";
    result.meaning =
        "Thickness of what fails: one number, a column of the perimeter, a raster, or a DTM before less one "
        "after.";
    result.absent = "required";
    return result;
}

Parameter particles_per_cell_parameter() {
    Parameter result = declare::parameter(
        "numerics.particles-per-cell", "integer", FRANA_MEMBER(numerics.particles_per_cell),
        [](std::int64_t& target, const std::string& value) -> std::optional<Refusal> {
            const auto count = integer_from_text(value);
            if (!count) return Refusal{"is not a whole number", ""};
            if (*count != 1 && *count != 4 && *count != 9 && *count != 16)
                return Refusal{"is not a square number from 1 to 16",
                               "4 is a good choice, 9 where fronts matter"};
            target = *count;
            return std::nullopt;
        },
        [](std::int64_t value) { return std::to_string(value); });
    result.limits = "1, 4, 9, 16";
    result.meaning = "Particles that fill one cell of the release at the start.";
    return result;
}

Parameter map_size_parameter() {
    Parameter result =
        text("output.map-size", FRANA_MEMBER(output.map_size), "text", "Width and height of the maps.");
    result.unit = "pixels";
    result.limits = "WIDTHxHEIGHT, 640x480 to 8000x8000";
    result.read = [](SceneSpec& scene, const std::string& value) -> std::optional<Refusal> {
        if (!size_from_text(value)) return Refusal{"is not a picture's size", "Write for example 1600x1200"};
        scene.output.map_size = value;
        return std::nullopt;
    };
    return result;
}

void add_terrain(std::vector<Parameter>& list) {
    list.push_back(text("terrain.dtm", FRANA_MEMBER(terrain.dtm), "file",
                        "Digital terrain model: any raster GDAL reads, elevations in its first band.",
                        "required"));
    list.push_back(
        text("terrain.crs", FRANA_MEMBER(terrain.crs), "text",
             "Working CRS, projected, in metres (EPSG:32632, WKT, PROJ); auto: the DTM's own if it is one, "
             "else the UTM zone it lies in; local: plain metres without a CRS."));
    list.push_back(text("terrain.dtm-crs", FRANA_MEMBER(terrain.dtm_crs), "text",
                        "CRS of the DTM where its file names none or a wrong one.", "the file's own"));
    list.push_back(number("terrain.cell-size", FRANA_MEMBER(terrain.cell_size), "m", Range{0.01, 1000},
                          "Side of the working grid's cells.", "the DTM's own"));
    list.push_back(bounds_parameter());
    list.push_back(
        choice("terrain.nodata-policy", FRANA_MEMBER(terrain.nodata_policy), {"stop", "wall", "fill"},
               "Flow that reaches ground without elevation: end the run, meet a wall, or cross a bed "
               "interpolated there beforehand."));
    list.push_back(
        choice("terrain.vertical-unit", FRANA_MEMBER(terrain.vertical_unit),
               {"auto", "metre", "foot", "us-survey-foot"},
               "Unit of the DTM's elevations; auto: as the file says, metres where it says nothing."));
    list.push_back(
        choice("terrain.resampling", FRANA_MEMBER(terrain.resampling),
               {"automatic", "nearest", "bilinear", "cubic", "average"},
               "How the DTM comes onto the working grid; automatic: copied where the cells coincide, "
               "averaged to coarser cells, bilinear to finer ones."));
    list.push_back(unavailable("terrain.friction-zones", FRANA_MEMBER(terrain.friction_zones),
                               "Polygons with their own friction."));
}

void add_release(std::vector<Parameter>& list) {
    list.push_back(
        text("release.perimeter", FRANA_MEMBER(release.perimeter), "file",
             "Outline of what fails: any polygon layer OGR reads, in its own CRS; FILE|layer=NAME picks one.",
             "required, unless thickness is a raster or a difference: then where that is positive"));
    list.push_back(thickness_parameter());
    list.push_back(choice("release.thickness-direction", FRANA_MEMBER(release.thickness_direction),
                          {"vertical", "normal"},
                          "Direction in which the thickness was measured: plumb, or normal to "
                          "the slope."));
    list.push_back(
        on_off("release.dtm-contains-release", FRANA_MEMBER(release.dtm_contains_release),
               "on: the DTM is the ground before the failure and the bed lies under the release; off: the "
               "release lies on top of the DTM."));
}

void add_numerics(std::vector<Parameter>& list) {
    list.push_back(choice("numerics.scheme", FRANA_MEMBER(numerics.scheme), {"default", "paper"},
                          "Set of numerical parts: frana's own, or the method as published."));
    list.push_back(choice("numerics.shape", FRANA_MEMBER(numerics.shape), {"auto", "bilinear", "quadratic"},
                          "Shape functions; auto: the scheme's (default: quadratic, paper: bilinear)."));
    list.push_back(
        choice("numerics.transfer", FRANA_MEMBER(numerics.transfer), {"auto", "pic", "flip", "apic"},
               "How velocities return to the particles; auto: the scheme's (default: apic, paper: pic)."));
    list.push_back(particles_per_cell_parameter());
    list.push_back(number("numerics.cfl", FRANA_MEMBER(numerics.cfl), "", Range{0, 1, true},
                          "Share of the largest stable time step."));
    list.push_back(on_off("numerics.well-balanced", FRANA_MEMBER(numerics.well_balanced),
                          "Keep still water still by a still level per node (default scheme).",
                          "on for scheme default, off for paper"));
    list.push_back(
        choice("numerics.slope-correction", FRANA_MEMBER(numerics.slope_correction),
               {"auto", "none", "normal", "surface"},
               "Form of the equations on steep ground; auto: normal for scheme default, none for paper."));
    list.push_back(
        on_off("numerics.curvature", FRANA_MEMBER(numerics.curvature),
               "Load of the motion over the bed's curvature: more friction in hollows, less over edges. "
               "Needs a slope correction."));
    list.push_back(choice("numerics.boundary", FRANA_MEMBER(numerics.boundary), {"open", "wall"},
                          "Edge of the working grid: material leaves and is counted, or is held."));
    list.push_back(number("numerics.gravity", FRANA_MEMBER(numerics.gravity), "m/s2", Range{0.1, 100},
                          "Acceleration of gravity."));
    list.push_back(number("numerics.minimum-depth", FRANA_MEMBER(numerics.minimum_depth), "m",
                          Range{1e-6, 10},
                          "Depth from which a cell counts as reached in maxima and arrival time."));
    list.push_back(choice("numerics.precision", FRANA_MEMBER(numerics.precision), {"double"},
                          "Arithmetic of the engine.", {"single"}));
}

void add_rest(std::vector<Parameter>& list) {
    list.push_back(
        number("time.end", FRANA_MEMBER(time.end), "s", Range{0, 1e6, true}, "Simulated time at most."));
    list.push_back(on_off("time.stop-when-still", FRANA_MEMBER(time.stop_when_still),
                          "End as soon as nothing moves any more."));
    list.push_back(
        number("time.stop-energy-share", FRANA_MEMBER(time.stop_energy_share), "", Range{0, 0.5},
               "End once kinetic energy is under this share of its peak; 0: never for this reason."));
    list.push_back(
        number("time.stop-moving-share", FRANA_MEMBER(time.stop_moving_share), "", Range{0, 0.5},
               "End once the moving volume is under this share of its peak; 0: never for this reason."));
    list.push_back(number("time.moving-speed", FRANA_MEMBER(time.moving_speed), "m/s", Range{0, 10, true},
                          "Speed from which volume counts as moving."));
    list.push_back(number("time.frame-interval", FRANA_MEMBER(time.frame_interval), "s", Range{0, 1e6, true},
                          "Simulated time between frames.", "a round number, at most sixty-one frames"));

    list.push_back(text("output.directory", FRANA_MEMBER(output.directory), "file",
                        "Result directory; --out overrides it.",
                        "results/NAME beside the scene, NAME being the scene's"));
    list.push_back(word_list("output.maps", FRANA_MEMBER(output.maps), {"on", "off"}, map_names(),
                             "Maps to draw; on: all."));
    list.push_back(on_off("output.frames", FRANA_MEMBER(output.frames),
                          "Write depth and velocity at the frame interval as GeoTIFFs."));
    list.push_back(on_off("output.animation", FRANA_MEMBER(output.animation), "Write animation.mp4."));
    list.push_back(word_list("output.formats", FRANA_MEMBER(output.formats), {}, {"geotiff"},
                             "Formats of rasters.", {"netcdf", "ascii"}));
    Parameter checkpoint = number("output.checkpoint-interval", FRANA_MEMBER(output.checkpoint_interval), "s",
                                  Range{0, 0}, "Wall time between checkpoints; 0: none.");
    checkpoint.limits = "0 (checkpoints are not available in this version)";
    list.push_back(checkpoint);
    list.push_back(number("output.trace-threshold", FRANA_MEMBER(output.trace_threshold), "m",
                          Range{1e-6, 100},
                          "Depth that counts as touched in the outlines, the covered area and the run-out."));
    list.push_back(map_size_parameter());
    list.push_back(
        text("output.title", FRANA_MEMBER(output.title), "text", "Title of the maps.", "the scene's name"));

    list.push_back(text("scar.perimeter", FRANA_MEMBER(scar.perimeter), "file",
                        "Surveyed outline to compare with: any polygon layer, in its own CRS.",
                        "no comparison"));
    list.push_back(number("scar.threshold", FRANA_MEMBER(scar.threshold), "m", Range{1e-6, 100},
                          "Depth that counts as touched in the comparison.", "output.trace-threshold"));
}

}  // namespace

std::vector<Parameter> scene_parameters() {
    std::vector<Parameter> list;
    add_terrain(list);
    add_release(list);
    add_material(list);
    add_entrainment(list);
    add_numerics(list);
    add_rest(list);
    return list;
}

std::vector<std::string> names_of(const std::vector<Parameter>& parameters) {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters) names.push_back(parameter.name());
    return names;
}

std::vector<Section> scene_sections() {
    return {{"terrain", "The ground and the working grid."},
            {"release", "What fails, and how thick it is."},
            {"material", "What it is made of."},
            {"entrainment", "What it takes from its bed and leaves on it."},
            {"numerics", "How it is computed."},
            {"time", "How long."},
            {"output", "What is written."},
            {"scar", "The surveyed outline to compare with."}};
}

std::vector<std::string> map_names() {
    return {"max_depth",    "max_velocity", "final_depth",    "arrival_time",
            "max_pressure", "max_depth_3d", "max_velocity_3d"};
}

}  // namespace frana
