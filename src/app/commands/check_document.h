// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/commands/time_estimate.h"
#include "app/commands/writing_forecast.h"
#include "app/input/prepare.h"
#include "core/json.h"

namespace frana::app {

/// What `frana check SCENE --json` says: share/doc/scripts.md.
struct CheckedScene {
    const Prepared& prepared;
    const RunEstimate& expected;
    const std::optional<TimeEstimate>& trial;
    const WritingForecast& writing;
    std::int64_t memory_bytes;
    int threads;
    std::string result;  ///< folder
    const std::vector<Sentence>& warnings;
};
Json check_document(const CheckedScene& checked);

}  // namespace frana::app
