// SPDX-License-Identifier: Apache-2.0
// Values common to scene files and the engine's scene (simulation/scene.h): in the engine's units, with their defaults,
// each once.
#pragma once

namespace frana {

struct MaterialValues {
    double density = 2000;               ///< [kg/m3]
    double surface_pressure = 0;         ///< p_A, gauge [Pa]
    double viscosity = 0;                ///< mu [Pa s]
    double yield_stress = 0;             ///< tau_Y [Pa]
    double yield_regularisation = 0.01;  ///< shear rate below which yield is softened in the plane [1/s]
};
// Defaults of single laws.
inline constexpr double k_laminar_resistance = 24;  ///< O'Brien-Julien K [-]
inline constexpr double k_friction_beta = 0.136;    ///< Pouliquen-Forterre beta [-]
inline constexpr double k_erosion_rate = 0.025;     ///< [m/s]
inline constexpr double k_critical_shear = 1000;    ///< [Pa]
inline constexpr double k_potential_depth = 0.1;    ///< [m/kPa]
inline constexpr double k_velocity_ratio = 1;       ///< at the base over mean [-]

struct StructuredValues {
    double fluid_density = 1000;        ///< [kg/m3]
    double fluid_viscosity = 0;         ///< a_eta [Pa s]; 0: no viscous terms
    double viscosity_growth = 10;       ///< b_eta, with the solids' fraction [-]
    double velocity_shape = 3;          ///< chi [-]
    double mobility = 1;                ///< A of the enhanced stress [-]
    double solids_shape = 2;            ///< zeta [-]
    double manning = 0.1;               ///< n [s/m^(1/3)]
    double dry_depth = 1e-4;            ///< [m]
    double young_modulus = 12e6;        ///< [Pa]
    double bulk_modulus = 23e6;         ///< [Pa]
    double critical_strain = 0.05;      ///< eps_c [-]
    double modulus_reduction = 1;       ///< divides both moduli [-]
    double pic_fraction = 0;            ///< [-]
    double pore_pressure_fraction = 0;  ///< B [-]
    double richardson_zaki = 2.4;       ///< M [-]
    double smoothing_velocity = 1;      ///< K of the drag [m/s]; 0: the mixture's flux
    double drag_mixing_exponent = 1;    ///< m of P [-]
    double linear_viscosity = 1;        ///< artificial [-]
    double quadratic_viscosity = 1;     ///< artificial [-]
    double artificial_stress = 0.5;     ///< [-]
};

struct NumericsValues {
    double cfl = 0.5;
    double gravity = 9.81;        ///< [m/s2]
    double minimum_depth = 0.01;  ///< depth from which a cell counts as reached in maxima and arrival time [m]
};
inline constexpr int k_particles_per_cell = 4;
inline constexpr double k_flight_slope_degrees = 70;

struct TimeValues {
    bool stop_when_still = true;      ///< end early once nothing moves
    double stop_energy_fraction = 0;  ///< end once the kinetic energy is below this fraction of its peak; 0: never
    double stop_moving_fraction = 0;  ///< end once the moving volume is below this fraction of its peak; 0: never
    double moving_speed = 0.1;        ///< speed that counts as moving [m/s]
    double stop_window = 0.25;        ///< fraction of the time since material last entered
};
inline constexpr double k_trace_threshold = 0.1;  ///< depth from which a cell belongs to the trace [m]

}  // namespace frana
