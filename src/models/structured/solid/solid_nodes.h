// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/thread_pool.h"
#include "core/zero_array.h"
#include "mpm/node_grid.h"

namespace frana::structured {

/// Sums of the solids at a node; one cache line.
struct alignas(64) SolidSums {
    double mass = 0;        ///< [kg]
    double px = 0, py = 0;  ///< momentum [kg m/s]
    double solids = 0;      ///< volume [m3]
    double confined = 0;    ///< volume [m3]
    double structured = 0;  ///< volume of solids that is structured [m3]
    double fx = 0, fy = 0;  ///< force of the lateral thrust [N]
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

/// Padded node indices [i0, i1) x [j0, j1).
struct NodeBox {
    std::int64_t i0 = 0, i1 = 0, j0 = 0, j1 = 0;
};

[[nodiscard]] inline bool is_within(const NodeBox& box, const NodeGrid& grid) noexcept {
    return box.i0 >= 0 && box.i1 <= grid.stride() && box.j0 >= 0 && box.j1 <= grid.padded_rows();
}

template <class Archive>
void serialise(Archive& archive, NodeBox& box) {
    auto& [i0, i1, j0, j1] = box;
    archive(i0, i1, j0, j1);
}

/// The solids on the background grid: cubic splines of four nodes a direction, node indices as
/// NodeGrid::index.
class SolidNodes {
  public:
    explicit SolidNodes(const NodeGrid& grid, bool gaps_are_walls, bool coupled);

    /// Whether all 16 nodes from this one are inside and not walls.
    [[nodiscard]] bool whole(std::size_t first) const noexcept { return whole_[first] != 0; }
    [[nodiscard]] bool active(std::size_t node) const noexcept { return active_[node] != 0; }
    void clear(const NodeBox& box, std::int64_t stride, ThreadPool& pool);

    /// Everything that steps change; walls do not.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [sum, coupled, pushes, h, nu, nv, solids, whole_fraction, where, inside, all_inside] =
            *this;
        archive(sum, coupled, pushes, h, nu, nv, solids, whole_fraction, where);
    }

    ZeroArray<SolidSums> sums;
    ZeroArray<CouplingSums> coupling;  ///< empty without fluid
    ZeroArray<NodePush> push;
    ZeroArray<double> depth, u, v, solid_fraction, structured;  ///< inputs of the fluid (SolidsOnGrid)
    NodeBox box;                                                ///< outside it all sums are zero

  private:
    std::vector<std::uint8_t> active_, whole_;
};

}  // namespace frana::structured
