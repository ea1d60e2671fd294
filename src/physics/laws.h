// SPDX-License-Identifier: Apache-2.0
// The list of laws. A law is a header in this folder and its name here; tables, keys, refusals, the list of terms and
// the stages of the time step follow from it.
#pragma once

#include "core/default_values.h"
#include "physics/bed_contact.h"
#include "physics/deposition_shear_stress.h"
#include "physics/erosion_growth.h"
#include "physics/erosion_mechanical.h"
#include "physics/erosion_shear_stress.h"
#include "physics/friction_bingham.h"
#include "physics/friction_chezy.h"
#include "physics/friction_cohesion.h"
#include "physics/friction_coulomb.h"
#include "physics/friction_herschel_bulkley.h"
#include "physics/friction_manning.h"
#include "physics/friction_obrien_julien.h"
#include "physics/friction_pouliquen_forterre.h"
#include "physics/friction_ramms_yield.h"
#include "physics/friction_turbulence.h"
#include "physics/law.h"
#include "physics/stress_bingham.h"
#include "physics/stress_earth_pressure.h"

namespace frana {

using BedLaws =
    LawList<LawKind::bed_friction, CoulombFriction, TurbulentFriction, CohesiveFriction, RammsYield, BinghamFriction,
            HerschelBulkleyExcess, OBrienJulienFriction, ManningFriction, ChezyFriction, PouliquenForterreExcess>;
/// Those of bed friction that are no polynomial of the speed; 5 slopes x 4 = 20 of update_nodes.
using ExcessLaw = std::variant<NoExcess, HerschelBulkleyExcess, PouliquenForterreExcess>;

/// 2 schemes x 3 transfers x 3 stresses x 2 = 36 of nodes_to_particles.
using StressLaws = LawList<LawKind::in_plane_stress, BinghamStress, EarthPressureStress>;

/// 2 metrics x 4 laws of erosion x 2 of deposition = 16 of exchange_at_nodes.
using ErosionLaws = LawList<LawKind::erosion, ShearStressErosion, GrowthErosion, MechanicalErosion>;
using DepositionLaws = LawList<LawKind::deposition, ShearStressDeposition>;

/// Calls visit.operator()<List>() for each kind of law.
template <class Visit>
void for_each_law_list(Visit&& visit) {
    visit.template operator()<BedLaws>();
    visit.template operator()<StressLaws>();
    visit.template operator()<ErosionLaws>();
    visit.template operator()<DepositionLaws>();
}

/// What the laws of a material read of it: density and the values of all keys.
struct MaterialValues : BedLaws::Values, StressLaws::Values {
    double density = k_flow_density;  ///< [kg/m3]
};
template <class Material>
MaterialValues values_of(const Material& material) {
    return {all_values<BedLaws>(material), all_values<StressLaws>(material), material.density};
}

}  // namespace frana
