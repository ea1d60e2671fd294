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
#include "params/grammar/value_text.h"
#include "simulation/run_warnings.h"

namespace frana::app::study {
namespace {

Sentence count(std::size_t number) {
    return numeral(std::to_string(number));
}

/// A warning of the runs, told with the one whose figure is the worst.
struct KindOfWarning {
    Sentence worst;
    std::size_t member = 0, runs = 0;
    double severity = 0;
};

/// The figure that a warning is about, the first of its numbers; of a number of particles the fewest are the worst.
double severity_of(const Sentence& warning) {
    const double figure = warning.first_number().value_or(0);
    return warning.pattern() == k_few_particles_warning ? -figure : figure;
}

}  // namespace

std::size_t failed_of(const std::vector<MemberRecord>& runs) {
    return static_cast<std::size_t>(
        std::count_if(runs.begin(), runs.end(), [](const MemberRecord& run) { return !run.failure.empty(); }));
}

Troubles troubles_of(const std::vector<MemberRecord>& runs, bool each_counts) {
    Troubles all;
    all.each_counts = each_counts;
    all.runs = runs.size();
    for (const MemberRecord& run : runs) {
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

Warnings kinds_of_warnings(const std::vector<MemberRecord>& runs, const Warnings& known, const std::string& table) {
    std::vector<std::string> order;
    std::map<std::string, KindOfWarning> kinds;
    for (const MemberRecord& run : runs) {
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
            kind.severity = severity;
        }
    }
    Warnings sentences;
    for (const std::string& pattern : order) {
        const KindOfWarning& kind = kinds.at(pattern);
        const std::string member = std::to_string(kind.member) + (table.empty() ? "" : " (" + table + ")");
        sentences.push_back(worded("{1} of {2} runs warn, most of all member {3}: {4}",
                                   {count(kind.runs), count(runs.size()), member, kind.worst}));
    }
    return sentences;
}

namespace {

/// Some of all runs, with weights that add up to 1.
FinishedMembers chosen(const FinishedMembers& all, const std::vector<std::size_t>& at) {
    FinishedMembers some;
    for (const std::size_t place : at) {
        some.records.push_back(all.records[place]);
        some.weights.push_back(all.weights[place]);
        if (!all.replicates.empty()) some.replicates.push_back(all.replicates[place]);
    }
    const double sum = std::accumulate(some.weights.begin(), some.weights.end(), 0.0);
    for (double& weight : some.weights) weight /= sum;
    some.store = all.store;
    some.columns = at;
    return some;
}

/// Takes for sensitivities whole groups of a design alone.
void choose_design(const StudyInput& input, StudyResult& result) {
    const SampleTable& table = input.table;
    result.design_at = result.finished_at;
    if (table.groups > 0) {
        std::map<std::size_t, std::size_t> counts;
        for (const std::size_t place : result.finished_at) ++counts[place % table.groups];
        std::erase_if(counts, [&](const auto& group) { return group.second != input.reading.study.group_size(); });
        std::erase_if(result.design_at, [&](std::size_t place) { return counts.count(place % table.groups) == 0; });
        result.groups = counts.size();
    }
    result.points.nominal = table.nominal;
    for (const std::size_t place : result.design_at) {
        result.points.numbers.push_back(table.numbers[place]);
        if (!table.places.empty()) result.points.places.push_back(table.places[place]);
    }
    if (table.places.empty()) result.points.places = rank_places(result.points);
    result.points.are_dependent = !input.reading.study.correlate.empty() || are_correlated(result.points);
}

/// Source::sway: the weights of exceedances as V^-b change with b as -ln V, around its mean.
std::vector<double> sway_of(const StudyInput& input, const StudyResult& result, const std::vector<std::size_t>& runs,
                            const std::vector<double>& weights, double error) {
    const auto& keys = input.table.keys;
    const auto volume = static_cast<std::size_t>(std::find(keys.begin(), keys.end(), k_volume_key) - keys.begin());
    std::vector<double> sway;
    double mean = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        sway.push_back(std::log(*number_from_text(input.table.values[result.members[runs[i]].member][volume])));
        mean += weights[i] * sway.back();
    }
    for (std::size_t i = 0; i < runs.size(); ++i) sway[i] = error * weights[i] * (mean - sway[i]);
    return sway;
}

/// The slopes of a region, or the only one of a study, with their runs.
std::shared_ptr<const AnnualRates> rates_of(const StudyInput& input, const FinishedMembers& all,
                                            const StudyResult& result) {
    const FrequencySpec& frequency = input.spec().frequency;
    if (!frequency.is_given()) return nullptr;
    std::vector<Source> sources(std::max<std::size_t>(1, input.slopes.size()));
    const std::size_t runs = all.size() / sources.size();
    for (std::size_t i = 0, first = 0; i < sources.size(); ++i) {
        Source& source = sources[i];
        const Slope* const slope = input.slopes.empty() ? nullptr : &input.slopes[i];
        source.name = slope != nullptr ? slope->name : "";
        source.rate = (slope != nullptr ? slope->frequency : frequency).rate.value_or(FrequencySpec::Rate{});
        std::vector<std::size_t> finished, every;
        for (std::size_t run = i * runs; run < (i + 1) * runs; ++run) {
            every.push_back(run);
            if (result.members[run].failure.empty()) finished.push_back(run);
        }
        source.members = chosen(all, finished);
        source.shares = chosen(all, every).weights;
        source.first = first;
        if (frequency.exponent_error)
            source.sway = sway_of(input, result, finished, source.members.weights, *frequency.exponent_error);
        first += finished.size();
    }
    return std::make_shared<AnnualRates>(std::move(sources), !frequency.by_columns, result.is_open);
}

}  // namespace

bool StudyResult::equal_weights() const {
    return std::all_of(design.weights.begin(), design.weights.end(),
                       [&](double weight) { return weight == design.weights.front(); });
}

std::vector<double> StudyResult::weights() const {
    std::vector<double> of_members(members.size());
    for (std::size_t i = 0; i < finished_at.size(); ++i) of_members[finished_at[i]] = finished.weights[i];
    return of_members;
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
    if (!any_open()) return weighted_quantile(figure(index), finished.weights, q);
    std::vector<double> values;  // 0: it failed before its first step
    for (const MemberRecord& one : members) values.push_back(index < one.figures.size() ? one.figures[index].value : 0);
    return weighted_quantile(at_most(std::span<const double>(values)), all.weights, q);
}

const std::vector<Figure>& StudyResult::figures() const {
    static const std::vector<Figure> k_none;
    return finished_at.empty() ? k_none : members[finished_at.front()].figures;
}

StudyResult read_study_result(const StudyInput& input, const std::string& folder, std::size_t count) {
    StudyResult result;
    const RecordFiles records(folder);
    FinishedMembers all;
    std::vector<std::size_t> everyone;
    for (std::size_t member = 0; member < count; ++member) {
        const MemberRecord& one = result.members.emplace_back(without_cells(require_record(records.place(member))));
        all.records.push_back(records.place(member));
        all.weights.push_back(input.table.weights[member]);
        if (input.table.is_replicated) all.replicates.push_back(input.table.replicate_of(member));
        result.is_open.push_back(one.end.is_open() || !one.failure.empty());
        everyone.push_back(member);
        if (one.failure.empty()) result.finished_at.push_back(member);
    }
    all.store = std::make_shared<CellStore>(all.records);
    result.finished = chosen(all, result.finished_at);
    choose_design(input, result);
    result.design = chosen(all, result.design_at);
    result.rates = rates_of(input, all, result);
    all.replicates.clear();  // a bound has no use for them
    result.all = chosen(all, everyone);
    result.grid = input.base.scene.grid;
    return result;
}

std::optional<RarePlace> rare_place_of(const StudyInput& input, const StudyResult& result) {
    if (!input.reading.study.rare_place) return std::nullopt;
    RarePlace rare{rare_event(input), {}, 0, 0};
    const auto cell = cell_at(result.grid, rare.event.place);
    // The maps of a large terrain may end before a place that nothing reaches.
    const std::vector<std::vector<std::size_t>> cells{cell ? std::vector{*cell} : std::vector<std::size_t>{}};
    for_each_feature(
        result, Quantity::depth, result.grid, cells,
        [&](std::size_t, std::span<const float> finished, std::span<const float> all) {
            rare.probability = MeanEstimate(result.finished).probability(finished, rare.event.threshold);
            for (const float depth : finished) rare.hits += static_cast<double>(depth) > rare.event.threshold ? 1 : 0;
            rare.high = rare.probability.high();
            if (result.any_open())
                rare.high = std::max(
                    rare.high, MeanEstimate(result.all).probability(result.at_most(all), rare.event.threshold).high());
        });
    return rare;
}

double largest_error(const StudyInput& input, const StudyResult& result) {
    double largest = 0;
    for (const MappedEvents& events : mapped_events(input.base.spec))
        largest =
            std::max(largest, quantity_maps(result, events.quantity, result.grid, events.thresholds).errors.largest());
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
            key.first_order = chaos.first_order[k];
            key.total = chaos.total[k];
            key.method = "polynomial chaos";
        }
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace frana::app::study
