// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/default_values.h"
#include "core/geometry.h"
#include "core/grid_spec.h"
#include "core/raster.h"
#include "core/words/warning.h"
#include "params/keys/shared_values.h"
#include "physics/parameters.h"

namespace frana {

/// A property of the solids that varies from place to place: a raster on the working grid, in the unit of SolidValues;
/// where it is NaN the uniform value applies.
struct SolidZone {
    double SolidValues::*value;
    Raster raster;
};

/// The same of the soil; where any is NaN the ground is tight.
struct SoilZone {
    double GreenAmpt::*value;
    Raster raster;
};

/// Rain by place from one time to another [s]: intensity [m/s]; NaN: none.
struct RainMap {
    double from = 0, until = 0;
    Raster intensity;
};

/// Composition of a structured flow: blocks of solids with the fluid they confine, or fluid alone.
struct StructuredMaterial : StructuredValues, SolidValues {
    bool solids = false;       ///< false: the release is fluid, and no parameter of solids is read
    double sin_dilatancy = 0;  ///< sin(psi) [-]
    PorePressure pores;        ///< of solids, each with its own density and hydrostatic ratio
    std::vector<SolidZone> zones;
    std::optional<Raster> initial_fluid;  ///< depth of free fluid at the start [m]; NaN: none
    bool more_fluid = false;              ///< there is fluid besides the release: initial, inflow or rain
    Rain rain;                            ///< with maps it has their times and none of its own
    std::vector<RainMap> rain_maps;
    std::optional<GreenAmpt> soil;  ///< none: tight
    std::vector<SoilZone> soil_zones;
};

/// Parameters that vary from place to place: rasters on the working grid. NaN: the uniform value of Material (and of
/// Entrainment) applies. A missing raster costs nothing.
struct MaterialZones {
    std::optional<Raster> friction_coefficient;     ///< tan(phi) [-], >= 0
    std::optional<Raster> turbulence;               ///< Voellmy xi [m/s2], > 0; infinity: off
    std::optional<Raster> cohesion;                 ///< [Pa], >= 0
    std::optional<Raster> erodible_depth;           ///< vertical [m], >= 0
    std::optional<Raster> detrainment_coefficient;  ///< [Pa], >= 0
};
/// All of them, by the quantities of params/keys/zone_keys.cpp.
struct ZoneRaster {
    const char* what;
    std::optional<Raster> MaterialZones::*raster;
    bool of_bed_friction = true;
};
inline constexpr ZoneRaster k_zone_rasters[] = {{"friction", &MaterialZones::friction_coefficient},
                                                {"turbulence", &MaterialZones::turbulence},
                                                {"cohesion", &MaterialZones::cohesion},
                                                {"erodible depth", &MaterialZones::erodible_depth, false},
                                                {"detrainment", &MaterialZones::detrainment_coefficient, false}};

struct TimeControl : TimeValues {
    double end = 0;  ///< [s]; src/params sets the default of scene files
    /// End once run-out and area above the threshold have changed by no more than this fraction over the window, and
    /// four times this fraction of the volume has moved to other cells; 0: never.
    double stop_change = 0;
    double trace_threshold = k_trace_threshold;  ///< depth from which a cell belongs to that area [m]
    double frame_interval = 0;                   ///< [s]; 0: no frames; infinite: by the motion
};

/// What a raster of thicknesses contains [m3].
struct FileVolume {
    double inside = 0;  ///< the perimeter
    double all = 0;     ///< 0 if it is not known: a raster too large to be read whole
};

/// One area that fails, in map coordinates of the working CRS.
struct ReleaseArea {
    MultiPolygon outline;
    double thickness = 0;                      ///< [m]; ignored where a raster is given
    std::optional<Raster> thickness_raster{};  ///< on the working grid; NaN or <= 0: nothing released there
    std::optional<double> volume{};            ///< [m3]: the thickness is scaled to release this volume
    bool normal_to_bed = false;                ///< thickness measured normal to the bed; false: vertically
    /// Elevation of a still surface [m]: the thickness is that over the bed that is computed with, and the raster only
    /// tells it. None: the thickness as given.
    std::optional<double> level{};
    double start = 0;  ///< time of failure [s]; its material is at rest until then
    double speed = 0;  ///< at the start, along the bed [m/s]
    /// Direction of that speed, clockwise from the grid's north [rad]; none: down the mean slope.
    std::optional<double> azimuth{};
    std::string name{};  ///< of its polygon in the user's file; empty: none
};

/// Discharge and velocity at one time; linear between times, zero before the first and after the last.
struct HydrographPoint {
    double time = 0;       ///< [s]
    double discharge = 0;  ///< [m3/s]
    double speed = 0;      ///< of the flow across the line, in map view [m/s]
};

/// Material that flows in through a line, in map coordinates of the working CRS.
struct Inflow {
    Polyline line;
    std::vector<HydrographPoint> hydrograph;  ///< times rise; an equal time is a step
    std::optional<double> azimuth;  ///< clockwise from the grid's north [rad]; none: normal to the line, downhill
};

/// A place where depth and speed are recorded over time.
struct Gauge {
    std::string name;
    Point place;  ///< map coordinates
};

/// A line through which the discharge is recorded over time.
struct CrossSection {
    std::string name;
    Polyline line;  ///< map coordinates
};

/// Recordings besides the maxima; each costs nothing unless requested.
struct Recording {
    std::vector<Gauge> gauges;
    std::vector<CrossSection> sections;
    double interval = 0;        ///< between rows of gauges and sections [s]; 0: every step
    bool intensity = false;     ///< maxima of depth times speed and of the energy head
    bool plane_stress = false;  ///< at frames and at the end
    bool normal_depth = false;  ///< RunResult::depth_is_normal
};

/// Everything the engine needs, validated, in SI units; constant from here on.
struct Scene {
    GridSpec grid;                          ///< working grid
    Raster terrain;                         ///< DTM on the working grid [m]; NaN: no data
    std::optional<Raster> walls;            ///< on the working grid: 1 where there is a wall that no flow overtops
    bool terrain_contains_release = false;  ///< the bed is the terrain minus the released (vertical) thickness
    std::vector<ReleaseArea> release;
    std::optional<double> release_volume;  ///< of all areas [m3]: their thicknesses are scaled by one factor to this
                                           ///< total
    std::vector<Inflow> inflows;
    /// Present: the structured model runs, and material, zones and entrainment are not read.
    std::optional<StructuredMaterial> structured;
    Material material;
    MaterialZones zones;
    Entrainment entrainment;
    Numerics numerics;
    TimeControl time;
    Recording recording;
    std::optional<FileVolume> file_volume;  ///< of the raster that gives the thickness; none: not known
    Warnings warnings;                      ///< of its keys, files and ground; results pass them on
};

/// Cell of a local origin; rows counted from the south.
struct OriginCell {
    std::int64_t column = 0, row = 0;
};

/// Sets the local origin to the cell that contains the south-western corner of all releases, inflows and initial fluid.
/// Results then do not depend on the extent of the grid beyond it.
void place_origin(Scene& scene);

/// Sets it to a cell of the grid. Throws Error(input) outside.
void put_origin(Scene& scene, OriginCell cell);

/// A cell of a raster.
struct Cell {
    std::int64_t row, column;
};

/// Returns the cell that contains a local point, the nearest one for points outside.
Cell cell_of(const GridSpec& grid, Point local);

/// Returns the slope of the terrain at a cell (east, north) [-], from the neighbours that have data.
Point gradient(const Raster& terrain, Cell cell);

/// Returns the map-view fraction of a speed along the bed in a direction (a unit vector): 1 / sqrt(1 + climb^2), or 1
/// if the scene's equations do not distinguish them.
double map_fraction(const Numerics& numerics, Point slope, Point direction);

}  // namespace frana
