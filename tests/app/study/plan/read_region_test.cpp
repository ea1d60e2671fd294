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
        return read_study(file_.string(), StudyKind::region);
    }
    std::filesystem::path file_;
};

TEST_F(ReadRegion, ReadsBackAsWritten) {
    const StudyReading reading = read(
        "[region]\nscene = s.ini\nname = NAME\nscenario = SC\nreturn-period = T\n[set]\ntime.end = 9\n"
        "[columns]\nrelease.thickness = H\nmaterial.friction-coefficient = MU\n");
    EXPECT_TRUE(reading.problems.empty()) << describe(reading.problems.list().front());
    const StudySpec& study = reading.study;
    EXPECT_EQ(study.scene, (file_.parent_path() / "s.ini").string());
    EXPECT_EQ(study.set, (std::vector<std::string>{"time.end=9"}));
    ASSERT_TRUE(study.region.has_value());
    EXPECT_EQ(study.region->columns.size(), 2U);
    EXPECT_EQ(study.region->columns[1].key, "material.friction-coefficient");
    EXPECT_EQ(study.region->columns[1].column, "MU");
    const StudyReading again = read(study_text(study));
    EXPECT_TRUE(again.problems.empty()) << describe(again.problems.list().front());
    EXPECT_EQ(study_text(again.study), study_text(study));
}

TEST_F(ReadRegion, ScenariosAreInOrderOfTheirPeriods) {
    const StudyReading reading = read(
        "[region]\nscene = s.ini\n[scenario 300]\nrelease.thickness = D300\n[scenario extreme]\nreturn-period = 1000\n"
        "release.thickness = DX\n[scenario 30]\nrelease.thickness = D30\n");
    EXPECT_TRUE(reading.problems.empty()) << describe(reading.problems.list().front());
    const auto& events = reading.study.region->events;
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[0].name + events[1].name + events[2].name, "30300extreme");
    EXPECT_EQ(events[2].return_period, 1000);
    EXPECT_EQ(events[1].columns.front().column, "D300");
    const StudyReading again = read(study_text(reading.study));
    EXPECT_TRUE(again.problems.empty()) << describe(again.problems.list().front());
    EXPECT_EQ(study_text(again.study), study_text(reading.study));
}

TEST_F(ReadRegion, MistakesInScenariosAreNamed) {
    const StudyReading reading = read(
        "[region]\nscene = s.ini\nscenario = SC\n[set]\nrelease.volume = 5\n[scenario 30]\nrelease.thickness = D30\n"
        "return-period = 100\n[scenario rare]\nrelease.volume = V\n[scenario a/b]\nrelease.thickness = D\n"
        "[scenario 300]\nreturn-period = 300\n[frequency]\nrate = 0.1\n");
    const std::vector<Problem>& all = reading.problems.list();
    EXPECT_TRUE(has_problem(all, "region.scenario", "SC")) << "an event is told once";
    EXPECT_TRUE(has_problem(all, "scenario 30.return-period", "100")) << "differs from its name";
    EXPECT_TRUE(has_problem(all, "scenario rare.return-period")) << "is missing";
    EXPECT_TRUE(has_problem(all, "scenario rare.release.volume")) << "is set for all, too";
    EXPECT_TRUE(has_problem(all, "scenario 30", "release.thickness")) << "other keys than the first";
    EXPECT_TRUE(has_problem(all, "scenario a/b.release.thickness", "D"));
    EXPECT_TRUE(has_problem(all, "scenario 300")) << "no column";
}

TEST_F(ReadRegion, EveryMistakeIsNamed) {
    const StudyReading reading = read(
        "[region]\nname = NAME\nscenari = SC\nwindow = 90\n[set]\nrelease.thickness = 2\n[columns]\n"
        "release.thickness = H\nterrain.cell-size = C\nrelease.perimeter-filter = F\nrelease.thicknes = X\n[degree]\n"
        "strong = red, red, red\n");
    const std::vector<Problem>& all = reading.problems.list();
    EXPECT_EQ(all.size(), 8U);
    EXPECT_TRUE(has_problem(all, "region.scene"));
    EXPECT_TRUE(has_problem(all, "region.scenari", "SC"));
    EXPECT_TRUE(has_problem(all, "region.window"));
    EXPECT_TRUE(has_problem(all, "columns.release.thickness")) << "also set for all slopes";
    EXPECT_TRUE(has_problem(all, "columns.terrain.cell-size", "C"));
    EXPECT_TRUE(has_problem(all, "columns.release.perimeter-filter", "F"));
    EXPECT_TRUE(has_problem(all, "columns.release.thicknes", "X"));
    ASSERT_TRUE(has_problem(all, "degree.strong", "red, red, red"));
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Problem& one) {
        return one.remedy.find("hazard.scheme") != std::string::npos;
    })) << "what replaced it";
}

}  // namespace
}  // namespace frana::app::study
