// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/error.h"
#include "core/text.h"

namespace frana::facade {

/// Refuses more particles than the engine can number with 32 bits.
inline void check_particle_count(double count, const std::string& where, Problems& problems) {
    constexpr double k_most_particles = 1e9;
    if (count <= k_most_particles) return;
    problems.add({"would need more particles than can be counted", where, shortest_text(count),
                  "at most " + shortest_text(k_most_particles), "Choose larger cells"});
}

}  // namespace frana::facade
