// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_study.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "support/problems.h"

namespace frana::app::study {
namespace {

class ReadRegion : public ::testing::Test {
  protected:
    ReadRegion()
        : file_(std::filesystem::temp_directory_path() / ("frana_region_" + std::to_string(::getpid()) + ".ini")) {}
    ~ReadRegion() override { std::filesystem::remove(file_); }
    StudyReading read(const std::string& text) const {
        std::ofstream(file_) << text;
        return read_region(file_.string());
    }
    std::filesystem::path file_;
};

TEST_F(ReadRegion, ColumnsAndMatrix) {
    const StudyReading reading = read(
        "[region]\nscene = s.ini\nname = NAME\nscenario = SC\nreturn-period = T\nwindow = 800\n[set]\ntime.end = 9\n"
        "[columns]\nrelease.thickness = H\nmaterial.friction-coefficient = MU\n[degree]\nreturn-periods = 10, 50, 200\n"
        "weak = yellow, yellow, yellow-white\n");
    EXPECT_TRUE(reading.problems.empty()) << describe(reading.problems.list().front());
    const StudySpec& study = reading.study;
    EXPECT_EQ(study.scene, (file_.parent_path() / "s.ini").string());
    EXPECT_EQ(study.set, (std::vector<std::string>{"time.end=9"}));
    ASSERT_TRUE(study.region.has_value());
    EXPECT_EQ(study.region->columns.size(), 2U);
    EXPECT_EQ(study.region->columns[1].key, "material.friction-coefficient");
    EXPECT_EQ(study.region->columns[1].column, "MU");
    EXPECT_EQ(study.region->window, 800.0);
    EXPECT_EQ(study.region->degrees.of(1, 150), HazardDegree::residual);
    EXPECT_EQ(study.region->degrees.of(2, 5), HazardDegree::red);
    const StudyReading again = read(region_text(study));
    EXPECT_TRUE(again.problems.empty()) << describe(again.problems.list().front());
    EXPECT_EQ(region_text(again.study), region_text(study));
}

TEST_F(ReadRegion, EveryMistakeIsNamed) {
    const StudyReading reading = read(
        "[region]\nname = NAME\nscenari = SC\nwindow = wide\n[set]\nrelease.thickness = 2\n[columns]\n"
        "release.thickness = H\nterrain.cell-size = C\nrelease.perimeter-filter = F\nrelease.thicknes = X\n[degree]\n"
        "strong = red, red\nreturn-periods = 30, 20, 300\nmedium = red, green, blue\n");
    const std::vector<Problem>& all = reading.problems.list();
    EXPECT_EQ(all.size(), 10U);
    EXPECT_TRUE(has_problem(all, "region.scene"));
    EXPECT_TRUE(has_problem(all, "region.scenari", "SC"));
    EXPECT_TRUE(has_problem(all, "region.window", "wide", "auto, or metres from 1 to 1000000"));
    EXPECT_TRUE(has_problem(all, "columns.release.thickness")) << "also set for all slopes";
    EXPECT_TRUE(has_problem(all, "columns.terrain.cell-size", "C"));
    EXPECT_TRUE(has_problem(all, "columns.release.perimeter-filter", "F"));
    EXPECT_TRUE(has_problem(all, "columns.release.thicknes", "X"));
    EXPECT_TRUE(has_problem(all, "degree.strong", "red, red"));
    EXPECT_TRUE(has_problem(all, "degree.return-periods", "30, 20, 300"));
    EXPECT_TRUE(has_problem(all, "degree.medium", "red, green, blue", "three of red, blue, yellow, yellow-white"));
}

}  // namespace
}  // namespace frana::app::study
