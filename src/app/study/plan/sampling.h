// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/study/study_spec.h"
#include "core/error.h"
#include "params/keys/parameter.h"

namespace frana::app::study {

/// Returns why a key of the scene cannot vary in a study; none: it can. Members must have the same cells and the same
/// outputs, otherwise their maps could not be combined.
std::optional<ValueProblem> refusal_to_vary(const Parameter& key);

/// Returns why a key cannot have a distribution: no number, a support beyond its range, a value it does not accept.
std::optional<ValueProblem> refusal_of(const Parameter& key, const Distribution& distribution);

/// A column of a user's table, and what it is taken for.
struct TableColumn {
    enum class Use { key, weight, result };
    std::string name;
    Use use = Use::key;  ///< result: a value that an earlier study wrote beside its keys, not used
};

/// The values of all members, decided once: member i depends on nothing but the study.
struct SampleTable {
    std::vector<std::string> keys;
    /// By member and key: the text of the value, as after `--set key=`.
    std::vector<std::vector<std::string>> values;
    /// The same as numbers for statistics: the value; of a choice or a field its index, or its place in [0, 1).
    std::vector<std::vector<double>> numbers;
    std::vector<bool> nominal;         ///< by key: the numbers have no order
    std::vector<double> weights;       ///< by member, greater than 0
    std::vector<TableColumn> columns;  ///< of the table that was read; empty: drawn
    Places places;                     ///< of the values in their distributions; none: of a table
    /// Members i, i + n, i + 2n, ... form group i of n groups of Morris' design: a point, then each key alone moved by
    /// half of its distribution. 0: members are independent of each other.
    std::size_t groups = 0;
    bool is_replicated = false;  ///< SamplingMethod::replicated
    std::size_t draws = 1;       ///< of a region: members i n, ... (i + 1) n - 1 are the n draws of slope i
    /// Of importance sampling, by member: k_replicates times its round, and the part of the round. Empty: one round.
    std::vector<std::size_t> parts;

    [[nodiscard]] std::size_t size() const noexcept { return values.size(); }
    /// The part of a replicated design that a member is from.
    [[nodiscard]] std::size_t replicate_of(std::size_t member) const noexcept {
        if (!parts.empty()) return parts[member];
        const std::size_t group = groups > 0 ? groups : draws;
        return (group > 1 ? member % group : member) % k_replicates;
    }
    /// Returns "key=value" of a member.
    [[nodiscard]] std::vector<std::string> overrides(std::size_t member) const;
};

/// Returns one line for each value: two tables with the same text have the same members, if their files have the same
/// content. Files are named without their folders, and numbered in the order of the members: a study can be moved.
std::string values_text(const SampleTable& table);
/// The values of one member, "key=value" line by line, files without their folders.
std::string values_text(const std::vector<std::string>& overrides);

/// Draws the members of a study that is not sampled by a table, of importance sampling those of its first round; its
/// problems were thrown before. Adds a problem for a correlation that no distribution has.
SampleTable draw_samples(const StudySpec& study, const std::string& label, Problems& problems);

/// The two steps of that: places that are independent in each key, and the members there, with the study's
/// correlations.
/// @param is_replicated as independent_places()
Places draw_places(const StudySpec& study, bool is_replicated = false);
SampleTable samples_at(const StudySpec& study, const Places& independent, const std::string& label, Problems& problems);

/// The same from a table with a row for each member: columns named as keys of the scene, `weight`, and those that
/// members.csv or posterior.csv contain beside these, which are not used. Rows of blanks are no members. Adds a problem
/// for any other column, for a key that cannot vary, for a table without rows or keys, and for weights that are not 0
/// or between k_least_table_weight and k_most_table_weight.
inline constexpr double k_least_table_weight = 1e-100,
                        k_most_table_weight = 1e100;  // their squares and sums stay finite
SampleTable samples_of_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                             const Place& where, Problems& problems);

/// The option of a choice that has a place.
double option_at(const Distribution& choice, double place);
/// Returns the numbers of one key at places in (0, 1), as SampleTable has them.
std::vector<double> numbers_at(const Distribution& distribution, std::vector<double> places);

/// Returns the overrides of the central member: medians, likeliest choices, no error of the terrain.
std::vector<std::string> central_values(const StudySpec& study);

/// The forms that a distribution may have, for messages.
inline constexpr const char* k_distributions =
    "uniform(a, b), log-uniform(a, b), normal(mean, sd), normal(mean, sd, low, high), log-normal(mean, sd), "
    "log-normal(mean, sd, low, high), triangular(a, likeliest, b), pert(a, likeliest, b), pareto(least, exponent, "
    "greatest), table(number: weight, ...), choice(value: weight, ...), gaussian-field(sd, range)";

/// Reads "uniform(0.1, 0.3)", "choice(a.shp: 0.7, \"b, c.shp\": 0.3)": a value with a comma is in quotes; without
/// weights all values are alike.
std::variant<Distribution, ValueProblem> distribution_from_text(const std::string& text);

/// Least and greatest value; infinite where there is none. Not for choices and fields.
struct Support {
    double low = 0, high = 0;
};
Support support_of(const Distribution& distribution);

}  // namespace frana::app::study
