// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "app/input/used_file.h"
#include "app/publish/report.h"
#include "app/text/number_text.h"
#include "core/words/words.h"

namespace frana::app {

/// Numbers and units as a report shows them in its language.
class ReportNumbers {
  public:
    explicit ReportNumbers(const Words& words) : words_(words) {}

    [[nodiscard]] std::string operator()(double value, int digits = 4) const {
        return words_.number(number_text(value, digits));
    }
    template <class T>
    [[nodiscard]] std::string grouped(T value) const {
        return words_.number(app::grouped(value));
    }
    /// Of any size: in groups of digits from a thousand on.
    [[nodiscard]] std::string of_any_size(double value) const {
        return std::abs(value) < 1000 ? (*this)(value) : grouped(value);
    }
    /// Of a fraction, without the sign.
    [[nodiscard]] std::string percent(double fraction) const { return (*this)(100 * fraction, 2); }
    /// With so many digits, in groups where they do not reach to the decimals.
    [[nodiscard]] std::string rounded(double value, int digits = 4) const {
        return std::abs(value) < std::pow(10, digits) ? (*this)(value, digits) : grouped(value);
    }
    /// Returns "m³/s" for "m3/s", nothing for "-".
    [[nodiscard]] static std::string unit(const std::string& text) { return text == "-" ? "" : unit_sign(text); }

  private:
    const Words& words_;
};

// What a report says of an input file, in its language; `frana check` says the same in English.

/// Returns "Release thickness (average)": what the file is for, and how a raster came to the working grid.
std::string role_in(const UsedFile& file, const Words& words);
/// Returns "1 polygon\n63 071 m²".
std::string content_in(const UsedFile& file, const Words& words);
/// Returns the operation from the file's CRS to the working CRS with its accuracy; empty for a file that has no CRS.
std::string operation_in(const UsedFile& file, const Words& words);

// The tables of report.html after the answer.

/// High values of depth, speed and pressure; the separate flows, gauges and cross-sections, if there are any.
Document high_values_table(const ReportInput& input);
/// Elevations and slopes under the release and along the path.
Document ground_table(const SummaryFacts& facts, const Words& words);
/// The levels of numerics.accuracy with their cost, the estimate of each value, what is claimed.
Document accuracy_tables(const AccuracyRecord& record, const Words& words);
Document budget_table(const RunResult& result, const Words& words);
Document numerics_table(const ReportInput& input);
/// The physics and numerics that were computed.
/// Each area that failed: name, start, area, volume.
Document release_table(const RunResult& result, const Words& words);
/// By which part of a friction table the flow ran where, and where that comes from.
Document friction_table(const FrictionByPlace& friction, const std::vector<FrictionArea>& areas, const Words& words);
Document hazard_table(const SceneSpec& spec, const std::vector<HazardArea>& areas, const Words& words);
/// Returns every file read, with its CRS, the coordinate operation and its accuracy; the comments of a preset.
Document inputs_table(const Prepared& prepared, const Words& words);
/// Returns keys of the scene: value, unit, origin, and the value chosen by frana for keys not given.
/// @param only_used omits those that do not matter for the scene's numbers
Document parameters_table(const Prepared& prepared, bool only_used, const Words& words);

}  // namespace frana::app
