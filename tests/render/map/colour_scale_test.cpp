// SPDX-License-Identifier: Apache-2.0
#include "render/map/legend.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "scenes.h"

namespace frana::render {
namespace {

Raster values(std::vector<double> list) {
    Raster raster(GridSpec{0, 0, 1, static_cast<std::int64_t>(list.size()), 1, ""});
    raster.values = std::move(list);
    return raster;
}

std::vector<std::string> labels(const ColourScale& scale) {
    std::vector<std::string> all;
    for (const ColourClass& one : scale.classes()) all.push_back(one.label);
    return all;
}

// Maps of different results, films and the frames of a film have the same classes in the same colours.
TEST(ColourScale, FixedClassesDoNotDependOnTheValues) {
    const std::vector<double> fixed{0, 0.5, 2, std::numeric_limits<double>::infinity()};
    const Raster small = values({0.01}), great = values({0.3, 1, 800});
    const ColourScale a({"depth", fixed, {}, &small}), b({"depth", fixed, {}, &great}),
        film({"depth", fixed, {}, &small, true});
    EXPECT_EQ(labels(a), (std::vector<std::string>{"0 – 0.5", "0.5 – 2", "> 2"}));
    for (const ColourScale* other : {&b, &film}) {
        ASSERT_EQ(labels(*other), labels(a));
        for (std::size_t i = 0; i < a.classes().size(); ++i)
            EXPECT_EQ(other->classes()[i].colour, a.classes()[i].colour);
    }
    EXPECT_EQ(b.find(800)->label, "> 2");
    EXPECT_THROW(ColourScale({"depth", {0, fixed.back()}, {}, &great}), Error);
}

TEST(ColourScale, EveryValueOfTheDataHasAClassThatContainsIt) {
    const Raster layer = values({0.001, 0.5, 1.99, 2, 7.3, 9.9999, 10, k_no_data});
    const ColourScale scale({"depth", {}, {}, &layer});
    for (const double value : layer.values) {
        const ColourClass* found = scale.find(value);
        if (std::isnan(value)) {
            EXPECT_EQ(found, nullptr);
            continue;
        }
        ASSERT_NE(found, nullptr) << value;
        EXPECT_LE(found->lower, value);
        EXPECT_GE(found->upper, value);
    }
    EXPECT_EQ(scale.find(2.0)->lower, 2.0);    // a bound belongs to the class above
    EXPECT_EQ(scale.find(10.0)->upper, 10.0);  // except the last
    EXPECT_EQ(scale.find(10.1), nullptr);
}

TEST(ColourScale, ValuesBeyondGivenBoundsGetOpenClasses) {
    const Raster layer = values({0.05, 0.3, 1.5, 30});
    const ColourScale scale({"depth", {0.1, 0.5, 2}, {}, &layer});
    EXPECT_EQ(labels(scale), (std::vector<std::string>{"< 0.1", "0.1 – 0.5", "0.5 – 2", "> 2"}));
    EXPECT_EQ(scale.find(0.05)->label, "< 0.1");
    EXPECT_EQ(scale.find(30)->label, "> 2");
    EXPECT_EQ(scale.find(2)->label, "0.5 – 2");
    EXPECT_EQ(scale.find(0.1)->label, "0.1 – 0.5");
}

TEST(ColourScale, ClassesWithoutValuesBeyondStayClosed) {
    const Raster layer = values({0.2, 1});
    EXPECT_EQ(labels(ColourScale({"depth", {0.1, 0.5, 2}, {}, &layer})),
              (std::vector<std::string>{"0.1 – 0.5", "0.5 – 2"}));
}

TEST(ColourScale, SkewedValuesGetWideningClasses) {
    std::vector<double> list(100, 0.3);
    list.push_back(17);
    const Raster layer = values(list);
    EXPECT_EQ(labels(ColourScale({"depth", {}, {}, &layer})),
              (std::vector<std::string>{"0 – 0.2", "0.2 – 0.5", "0.5 – 1", "1 – 2", "2 – 5", "5 – 10", "10 – 20"}));
}

TEST(ColourScale, BothSidesOfZero) {
    const Raster layer = values({-3.2, 0.5, 6.1});
    const ColourScale scale({"depth", {}, {}, &layer});
    EXPECT_LE(scale.classes().front().lower, -3.2);
    EXPECT_GE(scale.classes().back().upper, 6.1);
    EXPECT_EQ(scale.find(0.0)->lower, 0.0);
}

TEST(ColourScale, CategoriesMatchExactly) {
    const Raster layer = values({1, 2, 3, 4});
    const ColourScale scale({"depth", {}, {{1, "hit", {1, 2, 3}}, {3, "miss", {4, 5, 6}}}, &layer});
    EXPECT_EQ(scale.find(1)->label, "hit");
    EXPECT_EQ(scale.find(3)->colour, test::in_legend({4, 5, 6}));
    EXPECT_EQ(scale.find(2), nullptr);
}

TEST(ColourScale, ContradictionsAreAllReported) {
    try {
        ColourScale({"depth", {2, 1}, {{1, "hit", {}}}, nullptr});
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_EQ(error.problems().size(), 2U);
    }
}

}  // namespace
}  // namespace frana::render
