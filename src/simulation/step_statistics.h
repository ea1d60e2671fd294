// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace frana {

/// What a step showed, whatever the model: what the run's series, watches and counts are made from.
struct StepStatistics {
    double dt = 0;              ///< [s]
    double volume = 0;          ///< inside the domain [m3]
    double max_depth = 0;       ///< [m]
    double max_speed = 0;       ///< along the bed [m/s]
    double fastest = 0;         ///< particle in map view, however thin [m/s]
    double front_distance = 0;  ///< from the run's origin, in map view [m]
    double kinetic = 0;         ///< energy over density [m5/s2]
    double energy = std::numeric_limits<double>::quiet_NaN();
    ///< kinetic and potential, over density, as the step began [m5/s2]; NaN: not known
    double energy_moving = 0;      ///< of which kinetic [m5/s2]
    double energy_volume = 0;      ///< of the volume that has it [m3]
    double energy_dissipated = 0;  ///< by friction and walls in the step, over density [m5/s2]
    double moving = 0;             ///< volume faster than the run's moving speed, however thin [m3]
    double thin = 0;               ///< volume that is nowhere as deep as the minimum depth [m3]
    std::int64_t covered = 0;      ///< cells deeper than the minimum depth
    std::int64_t unsupported = 0;  ///< see RunResult::unsupported
    std::int64_t non_finite = 0;   ///< particles or cells with a non-finite state
    std::int64_t clamped = 0;      ///< particles whose area had to be bounded
    std::int64_t no_data = 0;      ///< particles or flows that came upon cells without terrain
};

}  // namespace frana
