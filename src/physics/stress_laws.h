// SPDX-License-Identifier: Apache-2.0
// The laws of stress in the plane, apart from the others: the sweeps over particles are compiled for each of them.
#pragma once

#include "physics/law.h"
#include "physics/stress_bingham.h"
#include "physics/stress_earth_pressure.h"

namespace frana {

/// 2 schemes x 3 transfers x 3 stresses x 2 = 36 of nodes_to_particles.
using StressLaws = LawList<LawKind::in_plane_stress, BinghamStress, EarthPressureStress>;

}  // namespace frana
