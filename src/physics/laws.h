// SPDX-License-Identifier: Apache-2.0
// The lists of laws, with those of kernel_laws.h. A law is a header in this folder and its name in one of the two;
// tables, keys, refusals, the list of terms and the stages of the time step follow from it.
#pragma once

#include "core/default_values.h"
#include "physics/friction_bingham.h"
#include "physics/friction_chezy.h"
#include "physics/friction_cohesion.h"
#include "physics/friction_coulomb.h"
#include "physics/friction_manning.h"
#include "physics/friction_obrien_julien.h"
#include "physics/friction_ramms_yield.h"
#include "physics/friction_turbulence.h"
#include "physics/kernel_laws.h"

namespace frana {

using BedLaws = LawList<LawKind::bed_friction, CoulombFriction, TurbulentFriction, CohesiveFriction, RammsYield,
                        BinghamFriction, HerschelBulkleyExcess, OBrienJulienFriction, ManningFriction, ChezyFriction,
                        PouliquenForterreExcess, ModifiedVoellmyExcess>;

/// Calls visit.operator()<List>() for each kind of law.
template <class Visit>
void for_each_law_list(Visit&& visit) {
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
template <class Material>
MaterialValues values_of(const Material& material) {
    return {all_values<BedLaws>(material), all_values<StressLaws>(material), material.density};
}

}  // namespace frana
