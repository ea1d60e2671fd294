// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_calibration.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

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

namespace frana::app::study {
namespace {

/// @param study of the keys, in the order of the places' coordinates
KeyDraws key_draws(const StudyReading& reading, const StudySpec& study, const std::string& event,
                   const PosteriorSample& sample) {
    Problems of_values;  // told of the members
    KeyDraws draws{event,
                   study.vary,
                   samples_at(study, sample.places, reading.label, of_values),
                   sample.weights,
                   {},
                   {},
                   samples_at(study, evenly_drawn(sample, k_draws), reading.label, of_values)};
    draws.posteriors = key_posteriors(draws.keys, draws.sample, draws.weights, event);
    draws.indistinct = indistinct_pairs(draws.sample, draws.weights);
    return draws;
}

/// Another slope: the keys that all events have.
KeyDraws next_slope(const StudyReading& reading, const PosteriorSample& sample) {
    StudySpec next = reading.study.of_event(0);
    next.vary = reading.study.vary;
    std::erase_if(next.correlate, [&](const Correlation& one) {
        return std::count_if(next.vary.begin(), next.vary.end(),
                             [&](const Variation& key) { return key.key == one.first || key.key == one.second; }) < 2;
    });
    return key_draws(reading, next, "", sample);
}

Scores scores_of(const std::vector<double>& scores, double variance_of_each = 0) {
    FinishedMembers alike;
    alike.weights.assign(scores.size(), 1 / static_cast<double>(scores.size()));
    const Estimate mean = MeanEstimate(alike).mean(scores);
    return {mean.value, weighted_quantile(scores, alike.weights, 0.05), weighted_quantile(scores, alike.weights, 0.95),
            std::sqrt(mean.error * mean.error + variance_of_each)};
}

/// Predicts the scores at an event from the surveys of the others. Its own keys keep their distributions.
void predict(const StudyInput& input, const CalibrationRuns& runs, std::size_t event, EventResult& result) {
    const EventRuns& own = runs.events[event];
    std::vector<PosteriorSample> others = runs.alone;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(event));
    const StudySpec& calibration = input.spec();
    const PosteriorSample next = population_of(calibration.vary, std::move(others), calibration.seed).next;
    result.predicted_keys = next_slope(input.reading, next).posteriors;
    Places places = evenly_drawn(next, k_draws);
    if (StudySpec of_own = calibration; !calibration.events[event].vary.empty()) {
        of_own.vary = calibration.events[event].vary;
        of_own.samples = static_cast<std::int64_t>(places.size());
        const Places drawn = draw_places(of_own);
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i].insert(places[i].end(), drawn[i].begin(), drawn[i].end());
    }
    std::vector<double> misfits, scores;
    for (std::size_t i = 0; i < own.searched; ++i) misfits.push_back(own.agreements[i].misfit);
    double variance = 0;
    for (const Prediction& one : emulator_of(calibration.of_event(event).vary, own.places, misfits).at(places)) {
        scores.push_back(1 - std::min(one.mean, 1.0));
        variance += one.variance / static_cast<double>(places.size());
    }
    result.predicted = scores_of(scores, variance);
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

/// How far inside or outside of all runs the outline of an event is, if that explains it: a shift of the outline has
/// one value, so that without one chi^2 is less by more than 3.84 in one of 20 surveys only.
/// @param widening of the stated errors, by which chi^2 is too great
std::optional<double> outline_bias(const EventRuns& runs, double widening) {
    constexpr double k_unlikely = 3.84;
    const MemberAgreement *best = nullptr, *shifted = nullptr;
    for (std::size_t i = 0; i < runs.searched; ++i) {
        const MemberAgreement& one = runs.agreements[i];
        if (std::isnan(one.chi_square)) continue;
        if (best == nullptr || one.chi_square < best->chi_square) best = &one;
        if (shifted == nullptr || one.unshifted < shifted->unshifted) shifted = &one;
    }
    if (best == nullptr || !(best->chi_square - shifted->unshifted > k_unlikely * widening * widening))
        return std::nullopt;
    return shifted->outside;
}

/// Whether no forecast run agrees as well as half of the search does: the posterior lies where the search hardly was.
bool is_beside(const EventRuns& runs) {
    std::vector<double> misfits;
    for (const MemberAgreement& one : runs.agreements) misfits.push_back(std::isnan(one.misfit) ? 1 : one.misfit);
    const auto forecast = misfits.begin() + static_cast<std::ptrdiff_t>(runs.searched);
    if (forecast == misfits.end() || forecast == misfits.begin()) return false;
    const double least = *std::min_element(forecast, misfits.end());
    std::sort(misfits.begin(), forecast);
    return least > misfits[runs.searched / 2];
}

/// Says what is doubtful of the search and the survey of an event.
void judge(const StudyInput& input, const CalibrationRuns& runs, std::size_t e, std::vector<StudyDoubt>& doubts) {
    const std::string& name = input.spec().events[e].name;
    const EventRuns& event = runs.events[e];
    const double factor = runs.models[e].widening(), q2 = runs.models[e].q2();
    if (factor > 1)
        doubts.push_back({"survey-error", name, "", factor,
                          worded("{1}: best run off by {2} times the survey's error: error raised",
                                 {name, short_number(factor, 2)})});
    if (const auto outside = event.is_stated() ? outline_bias(event, factor) : std::nullopt)
        doubts.push_back({"outline-bias", name, "", *outside,
                          worded("{1}: outline {2} m off all runs (+: outside): state perimeter-bias",
                                 {name, short_number(*outside, 2)})});
    if (!(q2 >= k_least_q2))
        doubts.push_back({"emulator", name, "", q2,
                          worded("{1}: runs predict others poorly (Q2 {2}, under {3}): raise study.samples",
                                 {name, short_number(q2, 2), short_number(k_least_q2)})});
    if (is_beside(event))
        doubts.push_back(
            {"beside", name, "", 0,
             worded("{1}: forecast runs agree less than half of the search: raise study.samples", {name})});
    if (!event.has_settled())
        doubts.push_back(
            {"unsettled", name, "", event.moves[1],
             worded("{1}: {2}", {name, worded("intervals not within {2} % after {1} members: raise study.samples",
                                              {std::to_string(event.searched), short_number(100 * k_settled)})})});
}

}  // namespace

