// SPDX-License-Identifier: Apache-2.0
#include "analysis/hazard.h"

#include <gtest/gtest.h>

namespace frana {
namespace {

constexpr HazardDegree k_red = HazardDegree::red, k_blue = HazardDegree::blue, k_yellow = HazardDegree::yellow,
                       k_residual = HazardDegree::residual;

// All twelve combinations by hand: three intensities with a high, medium, low and very low probability.
TEST(HazardDegree, MatrixOfIntensityAndProbability) {
    const DegreeMatrix matrix;
    const HazardDegree expected[3][4] = {
        {k_blue, k_blue, k_yellow, k_residual}, {k_red, k_blue, k_blue, k_residual}, {k_red, k_red, k_red, k_residual}};
    const double years[4] = {30, 100, 300, 301};
    for (int intensity = 1; intensity <= 3; ++intensity)
        for (int p = 0; p < 4; ++p)
            EXPECT_EQ(matrix.of(intensity, years[p]), expected[intensity - 1][p]) << intensity << ' ' << years[p];
}

// A limit belongs to the more probable class.
TEST(HazardDegree, LimitsAreThoseGiven) {
    DegreeMatrix matrix;
    matrix.periods = {10, 50, 200};
    EXPECT_EQ(matrix.of(1, 10), k_blue);
    EXPECT_EQ(matrix.of(1, 50.001), k_yellow);
    EXPECT_EQ(matrix.of(3, 200), k_red);
    EXPECT_EQ(matrix.of(3, 200.001), k_residual);
}

TEST(HazardDegree, LegendNamesWhatLeadsToEachDegree) {
    const DegreeMatrix matrix;
    EXPECT_EQ(matrix.conditions_of(k_red), "strong \u2264 300 a; medium \u2264 30 a");
    EXPECT_EQ(matrix.conditions_of(k_blue), "medium 30 \u2013 300 a; weak \u2264 100 a");
    EXPECT_EQ(matrix.conditions_of(k_yellow), "weak 100 \u2013 300 a");
    EXPECT_EQ(matrix.conditions_of(k_residual), "any > 300 a");
    for (const HazardClass& one : degree_classes(matrix))
        EXPECT_EQ(one.thresholds, matrix.conditions_of(static_cast<HazardDegree>(one.value)));
}

TEST(HazardDegree, NamesAreReadBack) {
    for (const HazardDegree degree : {k_red, k_blue, k_yellow, k_residual})
        EXPECT_EQ(degree_from(name_of(degree)), degree);
    EXPECT_FALSE(degree_from("orange"));
}

TEST(HazardDegree, SchemesWithThreeIntensities) {
    HazardScheme scheme;
    for (const int value : {1, 2, 3}) scheme.classes.push_back({.value = value});
    scheme.matrices.emplace_back();
    EXPECT_TRUE(has_intensities(scheme));
    scheme.classes.erase(scheme.classes.begin());
    EXPECT_TRUE(has_intensities(scheme)) << "the upper two";
    scheme.matrices.clear();
    EXPECT_FALSE(has_intensities(scheme)) << "no matrix";
    HazardScheme two;
    for (const int value : {1, 2}) two.classes.push_back({.value = value});
    two.matrices.emplace_back();
    EXPECT_FALSE(has_intensities(two));
}

}  // namespace
}  // namespace frana
