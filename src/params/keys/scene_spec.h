// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/friction_table.h"
#include "analysis/hazard.h"
#include "core/default_values.h"
#include "core/grid_spec.h"
#include "params/grammar/ini_file.h"
#include "params/keys/result_rasters.h"
#include "params/keys/shared_values.h"
#include "params/keys/thickness.h"

namespace frana {

/// The source of a parameter's value, in rising order of precedence.
enum class Origin { default_value, preset, friction_table, scene_file, command_line };

/// A field of error added to the elevations: analysis/gaussian_field.h.
struct TerrainErrorSpec {
    double standard_deviation = 0;  ///< [m]
    double range = 0;               ///< [m]
    std::int64_t seed = 0;
};

/// [terrain]
struct TerrainSpec {
    std::string dtm;
    std::string crs = "auto";
    std::optional<std::string> dtm_crs;
    std::optional<double> cell_size;
    std::optional<Bounds> bounds;
    std::optional<double> nodata_value;
    std::string vertical_unit = "auto";
    std::optional<std::string> source;  ///< of the elevations, as named on maps
    std::optional<std::string> friction_zones;
    std::optional<std::string> obstacles;
    std::optional<SourceSpec> obstacle_height;
    std::optional<std::string> walls;
    std::optional<TerrainErrorSpec> error;
};

/// How to read a vector file, besides its path.
struct LayerSpec {
    std::optional<std::string> filter;  ///< SQL condition on its attributes
    std::optional<std::string> crs;     ///< replaces that of the file
};

/// [release]
struct ReleaseSpec {
    std::optional<std::string> perimeter;
    LayerSpec perimeter_layer;
    std::optional<ThicknessSpec> thickness;
    std::string thickness_direction = "vertical";
    bool dtm_contains_release = false;
    std::optional<SourceSpec> level;  ///< instead of the thickness
    std::optional<SourceSpec> volume, start, velocity, direction, slip_depth;
};

/// [inflow]
struct InflowSpec {
    std::optional<std::string> line, hydrograph;
    std::optional<double> direction;  ///< degrees clockwise from grid north; none: downhill
};

/// [zones]
struct ZonesSpec {
    std::optional<SourceSpec> friction_angle, friction_coefficient, turbulence, cohesion, erodible_depth,
        detrainment_coefficient;
};

/// Keys of [material]: bed friction by place after a published table.
struct FrictionTableSpec {
    std::optional<std::string> name;        ///< of share/friction, or a file of one's own
    std::optional<FrictionTable> resolved;  ///< what it says
    std::optional<double> return_period;    ///< [years]
    std::optional<double> volume;           ///< [m3]; none: the release's
    std::vector<double> altitude_limits;    ///< [m]; empty: the table's
    std::optional<std::string> forest;      ///< polygons
    double friction_factor = 1, turbulence_factor = 1;
};

/// [structured], for material.model = structured; in the units of scene files (degrees).
struct StructuredSpec : StructuredValues {
    std::optional<std::string> phases;
    std::optional<std::string> zones;
    std::optional<SourceSpec> initial_fluid_depth;
    std::optional<SourceSpec> rain;                                                    ///< [mm/h]
    std::optional<SourceSpec> soil_conductivity, soil_suction, soil_moisture_deficit;  ///< [mm/h], [m], [-]
    std::optional<SourceSpec> solid_fraction = SourceSpec{SourceSpec::Kind::number, SolidValues{}.solid_fraction, {}};
    std::optional<SourceSpec> confined_fraction =
        SourceSpec{SourceSpec::Kind::number, SolidValues{}.confined_fraction, {}};
    std::optional<SourceSpec> grain_density = SourceSpec{SourceSpec::Kind::number, SolidValues{}.grain_density, {}};
    std::optional<SourceSpec> grain_diameter = SourceSpec{SourceSpec::Kind::number, SolidValues{}.grain_diameter, {}};
    std::optional<SourceSpec> cohesion, internal_friction_angle, bed_friction_angle;
    double dilatancy_angle = 0;
};

/// [time]
struct TimeSpec : TimeValues {
    double end = 300;
    double stop_change = 0.005;
    std::optional<double> frame_interval;
};

/// output.language: that of the locale of the process that prepares the scene.
inline constexpr const char* k_language_of_locale = "auto";
/// Value of output.depth.
inline constexpr const char* k_normal_depth = "normal";

/// [output]
struct OutputSpec {
    std::optional<std::string> directory;
    std::vector<std::string> maps{"on"};
    bool frames = true;
    bool animation = true;
    std::vector<std::string> formats{"geotiff"};
    double checkpoint_interval = 600;
    double trace_threshold = k_trace_threshold;
    std::string depth = "vertical";  ///< or "normal" to the bed: of rasters, maps and classes
    std::string map_size = "auto";
    std::vector<std::string> map_formats{"png"};
    std::optional<std::string> map_background, map_context;
    std::optional<std::string> map_attribution;
    std::optional<double> map_scale;  ///< n of 1 : n
    std::optional<double> map_turn;   ///< [degrees]
    std::optional<std::string> map_author, map_logo, map_date;
    bool charts = true;
    std::optional<std::string> title;
    std::string language = k_language_of_locale;
    std::string extent = "auto";
    bool report = true;
    std::optional<std::string> gauges;
    std::optional<std::string> sections;
    std::optional<std::string> profiles;
    std::optional<double> sample_interval;
    // Of the maps of probability that a study of many runs writes.
    std::vector<double> depth_thresholds{0.1, 0.5, 2};
    std::vector<double> velocity_thresholds{1, 5};
    std::vector<double> pressure_thresholds, momentum_flux_thresholds;
    std::vector<std::string> rasters;     ///< more than a run writes by itself
    std::optional<std::string> exposure;  ///< buildings, roads, people
    std::optional<std::string> exposure_name, exposure_count;
};

/// [hazard]
struct HazardSpec {
    std::optional<std::string> scheme;     ///< a name, or a file of one's own
    std::optional<HazardScheme> resolved;  ///< what it says; minimum depth as in the file: none
    std::optional<std::string> process;    ///< by whose matrix a region has degrees of hazard
    std::optional<double> minimum_depth;   ///< of a class [m]
};

/// [exposure]: what an event costs the features of output.exposure
struct ExposureSpec {
    std::optional<std::string> fragility, value, kind;
};

/// [observed], of which [scar] is a second name
struct ObservedSpec {
    std::optional<std::string> perimeter;
    LayerSpec perimeter_layer;
    std::optional<std::string> front;
    std::optional<std::string> deposit;
    std::optional<double> threshold;
    std::optional<double> perimeter_error, perimeter_bias, deposit_error;  ///< standard deviations [m]
    std::optional<double> error_length;                                    ///< [m]
};

/// Format of scene files; increases when the meaning of a key changes. A file without a format is of the first.
inline constexpr std::int64_t k_scene_format = 1;

/// A scene as specified in its file: each value validated, paths absolute, units as written. No file has been opened
/// yet.
struct SceneSpec {
    std::string file;  ///< the scene file, absolute
    std::int64_t format = k_scene_format;
    TerrainSpec terrain;
    ReleaseSpec release;
    InflowSpec inflow;
    Material material;
    FrictionTableSpec friction_table;
    StructuredSpec structured;
    ZonesSpec zones;
    Entrainment entrainment;
    Numerics numerics;
    TimeSpec time;
    OutputSpec output;
    HazardSpec hazard;
    ExposureSpec exposure;
    ObservedSpec observed;
    std::map<std::string, Origin> origins;  ///< "section.key" -> source of its value; absent: default

    [[nodiscard]] Origin origin_of(const std::string& name) const {
        const auto found = origins.find(name);
        return found == origins.end() ? Origin::default_value : found->second;
    }
};

/// Whether a friction table gives the quantity of this key.
inline bool gives_by_table(const std::string& key) {
    return key == "material.friction-angle" || key == "material.friction-coefficient" || key == "material.turbulence";
}
/// Whether a key names a friction table or says how it is read.
bool reads_friction_table(const std::string& key);
/// Returns the interval of frames [s]: as given, else infinity, of frames that follow the motion; 0 if nothing
/// needs frames.
double frame_interval(const SceneSpec& scene);
/// Returns the name of a scene: that of its file, or of its folder if the file is just "scene.ini".
std::string scene_name(const SceneSpec& scene);
/// Returns the result directory: as given, else results/NAME beside the scene file.
std::string output_directory(const SceneSpec& scene);
/// Returns the depth threshold of the comparison with the scar [m]: as given, else that of the trace.
double observed_threshold(const SceneSpec& scene);
/// Returns the depth above which ground has a class of hazard [m].
double hazard_minimum_depth(const SceneSpec& scene);

}  // namespace frana
