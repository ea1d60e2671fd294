// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/calibration_posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "app/study/openturns/functions.h"
#include "app/text/number_text.h"

namespace frana::app::study {
namespace {

constexpr double k_least_weight = 1e-4;  // of the greatest
constexpr double k_low = 0.05, k_high = 0.95;
constexpr double k_edge = 0.02;  // of a distribution, next to its limit

constexpr std::size_t k_sample = 3000;     // places of a posterior
constexpr std::size_t k_kernels = 100;     // of a proposal
constexpr double k_least_effective = 200;  // of a tempered sample
constexpr std::size_t k_candidates = 200;  // draws among which next members are chosen
constexpr int k_most_rounds = 12;

void add_interval(const Variation& key, const std::vector<double>& numbers, const std::vector<double>& places,
                  const std::vector<double>& weights, KeyPosterior& to) {
    to.low = weighted_quantile(numbers, weights, k_low);
    to.median = weighted_quantile(numbers, weights, 0.5);
    to.high = weighted_quantile(numbers, weights, k_high);
    to.width =
        (weighted_quantile(places, weights, k_high) - weighted_quantile(places, weights, k_low)) / (k_high - k_low);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        to.share_low += places[i] < k_edge ? weights[i] : 0;
        to.share_high += places[i] > 1 - k_edge ? weights[i] : 0;
    }
    const std::vector<double> prior = openturns().quantiles(key.distribution, {k_low, k_high});
    to.prior_low = prior[0];
    to.prior_high = prior[1];
}

Sentence name_of(const KeyPosterior& key) {
    return key.event.empty() ? Sentence(key.key) : worded("{1} of {2}", {key.key, key.event});
}

Sentence short_number(double value) {
    return numeral(number_text(value, 3));
}

}  // namespace

std::vector<double> weights_of(const std::vector<double>& log_likelihood, const std::vector<double>& density,
                               double power) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < density.size(); ++i)
        weights.push_back(std::isinf(log_likelihood[i]) ? log_likelihood[i]
                                                        : power * log_likelihood[i] - std::log(density[i]));
    const double greatest = *std::max_element(weights.begin(), weights.end());
    if (std::isinf(greatest)) return std::vector<double>(weights.size(), 0.0);
    double sum = 0;
    for (double& weight : weights) {
        weight = std::exp(weight - greatest);
        if (weight < k_least_weight) weight = 0;
        sum += weight;
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

namespace {

/// The greatest power up to 1 with which enough places have weight: tempering, as in sequential Monte Carlo (Del Moral,
/// Doucet and Jasra 2006).
double supported_power(const std::vector<double>& log_likelihood, const std::vector<double>& density) {
    const auto suffices = [&](double tried) {
        return effective_count(weights_of(log_likelihood, density, tried)) >= k_least_effective;
    };
    if (suffices(1)) return 1;
    double low = 0, high = 1;
    constexpr int k_halvings = 40;
    for (int i = 0; i < k_halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (suffices(middle) ? low : high) = middle;
    }
    return low;
}

std::vector<double> deviations(const Places& places, const std::vector<double>& weights) {
    std::vector<double> all;
    for (std::size_t k = 0; k < places.front().size(); ++k) {
        const std::vector<double> values = column_of(places, k);
        const double mean = std::inner_product(values.begin(), values.end(), weights.begin(), 0.0);
        double variance = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
            variance += weights[i] * (values[i] - mean) * (values[i] - mean);
        all.push_back(std::max(1e-3, std::sqrt(variance)));
    }
    return all;
}

/// Square of the distance of two places, measured in widths.
double square_between(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& widths) {
    double square = 0;
    for (std::size_t k = 0; k < a.size(); ++k) square += (a[k] - b[k]) * (a[k] - b[k]) / (widths[k] * widths[k]);
    return square;
}

std::size_t nearest(const Places& places, const std::vector<double>& to, const std::vector<double>& widths) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double square = square_between(places[i], to, widths);
        if (square < least) {
            least = square;
            best = i;
        }
    }
    return best;
}

}  // namespace