CalibrationResult calibration_result(const StudyInput& input, const CalibrationRuns& runs) {
    const StudySpec& calibration = input.spec();
    CalibrationResult result;
    if (troubles_of(runs.runs(), false).open > 0)
        result.doubts.push_back(
            {"unfinished", "", "", 0, worded("scores and posterior are of flows partly unfinished: raise time.end")});
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& of_event = runs.events[e];
        EventResult& event = result.events.emplace_back();
        event.after =
            key_draws(input.reading, calibration.of_event(e), calibration.events[e].name, runs.population.events[e]);
        event.best = *runs.models[e].best();  // run_calibration() ends without one
        event.best_score = 1 - of_event.agreements[event.best].misfit;
        std::vector<double> scores;
        for (std::size_t i = of_event.searched; i < of_event.agreements.size(); ++i)
            scores.push_back(std::isnan(of_event.agreements[i].misfit) ? 0 : 1 - of_event.agreements[i].misfit);
        event.fitted = scores_of(scores);
        if (of_event.is_stated()) event.uncounted = uncounted(input, runs, e);
        if (input.events() > 1) predict(input, runs, e, event);
        judge(input, runs, e, result.doubts);
        for (StudyDoubt& doubt : edge_doubts(event.after.posteriors)) result.doubts.push_back(std::move(doubt));
    }
    result.next = next_slope(input.reading, runs.population.next);
    if (input.events() == 1)
        result.spread = worded("new-slope: spread between slopes assumed, one event does not constrain it");
    return result;
}

std::vector<Variation> keys_of(const StudySpec& calibration) {
    std::vector<Variation> all = calibration.vary;
    for (const EventSpec& event : calibration.events)
        for (const Variation& one : event.vary)
            if (std::none_of(all.begin(), all.end(), [&](const Variation& other) { return other.key == one.key; }))
                all.push_back(one);
    return all;
}

