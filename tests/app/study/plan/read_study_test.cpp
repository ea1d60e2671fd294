// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_study.h"

#include <fstream>

#include "params/grammar/value_text.h"
#include "study/records.h"

namespace frana::app::study::test {
namespace {

class ReadStudy : public Records {
  protected:
    [[nodiscard]] StudyReading read(const std::string& text) const {
        const std::string file = (folder_ / "study.ini").string();
        std::ofstream(file) << text;
        return read_study(file);
    }
    [[nodiscard]] std::string problems(const std::string& text) const {
        std::vector<std::string> all;
        const StudyReading reading = read(text);
        for (const Problem& problem : reading.problems.list()) all.push_back(describe(problem));
        return joined(all, "\n");
    }
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
    const std::string all = problems(
        "[study]\nscene = scene.ini\nsamples = 1\nsampling = often\nlevls = 3\n[vary]\n"
        "terrain.cell-size = uniform(5, 10)\noutput.maps = choice(on, off)\nmaterial.turbulance = uniform(1, 2)\n"
        "material.friction-coefficient = uniform(1, 3)\nmaterial.density = choice(x, y)\n"
        "numerics.scheme = uniform(1, 2)\nrelease.thickness = 3\nterrain.error = uniform(0, 1)\n[correlate]\n"
        "material.density release.volume = 2\n[veer]\na = 1\n");
    for (const std::string words :
         {"study.samples: is out of range", "study.sampling: is not one of the choices", "study.levls: unknown key",
          "terrain.cell-size: cannot vary: all members need the same cells",
          "output.maps: cannot vary: it does not change the flow", "Did you mean material.turbulence?",
          "reaches from 1 to 3, beyond the key's range", "has the value x, which is not a number",
          "numerics.scheme: is a distribution of numbers", "release.thickness: is not a distribution",
          "terrain.error: is not a field", "is not a rank correlation", "veer.a: unknown key"})
        EXPECT_NE(all.find(words), std::string::npos) << words << "\n---\n" << all;
}

TEST_F(ReadStudy, RefusesWhatASamplingCannotDo) {
    const std::string two =
        "[vary]\nmaterial.friction-coefficient = uniform(0.1, 0.3)\nmaterial.turbulence = "
        "uniform(500, 900)\n";
    const std::string correlated = "[correlate]\nmaterial.turbulence material.friction-coefficient = 0.3\n";
    EXPECT_NE(problems(std::string(k_head) + "sampling = saltelli\nsamples = 102\n" + two).find("Write 100"),
              std::string::npos);
    EXPECT_NE(problems(std::string(k_head) + "sampling = grid\n" + two + correlated).find("needs independent keys"),
              std::string::npos);
    EXPECT_NE(
        problems(std::string(k_head) + two + correlated + "material.friction-coefficient material.turbulence = -0.3\n")
            .find("is given more than once, in either order"),
        std::string::npos);
    EXPECT_NE(problems(std::string(k_head) + "sampling = grid\nuntil = 0.02\n" + two).find("study.until"),
              std::string::npos);
    EXPECT_NE(problems(std::string(k_head) + "sampling = table:t.csv\n" + two).find("gives all values"),
              std::string::npos);
    EXPECT_NE(problems(k_head).find("at least one key"), std::string::npos);
    EXPECT_NE(problems("[vary]\nmaterial.turbulence = uniform(500, 900)\n").find("study.scene: is missing"),
              std::string::npos);
}

}  // namespace
}  // namespace frana::app::study::test
