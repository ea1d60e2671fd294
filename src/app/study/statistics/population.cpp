// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/population.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace frana::app::study {
namespace {

constexpr int k_first_sweeps = 200, k_sweeps = 2000;
constexpr int k_spreads = 100;  // s = 0.005, 0.015, ... 0.995

double probability_below(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// Numbers that depend on the seed alone, on any machine.
class Random {
  public:
    explicit Random(std::int64_t seed) : engine_(static_cast<std::uint64_t>(seed)) {}
    double uniform() { return (static_cast<double>(engine_() >> 11U) + 0.5) * 0x1p-53; }
    double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); }
    /// @param cumulative weights
    std::size_t among(const std::vector<double>& cumulative) {
        const double at = uniform() * cumulative.back();
        return static_cast<std::size_t>(std::upper_bound(cumulative.begin(), cumulative.end() - 1, at) -
                                        cumulative.begin());
    }

  private:
    std::mt19937_64 engine_;
};

/// A key with an order, in the population.
struct Normal {
    double mean = 0, spread = 1;
};

/// @param z of the events
Normal drawn_normal(const std::vector<double>& z, Random& random) {
    const auto n = static_cast<double>(z.size());
    const double mean = z.empty() ? 0 : std::accumulate(z.begin(), z.end(), 0.0) / n;
    double squares = 0;
    for (const double one : z) squares += (one - mean) * (one - mean);
    std::vector<double> logs, cumulative;
    for (int i = 0; i < k_spreads; ++i) {
        const double s = (i + 0.5) / k_spreads, of_mean = s * s + n * (1 - s * s);
        logs.push_back(-(n - 1) * std::log(s) - squares / (2 * s * s) - std::log(of_mean) / 2 -
                       n * mean * mean / (2 * of_mean));
    }
    const double greatest = *std::max_element(logs.begin(), logs.end());
    for (const double log : logs)
        cumulative.push_back((cumulative.empty() ? 0 : cumulative.back()) + std::exp(log - greatest));
    const double s = (static_cast<double>(random.among(cumulative)) + 0.5) / k_spreads,
                 precision = n / (s * s) + 1 / (1 - s * s);
    return {n * mean / (s * s) / precision + random.normal() / std::sqrt(precision), s};
}

std::size_t option_at(const Distribution& choice, double place) {
    double below = 0;
    std::size_t option = 0;
    while (option + 1 < choice.weights.size() && place >= (below += choice.weights[option])) ++option;
    return option;
}

/// The places of an event that have weight.
struct Candidates {
    std::vector<std::size_t> of_sample;
    std::vector<std::vector<double>> values;  ///< by shared key and place: z, or the option
    std::vector<double> logs;                 ///< of the weight over the density of all z
    std::size_t now = 0;                      ///< where the event is
};

class Sampler {
  public:
    Sampler(const std::vector<Distribution>& keys, const std::vector<PosteriorSample>& events, std::int64_t seed)
        : keys_(keys), normals_(keys.size()), random_(seed) {
        for (const PosteriorSample& event : events)
            if (event.possible()) events_.push_back(candidates_of(event));
    }

    /// Draws the population, then each event's place.
    /// @param weights by event and place: gets the probability of each; null: none
    void sweep(std::vector<std::vector<double>>* weights) {
        for (std::size_t k = 0; k < keys_.size(); ++k)
            if (!keys_[k].is_nominal()) normals_[k] = drawn_normal(values_of(k), random_);
        for (std::size_t e = 0; e < events_.size(); ++e) move(e, weights == nullptr ? nullptr : &(*weights)[e]);
    }
    [[nodiscard]] const Candidates& of(std::size_t event) const { return events_[event]; }
    [[nodiscard]] double spread(std::size_t key) const { return normals_[key].spread; }