namespace {

/// Adds a member's values to a row, empty where the key is not one of its own.
void add_values(const std::vector<Variation>& keys, const SampleTable& table, std::size_t member,
                std::vector<MemberCell>& row) {
    for (const Variation& key : keys) {
        const auto found = std::find(table.keys.begin(), table.keys.end(), key.key);
        const auto at = static_cast<std::size_t>(found - table.keys.begin());
        row.push_back({key.key, found == table.keys.end() ? "" : table.values[member][at]});
    }
}

Json json_of(const KeyPosterior& key) {
    Json json{{"for", key.event.empty() ? k_new_slope : k_this_event}, {"key", key.key}};
    if (!key.event.empty()) json["event"] = key.event;
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

Json json_of(const Scores& scores) {
    return {{"mean_score", scores.mean}, {"q05", scores.low}, {"q95", scores.high}, {"standard_error", scores.error}};
}

/// Returns posterior.csv: k_draws equal draws for each event again, and as many for another slope, which an ensemble
/// takes with sampling = table:FILE and study.for. Lines before the header say what is doubtful: it repeats them.
std::string posterior_csv(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result) {
    const Troubles troubles = troubles_of(runs.runs(), false);
    std::string text = troubles.any() ? "# " + one_line(headline(troubles).text()) + "\n" : "";
    for (const StudyDoubt& doubt : result.doubts) text += "# " + one_line(doubt.text.text()) + "\n";
    if (result.spread) text += "# " + one_line(result.spread->text()) + "\n";
    const std::vector<Variation> keys = keys_of(input.spec());
    std::vector<std::vector<MemberCell>> rows;
    const auto add = [&](const KeyDraws& draws) {
        for (std::size_t i = 0; i < draws.draws.size(); ++i) {
            auto& row = rows.emplace_back();
            row = {{k_for_column, draws.event.empty() ? k_new_slope : k_this_event}, {k_event_column, draws.event}};
            add_values(keys, draws.draws, i, row);
        }
    };
    for (const EventResult& event : result.events) add(event.after);
    add(result.next);
    return text + csv_of(rows);
}

/// Returns members.csv: a row for each run of each event with its values, score and misfits, and how it ended.
std::string members_csv(const StudyInput& input, const CalibrationRuns& runs) {
    const StudySpec& calibration = input.spec();
    const std::vector<Variation> keys = keys_of(calibration);
    std::vector<std::vector<MemberCell>> rows;
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& event = runs.events[e];
        for (std::size_t i = 0; i < event.members.size(); ++i) {
            const MemberRecord& one = event.members[i];
            auto& row = rows.emplace_back();
            row = {{"event", calibration.events[e].name},
                   {"member", std::to_string(i)},
                   {"use", i < event.searched ? "search" : "forecast"},
                   {"status", one.failure.empty() ? "finished" : "failed"},
                   {"score", cell_of(1 - event.agreements[i].misfit)}};
            add_values(keys, input.own[e].table, i, row);
            for (const Weight& measure : calibration.objective) {
                const auto found = std::find_if(event.measures.begin(), event.measures.end(),
                                                [&](const Weight& own) { return own.measure == measure.measure; });
                const auto at = static_cast<std::size_t>(found - event.measures.begin());
                const bool has_part = found != event.measures.end() && one.failure.empty();
                row.push_back({std::string("misfit ") + row_of(measure.measure).name,
                               has_part ? cell_of(event.agreements[i].parts[at]) : ""});
            }
            add_end(one, row);
        }
    }
    return csv_of(rows);
}

Json event_json(const StudyInput& input, const CalibrationRuns& all, const CalibrationResult& result, std::size_t e) {
    const StudySpec& calibration = input.spec();
    const EventRuns& runs = all.events[e];
    const EventResult& event = result.events[e];
    Json json{{"name", calibration.events[e].name},
              {"scene", calibration.events[e].scene},
              {"cell_size", input.own[e].base.scene.grid.cell_size},
              {"members", runs.searched},
              {"has_settled", runs.has_settled()},
              {"moves", {runs.moves[0], runs.moves[1]}},
              {"stated_errors", runs.is_stated()},
              {"pieces", runs.is_stated() ? runs.pieces : calibration.exponent},
              {"q2", all.models[e].q2()},
              {"error_factor", all.models[e].widening()},
              {"uncounted", event.uncounted},
              {"best_member", event.best},
              {"best_score", event.best_score},
              {"fitted", json_of(event.fitted)}};
    const SampleTable& table = input.own[e].table;
    for (std::size_t k = 0; k < table.keys.size(); ++k) json["best"][table.keys[k]] = table.values[event.best][k];
    if (runs.observed_runout > 0) json["observed_runout_m"] = runs.observed_runout;
    const MemberAgreement& best = runs.agreements[event.best];
    if (runs.is_stated()) json["best_chi_square"] = best.chi_square;
    for (std::size_t m = 0; m < runs.measures.size(); ++m)
        json["best_misfits"][row_of(runs.measures[m].measure).name] = best.parts[m];
    json["scheme"] = scheme_json(input.own[e]);
    if (event.scheme_check) json["scheme_check"] = check_json(*event.scheme_check);
    if (event.predicted) {
        json["leave_one_out"] = json_of(*event.predicted);
        for (const KeyPosterior& key : event.predicted_keys) json["leave_one_out"]["intervals"].push_back(json_of(key));
    }
    return json;
}

/// Returns calibration.json: intervals, scores by event, fitted and predicted. No wall time is in it.
std::string calibration_json(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result) {
    const StudySpec& calibration = input.spec();
    double best = 0;
    for (const EventResult& event : result.events) best += event.best_score / static_cast<double>(input.events());
    Json json{{"format", k_result_format}, {"best_score", best}};
    Json& objective = json["objective"] = Json::object();
    for (const Weight& one : calibration.objective) objective[row_of(one.measure).name] = one.weight;
    json["intervals"] = json["indistinct"] = json["events"] = json["warnings"] = Json::array();
    const auto add = [&](const KeyDraws& draws) {
        for (const KeyPosterior& key : draws.posteriors) json["intervals"].push_back(json_of(key));
        for (const IndistinctPair& pair : draws.indistinct)
            json["indistinct"].push_back({{"event", draws.event},
                                          {"first", draws.keys[pair.first].key},
                                          {"second", draws.keys[pair.second].key},
                                          {"correlation", pair.correlation}});
    };
    for (std::size_t e = 0; e < input.events(); ++e) {
        add(result.events[e].after);
        json["events"].push_back(event_json(input, runs, result, e));
    }
    add(result.next);
    // Of the population of slopes: parts of the distributions' own spread.
    for (std::size_t k = 0; k < calibration.vary.size(); ++k)
        if (const Interval& spread = runs.population.spread[k]; !std::isnan(spread.value))
            json["spread"].push_back({{"key", calibration.vary[k].key},
                                      {"from", input.events() > 1 ? "events" : "assumed"},
                                      {"q05", spread.low},
                                      {"q50", spread.value},
                                      {"q95", spread.high}});
    for (const StudyDoubt& doubt : result.doubts)
        json["warnings"].push_back({{"kind", doubt.kind},
                                    {"event", doubt.event},
                                    {"key", doubt.key},
                                    {"value", doubt.value},
                                    {"text", doubt.text.text()}});
    return json_text(json);
}

std::string calibration_summary_json(const StudyInput& input, const CalibrationRuns& runs, const StudyFacts& facts) {
    Json json = summary_head(input, facts);
    json["samples"] = input.spec().samples;
    json["runs"] = runs.runs().size();
    json["failed_runs"] = failed_of(runs.runs());
    return json_text(json);
}

/// Computes draws of the posterior by the other scheme, for each event.
void check_schemes(const StudyInput& input, const CalibrationRuns& runs, int threads, CalibrationResult& result) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& event = runs.events[e];
        std::vector<double> weights(event.members.size(), 1);
        std::fill_n(weights.begin(), event.searched, 0);
        auto& check = result.events[e].scheme_check = check_scheme(input.own[e], event.members, weights, threads);
        const std::string& name = input.spec().events[e].name;
        if (const auto doubt = check ? warning_of(*check, false) : std::nullopt)
            result.doubts.push_back({"scheme", name, "", 0, worded("{1}: {2}", {name, *doubt})});
    }
}

