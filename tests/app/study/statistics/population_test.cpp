// SPDX-License-Identifier: Apache-2.0
// What several events say of a new slope, against closed forms and against populations that are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

#include "app/study/plan/sampling.h"
#include "app/study/statistics/population.h"

namespace frana::app::study {
namespace {

std::vector<Variation> law(const std::string& text) {
    return {{"material.friction-coefficient", std::get<Distribution>(distribution_from_text(text))}};
}

double below(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// The posterior of one event with a flat prior and a normal likelihood in the place u.
PosteriorSample normal_event(double u, double deviation) {
    PosteriorSample event;
    constexpr int k_places = 1000;
    double sum = 0;
    for (int i = 0; i < k_places; ++i) {
        event.places.push_back({(i + 0.5) / k_places});
        const double off = (event.places.back()[0] - u) / deviation;
        sum += event.weights.emplace_back(std::exp(-off * off / 2));
    }
    for (double& weight : event.weights) weight /= sum;
    return event;
}

double quantile(const PosteriorSample& sample, double q) {
    std::vector<double> values;
    for (const auto& place : sample.places) values.push_back(place[0]);
    return weighted_quantile(values, sample.weights, q);
}

// z of the event is z_1 whatever s: that of a new slope is (1 - s^2) z_1 + sqrt(1 - (1 - s^2)^2) times a normal number,
// with s uniform in (0, 1).
TEST(Population, OneEventLeavesTheSpreadAsAssumed) {
    const PosteriorSample event = normal_event(below(1), 1e-3);
    const Population one = population_of(law("uniform(0, 1)"), {event}, 1);
    EXPECT_EQ(one.events[0].weights, event.weights);
    EXPECT_NEAR(one.spread[0].value, 0.5, 0.06);
    std::vector<double> z;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::normal_distribution<double> normal(0, 1);
    for (int i = 0; i < 200000; ++i) {
        const double s = uniform(random), kept = 1 - s * s;
        z.push_back(kept + std::sqrt(1 - kept * kept) * normal(random));
    }
    std::sort(z.begin(), z.end());
    for (const double q : {0.05, 0.25, 0.5, 0.75, 0.95})
        EXPECT_NEAR(quantile(one.next, q), below(z[static_cast<std::size_t>(q * 200000)]), 0.04) << q;
}

TEST(Population, EventsThatAgreeNarrowEachOtherAndTheNextSlope) {
    std::vector<PosteriorSample> events;
    for (int e = 0; e < 12; ++e) events.push_back(normal_event(0.4, 0.1));
    const Population agree = population_of(law("uniform(0, 1)"), events, 1);
    EXPECT_LT(agree.spread[0].value, 0.3);
    EXPECT_LT(quantile(agree.next, 0.95) - quantile(agree.next, 0.05), 0.3);
    const auto width = [](const PosteriorSample& event) { return quantile(event, 0.95) - quantile(event, 0.05); };
    EXPECT_LT(width(agree.events[3]), 0.8 * width(events[3]));
    // One with a value of its own is told by it, not by the others.
    events.push_back(normal_event(0.9, 0.02));
    const Population apart = population_of(law("uniform(0, 1)"), events, 1);
    EXPECT_GT(apart.spread[0].value, agree.spread[0].value);
    double mean = 0;
    for (std::size_t i = 0; i < apart.events[12].weights.size(); ++i)
        mean += apart.events[12].weights[i] * apart.events[12].places[i][0];
    EXPECT_NEAR(mean, 0.9, 0.02);
}

// Options of a choice: the user's weights count as one event.
TEST(Population, ChoicesAreCounted) {
    std::vector<PosteriorSample> events;
    for (int e = 0; e < 4; ++e) events.push_back({{{0.2}, {0.7}}, {1, 0}});
    const Population counted = population_of(law("choice(a: 0.5, b: 0.5)"), events, 1);
    double first = 0;
    for (const auto& place : counted.next.places) first += place[0] < 0.5 ? 1 : 0;
    EXPECT_NEAR(first / static_cast<double>(counted.next.places.size()), 4.5 / 5, 0.03);
    EXPECT_TRUE(std::isnan(counted.spread[0].value));
}

TEST(Population, WithoutEventsThatSayAnythingItIsTheDistribution) {
    PosteriorSample none = normal_event(0.5, 0.1);
    std::fill(none.weights.begin(), none.weights.end(), 0);
    const Population prior = population_of(law("uniform(0, 1)"), {none, none}, 1);
    for (const double q : {0.05, 0.5, 0.95}) EXPECT_NEAR(quantile(prior.next, q), q, 0.04);
}

TEST(Population, SameSeedSameBits) {
    const std::vector<PosteriorSample> events{normal_event(0.3, 0.1), normal_event(0.5, 0.05)};
    const Population a = population_of(law("uniform(0, 1)"), events, 3),
                     b = population_of(law("uniform(0, 1)"), events, 3);
    EXPECT_EQ(a.next.places, b.next.places);
    EXPECT_EQ(a.events[0].weights, b.events[0].weights);
    EXPECT_NE(a.next.places, population_of(law("uniform(0, 1)"), events, 4).next.places);
}

// Eight events with friction 0.05 to 0.6 drawn from a normal population, each known with an error: the predictive
// interval of 90 % against the part of the population that it holds. With FRANA_REPEATS it prints what it holds.
TEST(Population, IntervalHoldsNewSlopes) {
    const char* const asked = std::getenv("FRANA_REPEATS");
    const int repeats = asked == nullptr ? 6 : std::max(1, std::atoi(asked));
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0, 1);
    for (const double deviation : {0.03, 0.063, 0.1}) {  // of friction
        double held = 0, least = 1, held_by_joint = 0;
        for (int repeat = 0; repeat < repeats; ++repeat) {
            std::vector<PosteriorSample> events;
            double shared_sum = 0;
            for (int e = 0; e < 8; ++e) {
                const double friction = std::clamp(0.22 + deviation * normal(random), 0.06, 0.59),
                             u = (friction - 0.05) / 0.55, error = 0.03;
                shared_sum += u + error * normal(random);
                events.push_back(normal_event(u + error * normal(random), error));
            }
            const Population known = population_of(law("uniform(0.05, 0.6)"), events, repeat);
            const auto part = [&](double low, double high) {
                const auto z = [&](double u) { return (0.05 + 0.55 * u - 0.22) / deviation; };
                return below(z(high)) - below(z(low));
            };
            const double one = part(quantile(known.next, 0.05), quantile(known.next, 0.95));
            held += one / repeats;
            least = std::min(least, one);
            const double mean = shared_sum / 8, of_mean = 1.645 * 0.03 / std::sqrt(8.0);
            held_by_joint += part(mean - of_mean, mean + of_mean) / repeats;
        }
        if (asked != nullptr)
            std::printf(
                "friction sd %.3f: 90 %% interval holds %.1f %% of new slopes (least %.0f %%); one shared "
                "friction %.1f %%\n",
                deviation, 100 * held, 100 * least, 100 * held_by_joint);
        EXPECT_GT(held, 0.8) << deviation;
        EXPECT_LT(held, 0.97) << deviation;
    }
}

}  // namespace
}  // namespace frana::app::study
