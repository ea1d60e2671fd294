// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/error.h"
#include "facade/frana.h"

namespace frana::facade {

inline std::vector<Problem> problems_of(const std::vector<frana::Problem>& problems) {
    std::vector<Problem> list;
    for (const frana::Problem& p : problems) list.push_back({p.what, p.where, p.value, p.limit, p.remedy});
    return list;
}

/// Calls what may throw the engine's errors; its users get those of the interface.
template <class Work>
auto guarded(const Work& work) {
    try {
        return work();
    } catch (const frana::Error& error) {
        throw Error(error.what(), problems_of(error.problems()));
    }
}

[[noreturn]] inline void refuse(const frana::Problem& problem) {
    throw Error(describe(problem), problems_of({problem}));
}

}  // namespace frana::facade
