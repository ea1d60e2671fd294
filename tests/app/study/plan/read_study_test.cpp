// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_study.h"

#include <fstream>

#include "params/grammar/value_text.h"
#include "study/records.h"
#include "support/problems.h"

namespace frana::app::study::test {
namespace {

class ReadStudy : public Records {
  protected:
    [[nodiscard]] StudyReading read(const std::string& text) const {
        const std::string file = (folder_ / "study.ini").string();
        std::ofstream(file) << text;
        return read_study(file);
    }
    [[nodiscard]] std::vector<Problem> problems(const std::string& text) const { return read(text).problems.list(); }
};

constexpr const char* k_head = "[study]\nscene = scene.ini\n";

TEST_F(ReadStudy, ReadsBackAsWritten) {
    const StudyReading first = read(
        "[study]\nscene = scene.ini\nsamples = 300\nsampling = random\nseed = 9\nuntil = 0.02\nkeep = failed\n[vary]\n"
        "material.friction-coefficient = uniform(0.15, 0.35)\nmaterial.turbulence = log-uniform(500, 4000)\n"
        "release.perimeter = choice(a.shp: 7, \"b,c.shp\": 3)\nterrain.error = gaussian-field(0.5, 50)\n[correlate]\n"
        "material.friction-coefficient material.turbulence = -0.4\n");
    EXPECT_TRUE(first.problems.empty()) << describe(first.problems.list().front());
    EXPECT_EQ(first.study.samples, 300);
    EXPECT_EQ(first.study.scene, (folder_ / "scene.ini").string());
    ASSERT_EQ(first.study.vary.size(), 4U);
    EXPECT_EQ(first.study.vary[2].distribution.values[0], (folder_ / "a.shp").string());
    EXPECT_EQ(first.study.correlate[0].rho, -0.4);
    const std::string text = study_text(first.study);
    EXPECT_EQ(study_text(read(text).study), text);
}

TEST_F(ReadStudy, ReportsEveryProblemInOnePass) {
    const std::vector<Problem> all = problems(
        "[study]\nscene = scene.ini\nsamples = 1\nsampling = often\nlevls = 3\n[vary]\n"
        "terrain.cell-size = uniform(5, 10)\noutput.maps = choice(on, off)\nmaterial.turbulance = uniform(1, 2)\n"
        "material.friction-coefficient = uniform(1, 3)\nmaterial.density = choice(x, y)\n"
        "numerics.scheme = uniform(1, 2)\nrelease.thickness = 3\nterrain.error = uniform(0, 1)\n[correlate]\n"
        "material.density release.volume = 2\n[veer]\na = 1\n");
    EXPECT_EQ(all.size(), 13U);
    EXPECT_TRUE(has_problem(all, "study.samples", "1", "2 to 1000000"));
    EXPECT_TRUE(has_problem(all, "study.sampling", "often"));
    EXPECT_TRUE(has_problem(all, "study.levls", "3"));
    EXPECT_TRUE(has_problem(all, "vary.terrain.cell-size", "uniform(5, 10)"));
    EXPECT_TRUE(has_problem(all, "vary.output.maps", "choice(on, off)"));
    EXPECT_TRUE(has_problem(all, "vary.material.turbulance", "uniform(1, 2)"));
    EXPECT_TRUE(has_problem(all, "vary.material.friction-coefficient", "uniform(1, 3)", "0 to 2"));
    EXPECT_TRUE(has_problem(all, "vary.material.density", "choice(x, y)", "10 to 10000"));
    EXPECT_TRUE(has_problem(all, "vary.numerics.scheme", "uniform(1, 2)", "default, paper, finite-volume"));
    EXPECT_TRUE(has_problem(all, "vary.release.thickness", "3"));
    EXPECT_TRUE(has_problem(all, "vary.terrain.error", "uniform(0, 1)"));
    EXPECT_TRUE(has_problem(all, "correlate.material.density release.volume", "2", "greater than -1, less than 1"));
    EXPECT_TRUE(has_problem(all, "veer.a", "1"));
}

TEST_F(ReadStudy, AFrequencyIsReadBackAndItsVolumesVaryTheRelease) {
    const std::string text = std::string(k_head) + "[frequency]\nrate = 0.05 ± 0.02\nvolumes = 8e3: 20, 35e3: 300\n";
    const StudyReading first = read(text);
    EXPECT_TRUE(first.problems.empty()) << describe(first.problems.list().front());
    EXPECT_EQ(first.study.frequency.rate->value, 0.05);
    EXPECT_EQ(first.study.frequency.rate->deviation, 0.02);
    EXPECT_EQ(first.study.frequency.mapped_periods(), (std::vector<double>{30, 100, 300}));
    ASSERT_EQ(first.study.vary.size(), 1U);
    EXPECT_EQ(first.study.vary[0].key, "release.volume");
    const std::string written = study_text(first.study);
    EXPECT_EQ(study_text(read(written).study), written);
    EXPECT_FALSE(read(std::string(k_head) + "[vary]\nmaterial.turbulence = uniform(500, 900)\n").study.frequency.rate);
}

TEST_F(ReadStudy, RefusesAFrequencyThatCannotBeMeant) {
    const auto all = [&](const std::string& frequency, const std::string& rest = "") {
        return problems(k_head + rest + "[frequency]\n" + frequency);
    };
    const std::string vary = "[vary]\nmaterial.turbulence = uniform(500, 900)\n",
                      good = "volumes = 8000: 20, 9000: 30\n";
    EXPECT_TRUE(all(good, vary).empty());
    EXPECT_TRUE(all("rate = 0.05\n", vary).empty());
    const std::vector<Problem> years = all("rate = 20\n", vary);  // a return period
    ASSERT_TRUE(
        has_problem(years, "frequency.rate", "20", "greater than 0, at most 5, perhaps +- its standard deviation"));
    EXPECT_NE(years.front().remedy.find("write 0.05"), std::string::npos) << years.front().remedy;
    EXPECT_TRUE(has_problem(all("rate = -1\n", vary), "frequency.rate", "-1"));
    EXPECT_TRUE(has_problem(all("rate = 0.05 +- 20 %\n", vary), "frequency.rate"));
    EXPECT_TRUE(has_problem(all("volumes = 8000: 100, 9000: 20\n"), "frequency.volumes", "8000: 100, 9000: 20"));
    EXPECT_TRUE(has_problem(all("volumes = 9000: 20, 8000: 100\n"), "frequency.volumes"));
    EXPECT_TRUE(has_problem(all("volumes = 8000, 9000\n"), "frequency.volumes", "8000, 9000"));
    EXPECT_TRUE(has_problem(all("return-periods = 100\n", vary), "frequency.return-periods"));
    EXPECT_TRUE(
        has_problem(all("rate = 0.05\nreturn-periods = 100, 30\n", vary), "frequency.return-periods", "100, 30"));
    const std::vector<Problem> two = all("rate = 0.1\n" + good);
    ASSERT_TRUE(has_problem(two, "frequency.rate", "0.1", "0.05"));
    EXPECT_NE(two.front().what.find("frequency.volumes"), std::string::npos);
    EXPECT_TRUE(all("rate = 0.0505\n" + good).empty()) << "rounded";
    EXPECT_TRUE(has_problem(all(good, "[vary]\nrelease.volume = uniform(1, 2)\n"), "frequency.volumes"));
    EXPECT_TRUE(has_problem(all(good, "[set]\nrelease.volume = 1\n"), "frequency.volumes"));
    EXPECT_TRUE(has_problem(all(good, "sampling = table:t.csv\n"), "frequency.volumes"));
    EXPECT_TRUE(has_problem(all("rat = 0.05\n", vary), "frequency.rat"));
}

TEST_F(ReadStudy, RefusesWhatASamplingCannotDo) {
    const std::string two =
        "[vary]\nmaterial.friction-coefficient = uniform(0.1, 0.3)\nmaterial.turbulence = "
        "uniform(500, 900)\n";
    const std::string correlated = "[correlate]\nmaterial.turbulence material.friction-coefficient = 0.3\n";
    const std::string head = k_head;
    for (const std::string gone : {"saltelli", "latin-hypercube", "grid"}) {
        const std::vector<Problem> all = problems(head + "sampling = " + gone + "\n" + two);
        ASSERT_TRUE(has_problem(all, "study.sampling", gone)) << gone;
        EXPECT_NE(all.front().remedy.find("Write sampling = sobol"), std::string::npos) << all.front().remedy;
    }
    const std::vector<Problem> levels = problems(head + "levels = 3\n" + two);
    ASSERT_TRUE(has_problem(levels, "study.levels", "3"));
    EXPECT_NE(levels.front().remedy.find("sobol"), std::string::npos);
    const std::vector<Problem> polygons = problems(head + "per-polygon = on\n" + two);
    ASSERT_TRUE(has_problem(polygons, "study.per-polygon", "on"));
    EXPECT_NE(polygons.front().remedy.find("frana batch"), std::string::npos);
    EXPECT_TRUE(has_problem(problems(head + "sampling = morris\nsamples = 100\n" + two), "study.samples", "100"));
    EXPECT_TRUE(has_problem(problems(head + "sampling = morris\nsamples = 30\n" + two + correlated), "study.sampling",
                            "morris"));
    EXPECT_TRUE(
        has_problem(problems(head + two + correlated + "material.friction-coefficient material.turbulence = -0.3\n"),
                    "correlate.material.friction-coefficient material.turbulence", "-0.3"));
    EXPECT_TRUE(has_problem(problems(head + "sampling = morris\nsamples = 30\nuntil = 0.02\n" + two), "study.sampling",
                            "morris"));
    EXPECT_TRUE(has_problem(problems(head + "sampling = table:t.csv\n" + two), "study.sampling"));
    const std::string rare = "sampling = importance\nrare-place = house\n";
    EXPECT_TRUE(problems(head + rare + two).empty());
    EXPECT_TRUE(has_problem(problems(head + "sampling = importance\n" + two), "study.sampling", "importance"));
    EXPECT_TRUE(has_problem(problems(head + "rare-place = house\n" + two), "study.rare-place", "house"));
    EXPECT_TRUE(has_problem(problems(head + "samples = 63\n" + rare + two), "study.samples", "63", "at least 64"));
    EXPECT_TRUE(has_problem(problems(head + rare + "until = 0.02\n" + two), "study.sampling", "importance"));
    EXPECT_TRUE(has_problem(problems(head + rare + two + correlated), "study.sampling", "importance"));
    // 8 of the 50 members of the first round are 0.16 of them.
    const std::string option = "release.thickness-direction = choice(vertical: 21, normal: 4)\n";
    EXPECT_TRUE(problems(head + rare + two + option).empty());
    EXPECT_TRUE(has_problem(problems(head + "samples = 98\n" + rare + two + option), "vary.release.thickness-direction",
                            "normal: 0.16", "at least 0.16"));
    EXPECT_TRUE(problems(head + "samples = 98\n" + two + option).empty());
    EXPECT_TRUE(has_problem(problems(head), "study.ini: vary"));
    EXPECT_TRUE(has_problem(problems("[vary]\nmaterial.turbulence = uniform(500, 900)\n"), "study.scene"));
}

}  // namespace
}  // namespace frana::app::study::test
