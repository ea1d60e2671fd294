// SPDX-License-Identifier: Apache-2.0
#include "study/union_maps.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "study/member_record.h"

namespace frana::study {
namespace {

/// The classes of schemes without a weak intensity begin at medium; their numbers are those of the matrix.
void add_degree(double& degree, float intensity, double return_period, const DegreeMatrix& degrees) {
    const auto one = static_cast<double>(degrees.of(static_cast<int>(intensity), return_period));
    degree = std::isnan(degree) ? one : std::max(degree, one);
}

void add_greatest(double& greatest, float value) {
    const auto one = static_cast<double>(value);
    greatest = std::isnan(greatest) ? one : std::max(greatest, one);
}

void add_member(const UnionMember& member, const MemberRecord& record, const DegreeMatrix& degrees, UnionMaps& maps) {
    const GridSpec& grid = maps.depth.grid;
    record.for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t i) {
        if (row < 0 || column < 0 || row >= grid.rows || column >= grid.columns) return;
        const auto cell = static_cast<std::size_t>(row * grid.columns + column);
        const auto depth = static_cast<double>(record.depth[i]);
        double& deepest = maps.depth.values[cell];
        if (std::isnan(deepest) || depth > deepest) {
            deepest = depth;
            maps.worst.values[cell] = static_cast<double>(member.number);
        }
        double& hits = maps.hits.values[cell];
        hits = (std::isnan(hits) ? 0 : hits) + (depth > 0 ? 1 : 0);
        add_greatest(maps.velocity.values[cell], record.velocity[i]);
        if (!record.pressure.empty()) add_greatest(maps.pressure.values[cell], record.pressure[i]);
        if (std::isfinite(record.arrival[i])) {
            double& first = maps.arrival.values[cell];
            const auto arrival = static_cast<double>(record.arrival[i]);
            first = std::isnan(first) ? arrival : std::min(first, arrival);
        }
        if (record.intensity.empty() || !(record.intensity[i] >= 1)) return;
        add_greatest(maps.intensity.values[cell], record.intensity[i]);
        if (member.return_period)
            add_degree(maps.degree.values[cell], record.intensity[i], *member.return_period, degrees);
    });
}

}  // namespace

UnionMaps union_maps(const std::vector<UnionMember>& members, const GridSpec& grid, const DegreeMatrix& degrees) {
    UnionMaps maps;
    maps.depth = maps.velocity = maps.pressure = maps.arrival = maps.hits = maps.worst = maps.intensity = maps.degree =
        Raster(grid, k_no_data);
    for (const UnionMember& member : members) {
        const auto record = read_record(member.record);
        if (!record)
            throw Error(ErrorKind::environment, Problem{"the record of a member cannot be read", member.record, "", "",
                                                        "Check the disk; --resume computes that member again"});
        add_member(member, *record, degrees, maps);
    }
    return maps;
}

}  // namespace frana::study
