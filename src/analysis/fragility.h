// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "analysis/hazard.h"

namespace frana {

/// How likely a state of damage, or a worse one, is at an intensity: Phi(ln(x / median) / beta).
struct DamageState {
    std::string name{};
    double loss = 0;    ///< fraction of the value that is lost
    double median = 0;  ///< intensity at which it is as likely as not
    double beta = 0;    ///< standard deviation of the intensity's logarithm; 0: a step

    [[nodiscard]] double probability(double intensity) const;
};

/// A quantity that breaks features: what no median exceeds, and its greatest value in the table of exposed features.
struct BreakingQuantity {
    HazardQuantity quantity;
    double most;
    const char* column;
};
inline constexpr BreakingQuantity k_breaking_quantities[] = {{HazardQuantity::depth, 20, "max_depth_m"},
                                                             {HazardQuantity::velocity, 100, "max_velocity_ms"},
                                                             {HazardQuantity::pressure, 2000, "max_pressure_kpa"},
                                                             {HazardQuantity::momentum, 1e5, "max_momentum_flux_m3s2"}};

/// The states of features of one class (of buildings), from the lightest; each needs the same quantity.
struct FragilityClass {
    std::string name{};  ///< empty: the only one
    const BreakingQuantity* by = nullptr;
    std::vector<DamageState> states{};

    /// Returns the expected fraction of the value that is lost at an intensity:
    ///
    ///     sum P_k (L_k - L_(k-1)),    L_0 = 0
    ///
    /// A state is never likelier than a lighter one: where their curves cross, the lower counts.
    [[nodiscard]] double loss(double intensity) const;
};

/// What the features of a layer are worth, and how they break.
struct Fragility {
    std::vector<FragilityClass> classes{};
    std::vector<std::size_t> class_of{};  ///< by feature
    std::vector<double> value{};          ///< by feature; each 1 if no column says it

    [[nodiscard]] const FragilityClass& of(std::size_t feature) const { return classes[class_of[feature]]; }
    [[nodiscard]] double damage(std::size_t feature, double intensity) const {
        return value[feature] * of(feature).loss(intensity);
    }
    [[nodiscard]] double most(std::size_t feature) const { return value[feature] * of(feature).states.back().loss; }
    [[nodiscard]] bool uses(HazardQuantity quantity) const {
        return std::any_of(classes.begin(), classes.end(),
                           [&](const FragilityClass& one) { return one.by->quantity == quantity; });
    }
};

/// An expected damage and the interval in which it lies.
struct Damage {
    double value = 0, low = 0, high = 0;
};

}  // namespace frana
