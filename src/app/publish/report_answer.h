// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/publish/html_page.h"
#include "app/publish/report.h"

namespace frana::app {

// The first page of a report.

/// Returns the origin of a key's value: "scene file", "preset bindo".
std::string origin_text(const SceneSpec& spec, const std::string& key, const Words& words);

/// Recordings of a gauge in a few numbers.
struct GaugeAnswer {
    std::string name;
    std::optional<double> arrival;  ///< first row deeper than numerics.minimum-depth [s]; none: not reached
    double depth = 0, speed = 0;    ///< greatest [m], [m/s]
};
std::vector<GaugeAnswer> gauge_answers(const ReportInput& input);

/// What a reader who signs has before him, in English: whether the friction is a starting value or one of the scene's
/// own.
std::string what_one_run_is(const SceneSpec& spec);
/// How far, how deep, how fast, how sure, and in a sentence what the map is.
Document answer(const ReportInput& input);
/// The same for a terminal, a line each.
std::string answer_lines(const ReportInput& input);
/// Release and motion; exposure, comparison, warnings.
Document scenario(const ReportInput& input);
/// Further values with their estimated errors.
Document answer_tables(const ReportInput& input);

/// Returns "± 12", a word if the estimate does not converge, or the words for none.
std::string error_text(const ErrorEstimates& errors, const std::string& key, const Words& words);

}  // namespace frana::app
