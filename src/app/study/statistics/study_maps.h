// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "app/study/member_record.h"
#include "app/study/statistics/cell_statistics.h"
#include "core/raster.h"

namespace frana::app::study {

/// A member that counts in a union.
struct UnionMember {
    std::size_t number = 0;
    RecordPlace record;
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
    ErrorSummary errors;              ///< of all thresholds
    std::vector<Raster> quantile;     ///< for each of k_study_quantiles; NaN where it is 0
    Raster hits;                      ///< number of members that came
};

/// Of depth and velocity. For arrival only the quantiles are made, among the members that came; of pressure and
/// intensity only the probabilities.
QuantityMaps quantity_maps(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                           const std::vector<double>& thresholds);

/// Returns the probabilities if each open run exceeds everything, everywhere, for material behind may push its front
/// farther and higher than it had energy when it was cut; they are at least the probability itself.
/// @param probability of each threshold, of the runs that count
std::vector<Raster> probability_bounds(const std::vector<Raster>& probability, const OpenRuns& runs, Quantity quantity,
                                       const std::vector<double>& thresholds, const GridSpec& grid);

/// Returns an upper bound of each of k_study_quantiles of depth or velocity. None for a quantile beyond the weight of
/// the runs that are not open.
std::vector<std::optional<Raster>> quantile_bounds(const OpenRuns& runs, Quantity quantity, const GridSpec& grid);

/// The standard errors alone, of one quantity and all thresholds, without keeping maps.
ErrorSummary error_of(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                      const std::vector<double>& thresholds);

}  // namespace frana::app::study