void write_best_scenes(const StudyInput& input, const CalibrationResult& result, const ResultDirectory& directory) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const std::string name = input.events() == 1 ? k_best_scene : best_scene_of(input.spec().events[e].name);
        write_text_file(directory.path(name),
                        echoed_scene(input.own[e].member(result.events[e].best).scene, directory.target()));
    }
}

void tell(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result, RunLog& log) {
    for (std::size_t e = 0; e < input.events(); ++e)
        log.info(input.spec().events[e].name + ": score " + number_text(result.events[e].best_score, 3) + ", Q2 " +
                 number_text(runs.models[e].q2(), 3));
}

}  // namespace

StudyOutcome publish_calibration(const StudyInput& input, const CalibrationRuns& runs, int threads,
                                 const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log) {
    CalibrationResult result = calibration_result(input, runs);
    check_schemes(input, runs, threads, result);
    StudyFacts facts;
    const Findings found{log, facts.warnings};
    for (const auto& [kind, event, key, value, sentence] : result.doubts) found.warn(sentence);
    const StudyOutcome outcome = tell_of_runs(input, runs.runs(), k_member_table, facts, log);
    facts.threads = threads;
    facts.computed = runs.computed;
    write_study_file(input, directory);
    write_text_file(directory.path(k_posterior_table), posterior_csv(input, runs, result));
    write_text_file(directory.path(k_member_table), members_csv(input, runs));
    write_text_file(directory.path(k_calibration_file), calibration_json(input, runs, result));
    write_best_scenes(input, result, directory);
    publish_calibration_maps(input, runs, result, facts.troubles, directory, found);
    draw_calibration_charts(input, result, directory, found);
    tell(input, runs, result, log);
    facts.wall_seconds = since_start.seconds();
    if (input.own.front().base.spec.output.report) write_calibration_report(input, runs, result, facts, directory);
    write_text_file(directory.path(k_summary_file), calibration_summary_json(input, runs, facts));
    write_text_file(directory.path(k_log_file), log.text());
    return outcome;
}

}  // namespace frana::app::study
