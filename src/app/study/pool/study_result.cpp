// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/study_result.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "app/publish/publish.h"
#include "app/study/pool/member_runs.h"
#include "core/text.h"
#include "simulation/run_warnings.h"

namespace frana::app::study {
namespace {

Sentence count(std::size_t number) {
    return numeral(std::to_string(number));
}

/// A warning of the runs, told with the one whose figure is the worst.
struct KindOfWarning {
    Sentence worst;
    std::string table;
    std::size_t member = 0, runs = 0;
    double severity = 0;
};

/// The figure that a warning is about, the first of its numbers; of a number of particles the fewest are the worst.
double severity_of(const Sentence& warning) {
    const double figure = warning.first_number().value_or(0);
    return warning.pattern() == k_few_particles_warning ? -figure : figure;
}

}  // namespace

Troubles troubles_of(const std::vector<RunOfStudy>& runs, bool each_counts) {
    Troubles all;
    all.each_counts = each_counts;
    all.runs = runs.size();
    for (const RunOfStudy& run : runs) {
        all.failed += run.failure.empty() ? 0 : 1;
        all.warned += run.end.warnings.empty() ? 0 : 1;
        all.flew += std::any_of(run.end.warnings.begin(), run.end.warnings.end(),
                                [](const Warning& warning) { return warning.words.pattern() == k_flights_warning; });
        all.held += run.failure.empty() && run.end.is_held ? 1 : 0;
        all.open += run.failure.empty() && run.end.is_open() ? 1 : 0;
        if (run.end.is_cut) {
            ++all.cut;
            all.most_moving = std::max(all.most_moving, run.end.moving_fraction);
        }
        if (run.end.left()) {
            ++all.left;
            all.most_left = std::max(all.most_left, run.end.left_fraction);
        }
    }
    return all;
}

Warnings kinds_of_warnings(const std::vector<RunOfStudy>& runs, const Warnings& known) {
    std::vector<std::string> order;
    std::map<std::string, KindOfWarning> kinds;
    for (const RunOfStudy& run : runs) {
        std::set<std::string> told;
        for (const Warning& warning : without(run.end.warnings, known)) {
            const std::string& pattern = warning.words.pattern();
            const auto [at, is_new] = kinds.try_emplace(pattern);
            if (is_new) order.push_back(pattern);
            KindOfWarning& kind = at->second;
            kind.runs += told.insert(pattern).second ? 1 : 0;
            const double severity = severity_of(warning.words);
            if (!is_new && !(severity > kind.severity)) continue;
            kind.worst = warning.words;
            kind.member = run.member;
            kind.table = run.table;
            kind.severity = severity;
        }
    }
    Warnings sentences;
    for (const std::string& pattern : order) {
        const KindOfWarning& kind = kinds.at(pattern);
        const Sentence some = count(kind.runs), all = count(runs.size()), member = count(kind.member);
        sentences.push_back(kind.table.empty() ? worded("{1} of {2} runs warn, most of all member {3}: {4}",
                                                        {some, all, member, kind.worst})
                                               : worded("{1} of {2} runs warn, most of all member {3} of {4}: {5}",
                                                        {some, all, member, kind.table, kind.worst}));
    }
    return sentences;
}

std::vector<std::string> end_values(const MemberEnd& end) {
    const bool ran = !end.stop_reason.empty();
    const auto cell = [&](double value) { return ran && !std::isnan(value) ? shortest_text(value) : std::string(); };
    return {end.stop_reason,         cell(end.moving_fraction),
            cell(end.left_fraction), ran ? std::to_string(static_cast<int>(end.is_held)) : "",
            cell(end.energy_error),  std::to_string(end.warnings.size())};
}

void add_end(const MemberEnd& end, std::map<std::string, double>& numbers, std::map<std::string, std::string>& texts) {
    texts["stop_reason"] = end.stop_reason;
    numbers["warnings"] = static_cast<double>(end.warnings.size());
    if (end.stop_reason.empty()) return;
    numbers[k_end_key] = end.end;
    numbers["moving_fraction"] = end.moving_fraction;
    numbers["left_domain_fraction"] = end.left_fraction;
    numbers["held_by_no_data"] = end.is_held ? 1 : 0;
    if (!std::isnan(end.energy_error)) numbers["energy_error"] = end.energy_error;
}

namespace {

void add_finished(const StudyInput& input, const RecordFiles& records, std::size_t member, std::size_t place,
                  FinishedMembers& to, std::vector<std::size_t>& places) {
    to.records.push_back(records.place(member));
    to.weights.push_back(input.table.weights[member]);
    to.columns.push_back(place);
    if (input.table.is_replicated) to.replicates.push_back(input.table.replicate_of(member));
    places.push_back(place);
}

void scale_weights(FinishedMembers& members) {
    const double sum = std::accumulate(members.weights.begin(), members.weights.end(), 0.0);
    for (double& weight : members.weights) weight /= sum;
}

/// All runs with their weights among all.
OpenRuns open_runs(const StudyInput& input, const RecordFiles& records, const StudyResult& result) {
    OpenRuns all;
    for (const MemberResult& one : result.members) {
        all.runs.records.push_back(records.place(one.member));
        all.runs.weights.push_back(input.table.weights[one.member]);
        all.is_open.push_back(one.end.is_open() || !one.failure.empty());
    }
    scale_weights(all.runs);
    all.runs.store = std::make_shared<CellStore>(all.runs.records);
    return all;
}

/// Groups of a design of which every member finished; each gets the next number.
std::map<std::size_t, std::size_t> whole_groups(const StudyInput& input, const StudyResult& result) {
    std::map<std::size_t, std::size_t> counts, numbers;
    for (const std::size_t place : result.finished_at) ++counts[result.members[place].member % input.table.groups];
    for (const auto& [group, count] : counts)
        if (count == input.reading.study.group_size()) numbers.emplace(group, numbers.size());
    return numbers;
}

void choose_design(const StudyInput& input, const RecordFiles& records, StudyResult& result) {
    const SampleTable& table = input.table;
    result.points.nominal = table.nominal;
    if (table.groups > 0) {
        const auto groups = whole_groups(input, result);
        for (const std::size_t place : result.finished_at) {
            const std::size_t member = result.members[place].member;
            if (groups.count(member % table.groups) > 0)
                add_finished(input, records, member, place, result.design, result.design_at);
        }
        result.design.store = result.finished.store;
        result.groups = groups.size();
    } else {
        result.design = result.finished;
        result.design_at = result.finished_at;
    }
    for (const std::size_t place : result.design_at)
        result.points.numbers.push_back(table.numbers[result.members[place].member]);
    for (const std::size_t place : result.design_at)
        if (!table.places.empty()) result.points.places.push_back(table.places[result.members[place].member]);
    if (table.places.empty()) result.points.places = rank_places(result.points);
    result.points.are_dependent = !input.reading.study.correlate.empty() || are_correlated(result.points);
}

}  // namespace

bool StudyResult::equal_weights() const {
    return std::all_of(design.weights.begin(), design.weights.end(),
                       [&](double weight) { return weight == design.weights.front(); });
}

std::vector<RunOfStudy> StudyResult::runs() const {
    std::vector<RunOfStudy> all;
    for (const MemberResult& one : members) all.push_back({one.member, one.end, one.failure});
    return all;
}

std::size_t StudyResult::failed() const noexcept {
    return static_cast<std::size_t>(std::count_if(members.begin(), members.end(),
                                                  [](const MemberResult& member) { return !member.failure.empty(); }));
}

std::vector<double> StudyResult::figure(std::size_t index) const {
    std::vector<double> values;
    for (const std::size_t place : finished_at) values.push_back(members[place].figures[index].value);
    return values;
}

Estimate StudyResult::mean_of(std::size_t index) const {
    return MeanEstimate(finished).mean(figure(index));
}

Interval StudyResult::quantile_of(std::size_t index, double q) const {
    const std::vector<double> values = figure(index);
    const std::vector<float> floats(values.begin(), values.end());
    const double value = weighted_quantile(values, finished.weights, q),
                 margin = MeanEstimate(finished).probability(floats, static_cast<float>(value)).margin;
    constexpr double k_infinite = std::numeric_limits<double>::infinity();
    return {value, q > margin ? weighted_quantile(values, finished.weights, q - margin) : -k_infinite,
            q + margin < 1 ? weighted_quantile(values, finished.weights, q + margin) : k_infinite};
}

double StudyResult::quantile_bound(std::size_t index, double q) const {
    if (!open.any()) return weighted_quantile(figure(index), finished.weights, q);
    std::vector<double> values;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const std::vector<Figure>& of = members[i].figures;
        values.push_back(open.is_open[i]     ? std::numeric_limits<double>::infinity()
                         : index < of.size() ? of[index].value
                                             : 0);  // it failed before its first step
    }
    return weighted_quantile(values, open.runs.weights, q);
}

