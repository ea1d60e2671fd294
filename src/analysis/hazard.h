// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/raster.h"

namespace frana {

/// Quantities that hazard schemes use; share/doc/hazard.md defines which maxima are taken at one moment.
struct HazardQuantities {
    const Raster& depth;     ///< greatest depth [m]; NaN: never reached, no class
    const Raster& velocity;  ///< greatest speed [m/s]
    const Raster& flux;      ///< greatest product of depth and speed at one moment [m2/s]
    const Raster& head;      ///< greatest sum of depth and v^2 / 2g at one moment [m]
    const Raster& pressure;  ///< greatest dynamic pressure [kPa]
    const Raster& deposit;   ///< depth at the end [m]
};

/// Rising limits of a custom scheme: the class of a cell is one more than the number of limits that the quantity
/// exceeds, the highest over the quantities that have limits.
struct HazardLimits {
    std::vector<double> depth, velocity, flux, pressure;

    [[nodiscard]] bool empty() const noexcept {
        return depth.empty() && velocity.empty() && flux.empty() && pressure.empty();
    }
};

struct HazardClass {
    int value = 0;           ///< 1: the lowest
    std::string name;        ///< "High intensity"; of scheme custom the thresholds
    std::string thresholds;  ///< "depth > 1 m and speed > 1 m/s"
    Rgb colour;
    bool hatched = false;  ///< in areas, with white between

    /// "High intensity: depth > 1 m and speed > 1 m/s"
    [[nodiscard]] std::string label() const { return name == thresholds ? name : name + ": " + thresholds; }
};

struct HazardScheme {
    std::string name;    ///< "swiss-debris-flow"
    std::string source;  ///< of the thresholds
    std::vector<HazardClass> classes;
    HazardLimits limits;       ///< of scheme custom
    double minimum_depth = 0;  ///< up to which there is no class [m]

    /// "Any class: depth > 0.1 m"
    [[nodiscard]] std::string minimum_label() const;
};

/// Returns the scheme of a name, with these limits for `custom`; up to the minimum depth [m] there is no class. Throws
/// Error(input) for an unknown name.
HazardScheme hazard_scheme(const std::string& name, const HazardLimits& limits, double minimum_depth = 0);

/// Returns the class of every cell deeper than the scheme's minimum depth, NaN elsewhere.
Raster hazard_classes(const HazardScheme& scheme, const HazardQuantities& quantities);

}  // namespace frana
