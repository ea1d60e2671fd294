// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_calibration.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/pictures/charts.h"
#include "app/store/recorded_inputs.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/study/pool/study_result.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/study/statistics/sensitivity.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/json.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/output_parameters.h"
#include "params/scene/write_scene.h"

namespace frana::app::study {
namespace {

/// The scores at one event, 0 for members that failed there.
std::vector<double> scores_at(const std::vector<std::vector<double>>& misfits, std::size_t event) {
    std::vector<double> scores;
    for (const auto& one : misfits) scores.push_back(std::isnan(one[event]) ? 0 : 1 - one[event]);
    return scores;
}

/// The keys with their values in the members.
/// @param table_of of an event's members
template <class TableOf>
std::vector<KeySample> key_samples(const StudySpec& calibration, const TableOf& table_of) {
    std::vector<KeySample> keys;
    const auto add = [&](const Variation& one, const std::string& event, const SampleTable& table, std::size_t column) {
        KeySample& key = keys.emplace_back(KeySample{one.key, event, one.distribution, {}, {}, {}});
        for (std::size_t i = 0; i < table.size(); ++i) {
            key.places.push_back(table.places[i][column]);
            key.numbers.push_back(table.numbers[i][column]);
            key.texts.push_back(table.values[i][column]);
        }
    };
    const std::size_t shared = calibration.vary.size();
    for (std::size_t e = 0; e < calibration.events.size(); ++e) {
        const SampleTable& table = table_of(e);
        for (std::size_t k = 0; k < shared && e == 0; ++k) add(calibration.vary[k], "", table, k);
        const EventSpec& event = calibration.events[e];
        for (std::size_t k = 0; k < event.vary.size(); ++k) add(event.vary[k], event.name, table, shared + k);
    }
    return keys;
}

/// The same of a posterior's sample.
std::vector<KeySample> key_samples(const StudyReading& reading, const Places& places) {
    Problems of_values;  // told of the members
    return key_samples(reading.study, [&](std::size_t e) { return members_at(reading, e, places, of_values); });
}

/// @param sample as the model draws it without that event, and its posteriors
Explained explained(const CalibrationRuns& runs, const CalibrationModel& model, const PosteriorSample& sample,
                    std::vector<KeyPosterior> posteriors, std::size_t event, std::optional<std::size_t> without) {
    Explained result;
    const auto misfits = runs.misfits();
    std::vector<double> weights = model.member_weights(sample, without);
    if (without) {  // members that failed at the event itself predict nothing of it
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (std::isnan(misfits[i][event])) weights[i] = 0;
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
        if (sum > 0)
            for (double& weight : weights) weight /= sum;
    }
    const auto best = model.best(without);
    result.effective = effective_count(weights);
    if (!best || result.effective == 0) return result;
    const std::vector<double> scores = scores_at(misfits, event);
    result.possible = true;
    result.best = *best;
    result.best_score = scores[*best];
    result.mean = std::inner_product(scores.begin(), scores.end(), weights.begin(), 0.0);
    result.low = weighted_quantile(scores, weights, 0.05);
    result.high = weighted_quantile(scores, weights, 0.95);
    result.posteriors = std::move(posteriors);
    return result;
}

Sentence short_number(double value, int digits = 3) {
    return numeral(number_text(value, digits));
}

/// The measures of an event that do not count, because others have a stated error.
std::vector<std::string> uncounted(const StudyInput& input, const CalibrationRuns& runs, std::size_t event) {
    const ObservedSpec& stated = input.own[event].base.spec.observed;
    std::vector<std::string> names;
    for (const Weight& one : runs.events[event].measures) {
        const Evidence needs = row_of(one.measure).needs;
        const bool counts = needs == Evidence::scar               ? stated.perimeter_error.has_value()
                            : needs == Evidence::deposit          ? false
                            : needs == Evidence::elevation_change ? stated.deposit_error.has_value()
                                                                  : has_stated_error(input.spec().events[event], needs);
        if (!counts) names.emplace_back(row_of(one.measure).name);
    }
    return names;
}

/// Fills in what the likelihood rests on, and what is doubtful.
void judge(const StudyInput& input, const CalibrationRuns& runs, const CalibrationModel& model,
           CalibrationResult& result) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const std::string& name = input.spec().events[e].name;
        const bool is_stated = runs.events[e].pieces > 0;
        result.uncounted.push_back(is_stated ? uncounted(input, runs, e) : std::vector<std::string>{});
        if (const double factor = result.widening.emplace_back(model.widening(e)); factor > 1)
            result.doubts.push_back(worded("{1}: best run off by {2} times the survey's error: error raised",
                                           {name, short_number(factor, 2)}));
        if (!(result.q2[e] >= k_least_q2))
            result.doubts.push_back(worded("{1}: emulator Q2 {2}, under {3}: raise study.samples or narrow [vary]",
                                           {name, short_number(result.q2[e], 2), short_number(k_least_q2)}));
    }
    if (!runs.has_settled())
        result.doubts.push_back(worded("intervals not within {2} % after {1} members: raise study.samples",
                                       {std::to_string(runs.size()), short_number(100 * k_settled)}));
}

}  // namespace

