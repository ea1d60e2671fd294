// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "app/study/member_record.h"
#include "app/study/statistics/cell_store.h"
#include "app/study/study_spec.h"
#include "core/grid_spec.h"
#include "core/raster.h"

namespace frana::app::study {

/// Number of members with equal weights that would tell as much: (sum w)^2 / sum w^2; 0 without weight.
double effective_count(const std::vector<double>& weights);

/// The finished members of a study, in the order of their numbers.
struct FinishedMembers {
    std::vector<RecordPlace> records;
    std::vector<double> weights;          ///< as many; their sum is 1
    std::vector<std::size_t> replicates;  ///< SampleTable::replicate_of each; empty: all are independent
    /// Their records' values by cells, with others; `columns`: their places in it. Null: made whenever it is needed.
    std::shared_ptr<CellStore> store{};
    std::vector<std::size_t> columns{};

    [[nodiscard]] std::size_t size() const noexcept { return records.size(); }
    /// Number of independent members with equal weights whose mean is as certain.
    [[nodiscard]] double effective_size() const { return effective_count(weights); }
};

/// The runs of a study: those that finished, whose values count, and all, for upper bounds: of open ones nobody knows
/// where they would have come.
struct StudyRuns {
    FinishedMembers finished;              ///< whose maps are used
    std::vector<std::size_t> finished_at;  ///< their places among all runs
    FinishedMembers all;                   ///< weights over all of them, no replicates
    std::vector<bool> is_open;             ///< of each of all: it was cut, held, left the ground or failed

    [[nodiscard]] bool any_open() const { return std::find(is_open.begin(), is_open.end(), true) != is_open.end(); }
    /// Values of all runs if every open one has the most that there is.
    template <class Value>
    [[nodiscard]] std::vector<Value> at_most(std::span<const Value> values,
                                             Value most = std::numeric_limits<Value>::infinity()) const {
        std::vector<Value> bounded(values.begin(), values.end());
        for (std::size_t run = 0; run < bounded.size(); ++run)
            if (is_open[run]) bounded[run] = most;
        return bounded;
    }
};

/// Returns the probability that a value exceeds a threshold if every open run exceeds it.
/// @param values of all runs
double upper_bound(const StudyRuns& runs, std::span<const float> values, double threshold);

/// What a value is of a member that did not come: 0, no arrival.
inline float nothing_of(Quantity quantity) {
    return quantity == Quantity::arrival ? std::numeric_limits<float>::infinity() : 0.0F;
}

/// Values of members, or runs, that came to a place, in order of their places among all.
using Hits = std::span<const CellStore::Value>;

/// Calls visit(cell, hits) for every cell of a grid that any member reached, in order of cells. Memory is bounded by a
/// budget, whatever the number of members and cells, and each record is read once (CellStore). Throws
/// Error(environment) for a record that cannot be read.
void for_each_hit_cell(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                       const std::function<void(std::size_t cell, Hits hits)>& visit);
/// The same for every cell that any run reached, with the hits of finished members and of all runs.
void for_each_hit_cell(const StudyRuns& runs, Quantity quantity, const GridSpec& grid,
                       const std::function<void(std::size_t cell, Hits finished, Hits all)>& visit);

/// Returns the window that contains both; one without rows is none.
CellWindow window_of_both(const CellWindow& a, const CellWindow& b);

/// Returns the window that contains all cells reached by any member, in rows and columns of a grid; it may reach beyond
/// that grid, if members had others. Empty if there is none.
CellWindow reached_window(const FinishedMembers& members, const GridSpec& grid);

/// 97.5 % quantile of the normal distribution: of intervals of 95 %.
inline constexpr double k_normal = 1.959963984540054;
/// Likewise of Student's t distribution with 1, 2 ... degrees of freedom.
inline constexpr double k_student[] = {12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646};
static_assert(std::size(k_student) + 1 == k_replicates);

/// A mean over the members and how far it may be off because their number is finite.
struct Estimate {
    double value = 0;
    double error = 0;   ///< standard error; 0 where all members, or all replicates, are alike
    double margin = 0;  ///< value +- margin is the interval of 95 %