const std::vector<Figure>& StudyResult::figures() const {
    static const std::vector<Figure> k_none;
    return finished_at.empty() ? k_none : members[finished_at.front()].figures;
}

StudyResult read_study_result(const StudyInput& input, const std::string& folder, std::size_t count) {
    StudyResult result;
    const RecordFiles records(folder);
    for (std::size_t member = 0; member < count; ++member) {
        MemberRecord record = require_own_record(input, records.place(member), member);
        result.members.push_back({member, record.failure, std::move(record.end), std::move(record.figures),
                                  record.engine_seconds, record.particle_steps, record.grid().bounds()});
        if (result.members.back().failure.empty())
            add_finished(input, records, member, result.members.size() - 1, result.finished, result.finished_at);
    }
    scale_weights(result.finished);
    result.open = open_runs(input, records, result);
    result.finished.store = result.open.runs.store;
    choose_design(input, records, result);
    result.grid = input.base.scene.grid;
    return result;
}

std::optional<RarePlace> rare_place_of(const StudyInput& input, const StudyResult& result) {
    if (!input.reading.study.rare_place) return std::nullopt;
    RarePlace rare{rare_event(input), {}, 0, 0};
    const auto cell = cell_at(result.grid, rare.event.place);
    // The maps of a large terrain may end before a place that nothing reaches.
    const std::vector<std::vector<std::size_t>> cells{cell ? std::vector{*cell} : std::vector<std::size_t>{}};
    for_each_feature(result.finished, Quantity::depth, result.grid, cells,
                     [&](std::size_t, std::span<const float> depths) {
                         rare.probability = MeanEstimate(result.finished).probability(depths, rare.event.threshold);
                         for (const float depth : depths)
                             rare.hits += static_cast<double>(depth) > rare.event.threshold ? 1 : 0;
                     });
    rare.high = rare.probability.high();
    if (!result.open.any()) return rare;
    for_each_feature(result.open.runs, Quantity::depth, result.grid, cells,
                     [&](std::size_t, std::span<const float> depths) {
                         std::vector<float> most(depths.begin(), depths.end());
                         for (std::size_t run = 0; run < most.size(); ++run)
                             if (result.open.is_open[run]) most[run] = std::numeric_limits<float>::infinity();
                         const Estimate bound = MeanEstimate(result.open.runs).probability(most, rare.event.threshold);
                         rare.high = std::max(rare.high, bound.high());
                     });
    return rare;
}

