// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/calibration_posterior.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "app/study/openturns/functions.h"
#include "app/study/statistics/cell_statistics.h"

namespace frana::app::study {
namespace {

constexpr double k_least_weight = 1e-4;  // of the greatest
constexpr double k_few_members = 20;     // effective number below which intervals are doubtful
constexpr double k_low = 0.05, k_high = 0.95;

/// Sum over the used events of -ln max(D, least misfit); minus infinity if the member failed at one.
double log_agreement(const std::vector<double>& misfits, std::optional<std::size_t> without) {
    double sum = 0;
    for (std::size_t e = 0; e < misfits.size(); ++e) {
        if (e == without) continue;
        if (std::isnan(misfits[e])) return -std::numeric_limits<double>::infinity();
        sum -= std::log(std::max(misfits[e], k_least_misfit));
    }
    return sum;
}

double mean_of(const std::vector<double>& values, const std::vector<double>& weights) {
    return std::inner_product(values.begin(), values.end(), weights.begin(), 0.0);
}

double correlation(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weights) {
    const double mean_a = mean_of(a, weights), mean_b = mean_of(b, weights);
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        ab += weights[i] * (a[i] - mean_a) * (b[i] - mean_b);
        aa += weights[i] * (a[i] - mean_a) * (a[i] - mean_a);
        bb += weights[i] * (b[i] - mean_b) * (b[i] - mean_b);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

void add_interval(const KeySample& key, const std::vector<double>& weights, KeyPosterior& to) {
    to.low = weighted_quantile(key.numbers, weights, k_low);
    to.median = weighted_quantile(key.numbers, weights, 0.5);
    to.high = weighted_quantile(key.numbers, weights, k_high);
    to.width = (weighted_quantile(key.places, weights, k_high) - weighted_quantile(key.places, weights, k_low)) /
               (k_high - k_low);
    StudySpec alone;
    alone.vary.push_back({key.key, key.prior});
    Problems none;
    const SampleTable prior = samples_at(alone, {{k_low}, {k_high}}, "", none);
    to.prior_low = prior.numbers[0][0];
    to.prior_high = prior.numbers[1][0];
}

Sentence name_of(const KeyPosterior& key) {
    return key.event.empty() ? Sentence(key.key) : worded("{1} of {2}", {key.key, key.event});
}

Sentence short_number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", value);
    return numeral(text);
}

Sentence percent(double fraction) {
    return numeral(std::to_string(std::lround(100 * fraction)));
}

}  // namespace

double effective_count(const std::vector<double>& weights) {
    double sum = 0, squares = 0;
    for (const double weight : weights) {
        sum += weight;
        squares += weight * weight;
    }
    return squares > 0 ? sum * sum / squares : 0;
}

std::vector<double> posterior_weights(const Misfits& misfits, const std::vector<double>& density, double exponent,
                                      std::optional<std::size_t> without) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < misfits.size(); ++i)
        weights.push_back(exponent * log_agreement(misfits[i], without) - std::log(density[i]));
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

double supported_exponent(const Misfits& misfits, const std::vector<double>& density, double exponent,
                          std::optional<std::size_t> without) {
    const auto finished = std::count_if(misfits.begin(), misfits.end(), [&](const std::vector<double>& one) {
        return std::isfinite(log_agreement(one, without));
    });
    const double wanted = std::min(k_least_effective, 0.25 * static_cast<double>(finished));
    const auto suffices = [&](double tried) {
        return effective_count(posterior_weights(misfits, density, tried, without)) >= wanted;
    };
    if (finished == 0 || suffices(exponent)) return exponent;
    double low = 0, high = exponent;
    constexpr int k_halvings = 30;
    for (int i = 0; i < k_halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (suffices(middle) ? low : high) = middle;
    }
    return low;
}

std::optional<std::size_t> best_member(const Misfits& misfits, std::optional<std::size_t> without) {
    std::optional<std::size_t> best;
    double greatest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < misfits.size(); ++i) {
        const double agreement = log_agreement(misfits[i], without);
        if (!(agreement > greatest)) continue;
        greatest = agreement;
        best = i;
    }
    return best;
}

