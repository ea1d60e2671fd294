// SPDX-License-Identifier: Apache-2.0
#include "params/keys/scene_parameters.h"

#include <algorithm>

#include "params/keys/declare.h"
#include "params/keys/input_parameters.h"
#include "params/keys/material_parameters.h"
#include "params/keys/output_parameters.h"
#include "params/keys/picture_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/keys/site_parameters.h"
#include "params/keys/structured_parameters.h"

namespace frana {
namespace {

using declare::choice;
using declare::number;
using declare::on_off;
using declare::Range;
using declare::text;
using declare::word_list;

Parameter particles_per_cell_parameter() {
    Parameter result = declare::parameter(
        "numerics.particles-per-cell", "integer", FRANA_MEMBER(numerics.particles_per_cell),
        [](std::int64_t& target, const std::string& value) -> std::optional<ValueProblem> {
            const auto count = integer_from_text(value);
            if (!count) return ValueProblem{"is not a whole number", ""};
            if (*count != 1 && *count != 4 && *count != 9 && *count != 16)
                return ValueProblem{"is not a square number from 1 to 16", "4 is a good choice, 9 where fronts matter"};
            target = *count;
            return std::nullopt;
        },
        [](std::int64_t value) { return std::to_string(value); });
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
        "Error allowed by estimate for area, run-out, greatest depth and speed, gauges and cross-sections, as a "
        "fraction of "
        "each: coarser cells are computed first and refined only as far as the estimate asks, at most to the scene's "
        "own.";
    result.absent = "the scene's own cells at once, without an estimate";
    return result;
}

void add_numerics(std::vector<Parameter>& list) {
    list.push_back(choice("numerics.scheme", FRANA_MEMBER(numerics.scheme), {"default", "paper"},
                          "Numerical scheme: frana's own, or the method as published."));
    list.push_back(choice("numerics.shape", FRANA_MEMBER(numerics.shape), {"auto", "bilinear", "quadratic"},
                          "Shape functions; auto: the scheme's (default: quadratic, paper: bilinear)."));
    list.push_back(choice("numerics.transfer", FRANA_MEMBER(numerics.transfer), {"auto", "pic", "flip", "apic"},
                          "Velocity transfer to the particles; auto: the scheme's (default: apic, paper: pic)."));
    list.push_back(particles_per_cell_parameter());
    list.push_back(number("numerics.cfl", FRANA_MEMBER(numerics.cfl), "", Range{0, 1, true},
                          "Courant number: fraction of the largest stable time step.",
                          shortest_text(default_courant(true)) + ", " + shortest_text(default_courant(false)) +
                              " for scheme paper, with Bingham stress, and for material.model = structured"));
    list.push_back(on_off("numerics.well-balanced", FRANA_MEMBER(numerics.well_balanced),
                          "Keep still water at rest by a reference level per node (default scheme).",
                          "on for scheme default, off for paper"));
    list.push_back(choice("numerics.slope-correction", FRANA_MEMBER(numerics.slope_correction),
                          {"auto", "none", "normal", "surface"},
                          "Form of the equations on steep ground; auto: normal for scheme default, none for paper."));
    list.push_back(
        on_off("numerics.curvature", FRANA_MEMBER(numerics.curvature),
               "Motion along a curved bed: the speed along the bed is kept where the slope changes, with more friction "
               "in hollows and less over edges; off: the speed in map view is kept. Needs a slope correction.",
               "on with a slope correction"));
    list.push_back(on_off("numerics.flight", FRANA_MEMBER(numerics.flight),
                          "Where the bed falls away faster than a free fall, material flies without friction or "
                          "pressure and loses the velocity normal to the bed on landing; off: it stays on the bed. "
                          "Needs curvature, scheme default and transfer apic.",
                          "on with curvature, scheme default and transfer apic"));
    list.push_back(
        number("numerics.flight-slope", FRANA_MEMBER(numerics.flight_slope), "degrees", Range{0, 89},
               "Smallest slope of an edge at which material takes off, in the direction of motion; 0: any bump."));
    list.push_back(declare::option("numerics.boundary", FRANA_MEMBER(numerics.boundary),
                                   declare::Words<Boundary>{{"open", Boundary::open}, {"wall", Boundary::wall}},
                                   "Edge of the working grid: open (outflow is counted) or a wall."));
    list.push_back(number("numerics.gravity", FRANA_MEMBER(numerics.gravity), "m/s2", Range{0.1, 100},
                          "Acceleration of gravity."));
    list.push_back(
        number("numerics.minimum-depth", FRANA_MEMBER(numerics.minimum_depth), "m", Range{1e-6, 10},
               "Depth above which a cell counts as reached in maxima and arrival time. Film thinner than ten "
               "times it, at most 10 cm, has fewer particles."));
    list.push_back(choice("numerics.precision", FRANA_MEMBER(numerics.precision), {"double"},
                          "Arithmetic of the engine.", {"single"}));
    list.push_back(accuracy_parameter());
}

void add_rest(std::vector<Parameter>& list) {
    list.push_back(number("time.end", FRANA_MEMBER(time.end), "s", Range{0, 1e6, true}, "Longest simulated time."));
    list.push_back(
        on_off("time.stop-when-still", FRANA_MEMBER(time.stop_when_still), "End as soon as all material is at rest."));
    list.push_back(number("time.stop-energy-fraction", FRANA_MEMBER(time.stop_energy_fraction), "", Range{0, 0.5},
                          "End once the kinetic energy is below this fraction of its peak; 0: off."));
    list.push_back(number("time.stop-moving-fraction", FRANA_MEMBER(time.stop_moving_fraction), "", Range{0, 0.5},
                          "End once the moving volume is below this fraction of its peak; 0: off."));
    list.push_back(number("time.stop-momentum", FRANA_MEMBER(time.stop_momentum), "", Range{0, 0.5},
                          "End once the momentum, the sum of mass times speed, is below this fraction of its peak; 0: "
                          "off. 0.05 is customary for avalanches."));
    list.push_back(number("time.moving-speed", FRANA_MEMBER(time.moving_speed), "m/s", Range{0, 10, true},
                          "Speed above which volume counts as moving."));
    list.push_back(number("time.stop-change", FRANA_MEMBER(time.stop_change), "", Range{0, 0.5},
                          "End once run-out (or by a cell) and area over output.trace-threshold have changed by no "
                          "more than this fraction over time.stop-window, and no more than four times this fraction of "
                          "the volume has changed cell; 0: off."));
    list.push_back(
        number("time.stop-window", FRANA_MEMBER(time.stop_window), "", Range{0.05, 1},
               "Window of time.stop-change: fraction of the time since the last release or inflow, at least 10 s."));
    list.push_back(number("time.frame-interval", FRANA_MEMBER(time.frame_interval), "s", Range{0, 1e6, true},
                          "Simulated time between frames; each is the first state at or after its time.",
                          "a round number, at most sixty-one frames"));

    list.push_back(text("output.directory", FRANA_MEMBER(output.directory), "folder",
                        "Result directory; --out overrides it.",
                        "results/NAME beside the scene, with the scene's NAME"));
    list.push_back(word_list("output.maps", FRANA_MEMBER(output.maps), {"on", "off"}, map_names(),
                             "Maps to draw; on: all of the result."));
    list.push_back(on_off("output.frames", FRANA_MEMBER(output.frames),
                          "Write depth and velocity at the frame interval as GeoTIFFs."));
    list.push_back(on_off("output.animation", FRANA_MEMBER(output.animation), "Write animation.mp4."));
    list.push_back(word_list("output.formats", FRANA_MEMBER(output.formats), {},
                             {"geotiff", "netcdf", "zarr", "ascii", "particles-gpkg", "particles-vtp"},
                             "Formats: GeoTIFF is always written; netcdf and zarr add the frames as one file each, "
                             "particles-gpkg and particles-vtp the particles of each frame as GeoPackage points and "
                             "VTK polydata; ascii writes the AvaFrame rasters as ESRI ASCII grids."));
    list.push_back(number("output.checkpoint-interval", FRANA_MEMBER(output.checkpoint_interval), "s", Range{0, 1e6},
                          "Wall time between checkpoints for --resume; 0: only at the run's last step."));
    list.push_back(number("output.trace-threshold", FRANA_MEMBER(output.trace_threshold), "m", Range{1e-6, 100},
                          "Depth above which ground counts as covered in outlines, covered area and run-out."));
    list.push_back(choice("output.depth", FRANA_MEMBER(output.depth), {"vertical", k_normal_depth},
                          "Direction in which the flow's depth is measured in rasters, maps, classes and thresholds: "
                          "vertical, or normal to the bed. Gauges and cross-sections are always vertical."));
    add_pictures(list);
    add_extra_output(list);
    add_hazard(list);

    list.push_back(declare::on_map(declare::holds(
        "polygons", text("observed.perimeter", FRANA_MEMBER(observed.perimeter), "file",
                         "Surveyed outline to compare with: any polygon layer, in its own CRS.", "no comparison"))));
    add_survey(list);
    list.push_back(number("observed.threshold", FRANA_MEMBER(observed.threshold), "m", Range{1e-6, 100},
                          "Depth above which ground counts as covered in the comparison.", "output.trace-threshold"));
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
        return list;
    }();
    return k_list;
}

const Parameter* find_parameter(const std::vector<Parameter>& parameters, const std::string& name) {
    const auto found =
        std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name() == name; });
    return found == parameters.end() ? nullptr : &*found;
}

std::vector<std::string> names_of(const std::vector<Parameter>& parameters) {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters) names.push_back(parameter.name());
    return names;
}

std::vector<Section> scene_sections() {
    return {{"scene", "The scene file."},
            {"terrain", "Terrain and working grid."},
            {"release", "Release area and thickness."},
            {"inflow", "Inflow through lines over time."},
            {"material", "Material of the flow."},
            {"structured", "Material of the structured model (material.model = structured)."},
            {"zones", "Material values by place, where they differ from [material]."},
            {"entrainment", "Erosion and deposition."},
            {"numerics", "Numerical method."},
            {"time", "Simulated time, stopping and frames."},
            {"output", "Output files and pictures."},
            {"hazard", "Intensity classes."},
            {"observed", "The surveyed outline to compare with; [scar] is the same section."}};
}

}  // namespace frana
