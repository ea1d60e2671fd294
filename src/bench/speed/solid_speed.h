// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bench/speed/speed.h"

namespace frana::bench {

/// Throughput of the structured model, case "solids": a wet cohesive block, about as many particles, 9 a
/// cell, that slides down an uneven slope, yields and gives its fluid free; elasticity, plasticity, damage,
/// release, drag, virtual mass, buoyancy. A particle-step is one elastic substep of one particle; the grid's
/// share is in its time. Runs with one thread and with `threads`, and compares the depths bit for bit.
std::vector<SpeedRow> measure_solids(double particles, int threads, int steps);

}  // namespace frana::bench
