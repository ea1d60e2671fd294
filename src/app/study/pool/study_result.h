// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/result_numbers.h"
#include "app/study/member_record.h"
#include "app/study/plan/study_input.h"
#include "app/study/statistics/annual_rates.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/study/statistics/sensitivity.h"
#include "app/study/statistics/study_maps.h"

namespace frana::app::study {

/// @param each_counts as Troubles::each_counts
Troubles troubles_of(const std::vector<MemberRecord>& runs, bool each_counts);

/// One sentence for each kind of warning that the runs gave: of how many, and that of the run whose figure is the
/// worst.
/// @param known warnings of the study itself, which need not be told again
/// @param table that has the members' rows, of a study with several; empty: one
Warnings kinds_of_warnings(const std::vector<MemberRecord>& runs, const Warnings& known, const std::string& table = {});

/// Number of members without a result.
std::size_t failed_of(const std::vector<MemberRecord>& runs);

/// Sensitivities of one figure, by key.
struct FigureSensitivity {
    Figure figure;  ///< its texts
    std::vector<KeySensitivity> keys;
    double q2 = 0;  ///< Chaos::q2
};

/// The members that ran, in the order of their numbers; `finished_at` and `all` are in the same order.
struct StudyResult : StudyRuns {
    std::vector<MemberRecord> members;
    /// Members of whole groups of Morris' design, or all finished ones: those that sensitivities use. `groups`: rows of
    /// the first matrix among them, 0 if the members are independent.
    FinishedMembers design;
    std::vector<std::size_t> design_at;
    DesignPoints points;
    std::size_t groups = 0;
    GridSpec grid;                             ///< of all maps
    std::shared_ptr<const AnnualRates> rates;  ///< null: without a frequency

    [[nodiscard]] std::size_t failed() const { return failed_of(members); }
    /// Weights of all members: 0 of one that failed.
    [[nodiscard]] std::vector<double> weights() const;
    /// Whether the members that sensitivities use count alike: only then are there any.
    [[nodiscard]] bool equal_weights() const;
    /// Returns a figure of the finished members, in their order.
    [[nodiscard]] std::vector<double> figure(std::size_t index) const;
    /// Returns an upper bound of a quantile of a figure, if the open runs exceed everything; infinite: it has none.
    /// Without such runs it is the quantile itself.
    [[nodiscard]] double quantile_bound(std::size_t index, double q) const;
    /// Returns the mean of a figure.
    [[nodiscard]] Estimate mean_of(std::size_t index) const;
    /// Returns a quantile of a figure with its interval of 95 %: the quantiles at q -+ the margin of the probability
    /// that it is exceeded (Woodruff 1952, J. Am. Stat. Assoc. 47, 635); infinite where the members do not reach so
    /// far.
    [[nodiscard]] Interval quantile_of(std::size_t index, double q) const;
    /// Texts of the figures; empty if no member finished.
    [[nodiscard]] const std::vector<Figure>& figures() const;
};

/// Share of failed members above which the study itself has failed.
inline constexpr double k_most_failed = 0.05;

/// Reads the records of the first `count` members. Throws Error(environment) for one that cannot be read.
StudyResult read_study_result(const StudyInput& input, const std::string& folder, std::size_t count);

/// What a study by importance sampling was made for.
struct RarePlace {
    RareEvent event;
    Estimate probability;
    double high = 0;       ///< of its interval of 95 %, where runs whose full reach is not known count as hits
    std::size_t hits = 0;  ///< members in which it happened
};
/// None of other studies.
std::optional<RarePlace> rare_place_of(const StudyInput& input, const StudyResult& result);

/// Returns the standard error by which study.until decides, of the first members.
double largest_error(const StudyInput& input, const StudyResult& result);

/// What stands for a field of error in place of a method.
inline constexpr const char* k_not_explained = "not explained";
/// Returns the sensitivities of all figures that vary.
std::vector<FigureSensitivity> sensitivities(const StudyInput& input, const StudyResult& result);
/// Whether a key is a field of error (terrain.error), of which no polynomial of the keys knows.
bool is_field_of_error(const StudyInput& input, std::size_t key);

}  // namespace frana::app::study
