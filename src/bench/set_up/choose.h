// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.h"

namespace frana::bench {

/// Returns the cases with these names, in the given order; all if none is named. Throws Error(input) with every unknown
/// name.
template <class Case>
std::vector<Case> choose(std::vector<Case> all, const std::vector<std::string>& only, const std::string& bench) {
    if (only.empty()) return all;
    std::string names;
    for (const Case& one : all) names += (names.empty() ? "" : ", ") + one.name;
    std::vector<Case> some;
    Problems problems;
    for (const std::string& name : only) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Case& one) { return one.name == name; });
        if (found == all.end()) {
            problems.add({"the bench " + bench + " has no such case", "--case", name, names, "Give one of these"});
        } else {
            some.push_back(*found);
        }
    }
    problems.throw_if_any();
    return some;
}

}  // namespace frana::bench