std::vector<std::size_t> drawn(const std::vector<double>& weights, std::size_t count) {
    std::vector<std::size_t> draws;
    double below = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        below += weights[i];
        while (draws.size() < count && (static_cast<double>(draws.size()) + 0.5) / static_cast<double>(count) < below)
            draws.push_back(i);
    }
    return draws;
}

Places evenly_drawn(const PosteriorSample& sample, std::size_t count) {
    std::vector<std::string> codes(sample.places.size());  // bits of all keys in turn: Morton's order
    for (std::size_t i = 0; i < codes.size(); ++i)
        for (int bit = 1; bit <= 20; ++bit)
            for (const double at : sample.places[i])
                codes[i] += static_cast<int>(std::ldexp(at, bit)) % 2 == 0 ? '0' : '1';
    std::vector<std::size_t> order(codes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return codes[a] < codes[b]; });
    std::vector<double> weights;
    for (const std::size_t i : order) weights.push_back(sample.weights[i]);
    Places all;
    for (const std::size_t i : drawn(weights, count)) all.push_back(sample.places[order[i]]);
    return all;
}

double greatest_move(const PosteriorSample& before, const PosteriorSample& after) {
    double greatest = 0;
    for (std::size_t k = 0; k < after.places.front().size(); ++k)
        for (const double q : {k_low, 0.5, k_high})
            greatest = std::max(greatest, std::abs(weighted_quantile(column_of(after.places, k), after.weights, q) -
                                                   weighted_quantile(column_of(before.places, k), before.weights, q)));
    return greatest;
}

namespace {

/// A choice has a coordinate of 0 and 1 for each of its values; an error field is none: it is an error of the values.
Places coordinates(const std::vector<Variation>& keys, const Places& places) {
    Places all;
    for (const std::vector<double>& place : places) {
        std::vector<double>& one = all.emplace_back();
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const Distribution& key = keys[k].distribution;
            if (key.law == Law::gaussian_field) continue;
            if (key.law != Law::choice) one.push_back(place[k]);
            double below = 0;
            for (const double weight : key.weights) {
                one.push_back(place[k] >= below && place[k] < below + weight ? 1 : 0);
                below += weight;
            }
        }
    }
    return all;
}

}  // namespace

Emulator emulator_of(const std::vector<Variation>& keys, const Places& places, const std::vector<double>& distances) {
    Places at;
    std::vector<double> values;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        if (std::isnan(distances[i])) continue;
        at.push_back(places[i]);
        values.push_back(distances[i]);
    }
    if (values.empty()) return {std::nan(""), 0, {}};
    Emulator emulator = openturns().emulator(coordinates(keys, at), values);
    emulator.at = [keys, of_coordinates = emulator.at](const Places& to) {
        return of_coordinates(coordinates(keys, to));
    };
    return emulator;
}

EventModel::EventModel(std::vector<Variation> keys, Places places, EventEvidence evidence, Places prior,
                       std::int64_t seed)
    : keys_(std::move(keys)),
      places_(std::move(places)),
      prior_(std::move(prior)),
      evidence_(std::move(evidence)),
      emulator_(emulator_of(keys_, places_, evidence_.distances)),
      seed_(seed) {
    const auto is_field = [](const Variation& key) { return key.distribution.law == Law::gaussian_field; };
    if (std::none_of(keys_.begin(), keys_.end(), is_field)) emulator_.noise = 0;
}

EventModel::LogLikelihood EventModel::log_likelihood(const Prediction& distance, double widened) const {
    const double n = evidence_.pieces, all = distance.variance + emulator_.noise;
    if (!evidence_.is_stated) {
        const double square = std::max(distance.mean * distance.mean + all, k_least_misfit * k_least_misfit),
                     log = -n / 2 * std::log(square);
        return {log, log, n * n * distance.variance / square};
    }
    const double scale = widened * widened * widened, square = distance.mean * distance.mean / scale,
                 variance = all / scale;
    return {-(std::log1p(variance) + square / (1 + variance)) / 2, -(square + variance) / 2,
            square * variance + variance * variance / 2};
}

