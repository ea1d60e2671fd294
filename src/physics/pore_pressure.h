// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

namespace frana {

/// Pore-pressure ratio that dissipates exponentially:
///
///     r_u(t) = r_0 exp(-t / T)      [-]
///
/// r_0 pore pressure over total normal stress at the start, t time since the start of the run [s], T
/// dissipation time [s] (infinite: r_u stays). It reduces the normal stress in frictional laws by this fraction. Range:
/// 0 <= r_0 <= 1, T > 0. Limits: t = 0 gives r_0, t -> infinity dry friction; it does not depend on depth or speed, so
/// it is finite at zero of either. Sources: constant r_u, Hungr 1995, Can. Geotech. J. 32, 610; exponential decay as
/// the leading mode of consolidation, T of the order of d^2 / D with hydraulic diffusivity D, Iverson 1997, Rev.
/// Geophys. 35, 245.
struct PorePressure {
    double initial = 0;                                                 ///< r_0 [-]
    double dissipation_time = std::numeric_limits<double>::infinity();  ///< T [s]

    [[nodiscard]] bool active() const noexcept { return initial > 0; }
    [[nodiscard]] double ratio(double time) const noexcept { return initial * std::exp(-time / dissipation_time); }
};

}  // namespace frana
