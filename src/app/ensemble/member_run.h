// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/ensemble/study_input.h"
#include "study/member_record.h"

namespace frana::app {

/// A member and its values; the study's table need not have it.
struct MemberTask {
    std::size_t member = 0;
    std::vector<std::string> overrides;  ///< "key=value"
    std::size_t study = 0;               ///< of several whose members one command runs, as a calibration's events
};

/// Returns the record of a member of this study: with its number and its values; none if there is no such record.
std::optional<study::MemberRecord> own_record(const StudyInput& input, const std::string& folder, std::size_t member);

/// Runs a member on one thread, as `frana run` computes it; several may run at once. A member that cannot be prepared
/// or ends early has failed, and its record says why. Returns none if `stops` said so before its end. Throws
/// Error(environment).
std::optional<study::MemberRecord> run_member(const StudyInput& input, const MemberTask& task,
                                              const std::function<bool()>& stops);

}  // namespace frana::app
