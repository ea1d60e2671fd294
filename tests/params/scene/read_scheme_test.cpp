// SPDX-License-Identifier: Apache-2.0
// Files of hazard schemes: those of share/schemes, and what is refused.
#include "params/scene/read_scheme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/words/words.h"
#include "params/grammar/data_file.h"
#include "scene_fixture.h"

namespace frana {
namespace {

HazardScheme scheme(const std::string& name) {
    Problems problems;
    HazardScheme read = read_scheme(FRANA_SOURCE_SHARE "/schemes/" + name + ".ini", name, problems);
    EXPECT_TRUE(problems.empty()) << name;
    return read;
}

/// One cell; the quantities that its scheme does not use are zero.
double class_of(const HazardScheme& scheme, const std::vector<double>& q) {
    GridSpec grid;
    grid.columns = grid.rows = 1;
    std::vector<Raster> all(7, Raster(grid));
    for (std::size_t i = 0; i < q.size(); ++i) all[i].values[0] = q[i];
    return hazard_classes(scheme, {all[0], all[1], all[2], all[3], all[4], all[5], all[6]}).values[0];
}

const std::vector<std::string> k_names{
    "austrian-avalanche", "austrian-torrent", "italian-avalanche",          "swiss-avalanche",
    "swiss-debris-flow",  "swiss-flood",      "swiss-hillslope-debris-flow"};

TEST(SharedSchemes, AreThoseNamed) {
    EXPECT_EQ(data_names(FRANA_SOURCE_SHARE, k_scheme_folder), k_names);
}

TEST(SharedSchemes, HaveFiveNamesColoursThatDifferInLightnessAndASource) {
    for (const std::string& name : k_names) {
        const HazardScheme one = scheme(name);
        EXPECT_EQ(one.name, name);
        EXPECT_FALSE(one.named_source.empty()) << name;
        EXPECT_EQ(one.source == k_source_not_read, one.quote.empty()) << name;
        ASSERT_GE(one.classes.size(), 2U);
        for (const LanguageRow& language : languages().subspan(1)) {
            ASSERT_TRUE(one.texts.contains(language.code)) << name;
            EXPECT_EQ(one.texts.at(language.code).size(), one.classes.size() + 1) << name << ' ' << language.code;
            EXPECT_TRUE(one.texts.at(language.code).contains(one.called));
        }
        for (std::size_t i = 0; i < one.classes.size(); ++i) {
            EXPECT_FALSE(one.classes[i].thresholds.empty());
            if (i == 0) continue;
            const auto tone = [](Rgb c) { return 0.299 * c.r + 0.587 * c.g + 0.114 * c.b; };       // Rec. 601, of 255
            EXPECT_LT(tone(one.classes[i].colour), tone(one.classes[i - 1].colour) - 40) << name;  // darker in grey
        }
        EXPECT_TRUE(std::isfinite(class_of(one, {9, 9, 9, 9, 99, 9}))) << name;
        // Pressures have the warm colours of their practice: never more green than red.
        for (const HazardClass& kind : one.classes)
            if (one.uses(HazardQuantity::pressure)) {
                EXPECT_GE(kind.colour.r, kind.colour.g) << name;
            }
    }
}

TEST(SharedSchemes, PutValuesIntoTheirClasses) {
    const HazardScheme flow = scheme("swiss-debris-flow"), flood = scheme("swiss-flood"),
                       torrent = scheme("austrian-torrent"), snow = scheme("swiss-avalanche"),
                       austria = scheme("austrian-avalanche"), italy = scheme("italian-avalanche"),
                       slope = scheme("swiss-hillslope-debris-flow");
    EXPECT_EQ(class_of(flow, {1.01, 1.01}), 3);
    for (const auto& [h, v] : {std::pair{1.01, 1.0}, {1.0, 8.0}, {3.0, 0.5}, {0.2, 9.0}})
        EXPECT_EQ(class_of(flow, {h, v}), 2) << h << ' ' << v;
    for (const auto& [h, q, kind] : {std::tuple{2.01, 0.0, 3},
                                     {2.0, 0.0, 2},
                                     {0.5, 0.0, 1},
                                     {0.51, 0.0, 2},
                                     {0.4, 0.5, 1},
                                     {0.4, 0.51, 2},
                                     {0.4, 2.01, 3}})
        EXPECT_EQ(class_of(flood, {h, 0, q}), kind) << h << ' ' << q;
    EXPECT_EQ(class_of(torrent, {1, 0, 0, 1.49, 0, 0.69}), 1);
    EXPECT_EQ(class_of(torrent, {1, 0, 0, 1.5, 0, 0}), 2);
    EXPECT_EQ(class_of(torrent, {1, 0, 0, 0, 0, 0.7}), 2);
    EXPECT_EQ(class_of(snow, {1, 0, 0, 0, 29.99}), 2);
    EXPECT_EQ(class_of(snow, {1, 0, 0, 0, 30}), 3);
    EXPECT_TRUE(std::isnan(class_of(austria, {1, 0, 0, 0, 0.99}))) << "no zone below 1 kPa";
    EXPECT_EQ(class_of(austria, {1, 0, 0, 0, 1}), 1);
    EXPECT_EQ(class_of(austria, {1, 0, 0, 0, 10}), 1);
    EXPECT_EQ(class_of(austria, {1, 0, 0, 0, 10.01}), 2);
    for (const auto& [p, kind] : {std::pair{2.99, 1}, {3.0, 2}, {14.99, 2}, {15.0, 3}})
        EXPECT_EQ(class_of(italy, {1, 0, 0, 0, p}), kind) << p;
    for (const auto& [h, kind] : {std::pair{0.1, 1}, {0.11, 2}, {1.0, 2}, {1.01, 3}})
        EXPECT_EQ(class_of(slope, {h}), kind) << h;
}

TEST(SharedSchemes, OnlyThoseWithAMatrixTellIntensities) {
    for (const std::string& name : k_names) EXPECT_EQ(has_intensities(scheme(name)), name.starts_with("swiss")) << name;
    // Of those with a matrix for all processes and one of their own, one must be named.
    const DegreeMatrix usual;
    for (const std::string& name : k_names) {
        if (!name.starts_with("swiss")) continue;
        const HazardScheme one = scheme(name);
        const bool is_asked = one.matrix_of({}) == nullptr;
        EXPECT_EQ(is_asked, name != "swiss-avalanche") << name;
        const ProcessMatrix* const all = one.matrix_of(is_asked ? std::optional<std::string>("all") : std::nullopt);
        ASSERT_NE(all, nullptr) << name;
        EXPECT_EQ(all->degrees.periods, usual.periods) << name;
        EXPECT_EQ(all->degrees.degrees, usual.degrees) << name;
        if (!is_asked) continue;
        const ProcessMatrix& own = one.matrices.back();
        EXPECT_EQ(one.matrix_of(own.process), &own);
        EXPECT_NE(own.degrees.degrees, usual.degrees) << name;
        EXPECT_NE(own.source.find("Ticino"), std::string::npos) << name;
    }
    EXPECT_EQ(scheme("swiss-debris-flow").matrix_of("channel-debris-flow")->degrees.of(2, 300), HazardDegree::yellow);
}

TEST(SharedSchemes, TheDocumentHasEveryClass) {
    std::stringstream document;
    document << std::ifstream(FRANA_SOURCE_SHARE "/doc/hazard.md").rdbuf();
    for (const std::string& name : k_names) {
        const HazardScheme one = scheme(name);
        std::string classes;
        for (const HazardClass& kind : one.classes)
            classes +=
                (classes.empty() ? "" : "; ") + std::to_string(kind.value) + " " + kind.name + ": " + kind.thresholds;
        const std::string row =
            "| `" + name + "` | " + one.called + " | " + classes + " | " + (one.quote.empty() ? "no" : "yes") + " |\n";
        EXPECT_NE(document.str().find(row), std::string::npos) << row;
    }
}

class SchemeFile : public SceneFixture {
  protected:
    std::vector<Problem> refused(const std::string& text) const {
        Problems problems;
        (void)read_scheme(write(text, "own.ini"), "own.ini", problems);
        return problems.list();
    }
    static bool has(const std::vector<Problem>& problems, const std::string& key, const std::string& what) {
        return std::any_of(problems.begin(), problems.end(), [&](const Problem& one) {
            return one.where == "own.ini: " + key && one.what.find(what) != std::string::npos;
        });
    }
};

const std::string k_scheme_head = "[scheme]\ntitle = Ours\nsource = Office\n",
                  k_low = "[class-1]\nname = Low\ncolour = ffdd33\n",
                  k_high = "[class-2]\nname = High\ncolour = d7191c\ncondition = ";

TEST_F(SchemeFile, ASmallOneIsEnough) {
    EXPECT_TRUE(
        refused(k_scheme_head + k_low + k_high + "pressure > 5 kPa or depth > 1 m and velocity >= 2 m/s\n").empty());
}

TEST_F(SchemeFile, EveryMistakeIsToldAtOnceWithItsKey) {
    const auto problems = refused(
        "[scheme]\nsource = Office\nquote = words\nclasses-are = areas\nreturn-periods = 100, 30\ntitel-it = x\n"
        "[class-1]\nname = A: b\ncolour = red\n[class-3]\nname = C\ncolour = d7191c\ncondition = depth > 1 km\n");
    EXPECT_TRUE(has(problems, "scheme.title", "is missing"));
    EXPECT_TRUE(has(problems, "scheme.quote", "belong together"));
    EXPECT_TRUE(has(problems, "scheme.classes-are", "is not known"));
    EXPECT_TRUE(has(problems, "scheme.return-periods", "not a greater number"));
    EXPECT_TRUE(has(problems, "scheme.titel-it", "unknown key"));
    EXPECT_TRUE(has(problems, "class-1.name", "colon"));
    EXPECT_TRUE(has(problems, "class-1.colour", "not a colour"));
    EXPECT_TRUE(has(problems, "class-3", "follows no class"));
    EXPECT_TRUE(has(problems, "class-3.condition", "'depth > 1 km' is not a limit"));
    EXPECT_EQ(problems.size(), 9U);
}

TEST_F(SchemeFile, ConditionsAreRefused) {
    for (const char* condition :
         {"depth > -1 m", "depth > 0 m", "depth < 1 m", "depth > 1", "depth > 0,5 m", "height > 1 m", "depth > 1 m2/s",
          "depth > 1 m and", "depth > 1 m, velocity > 1 m/s", "depth > nan m", "depth>1 m"})
        EXPECT_TRUE(
            has(refused(k_scheme_head + k_low + k_high + condition + "\n"), "class-2.condition", "is not a limit"))
            << condition;
    EXPECT_TRUE(has(refused(k_scheme_head + k_low + "[class-2]\nname = High\ncolour = d7191c\n"), "class-2.condition",
                    "is missing"));
    EXPECT_TRUE(has(refused(k_scheme_head + k_low), "class-1.condition", "is missing"));
    EXPECT_TRUE(has(refused(k_scheme_head), "class-1", "has no classes"));
    // What is in the upper class must be in the one below.
    EXPECT_TRUE(has(refused(k_scheme_head + k_low + "condition = depth > 1 m\n" + k_high + "depth > 0.5 m\n"),
                    "class-2.condition", "the class below does not"));
    EXPECT_TRUE(has(refused(k_scheme_head + k_low + k_high + "depth > 1 m\ncondition = depth > 2 m\n"),
                    "class-2.condition", "more than once"));
}

TEST_F(SchemeFile, AMatrixIsWhole) {
    const std::string three = k_scheme_head + k_low + k_high +
                              "depth > 1 m\n[class-3]\nname = X\ncolour = 000000\ncondition = "
                              "depth > 2 m\n[degree]\n";
    const std::string rows = "strong = red, red, red\nmedium = red, blue, blue\nweak = blue, blue, yellow\n";
    EXPECT_TRUE(refused(three + "return-periods = 30, 100, 300\n" + rows).empty());
    EXPECT_TRUE(has(refused(three + "return-periods = 30, 100\n" + rows), "degree.return-periods", "are not three"));
    EXPECT_TRUE(has(refused(three + "return-periods = 30, 100, 300\nstrong = red, green, red\n"), "degree.strong",
                    "are not three degrees"));
    EXPECT_TRUE(
        has(refused(three + "return-periods = 30, 100, 300\nstrong = red, red, red\n"), "degree.weak", "is missing"));
    EXPECT_TRUE(
        has(refused(k_scheme_head + k_low + k_high + "depth > 1 m\n[degree]\nreturn-periods = 30, 100, 300\n" + rows),
            "degree.return-periods", "up to 3"));
}

TEST_F(SchemeFile, ASceneTakesItRelativeToItsFolder) {
    write(k_scheme_head + k_low + k_high + "head > 1 m\n", "own.ini");
    const SceneReading reading = read(k_least + "[hazard]\nscheme = own.ini\n");
    ASSERT_TRUE(reading.problems.empty());
    EXPECT_EQ(*reading.scene.hazard.scheme, (folder_ / "own.ini").string());
    EXPECT_EQ(reading.scene.hazard.resolved->called, "Ours");
    EXPECT_EQ(reading.scene.hazard.resolved->source, k_source_not_read);
    const std::vector<std::string> files = input_files(reading.scene);
    EXPECT_NE(std::find(files.begin(), files.end(), (folder_ / "own.ini").string()), files.end());
    EXPECT_FALSE(problems(k_least + "[hazard]\nscheme = none.ini\n").empty());
}

}  // namespace
}  // namespace frana
