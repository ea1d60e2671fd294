// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bench/exact/dam_break.h"

namespace frana::bench {

/// Collapse of a cylinder of water, computed on a fine radial grid, independent of the particle method.
///     (r h)_t + (r h u)_r = 0,   (r h u)_t + (r (h u^2 + g h^2 / 2))_r = g h^2 / 2
/// Finite volumes, piecewise linear in h and u (van Leer's limiter), HLL flux with the wave speeds of a dry
/// front, Heun's method in time; LeVeque 2002, chapters 6, 13 and 17. A wall at r = 0 and at the outer end.
class RadialReference {
  public:
    /// @param radius of the cylinder [m]  @param inside, outside depths [m]  @param extent outer wall [m]
    /// @param time [s]  @param cells over the extent
    RadialReference(double radius, double inside, double outside, double extent, double time, int cells);

    /// Returns depth and outward velocity at a distance from the middle.
    [[nodiscard]] WaterState at(double r) const;
    /// Returns the distance of the outermost place deeper than `depth` [m].
    [[nodiscard]] double reach(double depth) const;
    /// Volume over 2 pi [m3]; for the test of conservation.
    [[nodiscard]] double volume() const;

  private:
    struct Cell {
        double h = 0, q = 0;
    };
    void rate(const std::vector<Cell>& state, std::vector<Cell>& change) const;
    [[nodiscard]] double fastest() const;

    double dr_;
    std::vector<Cell> cells_;
};

}  // namespace frana::bench
