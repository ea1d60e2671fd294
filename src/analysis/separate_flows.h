// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/raster.h"

namespace frana {

/// Returns the number of the cell that contains a place in map coordinates; none outside the grid.
std::optional<std::size_t> cell_at(const GridSpec& grid, Point place);

/// Divides the cells of a result into flows that never met. Cells that were released or reached belong to the same flow
/// if they touch along a side or at a corner, or are connected by such cells. Reached cells from which no way leads to
/// a release or an inflow (material leaped there, or was too thin on its way) belong to the flow whose cells are
/// nearest in map view. Where nothing is released and no inflow is known, every connected region is a flow.
class SeparateFlows {
  public:
    /// `release` [m]: positive where something is released; `reached`: positive where material was at any time; on the
    /// same cells. `inflows`: places where material flows in, map coordinates; those outside the grid are ignored.
    /// Throws Error(input) if the cells differ.
    SeparateFlows(const Raster& release, const Raster& reached, const std::vector<Point>& inflows = {});

    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    /// Returns the number of the flow to which a released or reached cell belongs, in the order of their first cells;
    /// count(): another cell.
    [[nodiscard]] std::size_t flow_of(std::size_t cell) const noexcept;

  private:
    /// Cells [first, last) of one row.
    struct Run {
        std::size_t first, last;
        std::size_t flow;
    };

    void connect(std::int64_t columns);
    void join_islands(std::int64_t columns, const std::vector<bool>& has_source);
    void number_flows();

    std::vector<Run> runs_;  // by cell
    std::size_t count_ = 0;
};

}  // namespace frana
