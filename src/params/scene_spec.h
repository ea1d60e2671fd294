// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/grid_spec.h"
#include "params/thickness.h"

namespace frana {

/// Where a parameter's value came from, in rising order of precedence.
enum class Origin { default_value, preset, scene_file, command_line };

/// [terrain]
struct TerrainSpec {
    std::string dtm;
    std::string crs = "auto";
    std::optional<std::string> dtm_crs;
    std::optional<double> cell_size;
    std::optional<Bounds> bounds;
    std::string nodata_policy = "stop";
    std::string vertical_unit = "auto";
    std::string resampling = "automatic";
    std::optional<std::string> friction_zones;
};

/// [release]
struct ReleaseSpec {
    std::optional<std::string> perimeter;
    std::optional<ThicknessSpec> thickness;
    std::string thickness_direction = "vertical";
    bool dtm_contains_release = false;
};

/// [material], in the units a user writes (degrees).
struct MaterialSpec {
    std::optional<std::string> preset;
    std::string model = "voellmy-bingham";
    double density = 2000;
    std::optional<double> friction_angle;
    std::optional<double> friction_coefficient;
    std::optional<double> turbulence;  ///< none: the turbulent part is off
    double viscosity = 0;
    double yield_stress = 0;
    double surface_pressure = 0;
    double yield_regularisation = 0.01;
    std::string yield_ratio = "exact";
};

/// [numerics]
struct NumericsSpec {
    std::string scheme = "default";
    std::string shape = "auto";
    std::string transfer = "auto";
    std::int64_t particles_per_cell = 4;
    double cfl = 0.5;
    std::optional<bool> well_balanced;
    std::string slope_correction = "auto";
    std::string boundary = "open";
    double gravity = 9.81;
    double minimum_depth = 0.01;
    std::string precision = "double";
};

/// [time]
struct TimeSpec {
    double end = 300;
    bool stop_when_still = true;
    std::optional<double> frame_interval;
};

/// [output]
struct OutputSpec {
    std::optional<std::string> directory;
    std::vector<std::string> maps{"on"};
    bool frames = true;
    bool animation = true;
    std::vector<std::string> formats{"geotiff"};
    double checkpoint_interval = 0;
    double trace_threshold = 0.1;
    std::string map_size = "1600x1200";
    std::optional<std::string> title;
    std::string names = "frana";
    bool report = true;
    std::optional<std::string> gauges;
    std::optional<std::string> sections;
    std::optional<std::string> profiles;
    std::optional<double> sample_interval;
};

/// [hazard]
struct HazardSpec {
    std::optional<std::string> scheme;
    std::vector<double> depth_limits, velocity_limits, flux_limits, pressure_limits;
};

/// [scar]
struct ScarSpec {
    std::optional<std::string> perimeter;
    std::optional<std::string> front;
    std::optional<std::string> deposit;
    std::optional<double> threshold;
};

/// A scene as its file says it: validated one by one, paths absolute, units as written. Nothing has been
/// opened yet.
struct SceneSpec {
    std::string file;  ///< the scene file, absolute
    TerrainSpec terrain;
    ReleaseSpec release;
    MaterialSpec material;
    NumericsSpec numerics;
    TimeSpec time;
    OutputSpec output;
    HazardSpec hazard;
    ScarSpec scar;
    std::map<std::string, Origin> origins;  ///< "section.key" -> where its value came from; absent: default

    [[nodiscard]] Origin origin_of(const std::string& name) const {
        const auto found = origins.find(name);
        return found == origins.end() ? Origin::default_value : found->second;
    }
};

/// mu = tan(phi): the one place where the friction angle leaves degrees.
/// Only for a spec that read_scene accepted, which has one of the two.
double friction_coefficient(const MaterialSpec& material);
/// `auto` resolved: `normal` for the default scheme, `none` for the paper's.
std::string slope_correction(const NumericsSpec& numerics);
/// Resolved: on for the default scheme, off for the paper's.
bool well_balanced(const NumericsSpec& numerics);
/// The interval of frames [s]: as given, else a round number near a sixtieth of the end time; 0 where nothing
/// needs frames.
double frame_interval(const SceneSpec& scene);
/// What to call a scene: its file's name, or its folder's where the file is just "scene.ini".
std::string scene_name(const SceneSpec& scene);
/// The result directory: as given, else results/NAME beside the scene file.
std::string output_directory(const SceneSpec& scene);
/// The depth that counts as touched when compared with the scar [m]: as given, else the trace's.
double scar_threshold(const SceneSpec& scene);

}  // namespace frana