std::optional<std::size_t> EventModel::best() const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < places_.size(); ++i)
        if (const double one = evidence_.distances[i]; !std::isnan(one) && (!best || one < evidence_.distances[*best]))
            best = i;
    return best;
}

double EventModel::widening() const {
    const auto nearest = best();
    if (!nearest || !evidence_.is_stated) return 1;
    // Of a gamma distribution of the least chi^2, by Wilson and Hilferty; each key that is fitted takes 1 of the mean.
    constexpr double k_95_percent = 1.6449;
    const double n = evidence_.pieces, square = std::pow(evidence_.distances[*nearest], 2),
                 mean = std::max(n / 2, n - static_cast<double>(keys_.size())),
                 cubed = evidence_.scatter * evidence_.scatter / (9 * n * mean),
                 greatest = mean * std::pow(1 - cubed + k_95_percent * std::sqrt(cubed), 3);
    return square > std::max(n, greatest) ? std::sqrt(square / n) : 1;
}

std::vector<EventModel::LogLikelihood> EventModel::log_likelihoods(const Places& at) const {
    std::vector<LogLikelihood> all(at.size());
    if (!emulator_.at) return all;
    const double widened = widening();
    const std::vector<Prediction> distances = emulator_.at(at);
    const std::vector<double> alike(keys_.size(), 1);
    for (std::size_t i = 0; i < at.size(); ++i) {
        all[i] = log_likelihood(distances[i], widened);
        if (std::isnan(evidence_.distances[nearest(places_, at[i], alike)]))
            all[i].of_mean = all[i].mean = -std::numeric_limits<double>::infinity();
    }
    return all;
}

PosteriorSample EventModel::sample() const {
    if (!best()) return {prior_, std::vector<double>(prior_.size())};
    RefinedPlaces now{prior_, std::vector<double>(prior_.size(), 1)};
    for (int round = 0;; ++round) {
        std::vector<double> logs;
        for (const LogLikelihood& one : log_likelihoods(now.places)) logs.push_back(one.of_mean);
        const double power = supported_power(logs, now.density);
        const bool is_last = (power == 1 && round >= 2) || round == k_most_rounds;
        const std::vector<double> weights = weights_of(logs, now.density, is_last ? 1 : power);
        if (is_last || effective_count(weights) == 0) return {std::move(now.places), weights};
        std::vector<double> thinned(weights.size());
        for (const std::size_t i : drawn(weights, k_kernels)) thinned[i] += 1.0 / static_cast<double>(k_kernels);
        now = refined_places(now.places, thinned, k_sample, seed_ + round);
    }
}

Places EventModel::next(std::size_t count) const {
    const PosteriorSample posterior = sample();
    const std::vector<double> widths = deviations(posterior.places, posterior.weights);
    Places chosen;
    const auto choose = [&](const Places& among, const std::vector<double>& gains) {
        std::size_t best = 0;
        double greatest = -1;
        for (std::size_t i = 0; i < among.size(); ++i) {
            double gain = gains[i];
            for (const auto& one : chosen) gain *= 1 - std::exp(-square_between(one, among[i], widths));
            if (!(gain > greatest)) continue;
            greatest = gain;
            best = i;
        }
        chosen.push_back(among[best]);
    };
    const double so_far = log_likelihood({evidence_.distances[*best()], 0}, widening()).mean;
    std::vector<double> improvements;
    for (const LogLikelihood& one : log_likelihoods(posterior.places)) {
        const double deviation = std::sqrt(one.variance), z = (one.mean - so_far) / std::max(deviation, 1e-12);
        improvements.push_back(deviation *
                               (z * normal_below(z) + std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi)));
    }
    for (double& one : improvements)
        if (!std::isfinite(one)) one = 0;
    choose(posterior.places, improvements);
    Places among;
    for (const std::size_t i : drawn(posterior.weights, k_candidates)) among.push_back(posterior.places[i]);
    std::vector<double> variances;
    for (const LogLikelihood& one : log_likelihoods(among)) variances.push_back(one.variance);
    while (chosen.size() < count) choose(among, variances);
    return chosen;
}

