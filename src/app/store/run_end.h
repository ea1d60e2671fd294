// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/words/sentence.h"
#include "core/words/words.h"
#include "simulation/result.h"

namespace frana::app {

/// How a run ended. Maps, films, charts and the report say it in the same words.
struct RunEnd {
    std::string reason;  ///< English, as `describe` of a StopReason
    double seconds = 0;  ///< simulated
    double fastest = 0;  ///< greatest speed of the last step [m/s]
    /// Whether the front still moved when the end time was reached: final depth and run-out are not those of the
    /// deposit.
    bool is_cut_short = false;
    /// Whether only the deposit did: run-out and area had stopped changing.
    bool creeps = false;
};

RunEnd run_end(const RunResult& result);
/// The same from what summary.json says.
/// @param moving_fraction fraction of the volume that still moved
/// @param front_is_final as Settling::front_is_final; false: not known
RunEnd run_end(const std::string& reason, double seconds, double fastest, double moving_fraction, bool front_is_final);

/// "Run-out and area have stopped changing; the deposit still creeps at up to 0.3 m/s."
Sentence creeping_sentence(const RunEnd& end);

/// Returns "The run ended after 468 s: run-out, area and deposit have stopped changing; greatest speed then 1.2 m/s.",
/// in the language of the words.
std::string end_sentence(const RunEnd& end, const Words& words);

}  // namespace frana::app
