// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/default_values.h"
#include "models/structured/coupling/basal_pressure.h"
#include "models/structured/solid/damage.h"
#include "models/structured/solid/elasticity.h"
#include "models/structured/solid/pair_laws.h"

namespace frana::structured {

/// Earth pressure of solids on their neighbours, intact or broken: what cohesion changes tends to zero with it.
enum class EarthPressure {
    hydrostatic,  ///< the load beyond the strength, in all directions alike: heaps stop at the bed's friction angle
    active,       ///< Bell's, K_a without cohesion, as the paper: right on a smooth bed; heaps on a rough one too steep
    passive  ///< K_p where broken material (cohesion ratio under 0.05) is compressed, active elsewhere (Pitman & Le
             ///< 2005); intact material that is compressed has its elastic stress, up to the passive state
};

/// Stress of material without cohesion.
enum class BrokenMaterial {
    earth_pressure,  ///< earth pressure alone, as in depth-averaged avalanches; thickness changes freely
    elastic          ///< Drucker-Prager's without vertical strain, as in intact material: it cannot thicken
};

/// Laws and parameters of the solids; constant during a run. Lengths in metres, in map view.
struct SolidLaws : PairLaws {
    explicit SolidLaws(double smoothing_length) : PairLaws(smoothing_length) {}

    double gravity = k_standard_gravity;
    bool steep = true;  ///< gravity and friction over 1 + |grad b|^2
    Elasticity elastic;
    double sin_dilatancy = 0;                  ///< sin(psi)
    bool strength_of_particle_stress = false;  ///< yield is checked without the geostatic stress
    BrokenMaterial broken = BrokenMaterial::earth_pressure;
    EarthPressure earth_pressure = EarthPressure::hydrostatic;
    BasalPressure basal;
    bool fractures = true;  ///< cohesion can be lost
    Fragmentation fragmentation;
    double initial_structured = 1;  ///< f_sc of intact material

    double wave_speed = 0;  ///< of pressure waves in the lightest material [m/s]
    double artificial_stress = 0.5;
    double elastic_cfl = 0.25;  ///< fraction of the smoothing length that elastic waves cross in a substep
    bool skips_rest = true;     ///< cells at rest are skipped; false, for tests: computed, with the same bits
    double pic_fraction = 0;    ///< fraction of the grid's velocity that particles adopt in a step
};

}  // namespace frana::structured
