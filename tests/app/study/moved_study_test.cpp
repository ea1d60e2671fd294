// SPDX-License-Identifier: Apache-2.0
// Folders with studies and their results are moved, repeated and resumed.
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// A project folder whose study varies a number and a file, and its result.
class MovedStudy : public Ensemble {
  protected:
    MovedStudy() {
        fs::create_directories(folder_ / "project/data");
        write_polygon("other", {{20, 55}, {60, 55}, {60, 95}, {20, 95}});
        for (const char* file : {"dtm.asc", "dtm.prj", "perimeter.geojson", "other.geojson"})
            fs::rename(folder_ / file, folder_ / "project/data" / file);
        write(
            "project/scene.ini",
            "[terrain]\ndtm = data/dtm.asc\n[release]\nperimeter = data/perimeter.geojson\nthickness = 2\n[material]\n"
            "friction-coefficient = 0.2\n[time]\nend = 4\n" +
                k_numbers_only);
        write("project/study.ini",
              "[study]\nscene = scene.ini\nsamples = 6\nkeep = all\n[vary]\nmaterial.turbulence = uniform(300, 900)\n"
              "release.perimeter = choice(data/perimeter.geojson, data/other.geojson)\n");
    }
    [[nodiscard]] Outcome study(const std::string& file, const std::string& out,
                                const std::vector<std::string>& more = {}) const {
        return frana(with_more({"ensemble", file, "--out", out, "--threads", "2"}, more));
    }
    void compute() const { succeeded(study("project/study.ini", "project/results/many", {"--quiet"})); }
    void move_project() const {
        fs::create_directories(folder_ / "elsewhere/far");
        fs::rename(folder_ / "project", folder_ / "elsewhere/far/project");
    }
};

const std::string k_result = "elsewhere/far/project/results/many";

TEST_F(MovedStudy, TheResultNamesNoAbsolutePathButInItsRecordOfInputs) {
    compute();
    for (const std::string name : {"study.ini", "scene.ini", "members/member_0000000/scene.ini"}) {
        std::istringstream lines(read_text(path("project/results/many/" + name)));
        int keys = 0;
        for (std::string line; std::getline(lines, line);) {
            if (line.empty() || line.front() == '#') continue;
            ++keys;
            EXPECT_EQ(line.find(folder_.string()), std::string::npos) << name << ": " << line;
        }
        EXPECT_GT(keys, 5) << name;
    }
    EXPECT_NE(read_text(path("project/results/many/study.ini")).find("\nscene = ../../scene.ini\n"), std::string::npos);
    int scenes = 0, perimeters = 0;
    const Json inputs = parse_json(read_text(path("project/results/many/inputs.json"))).at("files");
    for (const Json& file : inputs) {
        scenes += file.at("key") == "study.scene" ? 1 : 0;
        perimeters += file.at("key") == "release.perimeter" ? 1 : 0;
    }
    EXPECT_EQ(scenes, 1);
    EXPECT_EQ(perimeters, 2);
}

TEST_F(MovedStudy, AMovedResultIsRepeatedWithTheSameBits) {
    compute();
    move_project();
    const Outcome again = succeeded(study(k_result + "/study.ini", "again", {"--quiet"}));
    const Rows then = members(k_result), now = members("again");
    ASSERT_EQ(then.size(), now.size());
    for (std::size_t i = 0; i < then.size(); ++i)
        for (const std::string column : {"material.turbulence", "runout_m", "covered_area_m2", "max_depth_m"})
            EXPECT_EQ(then[i].at(column), now[i].at(column)) << column;
    const std::string map = "/probability_depth_0.1.tif";
    ASSERT_TRUE(fs::exists(path("again" + map)));
    const Raster a = gis::read_result_raster(path("again" + map)), b = gis::read_result_raster(path(k_result + map));
    for (int row = 0; row < k_rows; ++row) {
        for (int column = 0; column < k_columns; ++column) {
            const bool both_empty = std::isnan(a.at(row, column)) && std::isnan(b.at(row, column));
            ASSERT_TRUE(both_empty || a.at(row, column) == b.at(row, column)) << row << ", " << column;
        }
    }
    // A member alone, as `frana run`.
    succeeded(frana({"run", k_result + "/members/member_0000001/scene.ini", "--out", "one", "--quiet"}));
}

TEST_F(MovedStudy, TheFinishedResultIsRecognised) {
    compute();
    move_project();
    const Outcome outcome = succeeded(study("elsewhere/far/project/study.ini", k_result, {"--resume"}));
    EXPECT_NE(outcome.err.find("the study is complete"), std::string::npos) << outcome.err;
}

TEST_F(MovedStudy, AStoppedStudyIsResumedAfterTheMove) {
    std::string text = read_text(path("project/study.ini"));
    write("project/study.ini", text.replace(text.find("samples = 6"), 11, "samples = 40"));
    {
        StartedProgram program(folder_.string(),
                               {"ensemble", "project/study.ini", "--out", "project/results/many", "--threads", "1"});
        ASSERT_TRUE(program.wait_until([&] { return !records().empty(); }));
        program.send(SIGTERM);
        EXPECT_NE(program.wait().exit_code, 0);
    }
    move_project();
    succeeded(study("elsewhere/far/project/study.ini", k_result, {"--resume"}));
    EXPECT_EQ(members(k_result).size(), 40U);
    const std::string log = read_text(path(k_result + "/log.txt"));
    EXPECT_EQ(log.find("computed 40 members"), std::string::npos) << log;  // those from before the move were kept
}

TEST_F(MovedStudy, AMissingSceneIsOneClearError) {
    compute();
    move_project();
    fs::remove(folder_ / "elsewhere/far/project/scene.ini");
    refusal_of(study(k_result + "/study.ini", "again"), {path("elsewhere/far/project/scene.ini")});
    EXPECT_FALSE(fs::exists(folder_ / "again"));
}

TEST_F(MovedStudy, AnInputWithAnotherContentIsWarnedOf) {
    compute();
    move_project();
    write("elsewhere/far/project/data/other.geojson",
          read_text(path("elsewhere/far/project/data/other.geojson")) + "\n");
    const Outcome outcome = succeeded(study(k_result + "/study.ini", "again"));
    EXPECT_NE(outcome.err.find("other.geojson changed since this result"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace frana::test
