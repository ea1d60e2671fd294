// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/thread_pool.h"
#include "core/zero_array.h"
#include "mpm/node_grid.h"
#include "particles/cell_order.h"
#include "particles/particle_set.h"

namespace frana::structured {

/// Sums of the solids at a node; one cache line.
struct alignas(64) SolidSums {
    double mass = 0;        ///< [kg]
    double px = 0, py = 0;  ///< momentum [kg m/s]
    double solids = 0;      ///< volume [m3]
    double confined = 0;    ///< volume [m3]
    double structured = 0;  ///< volume of solids that is structured [m3]
};

/// Additional sums at a node in scenes with fluid.
struct alignas(32) CouplingSums {
    double diameter = 0;  ///< volume of solids times grain diameter [m4]
    double friction = 0;  ///< greatest force of friction at the bed [N]
    double area = 0;      ///< claimed by the particles [m2]
    double pores = 0;     ///< volume between the solids at their placement [m3]
};

/// Values that the particles gather from a node.
struct alignas(32) NodePush {
    double ax = 0, ay = 0;   ///< acceleration [m/s2]
    double flatness = 1;     ///< 1 / (1 + |grad b|^2)
    double submergence = 0;  ///< fraction of the loose solids' pores that free fluid fills
};

/// The solids on the background grid: cubic splines of four nodes a direction, node indices as
/// NodeGrid::index. Only the tiles that the solids touch are ever read or written.
class SolidNodes {
  public:
    explicit SolidNodes(const NodeGrid& grid, bool walls_in_gaps, bool coupled);

    /// Zeroes the sums and the fluid's inputs in `tiles`.
    void clear(const NodeGrid& grid, ThreadPool& pool);
    /// Sets `tiles` to those that contain any of the sixteen nodes of a particle, and covers the ground that a step
    /// reads in and around them. After clear.
    void find_tiles(const ParticleSet& particles, const CellOrder& order, const NodeGrid& grid, ThreadPool& pool);

    /// Everything that steps change.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [sum, coupled, pushes, h, nu, nv, solids, whole_fraction, areal, gaps, where, frame,
                                closed_gaps] = *this;
        archive(sum, coupled, pushes, h, nu, nv, solids, whole_fraction, areal, gaps, where);
    }

    ZeroArray<SolidSums> sums;
    ZeroArray<CouplingSums> coupling;  ///< empty without fluid
    ZeroArray<NodePush> push;
    ZeroArray<double> depth, u, v, solid_fraction, structured, mass, pores;  ///< inputs of the fluid (SolidsOnGrid)
    std::vector<std::int64_t> tiles;  ///< ascending; outside them all sums are zero
    TileGrid grid;
    bool gaps_are_walls;
};

/// Checks, after reading, that the tiles are those of the grid.
[[nodiscard]] bool has_own_tiles(const SolidNodes& nodes);

}  // namespace frana::structured
