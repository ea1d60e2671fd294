// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/raster.h"
#include "study/member_record.h"

namespace frana::study {

/// The finished members of a study, in the order of their numbers, as files.
struct FinishedMembers {
    std::vector<std::string> records;  ///< their files
    std::vector<double> weights;       ///< as many; their sum is 1
    std::vector<std::size_t> groups;   ///< of Saltelli's design: the group of each; empty: all are independent

    [[nodiscard]] std::size_t size() const noexcept { return records.size(); }
    /// Number of independent members with equal weights whose mean is as certain: (sum w)^2 / sum w^2.
    [[nodiscard]] double effective_size() const;
};

/// Calls visit(cell, values) for every cell of a grid that any member reached, in order of cells; values has one number
/// for each member, 0 (arrival: infinity) where it did not come. Reads the records window by window: memory is bounded
/// by a budget, whatever the number of members and cells. Throws Error(environment) for a record that cannot be read.
void for_each_reached_cell(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                           const std::function<void(std::size_t cell, std::span<const float> values)>& visit);

/// Returns the window that contains all cells reached by any member, in rows and columns of a grid; it may reach beyond
/// that grid, if members had others. Empty if there is none.
CellWindow reached_window(const FinishedMembers& members, const GridSpec& grid);

/// Standard error of a probability p = sum w_i I_i from the indicators I_i of an event in each member: sqrt(p (1 - p) /
/// n_effective) for independent members; with groups sqrt(var(group means) / groups). 0 where all are alike.
class ProbabilityError {
  public:
    explicit ProbabilityError(const FinishedMembers& members);
    [[nodiscard]] double of(double probability, std::span<const float> values, double threshold) const;

  private:
    const FinishedMembers& members_;
    double effective_size_;
    std::size_t group_count_ = 0;
};

/// Probability that values exceed a threshold: the sum of the weights of those that do.
double exceedance(std::span<const float> values, const std::vector<double>& weights, double threshold);

/// Least value v with at least the fraction q of all weight at values <= v. `order` is scratch.
double weighted_quantile(std::span<const float> values, const std::vector<double>& weights, double q,
                         std::vector<std::size_t>& order);

}  // namespace frana::study
