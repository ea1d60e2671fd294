// SPDX-License-Identifier: Apache-2.0
#include "app/store/run_end.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/store/json_file.h"
#include "app/text/number_text.h"
#include "simulation/run_summary.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

constexpr double k_many = 0.05;  // fraction of the runs from which a study's first line tells

Sentence count(std::size_t number) {
    return numeral(std::to_string(number));
}

Sentence percent(double fraction) {
    return numeral(number_text(100 * fraction, 2));
}

}  // namespace

bool Troubles::are_first() const noexcept {
    if (on_levels || each_counts) return unfinished() > 0;
    return static_cast<double>(unfinished()) > k_many * static_cast<double>(runs);
}

Sentence headline(const Troubles& t) {
    std::vector<Sentence> parts;
    if (t.cut > 0)
        parts.push_back(worded("{1} of {2} runs were cut while they still moved (up to {3} % of the volume)",
                               {count(t.cut), count(t.runs), percent(t.most_moving)}));
    if (t.left > 0)
        parts.push_back(worded("{1} of {2} runs left the computed ground (up to {3} % of the volume)",
                               {count(t.left), count(t.runs), percent(t.most_left)}));
    if (t.held > 0)
        parts.push_back(worded("{1} of {2} runs were held by cells without elevation", {count(t.held), count(t.runs)}));
    if (t.failed > 0) parts.push_back(worded("{1} of {2} runs failed", {count(t.failed), count(t.runs)}));
    // A sum of differences: what coarser runs of a pair did not reach raises it.
    if (t.on_levels)
        return worded("Extent, run-out and probabilities may be too small or too large: {1}", {listed(parts)});
    return worded("Extent, run-out and probabilities are lower bounds: {1}", {listed(parts)});
}

Json json_of(const Troubles& t) {
    return {{"all", t.runs},
            {"cut", t.cut},
            {"left_ground", t.left},
            {"held_by_no_data", t.held},
            {"failed", t.failed},
            {"warned", t.warned},
            {"flew", t.flew},
            {"lower_bounds", t.open},
            {"each_counts", t.each_counts},
            {"on_levels", t.on_levels},
            {"greatest_moving_fraction", t.most_moving},
            {"greatest_left_domain_fraction", t.most_left}};
}

std::optional<Troubles> troubles_in(const Json& summary) {
    const auto whole = [&](const char* key) {
        return static_cast<std::size_t>(
            value_in<std::int64_t>(summary, std::string("/run_troubles/") + key).value_or(0));
    };
    if (!value_in<std::int64_t>(summary, "/run_troubles/all")) return std::nullopt;
    Troubles t;
    t.runs = whole("all");
    t.cut = whole("cut");
    t.left = whole("left_ground");
    t.failed = whole("failed");
    t.warned = whole("warned");
    t.open = whole("lower_bounds");
    t.held = whole("held_by_no_data");
    t.flew = whole("flew");
    t.most_moving = value_in<double>(summary, "/run_troubles/greatest_moving_fraction").value_or(0);
    t.most_left = value_in<double>(summary, "/run_troubles/greatest_left_domain_fraction").value_or(0);
    t.each_counts = value_in<bool>(summary, "/run_troubles/each_counts").value_or(false);
    t.on_levels = value_in<bool>(summary, "/run_troubles/on_levels").value_or(false);
    return t;
}

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