    /// The ends of the interval of a probability.
    [[nodiscard]] double low() const noexcept { return std::max(0.0, value - margin); }
    [[nodiscard]] double high() const noexcept { return std::min(1.0, value + margin); }
};

/// Estimates means m = sum w_i v_i, and the probability p that a value exceeds a threshold: the mean of its indicators.
/// Standard error of independent members: sqrt(sum w_i (v_i - m)^2 / n_effective), for p sqrt(p (1 - p) / n_effective);
/// of replicates with the weights W_r and the means m_r: sqrt(R / (R - 1) sum W_r^2 (m_r - m)^2). In rounds that is
/// summed over them, of each without the mean of its W_r (m_r - m), as places near an event say nothing of the others.
/// Margin: with the quantile of the normal distribution, of replicates that of Student's t with R - 1 degrees of
/// freedom; of independent members p is moved to (n p + 2) / (n + 4) for it, since an error estimated from few is too
/// small (Agresti & Coull 1998, American Statistician 52, 119): where p is small, that adds twice the square of what a
/// hit weighs to the variance. So it does in rounds. A probability whose standard error is 0 is not certain: with
/// p = 3 / n none of n members exceeds in 5 % of studies, and with 3 / R one of R replicates, each of n / R members,
/// counts one more. Where members have weights, 1 / n is the greatest: nowhere are they drawn more thinly. In one round
/// of such members replicates may scatter by their weights alone: with as many hits in each, 1 / n is the heaviest of
/// the hits, or of the misses where these are rarer, and 3 / n the least margin.
class MeanEstimate {
  public:
    explicit MeanEstimate(const FinishedMembers& members);
    [[nodiscard]] Estimate probability(std::span<const float> values, double threshold) const;
    [[nodiscard]] Estimate mean(std::span<const double> values) const;
    /// The same of values from 0 to `most`, of which no mean is certain: its margin is, as of a probability, never 0.
    [[nodiscard]] Estimate mean(std::span<const double> values, double most) const;

  private:
    template <class ValueOf>
    [[nodiscard]] Estimate of(const ValueOf& value) const;

    /// By how much a hit, or a miss, whichever is rarer, adds to the variance that it may be known too badly.
    template <class Exceeds>
    [[nodiscard]] double of_few(const Exceeds& exceeds) const;

    /// The least margin where replicates of members with weights have as many hits each; 0 elsewhere.
    template <class Exceeds>
    [[nodiscard]] double of_alike(const Exceeds& exceeds) const;

    const FinishedMembers& members_;
    double effective_size_;
    bool is_weighted_ = false;
    double greatest_weight_ = 0;        ///< of all weight
    std::vector<std::size_t> parts_{};  ///< by round: replicates that have members; empty: all members are independent
};

/// Of the sum of weights: what additions leave.
inline constexpr double k_weight_rounding = 1e-12;

/// Least value v with at least the fraction q of all weight at values <= v. `order` is scratch.
double weighted_quantile(std::span<const float> values, const std::vector<double>& weights, double q,
                         std::vector<std::size_t>& order);

/// The same for a figure of the members; the weights have a sum of 1.
double weighted_quantile(const std::vector<double>& values, const std::vector<double>& weights, double q);

/// Pearson's correlation of values with weights; NaN if one of the two does not vary.
double correlation(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& weights);

/// Values of the finished members and of all runs.
using RunValues = std::function<void(std::size_t at, std::span<const float> finished, std::span<const float> all)>;
/// Calls visit(feature, finished, all) for every feature, in order, with one number for each member or run: the
/// greatest value in any of the feature's cells (arrival: the least), nothing_of() where it reached none.
/// Memory is bounded by a budget, whatever the number of members and features. Throws Error(environment) for a record
/// that cannot be read.
/// @param cells of each feature, on the grid
void for_each_feature(const StudyRuns& runs, Quantity quantity, const GridSpec& grid,
                      const std::vector<std::vector<std::size_t>>& cells, const RunValues& visit);

}  // namespace frana::app::study
