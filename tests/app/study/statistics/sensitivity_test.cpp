// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/study/plan/sampling.h"

namespace frana::app::study {
namespace {

/// Three keys, each even in 0 to 1, by the same code as a study's.
SampleTable design(Sampling sampling, std::int64_t samples) {
    StudySpec study;
    study.sampling = sampling;
    study.samples = samples;
    for (const std::string key : {"material.friction-coefficient", "material.pore-pressure-ratio", "time.stop-window"})
        study.vary.push_back({key, std::get<Distribution>(distribution_from_text("uniform(0.1, 0.9)"))});
    Problems problems;
    return draw_samples(study, "study.ini", problems);
}

// Ishigami & Homma 1990: closed forms for a = 7, b = 0.1.
TEST(SobolIndices, OfIshigamisFunction) {
    constexpr double a = 7, b = 0.1, pi = std::numbers::pi;
    const SampleTable table = design(Sampling::saltelli, 5 * 2048);
    ASSERT_EQ(table.groups, 2048U);
    std::vector<double> output;
    for (const auto& row : table.numbers) {
        const auto x = [&](std::size_t k) { return -pi + 2 * pi * (row[k] - 0.1) / 0.8; };
        output.push_back(std::sin(x(0)) + a * std::pow(std::sin(x(1)), 2) + b * std::pow(x(2), 4) * std::sin(x(0)));
    }
    const auto keys = sobol_indices({table.numbers, table.nominal}, {output}, table.groups).front();
    const double first = 0.5 * std::pow(1 + b * std::pow(pi, 4) / 5, 2), second = a * a / 8,
                 joint = b * b * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50), all = first + second + joint;
    const double exact_first[] = {first / all, second / all, 0},
                 exact_total[] = {(first + joint) / all, second / all, joint / all};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(keys[k].first_order->value, exact_first[k], 0.02) << k;
        EXPECT_NEAR(keys[k].total->value, exact_total[k], 0.02) << k;
        EXPECT_LE(keys[k].first_order->low, exact_first[k]) << k;
        EXPECT_GE(keys[k].first_order->high, exact_first[k]) << k;
        EXPECT_EQ(keys[k].method, "Martinez");
    }
}

// A linear function: the indices are the squared coefficients over their sum, and there are no interactions.
TEST(SobolIndices, OfALinearFunction) {
    const SampleTable table = design(Sampling::saltelli, 5 * 1024);
    std::vector<double> output, constant(table.size(), 3.0);
    for (const auto& row : table.numbers) output.push_back(3 * row[0] + 2 * row[1] + row[2]);
    const auto both = sobol_indices({table.numbers, table.nominal}, {output, constant}, table.groups);
    const double exact[] = {9.0 / 14, 4.0 / 14, 1.0 / 14};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(both[0][k].first_order->value, exact[k], 0.02) << k;
        EXPECT_NEAR(both[0][k].total->value, exact[k], 0.02) << k;
        EXPECT_FALSE(both[1][k].first_order) << "a figure that does not vary is sensitive to nothing";
    }
}

TEST(RankCorrelations, OfMonotonicAndIndependentKeys) {
    const SampleTable table = design(Sampling::sobol, 512);
    const RankCorrelations ranks({table.numbers, table.nominal});
    std::vector<double> output;
    for (const auto& row : table.numbers) output.push_back(std::exp(-8 * row[1]));
    const auto keys = ranks.with(output);
    EXPECT_DOUBLE_EQ(keys[1].rank_correlation->value, -1);
    EXPECT_NEAR(keys[0].rank_correlation->value, 0, 0.05);
    EXPECT_LT(keys[0].rank_correlation->low, 0);
    EXPECT_GT(keys[0].rank_correlation->high, 0);
    EXPECT_EQ(keys[0].method, "Spearman");
    // An event that happens in the upper half: the rank correlation of even ranks with it is sqrt(3)/2.
    std::vector<char> happened;
    for (const auto& row : table.numbers) happened.push_back(static_cast<char>(row[0] > 0.5));
    EXPECT_NEAR(ranks.with_event(0, happened), std::sqrt(3.0) / 2, 1e-3);
}

TEST(RankCorrelations, OfKeysWithoutOrderAreRatios) {
    DesignPoints points{{}, {true, true}};
    std::vector<double> output;
    for (int i = 0; i < 60; ++i) {
        points.numbers.push_back({static_cast<double>(i % 3), static_cast<double>(i)});
        output.push_back(i % 3 == 1 ? 10 : 0);  // neither rises nor falls with the index
    }
    const auto keys = RankCorrelations(points).with(output);
    EXPECT_DOUBLE_EQ(keys[0].rank_correlation->value, 1);
    EXPECT_EQ(keys[0].method, "correlation ratio");
    EXPECT_FALSE(keys[1].rank_correlation) << "a class of its own in every member explains everything and nothing";
}

}  // namespace
}  // namespace frana::app::study
