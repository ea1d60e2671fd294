// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/scheme_check.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/process/terminal.h"
#include "app/study/pool/member_runs.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/text/number_text.h"

namespace frana::app::study {
namespace {

constexpr const char* k_scheme_key = "numerics.scheme";

/// The members with weight nearest to the median run-out and farthest, of several the first.
std::vector<SchemeCheck::Member> chosen(const std::vector<MemberRecord>& all, const std::vector<double>& all_weights) {
    std::vector<const MemberRecord*> finished;
    std::vector<double> run_outs, weights;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!(all_weights[i] > 0)) continue;
        finished.push_back(&all[i]);
        run_outs.push_back(value_of(all[i].figures, k_run_out_key));
        weights.push_back(all_weights[i]);
    }
    if (finished.empty()) return {};
    const double middle = weighted_quantile(run_outs, weights, 0.5);
    std::size_t median = 0, farthest = 0;
    for (std::size_t i = 0; i < run_outs.size(); ++i) {
        if (std::abs(run_outs[i] - middle) < std::abs(run_outs[median] - middle)) median = i;
        if (run_outs[i] > run_outs[farthest]) farthest = i;
    }
    std::vector<SchemeCheck::Member> members;
    for (const std::size_t i : {median, farthest}) {
        if (!members.empty() && median == farthest) break;
        SchemeCheck::Member member;
        member.member = finished[i]->member;
        member.is_farthest = !members.empty();
        for (std::size_t f = 0; f < std::size(k_checked_figures); ++f)
            member.own[f] = value_of(finished[i]->figures, k_checked_figures[f]);
        members.push_back(member);
    }
    return members;
}

/// Runs them again. Those that a signal stops stay without figures.
void run_again(const StudyInput& input, const std::vector<MemberTask>& tasks, int threads,
               std::vector<SchemeCheck::Member>& members) {
    for (SchemeCheck::Member& one : members) one.failure = "stopped by a signal";
    MemberThreads runs({&input}, std::min(threads, static_cast<int>(tasks.size())));
    for (const MemberTask& task : tasks) runs.add(task);
    for (std::size_t left = tasks.size(); left > 0 && stop_signal() == 0;) {
        constexpr int k_signal_wait = 100;  // [ms]
        runs.wait(k_signal_wait);
        if (const std::exception_ptr problem = runs.take_problem()) std::rethrow_exception(problem);
        const auto bytes = runs.take_record();
        if (!bytes) continue;
        --left;
        const auto record = record_from(bytes->bytes);
        for (SchemeCheck::Member& one : members) {
            if (one.member != bytes->member) continue;
            one.failure = record->failure;
            for (std::size_t f = 0; f < std::size(k_checked_figures); ++f)
                one.other[f] = value_of(record->figures, k_checked_figures[f]);
        }
    }
}

}  // namespace

std::optional<Scheme> common_scheme(const StudyInput& input) {
    const auto& keys = input.table.keys;
    const bool varies = std::find(keys.begin(), keys.end(), k_scheme_key) != keys.end();
    if (varies || input.base.scene.structured) return std::nullopt;
    return input.base.spec.numerics.scheme;
}

std::optional<SchemeCheck> check_scheme(const StudyInput& input, const std::vector<MemberRecord>& all,
                                        const std::vector<double>& weights, int threads) {
    const std::optional<Scheme> scheme = common_scheme(input);
    std::vector<SchemeCheck::Member> members = chosen(all, weights);
    if (!scheme || members.empty()) return std::nullopt;
    const Scheme other = *scheme == Scheme::finite_volume ? Scheme::standard : Scheme::finite_volume;
    SchemeCheck check{word_of(*scheme, k_schemes), word_of(other, k_schemes), "", {}};
    std::vector<MemberTask> tasks;
    for (const SchemeCheck::Member& one : members) {
        MemberTask& task = tasks.emplace_back(MemberTask{one.member, input.table.overrides(one.member), 0});
        task.overrides.push_back(k_scheme_key + ("=" + check.other));
        const SceneReading reading = input.scene_with(task.overrides);
        if (reading.problems.empty()) continue;
        const Problem& problem = reading.problems.list().front();
        check.refusal = problem.where + " " + problem.what;
        return check;
    }
    run_again(input, tasks, threads, members);
    check.members = std::move(members);
    return check;
}

namespace {

Sentence signed_percent(double fraction) {
    if (!std::isfinite(fraction)) return Sentence("-");
    const std::string text = number_text(100 * fraction, 2);
    return numeral((fraction > 0 ? "+" : "") + text);
}

}  // namespace

std::optional<Sentence> warning_of(const SchemeCheck& check, bool is_region) {
    constexpr double k_alike = 0.1;  // of run-out or area
    double most = 0;
    for (const SchemeCheck::Member& one : check.members)
        if (one.failure.empty())
            for (const std::size_t figure : {0, 1}) most = std::fmax(most, std::abs(one.difference(figure)));
    if (check.scheme != word_of(Scheme::finite_volume, k_schemes) || most <= k_alike) return std::nullopt;
    return worded("run-out or area differ {1} % from particles: take {2} = default",
                  {numeral(number_text(100 * most, 2)), std::string(is_region ? "region.scheme" : "study.scheme")});
}

std::vector<std::pair<Sentence, Sentence>> rows_of(const SchemeCheck& check) {
    std::vector<std::pair<Sentence, Sentence>> rows{{worded("Scheme of the runs"), check.scheme}};
    if (!check.refusal.empty()) rows.emplace_back(worded("Not checked by scheme {1}", {check.other}), check.refusal);
    for (const SchemeCheck::Member& one : check.members) {
        const Sentence name = worded(
            one.is_farthest ? worded("Farthest member {1} by scheme {2}") : worded("Median member {1} by scheme {2}"),
            {numeral(std::to_string(one.member)), check.other});
        rows.emplace_back(name, one.failure.empty()
                                    ? worded("run-out {1} %, area {2} %, greatest depth {3} %",
                                             {signed_percent(one.difference(0)), signed_percent(one.difference(1)),
                                              signed_percent(one.difference(2))})
                                    : worded("failed: {1}", {one.failure}));
    }
    return rows;
}

Json scheme_json(const StudyInput& input) {
    const auto scheme = common_scheme(input);
    return scheme ? Json(word_of(*scheme, k_schemes)) : Json();
}

Json check_json(const SchemeCheck& check) {
    Json json{{"scheme", check.other}, {"refused", check.refusal.empty() ? Json() : Json(check.refusal)}};
    json["members"] = Json::array();
    for (const SchemeCheck::Member& one : check.members) {
        Json member{{"member", one.member},
                    {"chosen", one.is_farthest ? "farthest" : "median"},
                    {"failure", one.failure.empty() ? Json() : Json(one.failure)}};
        for (std::size_t f = 0; f < std::size(k_checked_figures) && one.failure.empty(); ++f)
            member[k_checked_figures[f]] = {
                {"members_scheme", one.own[f]}, {"other_scheme", one.other[f]}, {"difference", one.difference(f)}};
        json["members"].push_back(std::move(member));
    }
    return json;
}

}  // namespace frana::app::study
