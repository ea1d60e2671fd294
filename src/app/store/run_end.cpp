// SPDX-License-Identifier: Apache-2.0
#include "app/store/run_end.h"

#include "app/text/number_text.h"
#include "simulation/run_summary.h"
#include "simulation/simulation.h"

namespace frana::app {
RunEnd run_end(const RunResult& result) {
    const double fastest = result.series.empty() ? 0 : result.series.back().max_speed;
    return run_end(describe(result.stop_reason), result.simulated_seconds, fastest, result.moving_fraction_limit,
                   result.settling && result.settling->front_is_final);
}

RunEnd run_end(const std::string& reason, double seconds, double fastest, double moving_fraction, bool front_is_final) {
    const MotionAtEnd motion =
        motion_at_end(reason == describe(StopReason::end_time), fastest, moving_fraction, front_is_final);
    return {reason, seconds, fastest, motion.front, motion.deposit};
}

Sentence creeping_sentence(const RunEnd& end) {
    return worded("Run-out and area have stopped changing; the deposit still creeps at up to {1} m/s.",
                  {numeral(number_text(end.fastest, 2))});
}

std::string end_sentence(const RunEnd& end, const Words& words) {
    return words(
        "The run ended after {1} s: {2}; greatest speed then {3} m/s.",
        {words.number(number_text(end.seconds, 3)), words(end.reason), words.number(number_text(end.fastest, 2))});
}

}  // namespace frana::app
