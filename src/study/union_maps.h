// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard_degree.h"
#include "core/raster.h"

namespace frana::study {

/// A member that counts in a union.
struct UnionMember {
    std::size_t number = 0;
    std::string record;  ///< its file
    std::optional<double> return_period{};
};

/// The worst of several members, cell by cell: what at least one of several sources does there. NaN where none came.
struct UnionMaps {
    Raster depth, velocity;  ///< greatest [m], [m/s]
    Raster pressure;         ///< greatest [kPa]; NaN everywhere if the records have none
    Raster arrival;          ///< earliest [s]
    Raster hits;             ///< number of members that came
    Raster worst;            ///< number of the member with the greatest depth, the lowest of several
    Raster intensity;        ///< greatest class; as pressure
    Raster degree;           ///< greatest degree of hazard; NaN also where no member has intensity and return period
};

/// Reads each record once, one after the other: time grows with the number of members, memory with the cells they
/// reached. Throws Error(environment) for a record that cannot be read.
UnionMaps union_maps(const std::vector<UnionMember>& members, const GridSpec& grid, const DegreeMatrix& degrees = {});

}  // namespace frana::study
