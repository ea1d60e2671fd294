// SPDX-License-Identifier: Apache-2.0
// Values common to scene files and the engine's scene (simulation/scene.h), with their defaults, each once.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/default_values.h"
#include "physics/law_values.h"

namespace frana {

/// [material]: one phase, a sum of laws at the bed, a stress in the plane; with the values of these laws' keys.
struct Material : LawValues {
    std::optional<std::string> preset;
    std::string model = "voellmy-bingham";
    double density = k_flow_density;                   ///< [kg/m3]
    std::vector<std::string> bed_friction{"voellmy"};  ///< words of laws; voellmy is two
    std::string in_plane_stress = "auto";              ///< or the word of a law, or none
};

/// [entrainment]
struct Entrainment : LawValues {
    std::string erosion = "off";  ///< or the word of a law
    bool deposition = false, detrainment = false;
    std::optional<double> erodible_depth;  ///< vertical, where MaterialZones has no value [m]

    [[nodiscard]] bool erodes() const noexcept { return erosion != "off"; }
    [[nodiscard]] bool active() const noexcept { return erodes() || deposition || detrainment; }
};

struct StructuredValues {
    double fluid_density = k_fluid_density;  ///< [kg/m3]
    double fluid_viscosity = 0;              ///< a_eta [Pa s]; 0: no viscous terms
    double manning = 0.1;                    ///< n [s/m^(1/3)]
    double dry_depth = k_dry_depth;          ///< [m]
    double young_modulus = 12e6;             ///< [Pa]
    double bulk_modulus = 23e6;              ///< [Pa]
    double critical_strain = 0.05;           ///< eps_c [-]
    std::optional<double> damage_length;     ///< R [m]
    double pore_pressure_fraction = 0;       ///< B [-]
    bool manning_on_total = false;           ///< by the total depth; false: by that of the free fluid
};

enum class Boundary { open, wall };

/// Set of numerical methods for the particles; share/doc/numerics.md compares them.
enum class Scheme { standard, paper, finite_volume };  // `standard` is "default" in scene files; a keyword of C++
inline constexpr std::pair<const char*, Scheme> k_schemes[] = {
    {"default", Scheme::standard}, {"paper", Scheme::paper}, {"finite-volume", Scheme::finite_volume}};

/// Transfer of nodal velocities to the particles (paper, equations 33 and 34; APIC: Jiang et al. 2015).
enum class Transfer { automatic, pic, flip, apic };
struct TransferRow {
    const char* word;
    Transfer transfer;
    const char* term;  ///< in the list of terms
};
inline constexpr TransferRow k_transfers[] = {{"auto", Transfer::automatic, ""},
                                              {"pic", Transfer::pic, "PIC"},
                                              {"flip", Transfer::flip, "FLIP"},
                                              {"apic", Transfer::apic, "APIC"}};

/// Effect of steep terrain in the map-plane equations; see share/doc/model.md, "Unknowns".
enum class SlopeCorrection { automatic, none, normal, surface };
inline constexpr std::pair<const char*, SlopeCorrection> k_slope_corrections[] = {
    {"auto", SlopeCorrection::automatic},
    {"none", SlopeCorrection::none},
    {"normal", SlopeCorrection::normal},
    {"surface", SlopeCorrection::surface}};

/// Treatment of cells without terrain data.
enum class NodataPolicy {
    stop,  ///< flow that reaches such a cell ends the run with a message
    wall,  ///< such cells are walls
    fill,  ///< the bed was interpolated across them when the terrain was read, and the number of cells reported
};
inline constexpr std::pair<const char*, NodataPolicy> k_nodata_policies[] = {
    {"stop", NodataPolicy::stop}, {"wall", NodataPolicy::wall}, {"fill", NodataPolicy::fill}};

/// Returns the word of a value in scene files.
template <class Value, std::size_t n>
std::string word_of(Value value, const std::pair<const char*, Value> (&words)[n]) {
    for (const auto& [word, one] : words)
        if (one == value) return word;
    return {};
}

/// [numerics] and terrain.nodata-policy. What is not given follows from the scheme: the functions below resolve it.
struct Numerics {
    Scheme scheme = Scheme::standard;
    Transfer transfer = Transfer::automatic;
    std::optional<double> cfl;            ///< Courant number
    double gravity = k_standard_gravity;  ///< [m/s2]
    double minimum_depth =
        k_minimum_depth;  ///< depth from which a cell counts as reached in maxima and arrival time [m]
    Boundary boundary = Boundary::open;
    int particles_per_cell = 4;         ///< a square number: 1, 4, 9, 16
    std::optional<bool> well_balanced;  ///< still level per node (default scheme only)
    SlopeCorrection slope_correction = SlopeCorrection::automatic;
    std::optional<bool> curvature;   ///< motion along a curved bed (Curved)
    std::optional<bool> flight;      ///< particles thrown off the bed fly
    double flight_angle = 55;        ///< JumpRules::angle [degrees]
    double flight_drag = 1;          ///< coefficient of the air's drag on what flies [-]
    double flight_clearance = 10;    ///< JumpRules::clearance [m]
    std::optional<double> accuracy;  ///< as a fraction
    NodataPolicy nodata = NodataPolicy::stop;
};

/// The scheme's own, if not chosen: pic for the paper's, apic for the default.
Transfer transfer_of(const Numerics& numerics);
/// The scheme's own, if not chosen: normal for the default, none for the paper's.
SlopeCorrection slope_correction(const Numerics& numerics);
/// On for the default scheme, off for the paper's.
bool well_balanced(const Numerics& numerics);
/// On if there is a slope correction, never without.
bool curvature(const Numerics& numerics);
/// Whether the requirements of flight are met: curvature, the default scheme, affine velocities.
bool can_fly(const Numerics& numerics);
/// On where possible, never elsewhere.
bool flight(const Numerics& numerics);
double courant_number(const Numerics& numerics, const Material& material);

struct TimeValues {
    bool stop_when_still = true;  ///< end early once nothing moves
    double stop_momentum = 0;     ///< end once the momentum is below this fraction of its peak; 0: never
    double moving_speed = 0.1;    ///< speed that counts as moving [m/s]
    double stop_window = 0.25;    ///< fraction of the time since material last entered
};
inline constexpr double k_trace_threshold = 0.1;  ///< depth from which a cell belongs to the trace [m]

}  // namespace frana