std::vector<KeyPosterior> key_posteriors(const std::vector<Variation>& keys, const SampleTable& draws,
                                         const std::vector<double>& weights, const std::string& event) {
    std::vector<KeyPosterior> all;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        KeyPosterior& one = all.emplace_back();
        one.key = keys[k].key;
        one.event = event;
        one.nominal = draws.nominal[k];
        if (!one.nominal) add_interval(keys[k], column_of(draws.numbers, k), column_of(draws.places, k), weights, one);
        for (const std::string& value : keys[k].distribution.values) {
            if (!one.nominal) break;
            double sum = 0;
            for (std::size_t i = 0; i < weights.size(); ++i) sum += draws.values[i][k] == value ? weights[i] : 0;
            one.values.emplace_back(value, sum);
        }
    }
    return all;
}

std::vector<IndistinctPair> indistinct_pairs(const SampleTable& draws, const std::vector<double>& weights) {
    std::vector<IndistinctPair> pairs;
    for (std::size_t a = 0; a < draws.keys.size(); ++a)
        for (std::size_t b = a + 1; b < draws.keys.size(); ++b) {
            if (draws.nominal[a] || draws.nominal[b]) continue;
            const double rho = correlation(column_of(draws.places, a), column_of(draws.places, b), weights);
            if (std::abs(rho) >= k_indistinct_correlation) pairs.push_back({a, b, rho});
        }
    std::stable_sort(pairs.begin(), pairs.end(), [](const IndistinctPair& one, const IndistinctPair& other) {
        return std::abs(one.correlation) > std::abs(other.correlation);
    });
    return pairs;
}

std::vector<Sentence> sentences(const std::vector<KeyPosterior>& keys, const std::vector<IndistinctPair>& pairs) {
    std::vector<Sentence> all;
    for (const IndistinctPair& pair : pairs)
        all.push_back(worded("{1}, {2}: correlation {3}",
                             {name_of(keys[pair.first]), name_of(keys[pair.second]), short_number(pair.correlation)}));
    return all;
}

std::vector<StudyDoubt> edge_doubts(const std::vector<KeyPosterior>& keys) {
    std::vector<StudyDoubt> all;
    for (const KeyPosterior& key : keys) {
        const bool is_low = key.share_low > 1 - k_high, is_high = key.share_high > 1 - k_high;
        if (key.nominal || is_low == is_high) continue;
        all.push_back({"prior-limit", key.event, key.key, is_low ? key.share_low : key.share_high,
                       worded("{1} at the limit {2} of its distribution: widen [vary]",
                              {name_of(key), short_number(is_low ? key.low : key.high)})});
    }
    return all;
}

std::vector<double> kernel_widths(const Places& places, const std::vector<double>& weights, double least) {
    std::vector<double> widths = deviations(places, weights);
    const double shrink = std::pow(effective_count(weights), -1.0 / (static_cast<double>(widths.size()) + 4));
    for (double& width : widths) width = std::max(least, width * shrink);
    return widths;
}

RefinedPlaces refined_places(const Places& design, const std::vector<double>& weights, std::size_t count,
                             std::int64_t seed) {
    constexpr double k_prior_part = 0.2, k_least_width = 0.02;
    return openturns().refined(design, weights, kernel_widths(design, weights, k_least_width), k_prior_part, count,
                               seed);
}

}  // namespace frana::app::study
