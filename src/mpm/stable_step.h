// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace frana {

/// Returns the stable time step [s]. The paper's (22) bounds only |v| dt / dx and would allow any step at rest; here:
///   - wave: nothing travels more than cfl cells, with w = max(|v| + sqrt(g h)) and the increase by gravity within the
///     step,
///     (w + g dt) dt <= cfl dx;
///   - in-plane viscosity, explicit in two dimensions: dt <= dx^2 / (4 D), D = (2 mu + tau_Y / sqrt(I2)) / rho.
inline double stable_step(double cell_size, double cfl, double wave_speed, double gravity,
                          double diffusivity) noexcept {
    const double reach = cfl * cell_size;
    double dt = 2 * reach / (wave_speed + std::sqrt(wave_speed * wave_speed + 4 * gravity * reach));
    if (diffusivity > 0) dt = std::min(dt, 0.25 * cell_size * cell_size / diffusivity);
    return dt;
}

}  // namespace frana
