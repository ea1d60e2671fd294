// SPDX-License-Identifier: Apache-2.0
// The laws that kernels are compiled for: of the others a kernel sees the sum alone (friction_sum.h), so that a changed
// law of bed friction is compiled where it is chosen and in no kernel.
#pragma once

#include "physics/bed_contact.h"
#include "physics/deposition_shear_stress.h"
#include "physics/detrainment_forest.h"
#include "physics/erosion_growth.h"
#include "physics/erosion_mechanical.h"
#include "physics/erosion_shear_stress.h"
#include "physics/friction_herschel_bulkley.h"
#include "physics/friction_modified_voellmy.h"
#include "physics/friction_pouliquen_forterre.h"
#include "physics/law.h"
#include "physics/stress_bingham.h"
#include "physics/stress_earth_pressure.h"

namespace frana {

/// Those of bed friction that are no polynomial of the speed; 5 slopes x 5 = 25 of update_nodes.
using ExcessLaw = std::variant<NoExcess, HerschelBulkleyExcess, PouliquenForterreExcess, ModifiedVoellmyExcess>;

/// 2 schemes x 3 transfers x 3 stresses x 2 = 36 of nodes_to_particles.
using StressLaws = LawList<LawKind::in_plane_stress, BinghamStress, EarthPressureStress>;

/// 2 metrics x 4 laws of erosion x 2 of deposition = 16 of exchange_at_nodes.
using ErosionLaws = LawList<LawKind::erosion, ShearStressErosion, GrowthErosion, MechanicalErosion>;
using DepositionLaws = LawList<LawKind::deposition, ShearStressDeposition>;
/// A sweep of its own, 2 metrics: it acts beside both.
using DetrainmentLaws = LawList<LawKind::detrainment, ForestDetrainment>;

}  // namespace frana
