// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// The sample's terrain flooded to a level, without any forcing for 60 s: a lake with islands and a shoreline, on
/// ground rougher than the grid, since a coarse grid samples single elevations of the fine one instead of means. Walls
/// on all sides, no friction. Mark: no particle faster than 1e-4 m/s.
/// @param dtm elevations without gaps; its cell size is the finest level, the others skip cells
AccuracyCase lake_dtm(const Raster& dtm);

/// Lakes at rest on [0, 10] m squared, surface at 10 m, closed walls; no still-water depth is specified. Source: Fois,
/// de Falco, Formaggia 2024, section 4.1 and Table 1.
///   lake-z1      Z = 5 exp(-2/5 |x - (5, 5)|^2), 1 s
///   lake-z2      Z = 4 m on [4, 8] m squared, else 0, 1 s
///   lake-island  Z = 13 exp(-2/5 |x - (5, 5)|^2): an island rises from the water, 10 s, no friction
/// "Exact" is the nodes' own state at the start, which a lake at rest must keep, bit for bit except for rounding. A row
/// of lake-z1 or lake-z2 is four runs: the paper's material (friction 20 degrees, xi 200 m/s2, 1200 kg/m3, 2000 Pa s,
/// 30 Pa) and neither friction nor stress, each with particles on a lattice and placed at random. Its errors are the
/// greatest of the four, its steps and seconds their sums. Marks: 1e-12; for the island 1e-10.
std::vector<AccuracyCase> lakes();

/// A lake over any bed, filled to `level`, run for `time`; `jitter` as in fill_lattice. Own values: the
/// greatest depth change [m], momentum [m2/s] and particle speed [m/s], with marks if given.
CaseStatistics run_lake(const Raster& bed, double level, const Material& material, Scheme scheme, double jitter,
                        double time);

}  // namespace frana::bench
