// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/study/statistics/cell_statistics.h"
#include "app/study/study_spec.h"
#include "core/raster.h"

namespace frana::app::study {

/// A slope with how often it fails, and its runs.
struct Source {
    std::string name;
    FrequencySpec::Rate rate;
    FinishedMembers members;     ///< finished ones; weights with the sum 1
    std::size_t first = 0;       ///< place of the first of them among the finished members of all sources
    std::vector<double> shares;  ///< of all its runs, in their order: weights with the sum 1
    /// By how much the weight of each of the members changes with one standard deviation of the exponent of the law of
    /// volumes; the sum is 0. Empty: the law is certain.
    std::vector<double> sway{};
};

/// Events a year, and half of the interval of 95 %.
struct AnnualRate {
    double value = 0, margin = 0;
};

/// How often something happens that any of several sources may cause, each failing alone.
///
/// Of sources i with the rates r_i, of standard deviation s_i, and the probabilities p_i of margin m_i (MeanEstimate)
///
///     value = sum r_i p_i,    margin^2 = sum (r_i m_i)^2 + (1.96 s_i p_i)^2 + (s_i m_i)^2 + (1.96 r_i d_i)^2
///
/// over the sources of which a run came to the place, d_i the change of p_i with one standard deviation of the law of
/// volumes, to first order; for one rate and one law of all, known no better for one than for the other, the second and
/// the last term are squares of sums. Where no run came the margin is the greatest that a source alone has.
class AnnualRates {
  public:
    /// @param is_open of each run of all sources, in their order (StudyRuns)
    AnnualRates(std::vector<Source> sources, bool is_common_rate, std::vector<bool> is_open);
    AnnualRates(const AnnualRates&) = delete;  // estimates refer to its sources
    AnnualRates& operator=(const AnnualRates&) = delete;

    [[nodiscard]] const std::vector<Source>& sources() const noexcept { return sources_; }
    [[nodiscard]] FrequencySpec::Rate of_all() const;
    /// Events a year for which each finished member stands.
    [[nodiscard]] const std::vector<double>& of_members() const noexcept { return member_rates_; }
    [[nodiscard]] bool has_open() const noexcept { return open_rate_ > 0; }

    /// How often a value exceeds a threshold.
    [[nodiscard]] AnnualRate exceeded(Hits hits, double threshold) const;
    /// What a value from 0 to `most` sums up to in a year: a damage.
    /// @param values of all finished members
    [[nodiscard]] AnnualRate sum(std::span<const double> values, double most) const;
    /// The same if every open run has the most. @param runs values of all runs
    [[nodiscard]] double bound_of_sum(std::span<const double> runs, double most) const;
    /// The same as exceeded(), of each source.
    [[nodiscard]] std::vector<double> by_source(Hits hits, double threshold) const;
    /// How often it may, if every open run exceeds it.
    /// @param runs hits of all runs, not of the finished members alone
    [[nodiscard]] double bound(Hits runs, double threshold) const;
    /// The greatest value that is reached so often, 0 where what comes is rarer.
    [[nodiscard]] double value_at(Hits hits, double rate) const;
    /// The same of all runs if every open run exceeds it; infinite: it has no bound.
    [[nodiscard]] double bound_at(Hits runs, double rate) const;

  private:
    /// Calls visit(source, probability, its change with the law of volumes) for the sources of the hits.
    template <class Visit>
    void for_each_source(Hits hits, double threshold, const Visit& visit) const;
    /// Sums up what each(visit) tells of the sources, by visit(source, estimate, change).
    template <class Each>
    [[nodiscard]] AnnualRate sum_of(const Each& each) const;

    std::vector<Source> sources_;
    std::vector<MeanEstimate> estimates_;
    std::vector<std::size_t> source_of_;            ///< by finished member
    std::vector<double> member_rates_, run_rates_;  ///< events a year for which each stands
    std::vector<bool> is_open_;
    bool is_common_rate_;
    double nowhere_ = 0, open_rate_ = 0;
};

/// What an AnnualRates says of one quantity, cell by cell.
struct RateMaps {
    std::vector<Raster> rate, margin;  ///< of exceeding each threshold; 0 and a margin where no run came
    std::vector<Raster> upper;         ///< likewise, with open runs; empty: there are none
    struct Once {
        Raster value, low, high;  ///< NaN where no run came; high: also where it has no bound
    };
    std::vector<Once> once;  ///< what is exceeded once in each period, with its interval of 95 %
};

/// @param runs of the sources of `rates`, all together
RateMaps rate_maps(const AnnualRates& rates, const StudyRuns& runs, Quantity quantity, const GridSpec& grid,
                   const std::vector<double>& thresholds, const std::vector<double>& periods);

}  // namespace frana::app::study
