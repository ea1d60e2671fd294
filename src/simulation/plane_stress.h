// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "models/voellmy_bingham/state.h"
#include "simulation/result.h"

namespace frana {

/// Normal stress in the plane [kPa], positive in compression: the paper's effective stress (equation 14), reversed,
///
///     rho (g h / 2 - sigma_xx),   rho (g h / 2 - sigma_yy)
///
/// h depth, vertical [m], sigma stress of the scene's law over density [m2/s2].
inline double plane_stress_kpa(double density, double gravity, double depth, double sigma) noexcept {
    return 1e-3 * density * (0.5 * gravity * depth - sigma);
}

/// Both components where there is a depth, as rasters; sigma from the differences of the velocity to the neighbours,
/// beyond the flow's edge that of the cell.
/// @param depth NaN: no flow  @param u, v velocity in map view [m/s]
std::vector<NamedRaster> plane_stress_rasters(const voellmy_bingham::PlaneStressLaw& law, double density,
                                              double gravity, const Raster& depth, const Raster& u, const Raster& v);

}  // namespace frana
