// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"

namespace frana {

/// Agreement in depth of a simulated deposit with an observed one, over the cells where either is deeper than the
/// threshold and the observation has data. With d = simulated minus observed depth:
struct DepositScores {
    double area_m2 = 0;             ///< of those cells
    double observed_volume_m3 = 0;  ///< over those cells
    double simulated_volume_m3 = 0;
    double bias_m = 0;                 ///< mean of d
    double mean_absolute_error_m = 0;  ///< mean of |d|
    double rmse_m = 0;                 ///< sqrt(mean of d^2)
    double correlation = 0;            ///< Pearson's, of the two depths; NaN if one does not vary
};

/// `simulated` final depth [m] (NaN: none), `observed` gain of elevation [m] (NaN: not surveyed; a loss counts as no
/// deposit), on the same cells. Throws Error(input) if the cells differ or neither has a deposit.
DepositScores compare_deposit(const Raster& simulated, const Raster& observed, double threshold);

}  // namespace frana
