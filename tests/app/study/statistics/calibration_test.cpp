// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "app/study/plan/sampling.h"
#include "app/study/statistics/calibration_posterior.h"
#include "app/study/statistics/cell_statistics.h"
#include "core/raster.h"

namespace frana::app::study {
namespace {

StudySpec two_keys(std::int64_t samples) {
    StudySpec study;
    study.samples = samples;
    study.seed = 4;
    study.vary.push_back(
        {"material.friction-coefficient", std::get<Distribution>(distribution_from_text("uniform(0, 1)"))});
    study.vary.push_back({"material.turbulence", std::get<Distribution>(distribution_from_text("uniform(100, 200)"))});
    return study;
}

SampleTable samples_of(const StudySpec& study, const Places& places) {
    Problems none;
    return samples_at(study, places, "", none);
}

constexpr double k_truth = 0.4, k_spread = 0.05;

/// A cube of two ordered keys of which the posterior of one event is known.
EventModel model_of(const Places& members, const std::vector<double>& distances, bool is_stated, double pieces) {
    const StudySpec study = two_keys(2048);
    return {study.vary, members, {distances, pieces, std::sqrt(2 * pieces), is_stated}, draw_places(study), 5};
}

double quantile_of(const PosteriorSample& sample, std::size_t key, double q) {
    std::vector<double> values;
    for (const auto& place : sample.places) values.push_back(place[key]);
    return weighted_quantile(values, sample.weights, q);
}

// chi = |u - 0.4| / 0.05 of the first key, with a floor from 9 pieces of noise: the posterior is a normal distribution.
// Its quantiles from 2000 weighted draws, of which about 700 count, have a standard error of 0.06 to 0.08 spreads; the
// emulator's own from 40 members must not add to it.
TEST(EventModel, PosteriorOfStatedErrorsIsTheClosedForm) {
    const Places members = draw_places(two_keys(40));
    std::vector<double> distances;
    for (const auto& place : members) distances.push_back(std::hypot(3, (place[0] - k_truth) / k_spread));
    const EventModel model = model_of(members, distances, true, 9);
    EXPECT_EQ(model.widening(), 1);
    EXPECT_GT(model.q2(), 0.99);
    const PosteriorSample sample = model.sample();
    EXPECT_NEAR(quantile_of(sample, 0, 0.5), k_truth, 0.2 * k_spread);
    EXPECT_NEAR(quantile_of(sample, 0, 0.05), k_truth - 1.645 * k_spread, 0.3 * k_spread);
    EXPECT_NEAR(quantile_of(sample, 0, 0.95), k_truth + 1.645 * k_spread, 0.3 * k_spread);
    // Nothing is said of the second key.
    EXPECT_NEAR(quantile_of(sample, 1, 0.05), 0.05, 0.04);
    EXPECT_NEAR(quantile_of(sample, 1, 0.95), 0.95, 0.04);
    for (const auto& place : model.next(4)) EXPECT_NEAR(place[0], k_truth, 4 * k_spread);
}

// No member is nearer than 5 times the stated errors: they are widened to it, and N is divided by 5.
TEST(EventModel, ErrorsAreWidenedToWhatTheModelCan) {
    const Places members = draw_places(two_keys(40));
    std::vector<double> distances;
    for (const auto& place : members)
        distances.push_back(std::hypot(15, std::pow(5, 1.5) * (place[0] - k_truth) / k_spread));
    const EventModel model = model_of(members, distances, true, 9);
    EXPECT_NEAR(model.widening(), 5, 0.1);
    const PosteriorSample sample = model.sample();
    EXPECT_NEAR(quantile_of(sample, 0, 0.95) - quantile_of(sample, 0, 0.05), 3.29 * k_spread, 0.4 * k_spread);
}

// D = 0.2 + |u - 0.4|, N = 5 without stated errors: density ~ D^-5, whose integral is in closed form.
TEST(EventModel, WithoutStatedErrorsTheBestAgreementSetsTheScale) {
    const Places members = draw_places(two_keys(64));
    std::vector<double> distances;
    for (const auto& place : members) distances.push_back(0.2 + std::abs(place[0] - k_truth));
    const PosteriorSample sample = model_of(members, distances, false, 5).sample();
    const auto below = [](double u) {  // integral of D^-5 from 0
        const auto power = [](double d) { return std::pow(d, -4) / 4; };
        return u < k_truth ? power(0.2 + k_truth - u) - power(0.6)
                           : 2 * power(0.2) - power(0.6) - power(0.2 + u - k_truth);
    };
    for (const double q : {0.05, 0.5, 0.95}) EXPECT_NEAR(below(quantile_of(sample, 0, q)) / below(1), q, 0.04) << q;
}

// Where the nearest member failed nothing has weight.
TEST(EventModel, FailedMembersHaveNoWeight) {
    const Places members = draw_places(two_keys(40));
    std::vector<double> distances;
    for (const auto& place : members)
        distances.push_back(place[0] < 0.5 ? k_no_data : std::hypot(3, (place[0] - k_truth) / k_spread));
    const EventModel model = model_of(members, distances, true, 9);
    EXPECT_GT(quantile_of(model.sample(), 0, 0.05), 0.4);
    EXPECT_GE(members[*model.best()][0], 0.5);
    const EventModel none = model_of(members, std::vector<double>(members.size(), k_no_data), true, 9);
    EXPECT_FALSE(none.sample().possible());
    EXPECT_FALSE(none.best());
}

// A field of error is another one in each member, and is integrated over: y = hypot(3, (u - 0.4 - g) / 0.05) with
// normal g of 0.05 leaves sqrt(2) times the spread of the stated error alone.
TEST(EventModel, AFieldOfErrorIsIntegratedOver) {
    StudySpec study = two_keys(160);
    study.vary[1] = {"terrain.error", std::get<Distribution>(distribution_from_text("gaussian-field(1, 50)"))};
    const Places members = draw_places(study);
    std::vector<double> distances;
    for (const auto& place : members) {
        const double g = openturns().quantiles({Law::normal, {0, k_spread}, {}, {}, {}}, {place[1]}).front();
        distances.push_back(std::hypot(3, (place[0] - k_truth - g) / k_spread));
    }
    study.samples = 2048;
    const EventModel model(study.vary, members, {distances, 9, std::sqrt(18), true}, draw_places(study), 5);
    const PosteriorSample sample = model.sample();
    const double width = quantile_of(sample, 0, 0.95) - quantile_of(sample, 0, 0.05);
    EXPECT_GT(width, 1.1 * 3.29 * k_spread);
    EXPECT_LT(width, 2.0 * 3.29 * k_spread);
    EXPECT_NEAR(quantile_of(sample, 0, 0.5), k_truth, k_spread);
}

TEST(EventModel, SameMembersSameBits) {
    const Places members = draw_places(two_keys(20));
    std::vector<double> distances;
    for (const auto& place : members) distances.push_back(std::hypot(3, (place[0] - k_truth) / k_spread, place[1]));
    const EventModel a = model_of(members, distances, true, 9), b = model_of(members, distances, true, 9);
    EXPECT_EQ(a.next(4), b.next(4));
    EXPECT_EQ(a.sample().weights, b.sample().weights);
}

TEST(Posterior, WithoutSurveysIntervalsAreThoseOfTheDistributions) {
    const StudySpec study = two_keys(4096);  // points of a Sobol' sequence: 1/4096 apart in each key
    const Places places = draw_places(study);
    const std::vector<double> even(places.size(), 1 / static_cast<double>(places.size()));
    const std::vector<KeyPosterior> keys = key_posteriors(study.vary, samples_of(study, places), even);
    EXPECT_NEAR(keys[0].prior_low, 0.05, 1e-9);
    EXPECT_NEAR(keys[0].prior_high, 0.95, 1e-9);
    EXPECT_NEAR(keys[1].low, 105, 1);
    EXPECT_NEAR(keys[1].median, 150, 1);
    EXPECT_NEAR(keys[1].high, 195, 1);
    EXPECT_NEAR(keys[1].width, 1, 0.01);
}

TEST(Posterior, PlacesFarBelowTheGreatestWeightHaveNone) {
    const std::vector<double> weights =
        weights_of({std::log(1e-5), 0, -std::numeric_limits<double>::infinity()}, {1, 1, 1});
    EXPECT_EQ(weights, (std::vector<double>{0, 1, 0}));
}

// Mean of 1 / q over members drawn from q is the volume of the cube, 1; its standard error follows from the members.
TEST(Refined, DensityIsThatOfTheMembers) {
    const StudySpec study = two_keys(64);
    const Places design = draw_places(study);
    std::vector<double> logs;
    for (const auto& place : design) logs.push_back(-20 * std::abs(place[0] - k_truth));
    const RefinedPlaces refined =
        refined_places(design, weights_of(logs, std::vector<double>(design.size(), 1)), 4000, 3);
    double sum = 0, squares = 0;
    for (const double density : refined.density) {
        EXPECT_GE(density, 0.2);  // the part drawn from the prior
        sum += 1 / density;
        squares += 1 / density / density;
    }
    const double mean = sum / 4000, error = std::sqrt((squares / 4000 - mean * mean) / 4000);
    EXPECT_NEAR(mean, 1, 3 * error);
    for (const auto& place : refined.places)
        for (const double coordinate : place) EXPECT_TRUE(coordinate >= 0 && coordinate <= 1);
}

// One place at the centre: a normal density with the least width, far from the faces that would cut it off.
TEST(Refined, DensityOfOneKernelIsTheClosedForm) {
    const RefinedPlaces refined = refined_places({{0.5, 0.5}}, {1}, 50, 1);
    constexpr double width = 0.02;
    for (std::size_t i = 0; i < refined.places.size(); ++i) {
        const double x = (refined.places[i][0] - 0.5) / width, y = (refined.places[i][1] - 0.5) / width;
        const double normal = std::exp(-(x * x + y * y) / 2) / (2 * std::numbers::pi * width * width);
        EXPECT_NEAR(refined.density[i], 0.2 + 0.8 * normal, 1e-9 * normal + 1e-9);
    }
}

TEST(Refined, SameSeedSameMembers) {
    const Places design{{0.2, 0.3}, {0.6, 0.9}, {0.5, 0.1}};
    const RefinedPlaces a = refined_places(design, {0.5, 0.3, 0.2}, 20, 11),
                        b = refined_places(design, {0.5, 0.3, 0.2}, 20, 11);
    EXPECT_EQ(a.places, b.places);
    EXPECT_EQ(a.density, b.density);
    EXPECT_NE(a.places, refined_places(design, {0.5, 0.3, 0.2}, 20, 12).places);
}

// Only the sum of the two keys matters: on a ridge they cannot be told apart.
TEST(Posterior, KeysOnARidgeCannotBeToldApart) {
    const StudySpec study = two_keys(2048);
    const Places places = draw_places(study);
    std::vector<double> logs;
    for (const auto& place : places) logs.push_back(-40 * std::abs(place[0] + place[1] - 1));
    const std::vector<double> weights = weights_of(logs, std::vector<double>(places.size(), 1));
    const SampleTable draws = samples_of(study, places);
    const auto pairs = indistinct_pairs(draws, weights);
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_LT(pairs[0].correlation, -0.95);
    EXPECT_TRUE(sentences(key_posteriors(study.vary, draws, weights), pairs)
                    .front()
                    .text()
                    .starts_with("material.friction-coefficient, material.turbulence: correlation -0.9"));
}

TEST(Posterior, ChoicesHaveProbabilities) {
    StudySpec study;
    study.vary.push_back(
        {"numerics.scheme", std::get<Distribution>(distribution_from_text("choice(default: 0.5, paper: 0.5)"))});
    const KeyPosterior after =
        key_posteriors(study.vary, samples_of(study, {{0.1}, {0.7}, {0.9}}), {0.25, 0.25, 0.5}).front();
    ASSERT_EQ(after.values.size(), 2U);
    EXPECT_EQ(after.values[0], (std::pair<std::string, double>{"default", 0.25}));
    EXPECT_EQ(after.values[1], (std::pair<std::string, double>{"paper", 0.75}));
}

TEST(CalibratedPosterior, AnEndWithin2PercentOfTheDistributionsLimitIsTold) {
    KeyPosterior key;
    key.key = "material.turbulence";
    key.low = 101;
    key.high = 160;
    for (const auto& [low, high, told] : {std::tuple{0.06, 0.0, "at the limit 101 of its distribution: widen"},
                                          {0.01, 0.2, "at the limit 160 of its distribution: widen"},
                                          {0.04, 0.04, ""},
                                          {0.06, 0.06, ""}}) {  // it says nothing of this key
        key.share_low = low;
        key.share_high = high;
        const std::vector<StudyDoubt> doubts = edge_doubts({key});
        ASSERT_EQ(doubts.empty(), std::string(told).empty());
        for (const StudyDoubt& doubt : doubts) {
            EXPECT_NE(doubt.text.text().find(told), std::string::npos) << doubt.text.text();
            EXPECT_EQ(doubt.kind, "prior-limit");
            EXPECT_EQ(doubt.key, "material.turbulence");
            EXPECT_EQ(doubt.value, std::max(low, high));
        }
    }
}

TEST(Draws, AreEvenInAllKeys) {
    const StudySpec study = two_keys(4096);
    const Places places = draw_places(study);
    const Places draws =
        evenly_drawn({places, std::vector<double>(places.size(), 1 / static_cast<double>(places.size()))}, 200);
    ASSERT_EQ(draws.size(), 200U);
    // Independent draws would have a standard error of 0.035 of this probability.
    double inside = 0;
    for (const auto& place : draws) inside += place[0] + place[1] < 1 ? 1.0 / 200 : 0;
    EXPECT_NEAR(inside, 0.5, 0.03);
}

}  // namespace
}  // namespace frana::app::study
