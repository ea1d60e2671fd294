// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/calibration_result.h"

#include <cmath>
#include <numeric>

#include "app/study/statistics/cell_statistics.h"
#include "app/text/number_text.h"

namespace frana::app::study {
namespace {

/// The scores at one event, 0 for members that failed there.
std::vector<double> scores_at(const Misfits& misfits, std::size_t event) {
    std::vector<double> scores;
    for (const auto& one : misfits) scores.push_back(std::isnan(one[event]) ? 0 : 1 - one[event]);
    return scores;
}

Explained explained(const Misfits& misfits, const Stage& stage, double exponent, std::size_t event,
                    std::optional<std::size_t> without, const std::vector<KeySample>& keys) {
    Explained result;
    const double supported = supported_exponent(misfits, stage.density, exponent, without);
    std::vector<double> weights = posterior_weights(misfits, stage.density, supported, without);
    if (without) {  // members that failed at the event itself predict nothing of it
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (std::isnan(misfits[i][event])) weights[i] = 0;
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
        if (sum > 0)
            for (double& weight : weights) weight /= sum;
    }
    const auto best = best_member(misfits, without);
    result.effective = effective_count(weights);
    if (!best || result.effective == 0) return result;
    const std::vector<double> scores = scores_at(misfits, event);
    result.possible = true;
    result.best = *best;
    result.best_score = scores[*best];
    result.mean = std::inner_product(scores.begin(), scores.end(), weights.begin(), 0.0);
    result.low = weighted_quantile(scores, weights, 0.05);
    result.high = weighted_quantile(scores, weights, 0.95);
    result.posteriors = key_posteriors(keys, weights);
    return result;
}

std::vector<KeySample> key_samples(const CalibrationInput& input, const Stage& stage) {
    const CalibrationSpec& calibration = input.spec();
    std::vector<KeySample> keys;
    const auto add = [&](const Variation& one, const std::string& event, std::size_t table, std::size_t column) {
        KeySample& key = keys.emplace_back(KeySample{one.key, event, one.distribution, {}, {}, {}});
        const SampleTable& values = stage.tables[table];
        for (std::size_t i = 0; i < values.size(); ++i) {
            key.places.push_back(values.places[i][column]);
            key.numbers.push_back(values.numbers[i][column]);
            key.texts.push_back(values.values[i][column]);
        }
    };
    const std::size_t shared = calibration.study.vary.size();
    for (std::size_t k = 0; k < shared; ++k) add(calibration.study.vary[k], "", 0, k);
    for (std::size_t e = 0; e < calibration.events.size(); ++e)
        for (std::size_t k = 0; k < calibration.events[e].vary.size(); ++k)
            add(calibration.events[e].vary[k], calibration.events[e].name, e, shared + k);
    return keys;
}

}  // namespace

double score_of(const std::vector<double>& misfits) {
    double sum = 0;
    for (const double misfit : misfits) sum += 1 - misfit;
    return sum / static_cast<double>(misfits.size());
}

std::string column_of(const CalibrationSpec& calibration, const KeySample& key) {
    return key.event.empty() || calibration.events.size() == 1 ? key.key : key.key + " of " + key.event;
}

CalibrationResult calibration_result(const CalibrationInput& input, const CalibrationRuns& runs) {
    const Stage& stage = runs.last();
    const double exponent = input.spec().exponent;
    const Misfits misfits = stage.misfits();
    CalibrationResult result;
    const auto best = best_member(misfits);
    if (!best)
        throw Error(ErrorKind::numerical, Problem{"no member finished for all events at once", input.reading.label, "",
                                                  "", "Narrow the ranges in [vary], or raise study.refine"});
    result.best = *best;
    result.exponent = supported_exponent(misfits, stage.density, exponent);
    result.weights = posterior_weights(misfits, stage.density, result.exponent);
    result.effective = effective_count(result.weights);
    result.keys = key_samples(input, stage);
    result.posteriors = key_posteriors(result.keys, result.weights);
    result.indistinct = indistinct_pairs(result.keys, result.weights);
    result.sentences = sentences(result.posteriors, result.indistinct);
    if (result.exponent < exponent)
        result.sentences.push_back(worded(
            "Few of the members explain the surveys: the exponent of the likelihood is lowered from {1} to {2} so that "
            "{3} of them count. The intervals are wider than the surveys allow; raise study.refine.",
            {numeral(number_text(exponent)), numeral(number_text(result.exponent, 2)),
             numeral(number_text(result.effective, 2))}));
    for (std::size_t e = 0; e < input.events(); ++e) {
        EventResult& event = result.events.emplace_back();
        event.fitted = explained(misfits, stage, exponent, e, std::nullopt, result.keys);
        if (input.events() > 1) event.predicted = explained(misfits, stage, exponent, e, e, result.keys);
    }
    return result;
}

}  // namespace frana::app::study
