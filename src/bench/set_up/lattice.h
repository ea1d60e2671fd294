// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "core/raster.h"
#include "particles/particle_set.h"

namespace frana::bench {

/// A flat grid from the origin, for cases without a map.
GridSpec plain_grid(std::int64_t columns, std::int64_t rows, double cell_size);

/// A raster of z(x, y) at the cell centres, local metres.
Raster sample_raster(const GridSpec& grid, const std::function<double(Point)>& z);

/// Depth and velocity at a local point; depth <= 0: no particle.
struct Seed {
    double depth = 0, u = 0, v = 0;
};

/// Fills the grid with `per_side` x `per_side` particles per cell, each with the depth and velocity at its place.
/// @param jitter 0: a lattice; otherwise each particle is displaced by up to jitter / 2 of the lattice spacing in both
///   directions, from a fixed generator (SplitMix64), the same on every machine
ParticleSet fill_lattice(const GridSpec& grid, int per_side, double jitter, const std::function<Seed(Point)>& state);

}  // namespace frana::bench
