// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ranks/job.h"

namespace frana::app {

/// A rank other than 0 of a study: reads it, runs the members that rank 0 gives it, each on one thread, and sends their
/// records back. Writes neither files nor messages: rank 0 is told of problems. Returns once rank 0 has nothing more to
/// do.
void work_for_rank_0(const ranks::Job& job, const std::string& study, int threads);

}  // namespace frana::app
