// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/grid_spec.h"
#include "core/raster.h"

namespace frana {

/// Which set of numerical parts moves the particles; share/doc/numerics.md compares them.
enum class Scheme { paper, standard };  // `standard` is spelt "default" outside; that word is taken in C++

/// How nodal velocities come back to the particles (paper, equations 33 and 34; APIC: Jiang et al. 2015).
enum class Transfer { pic, flip, apic };

/// How steep terrain enters the map-plane equations; see ../shared spec section 5 and share/doc/model.md.
enum class SlopeCorrection { none, normal, surface };

enum class Boundary { open, wall };

/// What happens where the terrain has no value.
enum class NodataPolicy {
    stop,  ///< flow that reaches such a cell ends the run with a message
    wall,  ///< such cells are walls
    fill,  ///< the bed was interpolated across them when the terrain was read, and the count reported
};

/// One phase with Voellmy bed friction and depth-integrated Bingham stress. Angles are already tangents here.
struct Material {
    double density = 2000;                                        ///< [kg/m3]
    double friction_coefficient = 0.3;                            ///< tan(phi) [-]
    double turbulence = std::numeric_limits<double>::infinity();  ///< Voellmy xi [m/s2]; infinity: off
    double surface_pressure = 0;                                  ///< p_A, gauge [Pa]
    double viscosity = 0;                                         ///< mu [Pa s]
    double yield_stress = 0;                                      ///< tau_Y [Pa]
    double yield_regularisation = 0.01;  ///< shear rate under which yield is softened [1/s]
    bool exact_yield_ratio = true;       ///< zeta from the cubic; false: the paper's (9)
};

struct Numerics {
    Scheme scheme = Scheme::standard;
    std::optional<Transfer> transfer;  ///< none: the scheme's own (paper: pic, default: apic)
    int particles_per_cell = 4;        ///< a square number: 1, 4, 9, 16
    double cfl = 0.5;
    bool well_balanced = true;  ///< still level per node (default scheme only)
    SlopeCorrection slope_correction = SlopeCorrection::normal;
    Boundary boundary = Boundary::open;
    NodataPolicy nodata = NodataPolicy::stop;
    double gravity = 9.81;        ///< [m/s2]
    double minimum_depth = 0.01;  ///< depth from which a cell counts as reached in maxima and arrival [m]
};

struct TimeControl {
    double end = 60;              ///< [s]
    bool stop_when_still = true;  ///< end early once nothing moves
    double frame_interval = 0;    ///< [s]; 0: no frames
};

/// One area that fails, in map coordinates of the working CRS.
struct ReleaseArea {
    MultiPolygon outline;
    double thickness = 0;                    ///< [m]; ignored where a raster is given
    std::optional<Raster> thickness_raster;  ///< on the working grid; NaN or <= 0: nothing released there
    std::optional<double> volume;            ///< [m3]: the thickness is scaled so that this is released
    bool normal_to_bed = false;              ///< thickness measured normal to the bed; false: vertically
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

/// What is recorded besides the maxima; nothing of it costs anything unless asked for.
struct Recording {
    std::vector<Gauge> gauges;
    std::vector<CrossSection> sections;
    double interval = 0;     ///< between rows of gauges and sections [s]; 0: every step
    bool intensity = false;  ///< maxima of depth times speed and of the energy head
};

/// Everything the engine needs, validated, in SI units; const from here on.
struct Scene {
    GridSpec grid;                          ///< working grid
    Raster terrain;                         ///< DTM on the working grid [m]; NaN: no data
    bool terrain_contains_release = false;  ///< the bed is the terrain less the released (vertical) thickness
    std::vector<ReleaseArea> release;
    Material material;
    Numerics numerics;
    TimeControl time;
    Recording recording;
};

}  // namespace frana
