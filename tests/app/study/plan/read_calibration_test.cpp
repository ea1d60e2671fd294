// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_study.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "support/problems.h"

namespace frana::app::study {
namespace {

namespace fs = std::filesystem;

class ReadCalibration : public ::testing::Test {
  protected:
    ReadCalibration()
        : file_(fs::temp_directory_path() /
                ("frana_calibration_" + std::to_string(::getpid()) + "_" +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".ini")) {}
    ~ReadCalibration() override {
        std::error_code ignored;
        fs::remove(file_, ignored);
    }
    [[nodiscard]] StudyReading read(const std::string& text) const {
        std::ofstream(file_, std::ios::binary) << text;
        return read_study(file_.string(), StudyKind::calibration);
    }

    fs::path file_;
};

const std::string k_two_events = R"([study]
samples = 64
seed = 5
[objective]
jaccard = 2
runout = 1
exponent = 8
[event south]
scene = a.ini
runout = 786 +- 20
arrival bridge = 35 ± 2.5
speed bridge = 12
depth church = 0.5
[event north]
scene = b.ini
[set]
terrain.cell-size = 10
time.end = 100
[set north]
time.end = 200
[vary]
material.friction-angle = uniform(10, 30)
material.turbulence = log-uniform(100, 1000)
[vary south]
release.volume = uniform(1000, 3000)
[correlate]
material.friction-angle material.turbulence = -0.3
)";

void expect_two_events(const StudySpec& spec) {
    EXPECT_EQ(spec.samples, 64);
    EXPECT_EQ(spec.exponent, 8);
    ASSERT_EQ(spec.objective.size(), 2U);
    EXPECT_EQ(spec.objective[0].measure, Measure::jaccard);
    EXPECT_EQ(spec.objective[0].weight, 2);
    ASSERT_EQ(spec.events.size(), 2U);
    const EventSpec& south = spec.events[0];
    const StudySpec of_south = spec.of_event(0), of_north = spec.of_event(1);
    EXPECT_EQ(south.name, "south");
    const auto runout = south.observed_by(Evidence::runout), arrival = south.observed_by(Evidence::arrival),
               speed = south.observed_by(Evidence::speed), depth = south.observed_by(Evidence::depth);
    ASSERT_EQ(runout.size(), 1U);
    EXPECT_EQ(runout[0].value, 786);
    EXPECT_EQ(runout[0].error, 20);
    ASSERT_EQ(arrival.size(), 1U);
    EXPECT_EQ(arrival[0].gauge, "bridge");
    EXPECT_EQ(arrival[0].value, 35);
    EXPECT_EQ(arrival[0].error, 2.5);
    EXPECT_EQ(speed.at(0).error, 0);
    EXPECT_EQ(speed.at(0).value, 12);
    EXPECT_EQ(depth.at(0).gauge, "church");
    ASSERT_EQ(south.vary.size(), 1U);
    EXPECT_EQ(of_south.vary.size(), 3U);
    EXPECT_EQ(of_south.vary[2].key, "release.volume");
    EXPECT_EQ(of_north.vary.size(), 2U);
    EXPECT_EQ(spec.vary.size(), 2U);
    const std::vector<std::string> both{"terrain.cell-size=10", "time.end=100"},
        other{"terrain.cell-size=10", "time.end=200"};
    EXPECT_EQ(of_south.set, both);
    EXPECT_EQ(of_north.set, other);
    EXPECT_EQ(spec.correlate.size(), 1U);
}

TEST_F(ReadCalibration, EventsShareKeysAndHaveTheirOwn) {
    const StudyReading reading = read(k_two_events);
    ASSERT_TRUE(reading.problems.empty()) << describe(reading.problems.list().front());
    expect_two_events(reading.study);
}

TEST_F(ReadCalibration, ItsTextReadsBackAsTheSame) {
    const StudyReading first = read(k_two_events);
    const std::string text = study_text(first.study);
    const StudyReading again = read(text);
    ASSERT_TRUE(again.problems.empty()) << describe(again.problems.list().front());
    expect_two_events(again.study);
    EXPECT_EQ(study_text(again.study), text);
}

TEST_F(ReadCalibration, ScenesInAListAreNamedAfterTheirFiles) {
    const StudyReading reading = read(
        "[study]\nscene = one/scene.ini, two.v2.ini\n[objective]\njaccard = 1\n[vary]\nmaterial.friction-angle = "
        "uniform(10, 30)\n");
    ASSERT_TRUE(reading.problems.empty()) << describe(reading.problems.list().front());
    ASSERT_EQ(reading.study.events.size(), 2U);
    EXPECT_EQ(reading.study.events[0].name, "one");
    EXPECT_EQ(reading.study.events[1].name, "two_v2");
    EXPECT_TRUE(fs::path(reading.study.events[1].scene).is_absolute());
}

TEST_F(ReadCalibration, EveryProblemIsFoundOnce) {
    const StudyReading reading = read(R"([study]
scene = a.ini, b.ini
samples = 1
refine = 100
coarse = 2
until = 0.02
sampling = morris
[objective]
jacard = 1
area = -1
exponent = 0
[event a]
runout = -3
lenght = 5
speed = 4
arrival bridge = 5 +- 0
[event x/y]
scene = c.ini
[event nowhere]
runout = 4
[vary]
terrain.cell-size = uniform(1, 2)
material.friction-angle = uniform(10, 95)
[vary b]
material.turbulense = uniform(1, 2)
material.friction-angle = uniform(1, 2)
[vary nobody]
material.turbulence = uniform(100, 200)
[more]
key = 1
)");
    const std::vector<Problem>& all = reading.problems.list();
    EXPECT_EQ(all.size(), 21U);
    EXPECT_TRUE(has_problem(all, "study.samples", "1", "2 to 1000000"));
    EXPECT_TRUE(has_problem(all, "study.refine", "100"));
    EXPECT_TRUE(has_problem(all, "study.coarse", "2"));
    const auto refine = std::find_if(all.begin(), all.end(), [](const Problem& one) { return one.value == "100"; });
    EXPECT_NE(refine->remedy.find("study.samples"), std::string::npos) << refine->remedy;  // what replaced it
    EXPECT_TRUE(has_problem(all, "study.until", "0.02"));
    EXPECT_TRUE(has_problem(all, "study.sampling", "morris", "sobol, random"));
    EXPECT_TRUE(has_problem(all, "objective.jacard", "1"));
    EXPECT_TRUE(has_problem(all, "objective.area", "-1", "0 to 1e+06"));
    EXPECT_TRUE(has_problem(all, "objective.exponent", "0", "0.1 to 1000"));
    EXPECT_TRUE(has_problem(all, ": objective")) << "no measure has a weight";
    EXPECT_TRUE(has_problem(all, "event a.runout", "-3"));
    EXPECT_TRUE(has_problem(all, "event a.lenght", "5"));
    EXPECT_TRUE(has_problem(all, "event a.speed", "4"));
    EXPECT_TRUE(has_problem(all, "event a.arrival bridge", "5 +- 0"));
    EXPECT_TRUE(has_problem(all, "event x/y.scene", "c.ini", "letters, digits, - and _, 60 at most"));
    EXPECT_TRUE(has_problem(all, "event nowhere.runout", "4"));
    EXPECT_TRUE(has_problem(all, "vary.terrain.cell-size", "uniform(1, 2)"));
    EXPECT_TRUE(has_problem(all, ": vary.material.friction-angle", "uniform(10, 95)", "0, or 1 to 60"));
    EXPECT_TRUE(has_problem(all, "vary b.material.turbulense", "uniform(1, 2)"));
    EXPECT_TRUE(has_problem(all, "vary b.material.friction-angle", "uniform(1, 2)")) << "given by the shared ones too";
    EXPECT_TRUE(has_problem(all, "vary nobody.material.turbulence", "uniform(100, 200)"))
        << "of an event that is not there";
    EXPECT_TRUE(has_problem(all, "more.key", "1"));
    std::vector<std::string> texts;
    for (const Problem& one : reading.problems.list()) texts.push_back(describe(one));
    std::sort(texts.begin(), texts.end());
    EXPECT_EQ(std::adjacent_find(texts.begin(), texts.end()), texts.end());
}

TEST_F(ReadCalibration, WhatIsMissingIsNamed) {
    const auto problems = [&](const std::string& text) { return read(text).problems.list(); };
    const std::vector<Problem> empty = problems("[study]\nsamples = 10\n");
    EXPECT_TRUE(has_problem(empty, "study.scene"));
    EXPECT_TRUE(has_problem(empty, ": objective"));
    const std::vector<Problem> zero = problems(
        "[study]\nscene = a.ini\n[objective]\njaccard = 0\n[vary]\nmaterial.friction-angle = uniform(1, "
        "2)\n");
    EXPECT_TRUE(has_problem(zero, ": objective"));
    EXPECT_TRUE(has_problem(problems("[study]\nscene = a.ini\n[objective]\njaccard = 1\n"), ": vary"));
}

TEST_F(ReadCalibration, AStudyWithAnObjectiveOrAnEventIsACalibration) {
    static_cast<void>(read(k_two_events));
    EXPECT_EQ(study_kind(file_.string()), StudyKind::calibration);
    static_cast<void>(read("[study]\nscene = a.ini\n[vary]\nmaterial.friction-angle = uniform(1, 2)\n"));
    EXPECT_EQ(study_kind(file_.string()), StudyKind::ensemble);
}

}  // namespace
}  // namespace frana::app::study
