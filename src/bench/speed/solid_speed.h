// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bench/speed/speed.h"

namespace frana::bench {

/// Measures the throughput of the structured model, case "solids": a wet cohesive block of about the given number of
/// particles, 9 per cell, that slides down an uneven slope, yields and releases its fluid; elasticity, plasticity,
/// damage, release, drag, virtual mass, buoyancy. A particle-step is one elastic substep of one particle; its time
/// includes that of the grid. Runs with one thread and with `threads`, and compares the depths bit for bit.
std::vector<SpeedRow> measure_solids(double particles, int threads, int steps);

}  // namespace frana::bench
