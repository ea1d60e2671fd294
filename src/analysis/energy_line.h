// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/raster.h"

namespace frana {

/// The maxima of a flow, and where its energy came from; all on one grid.
struct EnergyLineInput {
    const Raster& bed;     ///< elevation [m]
    const Raster& source;  ///< energy head where material enters: surface, and v^2 / 2g of its speed [m]; else NaN
    const Raster& depth;   ///< greatest; NaN where nothing came [m]
    const Raster& speed;   ///< greatest, along the bed [m/s]
    /// Least tangent of friction in a cell.
    std::function<double(std::size_t cell)> friction;
    double gravity = 0;  ///< [m/s2]
    double push = 0;     ///< greatest depth that pressure acts with [m]
};

/// How far a flow was above its energy line.
struct EnergyLineExcess {
    double height = 0;   ///< the greatest [m]
    double of_fall = 0;  ///< the greatest, relative to the fall from the line to the lowest ground on the way
    double volume = 0;   ///< greatest depths over the cells that exceed it by more than `k_line_error` of the fall [m3]
    Point place;         ///< of the greatest, map coordinates
};

/// Part of the fall that a flow may be above its energy line by the error of cells.
inline constexpr double k_line_error = 0.05;

/// Compares the maxima of a flow with its energy line. A mass that slid from its source along the best way over reached
/// ground has the head of the source less friction times length in map view (Heim 1932), and at most
///
///     v^2 / 2g <= line - z + h
///
/// where h is the push of pressure: with equality at the front of a dam break (Ritter 1892: v = 2 sqrt(g h)), also on a
/// rough incline (Mangeney et al. 2000). Ground that no way over reached cells leads to (behind a flight) has the
/// highest line of all.
EnergyLineExcess energy_line_excess(const EnergyLineInput& input);

}  // namespace frana
