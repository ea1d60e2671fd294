// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/study/statistics/sensitivity.h"

namespace frana::app::study {
namespace {

StudySpec study_of(Sampling sampling, std::int64_t samples,
                   const std::vector<std::pair<std::string, std::string>>& vary) {
    StudySpec study;
    study.sampling = sampling;
    study.samples = samples;
    for (const auto& [key, text] : vary)
        study.vary.push_back({key, std::get<Distribution>(distribution_from_text(text))});
    return study;
}

SampleTable drawn(const StudySpec& study) {
    Problems problems;
    SampleTable table = draw_samples(study, "study.ini", problems);
    EXPECT_TRUE(problems.empty()) << describe(problems.list().front());
    return table;
}

std::vector<double> column(const SampleTable& table, std::size_t key) {
    std::vector<double> values;
    for (const auto& row : table.numbers) values.push_back(row[key]);
    return values;
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
    const double middle = mean(values);
    double sum = 0;
    for (const double value : values) sum += (value - middle) * (value - middle);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

// Moments of each distribution in closed form. 8 scrambled Sobol' sequences of 1000 points give means of smooth
// functions to about a thousandth of the deviation.
TEST(Sampling, ValuesHaveTheirDistributions) {
    const StudySpec study = study_of(Sampling::sobol, 8192,
                                     {{"material.friction-coefficient", "uniform(0.1, 0.3)"},
                                      {"material.turbulence", "log-uniform(500, 4000)"},
                                      {"release.volume", "triangular(1e5, 2e5, 4e5)"},
                                      {"material.density", "normal(2000, 100)"},
                                      {"material.viscosity", "log-normal(50, 20)"},
                                      {"release.thickness-direction", "choice(vertical: 3, normal: 1)"}});
    const SampleTable table = drawn(study);
    ASSERT_EQ(table.size(), 8192U);
    const double ratio = std::log(8.0), log_mean = 3500 / ratio,
                 log_square = (4000.0 * 4000 - 500.0 * 500) / (2 * ratio);
    const struct {
        double mean, deviation;
    } exact[] = {{0.2, 0.2 / std::sqrt(12.0)},
                 {log_mean, std::sqrt(log_square - log_mean * log_mean)},
                 {7e5 / 3, std::sqrt((1.0 + 4 + 16 - 2 - 4 - 8) / 18) * 1e5},
                 {2000, 100},
                 {50, 20},
                 {0.25, std::sqrt(0.25 * 0.75)}};
    for (std::size_t k = 0; k < std::size(exact); ++k) {
        EXPECT_NEAR(mean(column(table, k)), exact[k].mean, 0.01 * exact[k].deviation) << k;
        EXPECT_NEAR(deviation(column(table, k)), exact[k].deviation, 0.03 * exact[k].deviation) << k;
    }
}

TEST(Sampling, CorrelationsAreThoseOfTheRanks) {
    for (const Sampling sampling : {Sampling::sobol, Sampling::random}) {
        StudySpec study = study_of(sampling, 2000,
                                   {{"material.friction-coefficient", "uniform(0.1, 0.3)"},
                                    {"material.turbulence", "log-uniform(500, 4000)"}});
        study.correlate = {{"material.friction-coefficient", "material.turbulence", -0.4}};
        const SampleTable table = drawn(study);
        const double rho =
            rank_correlations({table.numbers, table.nominal, {}}, column(table, 1))[0].rank_correlation->value;
        EXPECT_NEAR(rho, -0.4, 0.06) << static_cast<int>(sampling);  // three standard errors of 2000 random members
        const std::vector<double> values = column(table, 0);
        EXPECT_GE(*std::min_element(values.begin(), values.end()), 0.1);
        EXPECT_LE(*std::max_element(values.begin(), values.end()), 0.3);
    }
}

TEST(Sampling, CorrelationsThatContradictEachOtherAreRefused) {
    StudySpec study = study_of(Sampling::random, 10,
                               {{"material.friction-coefficient", "uniform(0.1, 0.3)"},
                                {"material.turbulence", "uniform(500, 4000)"},
                                {"material.density", "uniform(1000, 2000)"}});
    study.correlate = {{"material.friction-coefficient", "material.turbulence", 0.9},
                       {"material.turbulence", "material.density", 0.9},
                       {"material.friction-coefficient", "material.density", -0.9}};
    Problems problems;
    (void)draw_samples(study, "study.ini", problems);
    ASSERT_EQ(problems.list().size(), 1U);
    EXPECT_EQ(problems.list()[0].where, "study.ini: correlate");
}

TEST(Sampling, TheSeedDecidesEverything) {
    for (const Sampling sampling : {Sampling::sobol, Sampling::random}) {
        StudySpec study = study_of(
            sampling, 40,
            {{"material.friction-coefficient", "uniform(0.1, 0.3)"}, {"terrain.error", "gaussian-field(0.5, 50)"}});
        const SampleTable first = drawn(study), again = drawn(study);
        EXPECT_EQ(first.values, again.values);
        study.seed = 2;
        EXPECT_NE(first.values, drawn(study).values);
        std::set<std::string> fields;
        for (const auto& row : first.values) fields.insert(row[1]);
        EXPECT_GE(fields.size(), 40U);
    }
}

// Any power of two of a Sobol' sequence has one value in each of n equal parts of every distribution; so has each
// replicate, and it is not the same as another one.
TEST(Sampling, EachReplicateFillsEveryPart) {
    const SampleTable table = drawn(
        study_of(Sampling::sobol, 128,
                 {{"material.friction-coefficient", "uniform(0, 1)"}, {"material.density", "uniform(1000, 2000)"}}));
    ASSERT_TRUE(table.is_replicated);
    std::vector<std::vector<double>> values(k_replicates);
    for (std::size_t m = 0; m < table.size(); ++m) values[table.replicate_of(m)].push_back(table.numbers[m][0]);
    std::set<std::vector<double>> different;
    for (const std::vector<double>& replicate : values) {
        std::set<int> parts;
        for (const double value : replicate)
            parts.insert(static_cast<int>(value * static_cast<double>(replicate.size())));
        EXPECT_EQ(parts.size(), replicate.size());
        different.insert(replicate);
    }
    EXPECT_EQ(different.size(), k_replicates);
}

TEST(Sampling, MoreMembersFollowThoseOfFewer) {
    for (const Sampling sampling : {Sampling::sobol, Sampling::random}) {
        StudySpec study = study_of(sampling, 64,
                                   {{"material.friction-coefficient", "uniform(0.1, 0.3)"},
                                    {"material.turbulence", "log-uniform(500, 4000)"}});
        const SampleTable few = drawn(study);
        study.samples = 400;
        const SampleTable many = drawn(study);
        ASSERT_EQ(many.size(), 400U);
        EXPECT_TRUE(std::equal(few.values.begin(), few.values.end(), many.values.begin())) << name_of(sampling);
    }
}

TEST(Sampling, ValuesOutsideTheRangeAreRefusedWithTheRemedy) {
    Problems problems;
    (void)draw_samples(study_of(Sampling::random, 200, {{"material.friction-coefficient", "normal(0.1, 0.1)"}}),
                       "study.ini", problems);
    ASSERT_EQ(problems.list().size(), 1U);
    EXPECT_EQ(problems.list()[0].where, "study.ini: vary.material.friction-coefficient");
    EXPECT_NE(problems.list()[0].remedy.find("normal(0.1, 0.1, low, high)"), std::string::npos);
    EXPECT_EQ(
        drawn(study_of(Sampling::random, 200, {{"material.friction-coefficient", "normal(0.1, 0.1, 0, 1)"}})).size(),
        200U);
}

TEST(Sampling, ATableGivesTheMembersItself) {
    Problems problems;
    const SampleTable table = samples_of_table(
        {"member", "material.turbulence", "weight", "release.perimeter"},
        {{"0", "500", "0.5", "a.shp"}, {"1", "700", "0", "b.shp"}, {"2", "900", "1.5", "a.shp"}}, "table", problems);
    EXPECT_TRUE(problems.empty());
    ASSERT_EQ(table.size(), 2U);  // one has no weight
    EXPECT_EQ(table.overrides(1), (std::vector<std::string>{"material.turbulence=900", "release.perimeter=a.shp"}));
    EXPECT_EQ(table.weights, (std::vector<double>{0.5, 1.5}));
    EXPECT_TRUE(table.nominal[1]);
    std::vector<TableColumn::Use> uses;
    for (const TableColumn& column : table.columns) uses.push_back(column.use);
    using Use = TableColumn::Use;
    EXPECT_EQ(uses, (std::vector<Use>{Use::result, Use::key, Use::weight, Use::key}));
    (void)samples_of_table({"member"}, {{"1"}}, "table", problems);
    EXPECT_EQ(problems.list().size(), 1U);  // no key
}

// A column that is dropped without a word leaves all members equal, with a standard error of 0.
TEST(Sampling, EveryColumnOfATableIsKnownOrRefusedWithTheNearest) {
    Problems problems;
    (void)samples_of_table({"material.friction-angle", "material.turbulense", "terrain.cell-size", "output.maps",
                            "gauge a.b: max_depth_m"},
                           {{"8", "5", "5", "on", "1"}}, "t.csv", problems);
    ASSERT_EQ(problems.list().size(), 3U);
    EXPECT_EQ(problems.list()[0].where, "t.csv: material.turbulense");
    EXPECT_NE(problems.list()[0].remedy.find("material.turbulence"), std::string::npos);
    EXPECT_EQ(problems.list()[1].where, "t.csv: terrain.cell-size");
    EXPECT_EQ(problems.list()[2].where, "t.csv: output.maps");
    for (const auto& [column, nearest] : {std::pair("materail.friction-angle", "material.friction-angle"),
                                          {"friction-angle", "material.friction-angle"},
                                          {"Material.Friction-Angle", "material.friction-angle"},
                                          {"weigth", "weight"},
                                          {"Weight", "weight"}}) {
        Problems of_one;
        (void)samples_of_table({"material.turbulence", column}, {{"500", "1"}}, "t.csv", of_one);
        ASSERT_EQ(of_one.list().size(), 1U) << column;
        EXPECT_EQ(of_one.list()[0].where, std::string("t.csv: ") + column);
        EXPECT_NE(of_one.list()[0].remedy.find(nearest), std::string::npos) << of_one.list()[0].remedy;
    }
}

// 1e308 twice is infinite, and every probability was 0.
TEST(Sampling, AWeightWhoseSumsAreNotFiniteIsRefused) {
    for (const char* weight : {"1e308", "1e-300", "-1", "nan", "x"}) {
        Problems problems;
        (void)samples_of_table({"material.turbulence", "weight"}, {{"500", "1"}, {"600", weight}}, "t.csv", problems);
        ASSERT_EQ(problems.list().size(), 1U) << weight;
        EXPECT_EQ(problems.list()[0].where, "t.csv: weight");
        EXPECT_EQ(problems.list()[0].value, weight);
    }
}

TEST(Sampling, ARowOfBlanksIsNoMember) {
    Problems problems;
    const SampleTable table = samples_of_table({"material.turbulence", "weight"},
                                               {{"500", "1"}, {" ", ""}, {"700", "2"}, {"", "\t"}}, "t.csv", problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(table.weights, (std::vector<double>{1, 2}));
    EXPECT_FALSE(table.nominal[0]);
}

TEST(Sampling, TheCentralMemberHasMediansAndLikeliestChoices) {
    EXPECT_EQ(central_values(study_of(Sampling::sobol, 10,
                                      {{"material.friction-coefficient", "uniform(0, 0.5)"},
                                       {"release.thickness-direction", "choice(vertical: 1, normal: 2)"},
                                       {"terrain.error", "gaussian-field(1, 10)"}})),
              (std::vector<std::string>{"material.friction-coefficient=0.25", "release.thickness-direction=normal"}));
}

/// A study whose volumes are exceeded once in these return periods.
StudySpec frequency_study(std::int64_t samples) {
    StudySpec study = study_of(Sampling::sobol, samples, {{"material.friction-coefficient", "uniform(0, 1)"}});
    study.frequency.rate = FrequencySpec::Rate{1.0 / 20, 0};
    study.frequency.volumes = {{8000, 20}, {15000, 100}, {35000, 300}};
    study.vary.insert(study.vary.begin(),
                      {"release.volume", {Law::return_periods, {8000, 1, 15000, 5, 35000, 15}, {}, {}, ""}});
    return study;
}

/// Weighted mean of a function of the rows, over all weight.
template <class Of>
double weighted(const SampleTable& table, const Of& of) {
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        sum += table.weights[i] * of(table.numbers[i]);
        all += table.weights[i];
    }
    return sum / all;
}

// With 4096 even members one of them is 1 / 4096 of the units of log exceedance, log(15) + 1, times a weight of 3.7.
TEST(Sampling, VolumesAreExceededAsOftenAsTheirReturnPeriodsSay) {
    const SampleTable table = drawn(frequency_study(4096));
    const auto years = [&](double volume) {
        return 20 / weighted(table, [&](const std::vector<double>& row) { return row[0] >= volume ? 1.0 : 0.0; });
    };
    EXPECT_NEAR(years(8000), 20, 1e-9);
    EXPECT_NEAR(years(15000) / 100, 1, 0.01);
    EXPECT_NEAR(years(35000) / 300, 1, 0.01);
    // On a straight line in logarithms: the middle of both.
    EXPECT_NEAR(years(std::sqrt(15000.0 * 35000)) / std::sqrt(100.0 * 300), 1, 0.01);
    double greatest = 0;
    std::size_t rare = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        greatest = std::max(greatest, table.weights[i]);
        rare += table.numbers[i][0] >= 15000 ? 1 : 0;
    }
    EXPECT_LE(greatest, std::log(15.0) + 1);
    EXPECT_NEAR(static_cast<double>(rare) / 4096, (std::log(3.0) + 1) / (std::log(15.0) + 1), 0.01)
        << "a fifth of the events is more than half of the members";
}

// What follows the volume keeps its own distribution: under the weights the place of a correlated key is even.
TEST(Sampling, AKeyThatFollowsTheVolumeKeepsItsDistribution) {
    StudySpec study = frequency_study(4096);
    study.correlate.push_back({"release.volume", "material.friction-coefficient", -0.6});
    const SampleTable table = drawn(study);
    for (const double part : {0.1, 0.5, 0.9})
        EXPECT_NEAR(weighted(table, [&](const std::vector<double>& row) { return row[1] < part ? 1.0 : 0.0; }), part,
                    0.01);
    EXPECT_LT(weighted(table, [&](const auto& row) { return row[0] >= 35000 ? row[1] : 0; }) * 15, 0.35)
        << "the largest have little";
}

// Means of the laws in closed form: (a + 4 c + b) / 6; of the Pareto law with the exponent 1 between 1 and 4, the
// integral of 1 / x over that of 1 / x^2.
TEST(Sampling, TheLawsOfFrequenciesHaveTheirMeans) {
    const SampleTable table = drawn(study_of(Sampling::sobol, 4096,
                                             {{"material.turbulence", "pert(1, 2, 6)"},
                                              {"release.volume", "pareto(1, 1, 4)"},
                                              {"time.end", "table(9: 3, 1: 1)"}}));
    EXPECT_NEAR(mean(column(table, 0)), 15.0 / 6, 0.005);
    EXPECT_NEAR(mean(column(table, 1)), std::log(4.0) / 0.75, 0.005);
    EXPECT_NEAR(mean(column(table, 2)), 7, 0.01);
    EXPECT_FALSE(table.nominal[2]);
}

}  // namespace
}  // namespace frana::app::study
