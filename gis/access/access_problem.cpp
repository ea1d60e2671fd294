// SPDX-License-Identifier: Apache-2.0
#include "gis/access/access_problem.h"

#include <mutex>
#include <utility>

namespace frana::gis {
namespace {

// Libraries also read on their own threads.
std::mutex guard;
std::optional<AccessProblem> first_problem;

}  // namespace

void note_access_problem(AccessProblem problem) {
    const std::lock_guard lock(guard);
    if (!first_problem) first_problem = std::move(problem);
}

std::optional<AccessProblem> pop_access_problem() {
    const std::lock_guard lock(guard);
    return std::exchange(first_problem, std::nullopt);
}

}  // namespace frana::gis
