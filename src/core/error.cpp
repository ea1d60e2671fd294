// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"

#include <utility>

#include "core/utf8.h"

namespace frana {
namespace {

constexpr std::size_t k_longest_value = 1000;  // characters

std::string join(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        if (!text.empty()) text += '\n';
        text += describe(problem);
    }
    return text;
}

}  // namespace

std::string describe(const Problem& problem) {
    std::string text = problem.where.empty() ? problem.what : problem.where + ": " + problem.what;
    if (!problem.value.empty() || !problem.limit.empty()) {
        text += " (";
        if (!problem.value.empty()) text += "value " + elided(problem.value, k_longest_value);
        if (!problem.value.empty() && !problem.limit.empty()) text += "; ";
        if (!problem.limit.empty()) text += "allowed " + problem.limit;
        text += ')';
    }
    if (!problem.remedy.empty()) text += ". " + problem.remedy;
    // File names may contain terminal control sequences.
    return one_line(text);
}

Error::Error(ErrorKind kind, std::vector<Problem> problems)
    : std::runtime_error(join(problems)), kind_(kind), problems_(std::move(problems)) {}

Error::Error(ErrorKind kind, Problem problem) : Error(kind, std::vector<Problem>{std::move(problem)}) {}

void Problems::add(Problem problem) {
    list_.push_back(std::move(problem));
}

void Problems::add(const Error& error) {
    if (error.kind() != ErrorKind::input) throw error;
    list_.insert(list_.end(), error.problems().begin(), error.problems().end());
}

void Problems::throw_if_any() const {
    if (!list_.empty()) throw Error(ErrorKind::input, list_);
}

}  // namespace frana
