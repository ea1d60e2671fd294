// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace frana {

/// Share of |v| that counts as a wave's speed where particles carry the advection: what remains of it moves through the
/// nodes with the gradient of the velocity.
inline constexpr double k_carried = 0.15;

/// Greatest speeds of particles, which bound the time step [m/s].
struct FlowSpeeds {
    double wave = 0;          ///< |v| + sqrt(g h)
    double carried_wave = 0;  ///< k_carried |v| + sqrt(g h)
    double flow = 0;          ///< |v|

    void merge(const FlowSpeeds &s) noexcept {
        wave = std::max(wave, s.wave);
        carried_wave = std::max(carried_wave, s.carried_wave);
        flow = std::max(flow, s.flow);
    }
    template <class Archive>
    void serialise(Archive &archive) {
        auto &[all, relative, speed] = *this;
        archive(all, relative, speed);
    }
};

/// Bounds of the time step.
struct StepBounds {
    double cfl = 0.5;
    bool by_wave = false;  ///< particles carry the advection: steps may be longer than |v| + sqrt(g h) allows
};

/// Returns the stable time step [s]. The paper's (22) bounds only |v| dt / dx and would allow any step at rest; here:
///   - wave: nothing travels more than cfl cells, with w = max(|v| + sqrt(g h)) and the increase by gravity within the
///     step,
///     (w + g dt) dt <= cfl dx;
///   - StepBounds::by_wave: or, if that is longer, waves relative to the flow travel 3/4 cfl cells, w = max(k_carried
///     |v| + sqrt(g h)), and no particle more than 5/4 cfl, w = max |v|;
///   - in-plane viscosity, explicit in two dimensions: dt <= dx^2 / (4 D), D = (2 mu + tau_Y / sqrt(I2)) / rho.
inline double stable_step(double cell_size, const StepBounds &bounds, const FlowSpeeds &speeds, double gravity,
                          double diffusivity) noexcept {
    const auto step = [&](double cells, double w) {
        const double reach = cells * bounds.cfl * cell_size;
        return 2 * reach / (w + std::sqrt(w * w + 4 * gravity * reach));
    };
    double dt = step(1, speeds.wave);
    if (bounds.by_wave) dt = std::max(dt, std::min(step(0.75, speeds.carried_wave), step(1.25, speeds.flow)));
    if (diffusivity > 0) dt = std::min(dt, 0.25 * cell_size * cell_size / diffusivity);
    return dt;
}

}  // namespace frana
