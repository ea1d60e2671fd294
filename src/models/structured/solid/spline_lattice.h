// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/grid_spec.h"
#include "core/zero_array.h"
#include "models/structured/solid/cubic_stencil.h"

namespace frana::structured {

/// Nodes of cubic splines on a square lattice of its own, anchored at the local origin whatever the cells are. A node
/// holds the sums of the last `begin`; those of an earlier one count as zero, so that none is ever cleared.
template <class Sums>
class SplineLattice {
  public:
    struct Node : Sums {
        std::int64_t call = 0;
    };
    /// The sixteen nodes of a place: four rows of four.
    struct Stencil {
        Node* first = nullptr;
        std::int64_t stride = 0;
        double wx[4], wy[4], sx[4], sy[4];  ///< weights and, per node spacing, their slopes
        double to_x = 0, to_y = 0;          ///< from the place to the first node, in node spacings

        /// Calls visit(node, a, b), a the column and b the row.
        template <class Visit>
        void for_each(const Visit& visit) const {
            Node* row = first;
            for (int b = 0; b < 4; ++b, row += stride)
                for (int a = 0; a < 4; ++a) visit(row[a], a, b);
        }
    };

    /// @param bounds of the terrain [m]; places outside act at its edge
    /// @param side of the lattice [m]
    SplineLattice(const Bounds& bounds, double side)
        : side_(side),
          west_(CubicSpline::first(bounds.west / side)),
          south_(CubicSpline::first(bounds.south / side)),
          columns_(CubicSpline::first(bounds.east / side) + 4 - west_),
          rows_(CubicSpline::first(bounds.north / side) + 4 - south_),
          nodes_(static_cast<std::size_t>(columns_ * rows_)) {}

    [[nodiscard]] double side() const noexcept { return side_; }
    void begin() noexcept { ++call_; }
    /// The node's sums, zero if nothing was added since `begin`.
    [[nodiscard]] Node& fresh(Node& node) const noexcept {
        if (node.call != call_) node = Node{{}, call_};
        return node;
    }
    [[nodiscard]] Stencil at(double x, double y) noexcept {
        Stencil s;
        const double i = x / side_, j = y / side_;
        const std::int64_t column = CubicSpline::evaluate(i, s.wx, s.sx), row = CubicSpline::evaluate(j, s.wy, s.sy);
        s.to_x = static_cast<double>(column) - i;
        s.to_y = static_cast<double>(row) - j;
        s.stride = columns_;
        s.first = nodes_.data() + std::clamp<std::int64_t>(row - south_, 0, rows_ - 4) * columns_ +
                  std::clamp<std::int64_t>(column - west_, 0, columns_ - 4);
        return s;
    }

  private:
    double side_;
    std::int64_t west_, south_, columns_, rows_, call_ = 0;
    ZeroArray<Node> nodes_;
};

}  // namespace frana::structured
