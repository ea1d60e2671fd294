// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.h"

namespace frana {

inline ::testing::AssertionResult no_problem(const std::vector<Problem>& problems) {
    auto result = problems.empty() ? ::testing::AssertionSuccess() : ::testing::AssertionFailure();
    for (const Problem& problem : problems) result << describe(problem) << '\n';
    return result;
}

/// Whether one of some problems is at a place (the end of `where`: a key, a file), has a value and a limit. Sentences
/// are for people and may change. An empty text is any.
/// @tparam AnyProblem the engine's, or that of the library's header
template <class AnyProblem>
::testing::AssertionResult has_problem(const std::vector<AnyProblem>& problems, const std::string& where,
                                       const std::string& value = "", const std::string& limit = "") {
    auto failure = ::testing::AssertionFailure();
    failure << "none at \"" << where << "\" of \"" << value << "\" allowed \"" << limit << "\" among\n";
    for (const AnyProblem& problem : problems) {
        const std::string& place = problem.where;
        if (place.ends_with(where) && (value.empty() || problem.value == value) &&
            (limit.empty() || problem.limit == limit))
            return ::testing::AssertionSuccess();
        failure << '"' << place << "\" of \"" << problem.value << "\" allowed \"" << problem.limit
                << "\": " << problem.what << ". " << problem.remedy << '\n';
    }
    return failure;
}

}  // namespace frana
