// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/hazard.h"
#include "app/study/member_record.h"
#include "app/study/statistics/cell_statistics.h"
#include "core/raster.h"

namespace frana::app::study {

// The worst of several members, cell by cell: what at least one of several sources does there. NaN where none came.
// Memory is bounded as by for_each_hit_cell(), for the rasters of one function at a time.

struct DepthUnion {
    Raster depth;  ///< greatest [m]
    Raster hits;   ///< number of members that came
    Raster worst;  ///< number of the member with the greatest depth, the lowest of several
};
DepthUnion depth_union(const FinishedMembers& members, const GridSpec& grid);

/// Greatest value of a quantity (velocity, pressure, intensity).
Raster greatest_of(const FinishedMembers& members, Quantity quantity, const GridSpec& grid);

/// Earliest arrival [s].
Raster earliest_arrival(const FinishedMembers& members, const GridSpec& grid);

/// Greatest degree of hazard; NaN also where no member has intensity and return period.
/// @param periods of the members
Raster worst_degree(const FinishedMembers& members, const std::vector<std::optional<double>>& periods,
                    const GridSpec& grid, const DegreeMatrix& degrees);

/// Standard errors of probabilities over a map: as one cell's is known to a quarter only, those of alike probabilities
/// are taken together.
class ErrorSummary {
  public:
    void add(const Estimate& probability);
    void add(const ErrorSummary& other);
    /// The greatest root mean square of the standard errors in ten classes of the probability, where they are not 0.
    [[nodiscard]] double largest() const;
    /// The mean where they are not 0.
    [[nodiscard]] double mean() const;

  private:
    struct Class {
        double count = 0, sum = 0, squares = 0;
    };
    std::array<Class, 10> classes_{};
};

/// What the members together say of one quantity, cell by cell. Rasters are NaN where no member came, except the
/// probabilities, which are 0 there, and their margins.
struct QuantityMaps {
    std::vector<Raster> probability;  ///< of exceeding each threshold
    std::vector<Raster> margin;       ///< Estimate::margin
    /// The probabilities if each open run exceeds everything, everywhere, for material behind may push its front
    /// farther and higher than it had energy when it was cut; at least the probability itself. Empty: no run is open.
    std::vector<Raster> upper;
    ErrorSummary errors;           ///< of all thresholds
    std::vector<Raster> quantile;  ///< for each of k_study_quantiles; NaN where it is 0
    /// Likewise if each open run exceeds everything; none for a quantile beyond the weight of the runs that are not
    /// open. Empty: no run is open.
    std::vector<std::optional<Raster>> quantile_upper;
    Raster hits;  ///< number of members that came
};

/// Of depth and velocity. For arrival only the quantiles are made, without bounds, among the members that came; of
/// pressure and intensity only the probabilities.
QuantityMaps quantity_maps(const StudyRuns& runs, Quantity quantity, const GridSpec& grid,
                           const std::vector<double>& thresholds);

}  // namespace frana::app::study