std::string column_of(const StudySpec& calibration, const KeySample& key) {
    return key.event.empty() || calibration.events.size() == 1 ? key.key : key.key + " of " + key.event;
}

CalibrationResult calibration_result(const StudyInput& input, const CalibrationRuns& runs) {
    const CalibrationModel model = model_of(input.spec(), runs);
    const PosteriorSample sample = model.sample();
    CalibrationResult result;
    result.best = *model.best();  // run_calibration() ends without one
    result.q2 = model.q2();
    result.weights = model.member_weights(sample);
    result.effective = effective_count(result.weights);
    result.keys = key_samples(input.spec(), [&](std::size_t e) -> const SampleTable& { return input.own[e].table; });
    result.after = key_samples(input.reading, sample.places);
    result.weights_after = sample.weights;
    result.posteriors = key_posteriors(result.after, sample.weights);
    result.indistinct = indistinct_pairs(result.after, sample.weights);
    result.sentences = sentences(result.posteriors, result.indistinct);
    if (troubles_of(runs.runs(), false).open > 0)
        result.doubts.push_back(worded("scores and posterior are of flows partly unfinished: raise time.end"));
    judge(input, runs, model, result);
    for (Sentence& doubt : edge_doubts(result.posteriors)) result.doubts.push_back(std::move(doubt));
    if (const auto few = few_members(result.effective)) result.doubts.push_back(*few);
    for (std::size_t e = 0; e < input.events(); ++e) {
        EventResult& event = result.events.emplace_back();
        event.fitted = explained(runs, model, sample, {}, e, std::nullopt);
        if (input.events() == 1) continue;
        const PosteriorSample of_others = model.sample(e);
        event.predicted =
            explained(runs, model, of_others,
                      key_posteriors(key_samples(input.reading, of_others.places), of_others.weights), e, e);
    }
    return result;
}

