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

/// Numbers that depend on the seed alone, on any machine.
class Random {
  public:
    explicit Random(std::int64_t seed) : engine_(static_cast<std::uint64_t>(seed)) {}
    double uniform() { return (static_cast<double>(engine_() >> 11U) + 0.5) * 0x1p-53; }
    double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); }
    /// Draws a place with the exponentials of `logs` as weights, which become their running sums.
    std::size_t among(std::vector<double>& logs) {
        const double greatest = *std::max_element(logs.begin(), logs.end());
        double sum = 0;
        for (double& log : logs) log = sum += std::exp(log - greatest);
        return static_cast<std::size_t>(std::upper_bound(logs.begin(), logs.end() - 1, uniform() * sum) - logs.begin());
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
    const double mean = std::accumulate(z.begin(), z.end(), 0.0) / std::max(n, 1.0);
    double squares = 0;
    for (const double one : z) squares += (one - mean) * (one - mean);
    std::vector<double> logs;
    for (int i = 0; i < k_spreads; ++i) {
        const double s = (i + 0.5) / k_spreads, of_mean = s * s + n * (1 - s * s);
        logs.push_back(-(n - 1) * std::log(s) - squares / (2 * s * s) - std::log(of_mean) / 2 -
                       n * mean * mean / (2 * of_mean));
    }
    const double s = (static_cast<double>(random.among(logs)) + 0.5) / k_spreads,
                 precision = n / (s * s) + 1 / (1 - s * s);
    return {n * mean / (s * s) / precision + random.normal() / std::sqrt(precision), s};
}

class Sampler {
  public:
    Sampler(const std::vector<Variation>& shared, const std::vector<PosteriorSample>& events, std::int64_t seed)
        : normals_(shared.size()), random_(seed) {
        for (const Variation& key : shared) keys_.push_back(key.distribution);
        for (const PosteriorSample& event : events)
            if (event.possible()) events_.push_back(placed(event));
    }

    /// Draws the population, then each event's place.
    void sweep() {
        for (std::size_t k = 0; k < keys_.size(); ++k)
            if (!keys_[k].is_nominal()) normals_[k] = drawn_normal(values_of(k), random_);
        for (Event& event : events_) move(event);
    }
    /// Of an event's places in the last sweep, running sums of the probabilities, in any unit.
    [[nodiscard]] const std::vector<double>& sums(std::size_t event) const { return events_[event].sums; }
    [[nodiscard]] double spread(std::size_t key) const { return normals_[key].spread; }

    [[nodiscard]] std::vector<double> next() {
        std::vector<double> place;
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            const std::vector<double>& weights = keys_[k].weights;
            double u = random_.uniform();
            if (!keys_[k].is_nominal()) {
                const double z = normals_[k].mean + normals_[k].spread * random_.normal();
                u = std::clamp(normal_below(z), 0x1p-53, 1 - 0x1p-53);
            } else if (keys_[k].law == Law::choice) {
                std::vector<double> logs;
                for (std::size_t i = 0; i < weights.size(); ++i)
                    logs.push_back(std::log(weights[i] + events_with(k, i)));
                const std::size_t option = random_.among(logs);
                u = std::accumulate(weights.begin(), weights.begin() + static_cast<long>(option), u * weights[option]);
            }
            place.push_back(u);
        }
        return place;
    }

  private:
    struct Event {
        std::vector<std::vector<double>> values;  ///< by shared key and place: z, or the option
        std::vector<double> logs;                 ///< by place: of the weight over the density of all z
        std::vector<double> sums;
        std::size_t now = 0;
    };

    [[nodiscard]] Event placed(const PosteriorSample& event) {
        Event one;
        for (const double weight : event.weights) one.logs.push_back(std::log(weight));
        one.sums = one.logs;
        one.now = random_.among(one.sums);
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            std::vector<double> values = column_of(event.places, k);
            for (double& value : values) value = std::clamp(value, 1e-9, 1 - 1e-9);
            if (!keys_[k].is_nominal()) values = openturns().quantiles({Law::normal, {0, 1}, {}, {}, {}}, values);
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (!keys_[k].is_nominal()) one.logs[i] += values[i] * values[i] / 2;
                if (keys_[k].law == Law::choice) values[i] = option_at(keys_[k], values[i]);
            }
            one.values.push_back(std::move(values));
        }
        return one;
    }
    [[nodiscard]] std::vector<double> values_of(std::size_t key) const {
        std::vector<double> all;
        for (const Event& event : events_) all.push_back(event.values[key][event.now]);
        return all;
    }
    [[nodiscard]] double events_with(std::size_t key, std::size_t option) const {
        const std::vector<double> options = values_of(key);
        return static_cast<double>(std::count(options.begin(), options.end(), static_cast<double>(option)));
    }
    void move(Event& event) {
        event.sums = event.logs;
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            const std::vector<double>& values = event.values[k];
            const auto [mean, spread] = normals_[k];
            for (std::size_t i = 0; i < values.size() && !keys_[k].is_nominal(); ++i)
                event.sums[i] -= (values[i] - mean) * (values[i] - mean) / (2 * spread * spread);
            if (keys_[k].law != Law::choice) continue;
            std::vector<double> changes;  // by option, relative to the user's weight
            for (std::size_t option = 0; option < keys_[k].weights.size(); ++option)
                changes.push_back(
                    std::log1p((events_with(k, option) - (values[event.now] == static_cast<double>(option) ? 1 : 0)) /
                               keys_[k].weights[option]));
            for (std::size_t i = 0; i < values.size(); ++i)
                event.sums[i] += changes[static_cast<std::size_t>(values[i])];
        }
        event.now = random_.among(event.sums);
    }

    std::vector<Distribution> keys_;
    std::vector<Normal> normals_;
    std::vector<Event> events_;  ///< the possible ones
    Random random_;
};

}  // namespace

Population population_of(const std::vector<Variation>& shared, std::vector<PosteriorSample> events, std::int64_t seed) {
    Sampler sampler(shared, events, seed);
    std::vector<PosteriorSample*> possible;
    for (PosteriorSample& event : events)
        if (event.possible()) possible.push_back(&event);
    // One event alone: whatever the population, its distribution is the user's.
    if (possible.size() == 1) possible.clear();
    for (PosteriorSample* event : possible) std::fill(event->weights.begin(), event->weights.end(), 0);
    Population result;
    std::vector<std::vector<double>> spreads(shared.size());
    for (int sweep = -k_first_sweeps; sweep < k_sweeps; ++sweep) {
        sampler.sweep();
        if (sweep < 0) continue;
        result.next.places.push_back(sampler.next());
        for (std::size_t k = 0; k < shared.size(); ++k) spreads[k].push_back(sampler.spread(k));
        for (std::size_t e = 0; e < possible.size(); ++e) {
            const std::vector<double>& sums = sampler.sums(e);
            for (std::size_t i = 0; i < sums.size(); ++i)
                possible[e]->weights[i] += (sums[i] - (i == 0 ? 0 : sums[i - 1])) / sums.back() / k_sweeps;
        }
    }
    result.next.weights.assign(k_sweeps, 1.0 / k_sweeps);
    for (std::size_t k = 0; k < shared.size(); ++k) {
        const auto at = [&](double q) { return weighted_quantile(spreads[k], result.next.weights, q); };
        result.spread.push_back(shared[k].distribution.is_nominal() ? Interval{k_no_data, k_no_data, k_no_data}
                                                                    : Interval{at(0.5), at(0.05), at(0.95)});
    }
    result.events = std::move(events);
    return result;
}

}  // namespace frana::app::study
