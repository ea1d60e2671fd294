// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/study/plan/sampling.h"

namespace frana::app::study {
namespace {

/// Three keys, each even in 0 to 1, by the same code as a study's.
SampleTable design(Sampling sampling, std::int64_t samples, std::int64_t seed = 1) {
    StudySpec study;
    study.seed = seed;
    study.sampling = sampling;
    study.samples = samples;
    for (const std::string key : {"material.friction-coefficient", "material.pore-pressure-ratio", "time.stop-change"})
        study.vary.push_back({key, std::get<Distribution>(distribution_from_text("uniform(0.1, 0.9)"))});
    Problems problems;
    return draw_samples(study, "study.ini", problems);
}

// y = 3 u + u v of places u, v even in (0, 1): u moved by a half changes it by (3 + v) / 2, v by u / 2, the third key
// by nothing. 64 points of 8 sequences give means of such functions to about a hundredth of their deviation.
TEST(ElementaryEffects, OfAProduct) {
    const SampleTable table = design(Sampling::morris, 4 * 64);
    ASSERT_EQ(table.groups, 64U);
    std::vector<double> output;
    for (const auto& place : table.places) output.push_back(3 * place[0] + place[0] * place[1]);
    const auto keys = elementary_effects({table.numbers, table.nominal, table.places}, output, table.groups);
    EXPECT_NEAR(keys[0].effect->value, 1.75, 0.01);
    EXPECT_NEAR(keys[1].effect->value, 0.25, 0.01);
    EXPECT_EQ(keys[2].effect->value, 0);
    for (const std::size_t k : {0U, 1U}) EXPECT_NEAR(keys[k].effect_scatter, 0.5 / std::sqrt(12.0), 0.01) << k;
    EXPECT_LT(keys[0].effect->low, 1.75);
    EXPECT_GT(keys[0].effect->high, 1.75);
    // A key that first helps and then hinders has an effect, and its sign changes.
    for (std::size_t i = 0; i < output.size(); ++i) output[i] = std::abs(table.places[i][2] - 0.5) * 4;
    const auto bent = elementary_effects({table.numbers, table.nominal, table.places}, output, table.groups);
    EXPECT_GT(bent[2].effect_scatter, 0.5 * bent[2].effect->value);
}

TEST(RankCorrelations, OfMonotonicAndIndependentKeys) {
    const SampleTable table = design(Sampling::sobol, 512);
    std::vector<double> output;
    for (const auto& row : table.numbers) output.push_back(std::exp(-8 * row[1]));
    const auto keys = rank_correlations({table.numbers, table.nominal, {}}, output);
    EXPECT_DOUBLE_EQ(keys[1].rank_correlation->value, -1);
    EXPECT_NEAR(keys[0].rank_correlation->value, 0, 0.05);
    EXPECT_LT(keys[0].rank_correlation->low, 0);
    EXPECT_GT(keys[0].rank_correlation->high, 0);
}

// y = u + 2 v^2 + u v with u, v even in (0, 1): the variances of its parts are integrals of polynomials, which a
// polynomial of degree 2 has exactly; the third key has none. Rounding of 32 members is below 1e-9.
TEST(Chaos, HasTheFractionsOfAPolynomial) {
    const SampleTable table = design(Sampling::sobol, 32);
    std::vector<double> output, constant(table.size(), 3.0);
    for (const auto& place : table.places) output.push_back(place[0] + 2 * place[1] * place[1] + place[0] * place[1]);
    const auto both = openturns().chaos({table.numbers, table.nominal, table.places}, {output, constant}, {});
    // E[y | u] = 2/3 + 3/2 u, E[y | v] = 1/2 + v/2 + 2 v^2, and the product of the two centred.
    const double of_u = 9.0 / 48, of_v = 1.0 / 48 + 4.0 * 4 / 45 + 2 * 2 * 0.5 / 12, of_both = 1.0 / 144,
                 all = of_u + of_v + of_both;
    EXPECT_NEAR(both[0].q2, 1, 1e-9);
    EXPECT_NEAR(both[0].first_order[0], of_u / all, 1e-9);
    EXPECT_NEAR(both[0].first_order[1], of_v / all, 1e-9);
    EXPECT_NEAR(both[0].total[0], (of_u + of_both) / all, 1e-9);
    EXPECT_NEAR(both[0].total[2], 0, 1e-9);
    EXPECT_TRUE(std::isnan(both[1].q2));
}

// A choice of three values of which the middle one differs, with other counts of each, and a number: 60 members.
TEST(Chaos, HasKeysWithoutOrder) {
    DesignPoints points{{}, {true, false, true}, {}};
    std::vector<double> output;
    for (int i = 0; i < 60; ++i) {
        const double choice = i % 6 < 3 ? 0 : i % 6 < 4 ? 1 : 2, place = (i * 37 % 60 + 0.5) / 60;
        points.numbers.push_back({choice, place, static_cast<double>(i)});
        points.places.push_back({0, place, 0});
        output.push_back((choice == 1 ? 10 : 0) + 12 * place);
    }
    const Chaos chaos = openturns().chaos(points, {output}, {}).front();
    const double of_choice = 100.0 / 6 * 5 / 6, of_number = 12;  // the variance of an even number is 1/12
    EXPECT_NEAR(chaos.q2, 1, 1e-9);
    EXPECT_NEAR(chaos.first_order[0], of_choice / (of_choice + of_number), 1e-9);
    EXPECT_NEAR(chaos.first_order[1], of_number / (of_choice + of_number), 1e-9);
    EXPECT_EQ(chaos.first_order[2], 0) << "a value of its own in every member explains everything and nothing";
}

// An output that the keys do not decide: no polynomial predicts it, however many terms it has.
TEST(Chaos, DoesNotPredictWhatIsRandom) {
    const SampleTable table = design(Sampling::sobol, 64), other = design(Sampling::random, 64);
    std::vector<double> output;
    for (const auto& row : other.numbers) output.push_back(row[0]);
    EXPECT_LT(openturns().chaos({table.numbers, table.nominal, table.places}, {output}, {}).front().q2, 0.3);
}

// Twenty designs of 64 members of a smooth run-out against 2^13 members: every fraction to a few hundredths.
TEST(Chaos, SixtyFourMembersTellTheFractions) {
    const auto run_out = [](const std::vector<double>& x) { return std::cbrt(1 + x[2]) / (x[0] + 0.1 / (0.2 + x[1])); };
    const auto fractions = [&](const SampleTable& table) {
        std::vector<double> output;
        for (const auto& row : table.numbers) output.push_back(run_out(row));
        return openturns().chaos({table.numbers, table.nominal, table.places}, {output}, {}).front();
    };
    const Chaos exact = fractions(design(Sampling::sobol, 8192));
    for (int seed = 1; seed <= 20; ++seed) {
        const Chaos chaos = fractions(design(Sampling::sobol, 64, seed));
        EXPECT_GT(chaos.q2, k_least_q2);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(chaos.first_order[k], exact.first_order[k], 0.05) << seed;
    }
}

TEST(Chaos, TablesWhoseKeysDependOnEachOtherAreKnown) {
    DesignPoints points{{}, {false, false}, {}};
    for (int i = 0; i < 64; ++i) points.numbers.push_back({static_cast<double>(i), static_cast<double>(i * 37 % 64)});
    EXPECT_FALSE(are_correlated(points));
    for (auto& row : points.numbers) row[1] += row[0];
    EXPECT_TRUE(are_correlated(points));
}

TEST(RankCorrelations, OfKeysWithoutOrderAreRatios) {
    DesignPoints points{{}, {true, true}, {}};
    std::vector<double> output;
    for (int i = 0; i < 60; ++i) {
        points.numbers.push_back({static_cast<double>(i % 3), static_cast<double>(i)});
        output.push_back(i % 3 == 1 ? 10 : 0);  // neither rises nor falls with the index
    }
    const auto keys = rank_correlations(points, output);
    EXPECT_DOUBLE_EQ(keys[0].rank_correlation->value, 1);
    EXPECT_TRUE(std::isnan(keys[0].rank_correlation->low)) << "it has no interval";
    EXPECT_FALSE(keys[1].rank_correlation) << "a class of its own in every member explains everything and nothing";
}

}  // namespace
}  // namespace frana::app::study
