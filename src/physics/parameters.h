// SPDX-License-Identifier: Apache-2.0
// Parameters of laws that scenes and states keep. The formulas are in the laws' headers, which only the sources include
// that compute with them: a changed formula is compiled nowhere else.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace frana {

/// Of friction_voellmy.h.
struct VoellmyFriction {
    double friction_coefficient = 0;  ///< tan(phi) [-]
    double inverse_turbulence = 0;    ///< 1 / xi [s2/m]

    [[nodiscard]] bool active() const noexcept { return friction_coefficient > 0 || inverse_turbulence > 0; }

    /// Returns the speed after dt (speed_after_step).
    /// @param start speed before the step, @param driven the same after all driving forces of the step [m/s]
    template <class Number = double>
    [[nodiscard]] Number speed_after(std::type_identity_t<Number> start, std::type_identity_t<Number> driven, double dt,
                                     std::type_identity_t<Number> normal_gravity, double gravity,
                                     std::type_identity_t<Number> thickness) const;
};

/// Of pore_pressure.h.
struct PorePressure {
    struct State {
        double ratio = 0;           ///< r [-]
        double solid_fraction = 0;  ///< m [-]
    };
    State initial;
    double hydrostatic = 0;                                             ///< r_h [-]
    double dissipation_time = std::numeric_limits<double>::infinity();  ///< T unless D is given [s]
    double diffusivity = 0;                                             ///< D [m2/s]
    double critical_fraction = 0;                                       ///< m_c [-]
    double compressibility = 0;                                         ///< alpha [1/Pa]; 0: no dilatancy
    double density = 1;                                                 ///< rho [kg/m3]

    [[nodiscard]] bool dissipates() const noexcept { return diffusivity > 0 || std::isfinite(dissipation_time); }
    [[nodiscard]] bool dilates() const noexcept { return compressibility > 0; }
    /// Returns a bound of r.
    [[nodiscard]] double greatest() const noexcept {
        if (dilates()) return 1;
        return std::max(initial.ratio, dissipates() ? hydrostatic : 0);
    }
    [[nodiscard]] bool active() const noexcept { return greatest() > 0; }

    /// Returns the state after dt under constant coefficients, exact but for the factor m, which is that before.
    /// @param speed s [m/s]  @param normal_gravity g_n [m/s2]
    [[nodiscard]] State after(State state, double thickness, double speed, double normal_gravity,
                              double dt) const noexcept;
};

/// Of infiltration_green_ampt.h.
struct GreenAmpt {
    double conductivity = 0;  ///< K [m/s]
    double suction = 0;       ///< psi [m]
    double deficit = 0;       ///< D [-], under 1

    /// Returns what infiltrates of `water` [m] in dt [s], after `before` [m] has.
    [[nodiscard]] double operator()(double before, double water, double dt) const noexcept;
};

/// Of rain.h.
struct Rain {
    struct Point {
        double time = 0;       ///< [s]
        double intensity = 0;  ///< [m/s], of vertical depth
    };
    std::vector<Point> points;  ///< times rise; an equal time is a step

    [[nodiscard]] bool falls() const noexcept { return !points.empty(); }
    /// When the last of it has fallen [s].
    [[nodiscard]] double end() const noexcept { return falls() ? points.back().time : 0; }
    /// Depth that has fallen by a time: the integral, without error [m].
    [[nodiscard]] double depth_by(double time) const noexcept;
};

}  // namespace frana
