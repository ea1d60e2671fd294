// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/publish/summary.h"

namespace frana::app {

/// Estimated errors of a run's values due to the size of the cells.
struct ErrorEstimates {
    struct Estimate {
        double error = 0;  ///< in the unit of the value
        bool converging = false;
    };
    std::map<std::string, Estimate> of;  ///< by the value's key in summary.json, or as RunValue::key
    bool from_study = false;             ///< of `frana converge`; else of numerics.accuracy

    /// Returns none without an estimate.
    [[nodiscard]] std::optional<Estimate> find(const std::string& key) const;
};

/// Returns those of numerics.accuracy, else those that `frana converge` left beside the result for exactly this scene.
/// @param result the folder that the result will have
ErrorEstimates error_estimates(const SummaryFacts& facts, const std::string& result);

}  // namespace frana::app
