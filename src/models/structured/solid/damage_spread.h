// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/thread_pool.h"
#include "core/zero_array.h"
#include "models/structured/solid/pair_work.h"
#include "models/structured/solid/solid_laws.h"
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
/// two splines, each of variance side^2 / 3, one after the other, have that of a Gaussian of standard deviation R. The
/// lattice is anchored at the local origin, whatever cells and particles there are.
class DamageSpread {
  public:
    /// @param bounds of the terrain [m]
    /// @param length R [m]
    DamageSpread(const Bounds& bounds, double length);

    /// Reads volume, and strain and places in `work`; writes damage, cohesion_ratio, and bonds in `work`. Places have
    /// moved by at most the order's slack since it was sorted. Returns by cell of the order where cohesion was lost.
    std::vector<std::uint8_t> operator()(const CellOrder& order, const Fragmentation& law, ParticleSet& particles,
                                         PairWork& work, ThreadPool& pool);

  private:
    struct Sums {
        double weight = 0, damage = 0;
        std::int64_t call = 0;  ///< in which they were made; those of an earlier one count as zero
    };
    template <class Visit>
    void at_nodes(double x, double y, const Visit& visit);

    double side_;
    std::int64_t west_, south_, columns_, rows_;
    ZeroArray<Sums> sums_;
    std::int64_t call_ = 0;
};

}  // namespace frana::structured
