// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_errors.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/store/error_estimate.h"
#include "app/store/json_file.h"
#include "app/store/result_files.h"

namespace frana::app {

std::optional<ErrorEstimates::Estimate> ErrorEstimates::find(const std::string& key) const {
    const auto found = of.find(key);
    return found == of.end() ? std::nullopt : std::optional(found->second);
}

ErrorEstimates error_estimates(const SummaryFacts& facts, const std::string& result) {
    ErrorEstimates estimates;
    if (facts.accuracy) {
        for (const ValueEstimate& one : value_estimates(*facts.accuracy))
            if (!one.is_zero) estimates.of[one.value.key] = {one.error, one.convergence.trend == Trend::converging};
        return estimates;
    }
    if (!read_error_estimate(result, facts.spec)) return estimates;
    const auto file = std::filesystem::path(convergence_directory(result)) / k_convergence_file;
    const std::optional<Json> study = read_json_file(file.string());
    if (!study || !study->contains("statistics")) return estimates;
    estimates.from_study = true;
    for (const auto& [key, value] : study->at("statistics").items()) {
        const auto error = value_in<double>(value, "/estimated_error");
        const auto trend = value_in<std::string>(value, "/trend");
        if (error) estimates.of[key] = {*error, trend == describe(Trend::converging)};
    }
    return estimates;
}

}  // namespace frana::app
