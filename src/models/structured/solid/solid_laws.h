// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/coupling/basal_pressure.h"
#include "models/structured/solid/artificial.h"
#include "models/structured/solid/damage.h"
#include "models/structured/solid/elasticity.h"
#include "models/structured/solid/kernel.h"

namespace frana::structured {

/// Which earth pressure a column pushes its neighbours with.
enum class EarthPressure {
    active,         ///< K_a everywhere
    active_passive  ///< K_p where broken material (cohesion ratio under 0.05) is pushed together
};

/// How thick a column is that has lost all cohesion.
enum class BrokenColumn {
    free,    ///< it thickens and thins freely: the vertical stress stays the weight's (plane stress)
    confined ///< no elastic vertical strain, as while it is whole (plane strain)
};

/// Laws and numbers of the solids; const while they run. Lengths in metres, in map view.
struct SolidLaws {
    explicit SolidLaws(double smoothing_length) : kernel(smoothing_length) {}

    double gravity = 9.81;
    bool steep = true;  ///< gravity and friction over 1 + |grad b|^2
    Elasticity elastic;
    double sin_dilatancy = 0;           ///< sin(psi)
    bool strength_of_particle_stress = false;  ///< yield is checked without the geostatic stress
    BrokenColumn broken = BrokenColumn::free;
    EarthPressure earth_pressure = EarthPressure::active;
    BasalPressure basal;
    bool fractures = true;  ///< cohesion can be lost
    Fragmentation fragmentation;
    double initial_structured = 1;  ///< f_sc of whole material

    CubicKernel kernel;
    double wave_speed = 0;  ///< of pressure waves in the lightest material [m/s]
    double spacing = 1;  ///< of particles at the start, dp
    ArtificialViscosity viscosity;
    double artificial_stress = 0.5;
    double elastic_cfl = 0.25;
    double pic_share = 0;  ///< of the grid's velocity that particles take over in a step
};

}  // namespace frana::structured
