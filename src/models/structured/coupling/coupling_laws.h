// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/default_values.h"
#include "models/structured/coupling/drag.h"
#include "models/structured/coupling/virtual_mass.h"

namespace frana::structured {

/// Laws of the interaction of solids and free fluid.
struct CouplingLaws {
    bool buoyancy = true;
    bool drags = true;
    Drag drag;
    VirtualMass virtual_mass;
    double block_size = 0;     ///< d_sc of the structured part [m]; 0: the local depth
    double dry = k_dry_depth;  ///< least depth of free fluid that counts as fluid [m]
};

}  // namespace frana::structured
