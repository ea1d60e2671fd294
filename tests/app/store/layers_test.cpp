// SPDX-License-Identifier: Apache-2.0
#include "app/store/vector_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <limits>

#include "app/store/result_files.h"
#include "core/text.h"

namespace frana::app {
namespace {

std::vector<std::string> lines_of_file(const std::string& path) {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

TEST(Layers, DepthClassesAreFineWhereFlowsAreThin) {
    const auto classes = [](double maximum) { return class_bounds(true, maximum); };
    EXPECT_EQ(classes(38.2), (std::vector<double>{0, 0.5, 1, 2, 5, 10, 20, 30, 40}));
    EXPECT_EQ(classes(14.8), (std::vector<double>{0, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15}));
    EXPECT_EQ(classes(8), (std::vector<double>{0, 0.1, 0.2, 0.5, 1, 2, 3, 5, 8}));  // a bound may be the maximum
}

TEST(Layers, ClassesContainEveryMaximum) {
    for (const bool progressive : {true, false}) {
        for (const double maximum : {1e-7, 0.01, 0.3, 1.0, 2.0, 5.0, 9.99, 10.0, 123.0, 9e9}) {
            const std::vector<double> bounds = class_bounds(progressive, maximum);
            ASSERT_GE(bounds.size(), 2U) << progressive << ' ' << maximum;
            EXPECT_EQ(bounds.front(), 0) << progressive << ' ' << maximum;
            // a bound may be below the maximum by the rounding of one product
            EXPECT_GE(bounds.back() * (1 + 1e-9), maximum) << progressive;
            for (std::size_t i = 1; i < bounds.size(); ++i) EXPECT_GT(bounds[i], bounds[i - 1]) << progressive;
        }
        for (const double nothing : {0.0, std::numeric_limits<double>::quiet_NaN()})
            EXPECT_GE(class_bounds(progressive, nothing).size(), 2U) << progressive;
    }
}

// Bounds of a quantity are the same in all results, as many as the values need.
TEST(Layers, ClassesFollowTheValuesOnTheBoundsOfTheirQuantity) {
    constexpr double k_open = std::numeric_limits<double>::infinity();
    const ResultRaster& depth = *find_result_raster("max_depth");
    EXPECT_EQ(class_bounds(depth, 1.9), (std::vector<double>{0, 0.2, 0.5, 1, 2}));
    EXPECT_EQ(class_bounds(depth, 38.2).back(), 50);
    EXPECT_EQ(class_bounds(depth, 51).back(), k_open);
    EXPECT_EQ(class_bounds(depth, 0.3), class_bounds(true, 0.3)) << "two classes show nothing of a flow";
    for (const ResultRaster& row : result_rasters()) {
        if (!row.is_drawn() || row.classes.empty() || !row.bounds.empty()) continue;
        const std::vector<double> all = fixed_classes(row.classes);
        EXPECT_EQ(class_bounds(row, 1e9), all) << row.name;
        const std::vector<double> some = class_bounds(row, all[all.size() - 3]);
        EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin())) << row.name;
        EXPECT_EQ(some.size(), all.size() - 2) << row.name;
    }
}

// A pile that hardly moved does not decide on the colours of the flow beside it.
TEST(Layers, TheReleaseDoesNotRuleTheClassesOfDepth) {
    const ResultRaster& depth = *find_result_raster("max_depth");
    Raster deepest(GridSpec{0, 3, 1, 3, 1, ""}, k_no_data), release = deepest;
    deepest.values[0] = 37;
    release.values[0] = 36;
    deepest.values[1] = 1.6;
    constexpr double k_open = std::numeric_limits<double>::infinity();
    EXPECT_EQ(class_bounds(depth, deepest, release), (std::vector<double>{0, 0.2, 0.5, 1, 2, k_open}));
    deepest.values[1] = k_no_data;
    EXPECT_EQ(class_bounds(depth, deepest, release).back(), 50) << "nothing left the release";
}

TEST(Layers, TheDocumentListsTheBoundsOfClasses) {
    const std::vector<std::string> lines = lines_of_file(FRANA_SOURCE_DIR "/share/doc/maps.md");
    for (const QuantityClasses& row : quantity_classes()) {
        if (row.name != "max-depth" && row.name != "max-velocity" && row.name != "max-pressure") continue;
        std::string bounds;
        for (const double bound : row.bounds) bounds += (bounds.empty() ? "" : ", ") + shortest_text(bound);
        EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                                [&](const std::string& line) {
                                    return line.find(" | " + bounds + " " + row.unit + " | ") != std::string::npos;
                                }))
            << row.name << ": " << bounds;
    }
}

TEST(Layers, EveryMapOfTheSceneKeysIsARasterThatIsDrawn) {
    for (const std::string& name : map_names()) {
        const ResultRaster* const row = find_result_raster(raster_of_map(name));
        ASSERT_NE(row, nullptr) << name;
        EXPECT_TRUE(row->is_drawn() && row->in_result()) << name;
    }
    EXPECT_EQ(find_result_raster("view"), nullptr);
}

// The description in share/doc/results.md: its file, its unit, and when it exists.
TEST(Layers, EveryRasterIsExplained) {
    const std::vector<std::string> lines = lines_of_file(FRANA_SOURCE_DIR "/share/doc/results.md");
    for (const ResultRaster& row : result_rasters()) {
        if (!row.in_result()) continue;
        const auto line = std::find_if(lines.begin(), lines.end(), [&](const std::string& one) {
            return one.starts_with("| `") && one.find("`" + row.stem_pattern() + ".tif`") != std::string::npos;
        });
        ASSERT_NE(line, lines.end()) << row.name;
        if (!row.unit.empty() && row.unit != "-") {
            EXPECT_NE(line->find("[" + row.unit + "]"), std::string::npos) << row.name << ": " << *line;
        }
        EXPECT_NE(line->find(row.when), std::string::npos) << row.name << " " << row.when << ": " << *line;
    }
}

TEST(Layers, EveryFileIsExplained) {
    std::string text;
    for (const std::string name : {"results", "maps", "resuming"})
        for (const std::string& line : lines_of_file(FRANA_SOURCE_DIR "/share/doc/" + name + ".md"))
            text += line + "\n";
    for (const ResultFile& file : result_files()) {
        if (file.kind == FileKind::style || file.kind == FileKind::working) continue;
        // "frames/depth_*.tif" by its quantity, "maps/*.png" by its folder, a picture in any format.
        std::string name = file.pattern.substr(0, file.pattern.find('*'));
        while (name.ends_with('_') || name.ends_with('/')) name.pop_back();
        if (file.pattern.starts_with("members/")) name = "members";
        if (file.pattern.starts_with("frames/") && name.find('/') != std::string::npos)
            name.erase(0, name.find('/') + 1);
        // A Shapefile has several files.
        if (file.is_drawn() || (file.kind == FileKind::vector && !name.ends_with(".gpkg")))
            name = name.substr(0, name.find('.'));
        EXPECT_NE(text.find(name), std::string::npos) << file.pattern;
    }
}

}  // namespace
}  // namespace frana::app
