// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/coupling/basal_pressure.h"
#include "models/structured/solid/solid_laws.h"
#include "particles/particle_set.h"

namespace frana::structured {

/// Properties of a scene's solids: cohesion, which can be lost, confined fluid, and pore pressure. Terms without a
/// field are not computed.
template <bool Cohesive, bool Wet, bool Pressed = false>
struct SolidKind {
    static constexpr bool cohesive = Cohesive, wet = Wet, pressed = Pressed;
};

inline constexpr FieldMask k_solid_fields =
    k_basic_fields | FieldMask{Field::t_xx,   Field::t_yy,   Field::t_zz,     Field::t_xy,         Field::e_xx,
                               Field::e_yy,   Field::e_xy,   Field::friction, Field::bed_friction, Field::grain_density,
                               Field::push_x, Field::push_y, Field::flatness, Field::c_xx,         Field::c_xy,
                               Field::c_yx,   Field::c_yy};
inline constexpr FieldMask k_cohesion_fields{Field::cohesion, Field::cohesion_ratio, Field::damage};
inline constexpr FieldMask k_wet_fields{Field::confined, Field::pores, Field::submergence, Field::grain_diameter};
inline constexpr FieldMask k_release_fields{Field::confined_start, Field::released};

inline constexpr FieldMask k_pore_fields{Field::pore_pressure, Field::hydrostatic};

/// The fields of a scene's solids.
inline constexpr FieldMask solid_fields(bool cohesive, bool wet) {
    FieldMask fields = k_solid_fields;
    if (cohesive) fields = fields | k_cohesion_fields;
    if (wet) fields = fields | k_wet_fields;
    if (cohesive && wet) fields = fields | k_release_fields;
    return fields;
}

/// Mass of a particle [kg].
inline double particle_mass(const SolidLaws& laws, const ParticleSet& particles, std::size_t p) noexcept {
    const double confined = particles[Field::confined] != nullptr ? particles[Field::confined][p] : 0;
    return particles[Field::grain_density][p] * particles[Field::volume][p] + laws.basal.fluid_density * confined;
}

/// A particle's column: mass, depth, load on the bed, thrust on its neighbours.
struct ParticleLoad {
    double mass = 0;        ///< [kg]
    double depth = 0;       ///< [m]
    double cohesion = 0;    ///< present, less the friction that excess pore pressure takes off [Pa]
    double lost = 0;        ///< what that takes off beyond the cohesion [Pa]
    double held = 0;        ///< fraction of the initial confined fluid and structured solids that strength holds
    double structured = 0;  ///< f_sc
    double kept = 0;        ///< confined fluid that remains [m]
    double load = 0;        ///< N, excess pore pressure included: that of the stress inside [Pa]
    double bearing = 0;     ///< N without it: that of friction at the bed [Pa]
    double borne = 0;       ///< mean vertical pressure that strength bears [Pa]
    double thrust = 0;      ///< P_lat [N/m]
};

/// Sets thrust and borne of a column whose depth, cohesion and load are known: what its strength does not bear acts in
/// all directions alike (next_stress).
inline void set_thrust(double friction, ParticleLoad& column) noexcept {
    const double bears = DruckerPrager::of(friction, column.cohesion).uniaxial();
    column.thrust = hydrostatic_thrust(column.load, column.depth, bears);
    column.borne = std::min(0.5 * column.load, bears);
}

/// Fraction of its confined fluid and structured solids that a column still holds: the cohesion's, but no more than its
/// strength bears of the mean vertical pressure, so that a cohesion that tends to zero tends to none (ours).
/// @param ratio cohesion over initial cohesion, chi [-]
/// @param bears uniaxial strength q [Pa]
/// @param weight of the column on its base [Pa]
inline double held_fraction(double ratio, double bears, double weight) noexcept {
    return 2 * bears < ratio * weight ? 2 * bears / weight : ratio;
}

/// A particle's solids with all of their pores full, as when it was placed: what the pore pressure drains through and
/// is a fraction of.
struct Saturated {
    double depth = 0;    ///< [m]
    double density = 0;  ///< [kg/m3]