double largest_error(const StudyInput& input, const StudyResult& result) {
    double largest = 0;
    for (const MappedEvents& events : mapped_events(input.base.spec))
        largest =
            std::max(largest, error_of(result.finished, events.quantity, result.grid, events.thresholds).largest());
    return largest;
}

bool is_field_of_error(const StudyInput& input, std::size_t key) {
    return input.table.keys[key] == "terrain.error";
}

std::vector<FigureSensitivity> sensitivities(const StudyInput& input, const StudyResult& result) {
    const bool is_morris = input.reading.study.sampling == Sampling::morris;
    std::vector<FigureSensitivity> all;
    if (result.design_at.size() < 2 || !result.equal_weights()) return all;
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        std::vector<double> output;
        for (const std::size_t place : result.design_at) output.push_back(result.members[place].figures[f].value);
        if (std::adjacent_find(output.begin(), output.end(), std::not_equal_to<>()) == output.end()) continue;
        const Chaos chaos = openturns().chaos(result.points, {output}, {}).front();
        FigureSensitivity one{result.figures()[f], {}, chaos.q2};
        one.keys = !is_morris          ? rank_correlations(result.points, output)
                   : result.groups > 1 ? elementary_effects(result.points, output, result.groups)
                                       : std::vector<KeySensitivity>(result.points.nominal.size());
        for (std::size_t k = 0; k < one.keys.size(); ++k) {
            KeySensitivity& key = one.keys[k];
            constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
            if (std::isnan(chaos.q2) || result.points.are_dependent || chaos.q2 < k_least_q2) {
                key.method = std::isnan(chaos.q2)          ? "not measurable"
                             : result.points.are_dependent ? "refused: keys are correlated"
                                                           : "refused: Q2 < " + shortest_text(k_least_q2);
                continue;
            }
            if (is_field_of_error(input, k)) {  // no polynomial has it: it is in what they leave
                key.method = k_not_explained;
                continue;
            }
            key.first_order = Interval{chaos.first_order[k], k_none, k_none};
            key.total = Interval{chaos.total[k], k_none, k_none};
            key.method = "polynomial chaos";
        }
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace frana::app::study
