// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard_degree.h"
#include "core/raster.h"
#include "study/member_record.h"

namespace frana::study {

/// A member that counts in a union.
struct UnionMember {
    std::size_t number = 0;
    std::string record;  ///< its file
    std::optional<double> return_period{};
};

// The worst of several members, cell by cell: what at least one of several sources does there. NaN where none came.
// Each function reads each record once, one after the other: time grows with the number of members, memory with the
// cells they reached, for the rasters of one function at a time. Throws Error(environment) for a record that cannot be
// read.

struct DepthUnion {
    Raster depth;  ///< greatest [m]
    Raster hits;   ///< number of members that came
    Raster worst;  ///< number of the member with the greatest depth, the lowest of several
};
DepthUnion depth_union(const std::vector<UnionMember>& members, const GridSpec& grid);

/// Greatest value of a quantity (velocity, pressure, intensity); NaN everywhere if the records have none.
Raster greatest_of(const std::vector<UnionMember>& members, Quantity quantity, const GridSpec& grid);

/// Earliest arrival [s].
Raster earliest_arrival(const std::vector<UnionMember>& members, const GridSpec& grid);

/// Greatest degree of hazard; NaN also where no member has intensity and return period.
Raster worst_degree(const std::vector<UnionMember>& members, const GridSpec& grid, const DegreeMatrix& degrees);

}  // namespace frana::study
