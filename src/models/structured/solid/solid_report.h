// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "mpm/ground_walls.h"

namespace frana::structured {

/// Results of a pass over particles.
struct SolidReport {
    double speed2 = 0;         ///< greatest |v|^2 [m2/s2]
    double apart2 = 0;         ///< greatest |v - mean|^2 [m2/s2]
    double acceleration2 = 0;  ///< before friction [m2/s4]
    double opening = 0;        ///< greatest rate at which an area changes, over the area [1/s]
    std::int64_t non_finite = 0;
    bool rests = true;         ///< nothing moves, and friction exceeds the forces by a margin; of the substep alone
    std::int64_t clamped = 0;  ///< particles whose area would have changed more than sevenfold in a substep
    WallContact walls{};       ///< of the ground

    void merge(const SolidReport& o) {
        speed2 = std::max(speed2, o.speed2);
        apart2 = std::max(apart2, o.apart2);
        acceleration2 = std::max(acceleration2, o.acceleration2);
        opening = std::max(opening, o.opening);
        non_finite += o.non_finite;
        clamped += o.clamped;
        walls.merge(o.walls);
        rests = rests && o.rests;
    }
};

template <class Archive>
void serialise(Archive& archive, SolidReport& report) {
    [[maybe_unused]] auto& [speed2, apart2, acceleration2, opening, non_finite, rests, clamped, walls] = report;
    archive(speed2, apart2, acceleration2, opening, non_finite, clamped);
}

}  // namespace frana::structured
