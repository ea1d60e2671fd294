// SPDX-License-Identifier: Apache-2.0
#include "study/union_maps.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace frana::study {
namespace {

/// Calls visit(member, record, cell, index) for the cells that each member reached.
template <class Visit>
void for_each_cell(const std::vector<UnionMember>& members, const GridSpec& grid, const Visit& visit) {
    for (const UnionMember& member : members) {
        const auto record = read_record(member.record);
        if (!record)
            throw Error(ErrorKind::environment, Problem{"the record of a member cannot be read", member.record, "", "",
                                                        "Check the disk; --resume computes that member again"});
        record->for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
            if (row < 0 || column < 0 || row >= grid.rows || column >= grid.columns) return;
            visit(member, *record, static_cast<std::size_t>(row * grid.columns + column), index);
        });
    }
}

void raise(double& greatest, double value) {
    greatest = std::isnan(greatest) ? value : std::max(greatest, value);
}

}  // namespace

DepthUnion depth_union(const std::vector<UnionMember>& members, const GridSpec& grid) {
    DepthUnion maps{Raster(grid, k_no_data), Raster(grid, k_no_data), Raster(grid, k_no_data)};
    for_each_cell(members, grid,
                  [&](const UnionMember& member, const MemberRecord& record, std::size_t cell, std::size_t index) {
                      const auto depth = static_cast<double>(record.depth[index]);
                      double& deepest = maps.depth.values[cell];
                      if (std::isnan(deepest) || depth > deepest) {
                          deepest = depth;
                          maps.worst.values[cell] = static_cast<double>(member.number);
                      }
                      double& hits = maps.hits.values[cell];
                      hits = (std::isnan(hits) ? 0 : hits) + (depth > 0 ? 1 : 0);
                  });
    return maps;
}

Raster greatest_of(const std::vector<UnionMember>& members, Quantity quantity, const GridSpec& grid) {
    Raster greatest(grid, k_no_data);
    for_each_cell(members, grid,
                  [&](const UnionMember&, const MemberRecord& record, std::size_t cell, std::size_t index) {
                      const std::vector<float>& values = record.of(quantity);
                      const bool has_class = quantity != Quantity::intensity || (!values.empty() && values[index] > 0);
                      if (!values.empty() && has_class)
                          raise(greatest.values[cell], static_cast<double>(values[index]));
                  });
    return greatest;
}

Raster earliest_arrival(const std::vector<UnionMember>& members, const GridSpec& grid) {
    Raster earliest(grid, k_no_data);
    for_each_cell(members, grid,
                  [&](const UnionMember&, const MemberRecord& record, std::size_t cell, std::size_t index) {
                      const auto arrival = static_cast<double>(record.arrival[index]);
                      if (!std::isfinite(arrival)) return;
                      double& first = earliest.values[cell];
                      first = std::isnan(first) ? arrival : std::min(first, arrival);
                  });
    return earliest;
}

Raster worst_degree(const std::vector<UnionMember>& members, const GridSpec& grid, const DegreeMatrix& degrees) {
    Raster worst(grid, k_no_data);
    for_each_cell(
        members, grid, [&](const UnionMember& member, const MemberRecord& record, std::size_t cell, std::size_t index) {
            if (record.intensity.empty() || !(record.intensity[index] >= 1) || !member.return_period) return;
            raise(worst.values[cell],
                  static_cast<double>(degrees.of(static_cast<int>(record.intensity[index]), *member.return_period)));
        });
    return worst;
}

}  // namespace frana::study