namespace {

/// Mean over the events of a member's scores; NaN if it failed at one.
double score_of(const std::vector<double>& misfits) {
    double sum = 0;
    for (const double misfit : misfits) sum += 1 - misfit;
    return sum / static_cast<double>(misfits.size());
}

std::string cell(double value) {
    return std::isnan(value) ? "" : shortest_text(value);
}

/// How a member's runs ended: the worst of the events.
MemberEnd end_of(const CalibrationRuns& runs, std::size_t member) {
    MemberEnd worst;
    for (const EventRuns& event : runs.events) {
        const MemberEnd& end = event.members[member].end;
        worst.stop_reason += (&event == &runs.events.front() ? "" : "; ") + end.stop_reason;
        worst.moving_fraction = std::max(worst.moving_fraction, end.moving_fraction);
        worst.left_fraction = std::max(worst.left_fraction, end.left_fraction);
        worst.energy_error = std::fmax(worst.energy_error, end.energy_error);
        worst.warnings.insert(worst.warnings.end(), end.warnings.begin(), end.warnings.end());
    }
    return worst;
}

Json json_of(const KeyPosterior& key, const std::string& best) {
    Json json{{"key", key.key}};
    if (!key.event.empty()) json["event"] = key.event;
    json["best"] = best;
    if (key.nominal) {
        for (const auto& [value, probability] : key.values) json["probabilities"][value] = probability;
        return json;
    }
    json["q05"] = key.low;
    json["q50"] = key.median;
    json["q95"] = key.high;
    json["prior_q05"] = key.prior_low;
    json["prior_q95"] = key.prior_high;
    json["width_of_prior"] = key.width;
    return json;
}

Json json_of(const CalibrationResult& result, const Explained& one) {
    if (!one.possible) return nullptr;
    Json json{{"best_member", one.best}, {"best_score", one.best_score},
              {"mean_score", one.mean},  {"q05", one.low},
              {"q95", one.high},         {"effective_members", one.effective}};
    for (std::size_t k = 0; k < one.posteriors.size(); ++k)
        json["intervals"].push_back(json_of(one.posteriors[k], result.keys[k].texts[one.best]));
    return json;
}

/// Lines before the header: who reads the table reads its doubts, and `frana ensemble` repeats them.
std::string doubt_lines(const CalibrationRuns& runs, const CalibrationResult& result) {
    const Troubles troubles = troubles_of(runs.runs(), false);
    std::string text = troubles.any() ? "# " + one_line(headline(troubles).text()) + "\n" : "";
    for (const Sentence& doubt : result.doubts) text += "# " + one_line(doubt.text()) + "\n";
    return text;
}

/// Returns posterior.csv: a row for each member with its weight, score, values and misfits. A column
/// of a shared key has the key's name, so that `frana ensemble` takes the file with sampling = table:FILE.
std::string posterior_csv(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result) {
    const StudySpec& calibration = input.spec();
    std::vector<std::string> heads{"member", "status", "weight", "score"};
    for (const KeySample& key : result.keys) heads.push_back(column_of(calibration, key));
    for (std::size_t e = 0; e < input.events(); ++e) {
        heads.push_back("score " + calibration.events[e].name);
        for (const Weight& one : runs.events[e].measures)
            heads.push_back(std::string("misfit ") + row_of(one.measure).name + " " + calibration.events[e].name);
    }
    heads.emplace_back("engine_seconds");
    heads.insert(heads.end(), std::begin(k_end_columns), std::end(k_end_columns));
    heads.emplace_back("reason");
    std::string text = doubt_lines(runs, result) + csv_line(heads);
    const auto misfits = runs.misfits();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double score = score_of(misfits[i]);
        std::vector<std::string> row{std::to_string(i), std::isnan(score) ? "failed" : "finished",
                                     shortest_text(result.weights[i]), cell(score)};
        for (const KeySample& key : result.keys) row.push_back(key.texts[i]);
        std::string reason;
        double seconds = 0;
        for (std::size_t e = 0; e < input.events(); ++e) {
            const MemberRecord& one = runs.events[e].members[i];
            row.push_back(cell(1 - misfits[i][e]));
            for (std::size_t m = 0; m < runs.events[e].measures.size(); ++m)
                row.push_back(one.failure.empty() ? shortest_text(runs.events[e].agreements[i].parts[m]) : "");
            if (!one.failure.empty())
                reason += (reason.empty() ? "" : "; ") + calibration.events[e].name + ": " + one.failure;
            seconds += one.engine_seconds;
        }
        row.push_back(shortest_text(seconds));
        for (std::string& one : end_values(end_of(runs, i))) row.push_back(std::move(one));
        row.push_back(reason);
        text += csv_line(row);
    }
    return text;
}

/// The same for one event that has keys of its own: all its keys by their names.
std::string event_posterior_csv(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                                std::size_t event) {
    const SampleTable& table = input.own[event].table;
    std::vector<std::string> heads{"member", "weight", "score"};
    heads.insert(heads.end(), table.keys.begin(), table.keys.end());
    std::string text = doubt_lines(runs, result) + csv_line(heads);
    for (std::size_t i = 0; i < table.size(); ++i) {
        std::vector<std::string> row{std::to_string(i), shortest_text(result.weights[i]),
                                     cell(1 - runs.events[event].agreements[i].misfit)};
        row.insert(row.end(), table.values[i].begin(), table.values[i].end());
        text += csv_line(row);
    }
    return text;
}

