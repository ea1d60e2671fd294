// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

namespace frana::structured {

/// Results of a pass over particles.
struct SolidReport {
    double speed2 = 0;         ///< greatest |v|^2 [m2/s2]
    double apart2 = 0;         ///< greatest |v - mean|^2 [m2/s2]
    double acceleration2 = 0;  ///< before friction [m2/s4]
    double approach = 0;       ///< greatest |phi| of the artificial viscosity [m/s]
    std::int64_t non_finite = 0;
    std::int64_t skipped = 0;  ///< particles that were not computed because nothing changed
    bool rests = true;         ///< nothing moves, and friction exceeds the forces by a margin; of the substep alone
    std::int64_t clamped = 0;  ///< particles whose area would have changed by more than half in a step

    void merge(const SolidReport& o) {
        speed2 = std::max(speed2, o.speed2);
        apart2 = std::max(apart2, o.apart2);
        acceleration2 = std::max(acceleration2, o.acceleration2);
        approach = std::max(approach, o.approach);
        non_finite += o.non_finite;
        clamped += o.clamped;
        skipped += o.skipped;
        rests = rests && o.rests;
    }
};

template <class Archive>
void serialise(Archive& archive, SolidReport& report) {
    [[maybe_unused]] auto& [speed2, apart2, acceleration2, approach, non_finite, skipped, rests, clamped] = report;
    archive(speed2, apart2, acceleration2, approach, non_finite, clamped);
}

}  // namespace frana::structured
