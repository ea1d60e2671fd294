// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/study/plan/sampling.h"
#include "app/study/statistics/calibration_posterior.h"
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

std::vector<KeySample> samples_of(const StudySpec& study, const Places& places) {
    Problems none;
    const SampleTable table = samples_at(study, places, "", none);
    std::vector<KeySample> keys;
    for (std::size_t k = 0; k < study.vary.size(); ++k) {
        KeySample& key = keys.emplace_back(KeySample{study.vary[k].key, "", study.vary[k].distribution, {}, {}, {}});
        for (std::size_t i = 0; i < table.size(); ++i) {
            key.places.push_back(table.places[i][k]);
            key.numbers.push_back(table.numbers[i][k]);
            key.texts.push_back(table.values[i][k]);
        }
    }
    return keys;
}

constexpr double k_exponent = 10, k_truth = 0.4, k_steepness = 2;

/// ln D = -2 + 2 |u - 0.4| of the first key: with N = 10 the posterior density is that of a Laplace distribution about
/// 0.4 with the scale 1 / 20, cut off at 0 and 1.
Misfits laplace_misfits(const Places& places) {
    Misfits misfits;
    for (const auto& place : places) misfits.push_back({std::exp(-2 + k_steepness * std::abs(place[0] - k_truth))});
    return misfits;
}

double laplace_quantile(double q) {
    const double rate = k_exponent * k_steepness;
    const auto integral = [&](double u) {  // of exp(-rate |u - truth|), from minus infinity
        return u < k_truth ? std::exp(rate * (u - k_truth)) / rate : (2 - std::exp(-rate * (u - k_truth))) / rate;
    };
    double low = 0, high = 1;
    while (high - low > 1e-12) {
        const double middle = (low + high) / 2;
        ((integral(middle) - integral(0)) / (integral(1) - integral(0)) < q ? low : high) = middle;
    }
    return low;
}

// (0.1)^-2 : (0.2)^-2 : (0.005 -> 0.01)^-2 = 100 : 25 : 10000, divided by the densities 1, 0.5, 4: 100 : 50 : 2500.
TEST(Posterior, WeightsAreThoseOfTheFormula) {
    const std::vector<double> weights = posterior_weights({{0.1}, {0.2}, {0.005}}, {1, 0.5, 4}, 2);
    EXPECT_NEAR(weights[0], 100.0 / 2650, 1e-12);
    EXPECT_NEAR(weights[1], 50.0 / 2650, 1e-12);
    EXPECT_NEAR(weights[2], 2500.0 / 2650, 1e-12);
}

// One of 40 members is ten times as good: alone it would have all the weight.
TEST(Posterior, TheExponentIsLoweredWhereOneMemberWouldCount) {
    Misfits misfits(40, {0.2});
    misfits[7] = {0.02};
    const std::vector<double> even(40, 1);
    EXPECT_LT(effective_count(posterior_weights(misfits, even, 5)), 1.1);
    const double supported = supported_exponent(misfits, even, 5);
    // (39 + g)^2 / (39 + g^2) = 8 for g = 10^N: 7 g^2 - 78 g - 1209 = 0
    EXPECT_NEAR(std::pow(10, supported), (78 + std::sqrt(78.0 * 78 + 4 * 7 * 1209)) / 14, 1e-4);
    EXPECT_EQ(supported_exponent(Misfits(40, {0.2}), even, 5), 5);
}

// Events multiply; an event that is left out does not count, and neither does its failure.
TEST(Posterior, EventsMultiplyAndOneMayBeLeftOut) {
    const Misfits misfits{{0.1, 0.4}, {0.2, 0.1}, {0.05, k_no_data}};
    const std::vector<double> both = posterior_weights(misfits, {1, 1, 1}, 1);
    EXPECT_NEAR(both[0] / both[1], (0.2 * 0.1) / (0.1 * 0.4), 1e-12);
    EXPECT_EQ(both[2], 0);
    const std::vector<double> first = posterior_weights(misfits, {1, 1, 1}, 1, 1);
    EXPECT_NEAR(first[2] / first[0], 2, 1e-12);
    EXPECT_EQ(best_member(misfits), 1U);
    EXPECT_EQ(best_member(misfits, 1), 2U);
    EXPECT_FALSE(best_member({{k_no_data}, {k_no_data}}));
    const std::vector<double> none = posterior_weights({{k_no_data}, {k_no_data}}, {1, 1}, 10);
    EXPECT_EQ(effective_count(none), 0);
}

TEST(Posterior, MembersFarBelowTheGreatestWeightHaveNone) {
    const std::vector<double> weights = posterior_weights({{0.1}, {0.3}}, {1, 1}, 10);  // 3^-10 = 1.7e-5
    EXPECT_EQ(weights[1], 0);
    EXPECT_EQ(weights[0], 1);
}