/// Returns calibration.json: best values, intervals, scores by event, fitted and predicted. No wall time is in it.
std::string calibration_json(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result) {
    const StudySpec& calibration = input.spec();
    const auto misfits = runs.misfits();
    Json json{{"format", k_result_format},
              {"members", runs.size()},
              {"effective_members", result.effective},
              {"has_settled", runs.has_settled()},
              {"best_member", result.best},
              {"best_score", score_of(misfits[result.best])}};
    Json& objective = json["objective"] = Json::object();
    for (const Weight& one : calibration.objective) objective[row_of(one.measure).name] = one.weight;
    Json& keys = json["intervals"] = Json::array();
    for (std::size_t k = 0; k < result.posteriors.size(); ++k)
        keys.push_back(json_of(result.posteriors[k], result.keys[k].texts[result.best]));
    Json& pairs = json["indistinct"] = Json::array();
    for (const IndistinctPair& pair : result.indistinct)
        pairs.push_back({{"first", column_of(calibration, result.keys[pair.first])},
                         {"second", column_of(calibration, result.keys[pair.second])},
                         {"correlation", pair.correlation}});
    Json& events = json["events"] = Json::array();
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& runs_of_event = runs.events[e];
        Json event{{"name", calibration.events[e].name},
                   {"scene", calibration.events[e].scene},
                   {"cell_size", input.own[e].base.scene.grid.cell_size},
                   {"stated_errors", runs_of_event.pieces > 0},
                   {"pieces", runs_of_event.pieces > 0 ? runs_of_event.pieces : calibration.exponent},
                   {"q2", result.q2[e]},
                   {"error_factor", result.widening[e]},
                   {"uncounted", result.uncounted[e]},
                   {"fitted", json_of(result, result.events[e].fitted)}};
        if (runs_of_event.observed_runout > 0) event["observed_runout_m"] = runs_of_event.observed_runout;
        const MemberAgreement& best = runs_of_event.agreements[result.best];
        for (std::size_t m = 0; m < runs_of_event.measures.size(); ++m)
            event["best_misfits"][row_of(runs_of_event.measures[m].measure).name] = best.parts[m];
        event["scheme"] = scheme_json(input.own[e]);
        if (const auto& check = result.scheme_checks[e]) event["scheme_check"] = check_json(*check);
        if (input.events() > 1) event["leave_one_out"] = json_of(result, result.events[e].predicted);
        events.push_back(std::move(event));
    }
    for (const double move : runs.moves) json["moves"].push_back(move);
    json["doubts"] = texts_of(result.doubts);
    return json_text(json);
}

std::string calibration_summary_json(const StudyInput& input, const CalibrationRuns& runs, const StudyFacts& facts) {
    Json json = summary_head(input, facts);
    json["samples"] = input.spec().samples;
    json["members"] = runs.size();
    json["runs"] = runs.size() * input.events();
    json["failed_runs"] = failed_of(runs.runs());
    return json_text(json);
}

/// Computes members that the surveys give weight by the other scheme, for each event.
void check_schemes(const StudyInput& input, const CalibrationRuns& runs, int threads, CalibrationResult& result) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const auto& check = result.scheme_checks.emplace_back(
            check_scheme(input.own[e], runs.events[e].members, result.weights, threads));
        if (const auto doubt = check ? warning_of(*check) : std::nullopt)
            result.doubts.push_back(worded("{1}: {2}", {input.spec().events[e].name, *doubt}));
    }
}

void write_best_scenes(const StudyInput& input, const CalibrationResult& result, const ResultDirectory& directory) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const StudyInput& study = input.own[e];
        const std::string name = input.events() == 1 ? k_best_scene : best_scene_of(input.spec().events[e].name);
        write_text_file(directory.path(name), echoed_scene(study.member(result.best).scene, directory.target()));
    }
}

void tell(const StudyInput& input, const CalibrationResult& result, RunLog& log) {
    for (std::size_t e = 0; e < input.events(); ++e)
        log.info(input.spec().events[e].name + ": score " + number_text(result.events[e].fitted.best_score, 3) +
                 ", Q2 " + number_text(result.q2[e], 3));
}

}  // namespace

StudyOutcome publish_calibration(const StudyInput& input, const CalibrationRuns& runs, int threads,
                                 const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log) {
    CalibrationResult result = calibration_result(input, runs);
    check_schemes(input, runs, threads, result);
    for (const Sentence& doubt : result.doubts) log.warn(doubt);
    StudyFacts facts;
    const StudyOutcome outcome = tell_of_runs(input, runs.runs(), k_posterior_table, facts, log);
    facts.threads = threads;
    facts.computed = runs.computed;
    write_study_file(input, directory);
    write_text_file(directory.path(k_posterior_table), posterior_csv(input, runs, result));
    for (std::size_t e = 0; input.events() > 1 && e < input.events(); ++e)
        if (const EventSpec& event = input.spec().events[e]; !event.vary.empty())
            write_text_file(directory.path(posterior_of(event.name)), event_posterior_csv(input, runs, result, e));
    write_text_file(directory.path(k_calibration_file), calibration_json(input, runs, result));
    write_best_scenes(input, result, directory);
    publish_calibration_maps(input, runs, result, facts.troubles, directory, log);
    draw_calibration_charts(input, result, directory, log);
    tell(input, result, log);
    facts.warnings += log.take_warnings();
    facts.wall_seconds = since_start.seconds();
    if (input.own.front().base.spec.output.report) write_calibration_report(input, runs, result, facts, directory);
    write_text_file(directory.path(k_summary_file), calibration_summary_json(input, runs, facts));
    write_text_file(directory.path(k_log_file), log.text());
    return outcome;
}

}  // namespace frana::app::study
