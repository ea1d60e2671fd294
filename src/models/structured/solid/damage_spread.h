// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/thread_pool.h"
#include "models/structured/solid/solid_laws.h"
#include "models/structured/solid/solid_work.h"
#include "models/structured/solid/spline_lattice.h"
#include "particles/cell_order.h"
#include "particles/particle_set.h"

namespace frana::structured {

/// Damage with a length (nonlocal: Pijaudier-Cabot & Bazant 1987, J. Eng. Mech. 113, 1512). The strain dD that a
/// yielding particle adds to its damage acts on all cohesive material around it,
///     dD(x_i) = sum_j w_j dD_j K(x_i, x_j) / sum_j w_j K(x_i, x_j),   w = V c / c_0
/// so that a band that breaks is as wide as the material's length R and not as wide as the cells. Each weighs with the
/// cohesion that it has left (ours): what flows away from a face does not break the face, or damage would be
/// contagious. Material that does not bear its own weight when it is intact breaks as a whole: there dD is its own.
///
/// K(x, y) = sum_n N_n(x) N_n(y) over the nodes n of a lattice of side sqrt(3/2) R, N the cubic splines of equation 87:
/// two splines, each of variance side^2 / 3, one after the other, have that of a Gaussian of standard deviation R.
class DamageSpread {
  public:
    /// @param bounds of the terrain [m]
    /// @param length R [m]
    DamageSpread(const Bounds& bounds, double length) : lattice_(bounds, std::sqrt(1.5) * length) {}

    /// Reads volume, places, and strain and bonds in `work`; writes damage, cohesion_ratio. Places have moved by at
    /// most the order's slack since it was sorted.
    void operator()(const CellOrder& order, const Fragmentation& law, ParticleSet& particles, const SolidWork& work,
                    ThreadPool& pool);

  private:
    struct Sums {
        double weight = 0, damage = 0;
    };
    SplineLattice<Sums> lattice_;
};

}  // namespace frana::structured