// Quantiles of a Laplace distribution in closed form; 4096 points of a Sobol' sequence are 1/4096 apart in each key.
TEST(Posterior, IntervalsAreThoseOfTheClosedForm) {
    const StudySpec study = two_keys(4096);
    const Places places = draw_places(study);
    const std::vector<double> weights =
        posterior_weights(laplace_misfits(places), std::vector<double>(places.size(), 1), k_exponent);
    const std::vector<KeyPosterior> keys = key_posteriors(samples_of(study, places), weights);
    EXPECT_NEAR(keys[0].low, laplace_quantile(0.05), 0.002);
    EXPECT_NEAR(keys[0].median, laplace_quantile(0.5), 0.002);
    EXPECT_NEAR(keys[0].high, laplace_quantile(0.95), 0.002);
    EXPECT_NEAR(keys[0].prior_low, 0.05, 1e-9);
    EXPECT_NEAR(keys[0].prior_high, 0.95, 1e-9);
    EXPECT_NEAR(keys[0].width, (laplace_quantile(0.95) - laplace_quantile(0.05)) / 0.9, 0.005);
    EXPECT_NEAR(keys[1].low, 105, 1);
    EXPECT_NEAR(keys[1].high, 195, 1);
    EXPECT_NEAR(keys[1].width, 1, 0.01);
    // The figure of each key, and no verdict: 79.8 % of the prior's width counted as determined, 80.2 % did not.
    const auto said = sentences(keys, {});
    ASSERT_EQ(said.size(), 2U);
    EXPECT_NE(said[1].text().find("material.turbulence is 105"), std::string::npos) << said[1].text();
    EXPECT_NE(said[1].text().find("100 % of the width"), std::string::npos) << said[1].text();
}

// The same posterior from members drawn elsewhere: weights divide by the density from which they were drawn. A quantile
// from n effective members has the standard error sqrt(q (1 - q) / n) in probability; three of them.
TEST(Refined, MembersGiveTheSameIntervals) {
    const StudySpec study = two_keys(128);
    const Places design = draw_places(study);
    const std::vector<double> first =
        posterior_weights(laplace_misfits(design), std::vector<double>(design.size(), 1), k_exponent / 2);
    const RefinedPlaces refined = refined_places(design, first, 2000, 7);
    const std::vector<double> weights = posterior_weights(laplace_misfits(refined.places), refined.density, k_exponent);
    const double effective = effective_count(weights);
    EXPECT_GT(effective, 700);  // more than the 2000 x 0.1 that the prior would give
    const KeyPosterior key = key_posteriors(samples_of(study, refined.places), weights).front();
    for (const auto& [q, value] : {std::pair{0.05, key.low}, {0.5, key.median}, {0.95, key.high}}) {
        const double error = 3 * std::sqrt(q * (1 - q) / effective);
        EXPECT_GE(value, laplace_quantile(std::max(0.0, q - error))) << q;
        EXPECT_LE(value, laplace_quantile(std::min(1.0, q + error))) << q;
    }
}

// Mean of 1 / q over members drawn from q is the volume of the cube, 1; its standard error follows from the members.
TEST(Refined, DensityIsThatOfTheMembers) {
    const StudySpec study = two_keys(64);
    const Places design = draw_places(study);
    const RefinedPlaces refined = refined_places(
        design, posterior_weights(laplace_misfits(design), std::vector<double>(design.size(), 1), k_exponent), 4000, 3);
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
    Misfits misfits;
    for (const auto& place : places) misfits.push_back({std::exp(-2 + 4 * std::abs(place[0] + place[1] - 1))});
    const std::vector<double> weights = posterior_weights(misfits, std::vector<double>(places.size(), 1), k_exponent);
    const std::vector<KeySample> keys = samples_of(study, places);
    const auto pairs = indistinct_pairs(keys, weights);
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_LT(pairs[0].correlation, -0.95);
    const auto said = sentences(key_posteriors(keys, weights), pairs);
    EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const Sentence& one) {
        const std::string text = one.text();
        return text.find("cannot tell material.friction-coefficient from material.turbulence") != std::string::npos &&
               text.find("smaller values of the other") != std::string::npos;
    }));
}

TEST(Posterior, ChoicesHaveProbabilities) {
    KeySample key{
        "numerics.scheme", "",        std::get<Distribution>(distribution_from_text("choice(a: 0.5, b: 0.5)")),
        {0.1, 0.7, 0.9},   {0, 1, 1}, {"a", "b", "b"}};
    const KeyPosterior after = key_posteriors({key}, {0.25, 0.25, 0.5}).front();
    ASSERT_EQ(after.values.size(), 2U);
    EXPECT_EQ(after.values[0], (std::pair<std::string, double>{"a", 0.25}));
    EXPECT_EQ(after.values[1], (std::pair<std::string, double>{"b", 0.75}));
}

TEST(Posterior, FewMembersAreTold) {
    ASSERT_TRUE(few_members(12.6));
    EXPECT_NE(few_members(12.6)->text().find("12.6"), std::string::npos);
    EXPECT_FALSE(few_members(20));
}

}  // namespace
}  // namespace frana::app::study
