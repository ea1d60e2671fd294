// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/store/run_troubles.h"
#include "study/member_record.h"

namespace frana::app {

/// A run of a study, as far as it may mislead a reader of the study's maps.
struct RunOfStudy {
    std::size_t member = 0;
    study::MemberEnd end;
    std::string failure;  ///< empty: it finished
    std::string table{};  ///< whose row it is, of a study with several tables of members
};

/// @param each_counts as Troubles::each_counts
Troubles troubles_of(const std::vector<RunOfStudy>& runs, bool each_counts);

/// One sentence for each kind of warning that the runs gave: of how many, and that of the run whose figure is the
/// worst.
/// @param known warnings of the study itself, which need not be told again
std::vector<Sentence> kinds_of_warnings(const std::vector<RunOfStudy>& runs, const std::vector<Sentence>& known);

/// The cells of a run in the columns study::k_end_columns.
std::vector<std::string> end_values(const study::MemberEnd& end);
/// The same values as attributes.
void add_end(const study::MemberEnd& end, std::map<std::string, double>& numbers,
             std::map<std::string, std::string>& texts);

}  // namespace frana::app
