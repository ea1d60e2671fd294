// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/sampling.h"

#include <gtest/gtest.h>

namespace frana::app::study {
namespace {

Distribution good(const std::string& text) {
    const auto read = distribution_from_text(text);
    const auto* refusal = std::get_if<ValueProblem>(&read);
    EXPECT_EQ(refusal, nullptr) << text << ": " << (refusal != nullptr ? refusal->what : "");
    return refusal == nullptr ? std::get<Distribution>(read) : Distribution{};
}

std::string refusal(const std::string& text) {
    const auto read = distribution_from_text(text);
    const auto* one = std::get_if<ValueProblem>(&read);
    EXPECT_NE(one, nullptr) << text;
    return one == nullptr ? "" : one->what;
}

TEST(DistributionText, EveryFormIsRead) {
    EXPECT_EQ(good("uniform(0.15, 0.35)").numbers, (std::vector<double>{0.15, 0.35}));
    EXPECT_EQ(good("log-uniform(500, 4000)").law, Law::log_uniform);
    EXPECT_EQ(good("normal(1, 2)").numbers.size(), 2U);
    EXPECT_EQ(good("normal(1, 2, 0, 3)").numbers.size(), 4U);
    EXPECT_EQ(good("log-normal(1, 2)").law, Law::log_normal);
    EXPECT_EQ(good("triangular(1e5, 2e5, 4e5)").numbers[1], 2e5);
    EXPECT_EQ(good("gaussian-field(0.5, 50)").law, Law::gaussian_field);
    EXPECT_EQ(good("pert(1, 2, 4)").numbers.size(), 3U);
    EXPECT_EQ(good("pareto(1e3, 0.8, 1e5)").law, Law::pareto);
    const Distribution table = good("table(16: 1, 9: 3)");
    EXPECT_EQ(table.numbers, (std::vector<double>{9, 16}));
    EXPECT_EQ(table.weights, (std::vector<double>{0.75, 0.25}));
}

TEST(DistributionText, ValuesOfChoicesMayContainColonsAndCommas) {
    const Distribution files = good(R"(choice(raster:a.tif: 1, "difference:a.tif,b.tif": 3))");
    EXPECT_EQ(files.values, (std::vector<std::string>{"raster:a.tif", "difference:a.tif,b.tif"}));
    EXPECT_EQ(files.weights, (std::vector<double>{0.25, 0.75}));
    EXPECT_EQ(good("choice(a.shp, b.shp)").weights, (std::vector<double>{0.5, 0.5}));
    EXPECT_EQ(good("choice(4, 9, 16)").values.size(), 3U);
}

TEST(DistributionText, WhatMakesNoSenseIsRefused) {
    for (const std::string text : {"0.3",
                                   "uniform",
                                   "uniform(1)",
                                   "uniform(2, 1)",
                                   "uniform(1, 1)",
                                   "uniform(1, x)",
                                   "uniform(1, 2",
                                   "(1, 2)",
                                   "log-uniform(0, 1)",
                                   "normal(1, 0)",
                                   "normal(1, 2, 3)",
                                   "normal(1, 2, 2, 3)",
                                   "log-normal(0, 1)",
                                   "triangular(1, 0, 2)",
                                   "triangular(1, 1, 1)",
                                   "pert(1, 0, 2)",
                                   "pareto(0, 1, 2)",
                                   "pareto(1, 0, 2)",
                                   "pareto(2, 1, 1)",
                                   "table(a: 1)",
                                   "table(1: 1, 1.0: 2)",
                                   "table(1: 0)",
                                   "choice()",
                                   "choice(a: 0)",
                                   "choice(a: 1, b)",
                                   "choice(a, a)",
                                   "choice(\"a)",
                                   "gaussian-field(0, 1)",
                                   "gaussian-field(1)",
                                   "beta(1, 2)"})
        EXPECT_FALSE(refusal(text).empty()) << text;
}

}  // namespace
}  // namespace frana::app::study