std::vector<KeyPosterior> key_posteriors(const std::vector<KeySample>& keys, const std::vector<double>& weights) {
    std::vector<KeyPosterior> all;
    for (const KeySample& key : keys) {
        KeyPosterior& one = all.emplace_back();
        one.key = key.key;
        one.event = key.event;
        one.nominal = key.prior.is_nominal();
        if (!one.nominal) {
            add_interval(key, weights, one);
        } else if (key.prior.law == Law::choice) {
            for (const std::string& value : key.prior.values) {
                double sum = 0;
                for (std::size_t i = 0; i < weights.size(); ++i) sum += key.texts[i] == value ? weights[i] : 0;
                one.values.emplace_back(value, sum);
            }
        }
    }
    return all;
}

std::vector<IndistinctPair> indistinct_pairs(const std::vector<KeySample>& keys, const std::vector<double>& weights) {
    std::vector<IndistinctPair> pairs;
    for (std::size_t a = 0; a < keys.size(); ++a) {
        for (std::size_t b = a + 1; b < keys.size(); ++b) {
            if (keys[a].prior.is_nominal() || keys[b].prior.is_nominal()) continue;
            const double rho = correlation(keys[a].places, keys[b].places, weights);
            if (std::abs(rho) >= k_indistinct_correlation) pairs.push_back({a, b, rho});
        }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const IndistinctPair& one, const IndistinctPair& other) {
        return std::abs(one.correlation) > std::abs(other.correlation);
    });
    return pairs;
}

std::vector<Sentence> sentences(const std::vector<KeyPosterior>& keys, const std::vector<IndistinctPair>& pairs) {
    std::vector<Sentence> all;
    for (const KeyPosterior& key : keys) {
        if (key.nominal) continue;
        all.push_back(worded("With the surveys {1} is {2} to {3} (90 %): {4} % of the width that it has without them.",
                             {name_of(key), short_number(key.low), short_number(key.high), percent(key.width)}));
    }
    for (const IndistinctPair& pair : pairs)
        all.push_back(
            worded(pair.correlation > 0
                       ? worded("The surveys cannot tell {1} from {2}: greater values of one explain them as well "
                                "with greater values of the other (correlation {3}).")
                       : worded("The surveys cannot tell {1} from {2}: greater values of one explain them as well "
                                "with smaller values of the other (correlation {3})."),
                   {name_of(keys[pair.first]), name_of(keys[pair.second]), short_number(pair.correlation)}));
    return all;
}

std::optional<Sentence> few_members(double effective) {
    if (effective >= k_few_members) return std::nullopt;
    return worded(
        "The posterior rests on few members (effective number {1}): its intervals are rough. Raise study.refine.",
        {short_number(effective)});
}

namespace {

constexpr double k_prior_part = 0.2, k_least_width = 0.02;

/// Width of the kernels along each key.
std::vector<double> kernel_widths(const Places& design, const std::vector<double>& weights) {
    const std::size_t keys = design.front().size();
    const double shrink = std::pow(effective_count(weights), -1.0 / (static_cast<double>(keys) + 4));
    std::vector<double> widths;
    for (std::size_t k = 0; k < keys; ++k) {
        double mean = 0, variance = 0;
        for (std::size_t i = 0; i < design.size(); ++i) mean += weights[i] * design[i][k];
        for (std::size_t i = 0; i < design.size(); ++i)
            variance += weights[i] * (design[i][k] - mean) * (design[i][k] - mean);
        widths.push_back(std::max(k_least_width, std::sqrt(variance) * shrink));
    }
    return widths;
}

}  // namespace

RefinedPlaces refined_places(const Places& design, const std::vector<double>& weights, std::size_t count,
                             std::int64_t seed) {
    return openturns().refined(design, weights, kernel_widths(design, weights), k_prior_part, count, seed);
}

}  // namespace frana::app::study