    [[nodiscard]] std::vector<double> next() {
        std::vector<double> place;
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            const Distribution& key = keys_[k];
            if (!key.is_nominal()) {
                const double u = probability_below(normals_[k].mean + normals_[k].spread * random_.normal());
                place.push_back(std::clamp(u, 0x1p-53, 1 - 0x1p-53));
            } else if (key.law == Law::gaussian_field) {
                place.push_back(random_.uniform());
            } else {
                std::vector<double> cumulative;
                for (std::size_t i = 0; i < key.weights.size(); ++i)
                    cumulative.push_back((cumulative.empty() ? 0 : cumulative.back()) + key.weights[i] +
                                         static_cast<double>(events_with(k, i)));
                const std::size_t option = random_.among(cumulative);
                place.push_back(std::accumulate(key.weights.begin(), key.weights.begin() + static_cast<long>(option),
                                                key.weights[option] * random_.uniform()));
            }
        }
        return place;
    }

  private:
    [[nodiscard]] Candidates candidates_of(const PosteriorSample& event) {
        Candidates one;
        std::vector<double> cumulative;
        for (std::size_t i = 0; i < event.weights.size(); ++i) {
            if (!(event.weights[i] > 0)) continue;
            one.of_sample.push_back(i);
            one.logs.push_back(std::log(event.weights[i]));
            cumulative.push_back((cumulative.empty() ? 0 : cumulative.back()) + event.weights[i]);
        }
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            std::vector<double> places;
            for (const std::size_t i : one.of_sample) places.push_back(std::clamp(event.places[i][k], 1e-9, 1 - 1e-9));
            if (!keys_[k].is_nominal()) {
                places = openturns().quantiles({Law::normal, {0, 1}, {}, {}, {}}, places);
                for (std::size_t i = 0; i < places.size(); ++i) one.logs[i] += places[i] * places[i] / 2;
            } else if (keys_[k].law == Law::choice) {
                for (double& place : places) place = static_cast<double>(option_at(keys_[k], place));
            }
            one.values.push_back(std::move(places));
        }
        one.now = random_.among(cumulative);
        return one;
    }
    [[nodiscard]] std::vector<double> values_of(std::size_t key) const {
        std::vector<double> all;
        for (const Candidates& event : events_) all.push_back(event.values[key][event.now]);
        return all;
    }
    [[nodiscard]] std::size_t events_with(std::size_t key, std::size_t option) const {
        const std::vector<double> options = values_of(key);
        return static_cast<std::size_t>(std::count(options.begin(), options.end(), static_cast<double>(option)));
    }
    void move(std::size_t e, std::vector<double>* weights) {
        Candidates& event = events_[e];
        std::vector<double> logs = event.logs;
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            const std::vector<double>& values = event.values[k];
            if (!keys_[k].is_nominal()) {
                const double factor = 0.5 / (normals_[k].spread * normals_[k].spread);
                for (std::size_t i = 0; i < logs.size(); ++i)
                    logs[i] -= factor * (values[i] - normals_[k].mean) * (values[i] - normals_[k].mean);
            } else if (keys_[k].law == Law::choice) {
                std::vector<double> changes;  // by option, relative to the user's weight
                for (std::size_t option = 0; option < keys_[k].weights.size(); ++option) {
                    const double others = static_cast<double>(events_with(k, option)) -
                                          (values[event.now] == static_cast<double>(option) ? 1 : 0);
                    changes.push_back(std::log1p(others / keys_[k].weights[option]));
                }
                for (std::size_t i = 0; i < logs.size(); ++i) logs[i] += changes[static_cast<std::size_t>(values[i])];
            }
        }
        const double greatest = *std::max_element(logs.begin(), logs.end());
        double sum = 0;
        for (double& log : logs) log = sum += std::exp(log - greatest);
        event.now = random_.among(logs);
        for (std::size_t i = 0; weights != nullptr && i < logs.size(); ++i)
            (*weights)[event.of_sample[i]] += (logs[i] - (i == 0 ? 0 : logs[i - 1])) / sum / k_sweeps;
    }

    const std::vector<Distribution>& keys_;
    std::vector<Normal> normals_;
    std::vector<Candidates> events_;  ///< the possible ones
    Random random_;
};

}  // namespace

Population population_of(const std::vector<Distribution>& shared, std::vector<PosteriorSample> events,
                         std::int64_t seed) {
    Sampler sampler(shared, events, seed);
    std::vector<std::vector<double>> weights, spreads(shared.size());
    for (const PosteriorSample& event : events)
        if (event.possible()) weights.emplace_back(event.weights.size());
    Population result;
    for (int sweep = -k_first_sweeps; sweep < k_sweeps; ++sweep) {
        sampler.sweep(sweep < 0 ? nullptr : &weights);
        if (sweep < 0) continue;
        result.next.push_back(sampler.next());
        for (std::size_t k = 0; k < shared.size(); ++k) spreads[k].push_back(sampler.spread(k));
    }
    const std::vector<double> even(k_sweeps, 1.0 / k_sweeps);
    for (std::size_t k = 0; k < shared.size(); ++k) {
        const bool has_none = shared[k].is_nominal();
        result.spread.push_back(has_none ? std::nan("") : weighted_quantile(spreads[k], even, 0.5));
        result.spread_low.push_back(has_none ? std::nan("") : weighted_quantile(spreads[k], even, 0.05));
        result.spread_high.push_back(has_none ? std::nan("") : weighted_quantile(spreads[k], even, 0.95));
    }
    // One event alone: whatever the population, its distribution is the user's.
    if (weights.size() > 1) {
        auto with = weights.begin();
        for (PosteriorSample& event : events)
            if (event.possible()) event.weights = std::move(*with++);
    }
    result.events = std::move(events);
    return result;
}

}  // namespace frana::app::study
