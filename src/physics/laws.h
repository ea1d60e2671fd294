// SPDX-License-Identifier: Apache-2.0
// The lists of laws, with that of stress_laws.h. A law is a header in this folder and its name in one of the two;
// tables, keys, refusals, the list of terms and the stages of the time step follow from it. Included where a list is
// gone through, and nowhere else: whoever reads the values of one law includes its header.
#pragma once

#include "core/default_values.h"
#include "physics/deposition_shear_stress.h"
#include "physics/detrainment_forest.h"
#include "physics/erosion_growth.h"
#include "physics/erosion_mechanical.h"
#include "physics/erosion_shear_stress.h"
#include "physics/friction_bingham.h"
#include "physics/friction_chezy.h"
#include "physics/friction_cohesion.h"
#include "physics/friction_coulomb.h"
#include "physics/friction_herschel_bulkley.h"
#include "physics/friction_manning.h"
#include "physics/friction_modified_voellmy.h"
#include "physics/friction_obrien_julien.h"
#include "physics/friction_pouliquen_forterre.h"
#include "physics/friction_ramms_yield.h"
#include "physics/friction_turbulence.h"
#include "physics/stress_laws.h"

namespace frana {

using BedLaws = LawList<LawKind::bed_friction, CoulombFriction, TurbulentFriction, CohesiveFriction, RammsYield,
                        BinghamFriction, HerschelBulkleyExcess, OBrienJulienFriction, ManningFriction, ChezyFriction,
                        PouliquenForterreExcess, ModifiedVoellmyExcess>;

/// 2 metrics x 4 laws of erosion x 2 of deposition = 16 of exchange_at_nodes.
using ErosionLaws = LawList<LawKind::erosion, ShearStressErosion, GrowthErosion, MechanicalErosion>;
using DepositionLaws = LawList<LawKind::deposition, ShearStressDeposition>;
/// A sweep of its own, 2 metrics: it acts beside both.
using DetrainmentLaws = LawList<LawKind::detrainment, ForestDetrainment>;

/// Calls visit.operator()<List>() for each kind of law.
void for_each_law_list(const auto& visit) {
    visit.template operator()<BedLaws>();
    visit.template operator()<StressLaws>();
    visit.template operator()<ErosionLaws>();
    visit.template operator()<DepositionLaws>();
    visit.template operator()<DetrainmentLaws>();
}

/// What the laws of a material read of it: density and the values of all keys.
struct MaterialValues : BedLaws::Values, StressLaws::Values {
    double density = k_flow_density;  ///< [kg/m3]
};
MaterialValues values_of(const auto& material) {
    return {all_values<BedLaws>(material), all_values<StressLaws>(material), material.density};
}

}  // namespace frana
