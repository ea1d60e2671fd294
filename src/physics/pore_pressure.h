// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "physics/law.h"
#include "physics/parameters.h"

namespace frana {

/// Pore pressure at the bed, a state of the moving material, as its ratio r to the total normal stress sigma = rho g_n
/// d, and with dilatancy the solid fraction m:
///
///     dr/dt = -(r - r_h) / T - 3 s (m - m_c) / (alpha d sigma)
///     dm/dt = (2/3) alpha m sigma (r - r_h) / T
///
/// r_h = rho_f / rho hydrostatic ratio (0: pores that drain), T = 4 d^2 / (pi^2 D) or given [s], d thickness and g_n
/// gravity normal to the bed, D hydraulic diffusivity [m2/s], s speed [m/s], alpha compressibility of the grains' frame
/// [1/Pa], m_c critical solid fraction. Range: 0 <= r <= 1. Limits: without T and alpha r stays; at rest r tends to
/// r_h, in steady shear m to m_c; d -> 0 drains at once. The material carries r, so that pressure follows its load when
/// the thickness changes (undrained loading).
///
/// Sources: r, Hungr 1995, Can. Geotech. J. 32, 610; T, first mode of the consolidation of a layer that drains at its
/// surface, Terzaghi 1943, Theoretical Soil Mechanics, chapter 13, for flows Iverson 1997, Rev. Geophys. 35, 245;
/// dilatancy, Iverson and George 2014, Proc. R. Soc. A 470, 20130819, with shear rate 2 s / d, dilatancy angle m - m_c
/// (their m_eq at a shear that is slow against the stress, and without its part in friction), and a constant alpha. The
/// second line is their balance of solids: what the pressure loses, 2/3 of it in the mean over a parabola, compacts.
inline PorePressure::State PorePressure::after(State state, double thickness, double speed, double normal_gravity,
                                               double dt) const noexcept {
    constexpr double k_thinnest = 1e-6;  // [m]
    const double d = std::max(thickness, k_thinnest);
    const double rate =
        diffusivity > 0 ? 0.25 * std::numbers::pi * std::numbers::pi * diffusivity / (d * d) : 1 / dissipation_time;
    const double x = state.ratio - hydrostatic;
    if (!dilates()) return {hydrostatic + x * std::exp(-rate * dt), state.solid_fraction};
    // A damped oscillator: x' = -2 a x - S y, y' = B x, y = m - m_c.
    const double sigma = density * normal_gravity * d, y = state.solid_fraction - critical_fraction;
    const double a = 0.5 * rate, shear = 3 * speed / (compressibility * d * sigma);
    const double gain = 2.0 / 3 * compressibility * state.solid_fraction * sigma * rate;
    const double w2 = shear * gain - a * a, w = std::sqrt(std::abs(w2));
    double even = 0, odd = 0;  // exp(-a dt) cos(w dt), exp(-a dt) sin(w dt) / w
    if (w * dt < 1e-8) {
        even = std::exp(-a * dt);
        odd = even * dt;
    } else if (w2 > 0) {
        even = std::exp(-a * dt) * std::cos(w * dt);
        odd = std::exp(-a * dt) * std::sin(w * dt) / w;
    } else {
        const double slow = std::exp(-shear * gain / (a + w) * dt), fast = std::exp(-(a + w) * dt);
        even = 0.5 * (slow + fast);
        odd = 0.5 * (slow - fast) / w;
    }
    return {std::clamp(hydrostatic + x * even - (a * x + shear * y) * odd, 0.0, 1.0),
            std::clamp(critical_fraction + y * even + (gain * x + a * y) * odd, 0.0, 1.0)};
}

/// Its keys, read by the laws of friction of the solid.
struct PoreValues {
    std::optional<double> pore_pressure_ratio, pore_dissipation_time, hydraulic_diffusivity, compressibility,
        solid_fraction, critical_solid_fraction;
    double pore_fluid_density = 0;

    /// @param density of the flow [kg/m3]
    [[nodiscard]] PorePressure pore_pressure(double density) const {
        PorePressure p{{pore_pressure_ratio.value_or(0), solid_fraction.value_or(0)}, pore_fluid_density / density};
        p.dissipation_time = pore_dissipation_time.value_or(p.dissipation_time);
        p.diffusivity = hydraulic_diffusivity.value_or(0);
        p.critical_fraction = critical_solid_fraction.value_or(0);
        p.compressibility = compressibility.value_or(0);
        p.density = density;
        return p;
    }
    static auto keys() {
        return std::tuple{
            law_key(&PoreValues::pore_pressure_ratio, "material.pore-pressure-ratio", worded("pore pressure ratio"), "",
                    {0, 1},
                    "Pore pressure over total normal stress at the start, r_u; reduces friction by this fraction.",
                    "0"),
            law_key(&PoreValues::pore_dissipation_time, "material.pore-dissipation-time", "", "s", {0, 1e9, true},
                    "Time in which the excess pore pressure decreases to 1/e.", "no dissipation"),
            law_key(&PoreValues::hydraulic_diffusivity, "material.hydraulic-diffusivity", "", "m2/s", {0, 1e3, true},
                    "Hydraulic diffusivity D; excess pore pressure decreases to 1/e in 4 d^2 / (pi^2 D), d thickness.",
                    "no dissipation"),
            law_key(&PoreValues::pore_fluid_density, "material.pore-fluid-density", "", "kg/m3", {0, 5000},
                    "Density of the pore fluid, to whose hydrostatic pressure excess pressure decreases; 0: to none."),
            law_key(&PoreValues::compressibility, "material.compressibility", "", "1/Pa", {0, 1, true},
                    "Compressibility of the grains' frame; with it shear changes pore pressure (dilatancy).",
                    "no dilatancy"),
            law_key(&PoreValues::solid_fraction, "material.solid-fraction", "", "", {0.1, 0.9},
                    "Solid fraction of the flow at the start, for dilatancy.", "no dilatancy"),
            law_key(&PoreValues::critical_solid_fraction, "material.critical-solid-fraction", "", "", {0.1, 0.9},
                    "Solid fraction that does not change in steady shear; looser flow gains pore pressure in shear.",
                    "no dilatancy")};
    }
    /// Returns the names of the keys, and of others before them.
    static std::vector<std::string> names(std::vector<std::string> list) {
        std::apply([&](const auto&... key) { (list.emplace_back(key.name), ...); }, keys());
        return list;
    }
};

}  // namespace frana