    template <class Kind>
    static Saturated of(const SolidLaws& laws, const ParticleSet& particles, std::size_t p) noexcept {
        const double solids = particles[Field::volume][p], pores = Kind::wet ? particles[Field::pores][p] : 0;
        const double mass = particles[Field::grain_density][p] * solids + laws.basal.fluid_density * pores;
        return {(solids + pores) / particles[Field::area][p], mass / (solids + pores)};
    }
};

/// Reads volume, area, confined, submergence, cohesion, cohesion_ratio, friction, grain_density, and with pore pressure
/// confined_start, pores, pore_pressure and hydrostatic of particle p.
template <class Kind>
ParticleLoad particle_load(const SolidLaws& laws, const ParticleSet& particles, std::size_t p) noexcept {
    const double solids = particles[Field::volume][p], inverse_area = 1 / particles[Field::area][p];
    const double grain_density = particles[Field::grain_density][p], friction = particles[Field::friction][p];
    double confined = 0, submerged = 0, ratio = 0;
    ParticleLoad s;
    if constexpr (Kind::wet) {
        confined = particles[Field::confined][p];
        submerged = particles[Field::submergence][p];
    }
    if constexpr (Kind::cohesive) {
        ratio = particles[Field::cohesion_ratio][p];
        s.cohesion = ratio * particles[Field::cohesion][p];
    }
    double weight = 0, excess = 0;  // of the saturated solids, and of the pore pressure at the bed [Pa]
    if constexpr (Kind::pressed) {
        const Saturated whole = Saturated::of<Kind>(laws, particles, p);
        weight = laws.basal.gravity * whole.density * whole.depth;
        excess = weight * (particles[Field::pore_pressure][p] - particles[Field::hydrostatic][p]);
        // Mohr and Coulomb's strength c + (sigma - p) tan(phi) is that of a cohesion c - p tan(phi); p in the mean.
        const double taken = 0.5 * friction * std::max(0.0, excess);
        s.lost = std::max(0.0, taken - s.cohesion);
        s.cohesion = std::max(0.0, s.cohesion - taken);
    }
    s.mass = grain_density * solids + laws.basal.fluid_density * confined;
    s.held = held_fraction(ratio, DruckerPrager::of(friction, s.cohesion).uniaxial(),
                           laws.basal.gravity * s.mass * inverse_area);
    double kept = confined;
    if constexpr (Kind::pressed && Kind::wet && Kind::cohesive)
        if (const double start = particles[Field::confined_start][p]; start > 0) {
            // Strength returns where excess pressure becomes hydrostatic; structure that has let its water go does not.
            s.held = std::min(s.held, confined / start);
            kept = std::min(kept, start * s.held);
        }
    s.structured = s.held;
    // The grid's submergence is of all pores, and of water that is on the grid: those of structured solids have
    // confined fluid, and what is released in this step is in the loose solids' already.
    if constexpr (Kind::pressed && Kind::wet)
        if (const double pores = (1 - s.structured) * particles[Field::pores][p]; pores > 0)
            submerged = std::min(1.0, (submerged * particles[Field::pores][p] + confined - kept) / pores);
    s.kept = kept * inverse_area;
    s.depth = (solids + confined) * inverse_area;
    s.load = laws.basal({solids * inverse_area, s.kept, s.structured, submerged}, grain_density);
    s.bearing = s.load;
    if constexpr (Kind::pressed) {
        s.lost = std::min(s.lost, 0.5 * friction * s.load);
        s.bearing = std::clamp(s.load - excess, 0.0, std::max(s.load, weight));
    }
    set_thrust(friction, s);
    return s;
}

/// Whether a column's only stress is its earth pressure.
inline bool flows_freely(const ParticleLoad& column) noexcept {
    return !(column.cohesion > 0);
}

/// Greatest deceleration by friction at the bed [m/s2].
/// @param density of the column [kg/m2]
inline double bed_resistance(const SolidLaws& laws, const ParticleLoad& column, double density, double friction,
                             double flatness) noexcept {
    return column.bearing / density * friction * (laws.steep ? flatness : 1);
}

}  // namespace frana::structured
