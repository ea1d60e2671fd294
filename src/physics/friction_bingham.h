// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/friction_herschel_bulkley.h"
#include "physics/law.h"
#include "physics/stress_bingham.h"

namespace frana {

/// Bed resistance of a Bingham fluid: that of Herschel and Bulkley with m = 1. The quadratic of Fois, de Falco,
/// Formaggia 2024 (equation 9) differs from this exact root by up to 0.043.
struct BinghamFriction {
    static constexpr const char* word = BinghamStress::word;
    static Law row() {
        return {.sentence = worded("Bingham bed resistance"),
                .reads = {"material.yield-stress"},
                .needs = {"material.viscosity"},
                .resists_alike = {"resistance of the fluid"}};
    }
    static HerschelBulkleyExcess build(const auto& b) {
        return {b.material.density, b.material.yield_stress, b.material.viscosity, 1};
    }
};

}  // namespace frana
