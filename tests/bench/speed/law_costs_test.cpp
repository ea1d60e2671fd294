// SPDX-License-Identifier: Apache-2.0
#include "bench/speed/law_costs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "params/keys/laws.h"

namespace frana::bench {
namespace {

// Times are not tested; the particles' fields are.
TEST(LawCosts, EveryLawRunsAndOnlyStressAndPorePressureNeedMoreFields) {
    const auto costs = run_law_costs(400, 3);
    ASSERT_FALSE(costs.empty());
    EXPECT_EQ(costs[0].relative, 1);
    for (const LawCost& cost : costs) {
        EXPECT_GT(cost.nanoseconds, 0) << cost.law;
        const bool stress = cost.law == "in-plane Bingham" || cost.law == "earth pressure";
        const bool flies = cost.law != "without curvature";  // Field::flown
        const int more = (stress ? 3 : 0) + (cost.law == "pore pressure" ? 1 : 0) - (flies ? 0 : 1);
        EXPECT_EQ(cost.bytes_per_particle - costs[0].bytes_per_particle, more * 8) << cost.law;
    }
    // Voellmy's two terms are the plain scene.
    for (const Law& law : laws()) {
        const bool plain = law.word == "coulomb" || law.word == "turbulence";
        const bool there =
            std::any_of(costs.begin(), costs.end(), [&](const LawCost& c) { return c.law == law.sentence; });
        if (law.kind == LawKind::bed_friction) {
            EXPECT_EQ(there, !plain) << law.word;
        }
    }
    const std::string csv = law_costs_csv(costs);
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "law,nanoseconds_per_particle_step,relative_to_plain,bytes_per_particle");
}

}  // namespace
}  // namespace frana::bench
