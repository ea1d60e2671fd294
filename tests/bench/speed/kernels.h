// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace frana::bench {

/// One kernel on one tile of a moving sheet: 1024 particles, 4 per cell, over uneven ground.
struct KernelCase {
    std::string name;           ///< what it does, and "plain" or "fast"
    std::function<void()> run;  ///< once over all particles; may be repeated
};
inline constexpr int k_kernel_particles = 1024;

/// Returns the default scheme's sweeps over particles, plain and, if the processor supports them, fast.
std::vector<KernelCase> kernel_cases();

}  // namespace frana::bench
