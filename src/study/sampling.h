// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "study/study_spec.h"

namespace frana::study {

/// The values of all members, decided once: member i depends on nothing but the study.
struct SampleTable {
    std::vector<std::string> keys;
    /// By member and key: the text of the value, as after `--set key=`.
    std::vector<std::vector<std::string>> values;
    /// The same as numbers for statistics: the value; of a choice or a field its index, or its place in [0, 1).
    std::vector<std::vector<double>> numbers;
    std::vector<bool> nominal;    ///< by key: the numbers have no order
    std::vector<double> weights;  ///< by member, greater than 0
    /// Saltelli's design (Saltelli et al. 2010): members i, i + n, i + 2n, ... form group i of n groups: rows of the
    /// matrices A, B, then A with one column of B each. 0: members are independent of each other.
    std::size_t groups = 0;

    [[nodiscard]] std::size_t size() const noexcept { return values.size(); }
    /// Returns "key=value" of a member.
    [[nodiscard]] std::vector<std::string> overrides(std::size_t member) const;
};

/// Draws the members of a study that is not sampled by a table; its problems were thrown before. Adds a problem for a
/// correlation that no distribution has.
SampleTable draw_samples(const StudySpec& study, const std::string& label, Problems& problems);

/// The same from a table with a row for each member: columns named as keys of the scene, and, if there is one,
/// `weight`; others are ignored. Adds a problem for a table without rows or keys, and for weights that are not
/// positive.
SampleTable samples_of_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                             const std::string& where, Problems& problems);

/// Returns the overrides of the central member: medians, likeliest choices, no error of the terrain.
std::vector<std::string> central_values(const StudySpec& study);

}  // namespace frana::study
