// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// A wide slab 1 m deep on planes, Coulomb friction, in map view: its middle must move as a rigid block,
///     du/dt = g cos^2(theta) (tan theta - tan phi)
/// (share/doc/model.md, "Curvature"; elementary mechanics). The comparison uses the nodes within 20 m of the exact
/// middle, on 35 degrees with phi = 20 degrees after 4 s. Own values, mark 1e-3: the relative speed error of the middle
/// on 25, 35 and 45 degrees, and of the distance to rest of a slab that starts at 10 m/s on 10 degrees with phi = 25
/// degrees. The paper's scheme has no slope correction, and is too fast by 1 / cos^2(theta).
AccuracyCase sliding_block();

/// Runs a slab 200 m long and 1 m deep that starts at x = 20 m on a plane falling to the right; for sliding_block and
/// voellmy_plane.
struct Slab {
    double slope_deg = 0;
    Material material;
    double start_speed = 0;  ///< in map view [m/s]
    double time = 0;         ///< [s]
    double travel = 0;       ///< exact distance of the middle, in map view [m]
    double speed = 0;        ///< exact speed at the end, in map view [m/s]
};

struct SlabOutcome {
    CaseStatistics statistics;
    double mean_speed = 0;  ///< of particles within 20 m of the exact middle [m/s]
    double distance = 0;    ///< their mean speed summed over time [m]
};

SlabOutcome run_slab(double cell_size, Scheme scheme, const Slab& slab, const std::function<double(double)>& travel);

}  // namespace frana::bench
