// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// A project folder with inputs and a result, of which copies are moved.
class Moved : public TinyScene {
  protected:
    Moved() {
        fs::create_directories(folder_ / "project/data");
        for (const char* file : {"dtm.asc", "dtm.prj", "perimeter.geojson"})
            fs::rename(folder_ / file, folder_ / "project/data" / file);
        write(
            "project/scene.ini",
            "[terrain]\ndtm = data/dtm.asc\n[release]\nperimeter = data/perimeter.geojson\nthickness = 2\n[material]\n"
            "friction-coefficient = 0.2\n[time]\nend = 5\n" +
                k_numbers_only);
        succeeded(frana({"run", "project/scene.ini", "--out", "project/results/one", "--quiet"}));
    }
    void move_project() {
        fs::create_directories(folder_ / "elsewhere/far");
        fs::rename(folder_ / "project", folder_ / "elsewhere/far/project");
    }
};

TEST_F(Moved, ResultsNameTheirInputsRelatively) {
    const std::string scene = read_text(path("project/results/one/scene.ini"));
    EXPECT_NE(scene.find("\ndtm = ../../data/dtm.asc\n"), std::string::npos) << scene;
    const Json inputs = parse_json(read_text(path("project/results/one/inputs.json"))).at("files");
    ASSERT_EQ(inputs.size(), 3U);  // the .prj too
    EXPECT_EQ(inputs.at(0).at("key"), "terrain.dtm");
    EXPECT_EQ(inputs.at(0).at("file"), "../../data/dtm.asc");
    EXPECT_EQ(inputs.at(0).at("place"), path("project/data/dtm.asc"));
    EXPECT_EQ(inputs.at(0).at("bytes"), fs::file_size(path("project/data/dtm.asc")));
    EXPECT_EQ(inputs.at(0).at("xxh128").get<std::string>().size(), 32U);
}

TEST_F(Moved, AMovedResultIsRepeated) {
    move_project();
    const Outcome again =
        succeeded(frana({"run", "elsewhere/far/project/results/one/scene.ini", "--out", "again", "--quiet"}));
    EXPECT_EQ(again.err, "");
    // The same cells; the metadata differ, whose scene names the inputs from another place.
    EXPECT_EQ(json_number(read_text(path("again/summary.json")), "max_depth_m"),
              json_number(read_text(path("elsewhere/far/project/results/one/summary.json")), "max_depth_m"));
    EXPECT_EQ(read_text(path("again/timeseries.csv")),
              read_text(path("elsewhere/far/project/results/one/timeseries.csv")));
    // Into a place beside it: the same scene but for its name.
    succeeded(frana({"run", "elsewhere/far/project/results/one/scene.ini", "--out", "elsewhere/far/project/results/two",
                     "--quiet"}));
    EXPECT_EQ(read_text(path("elsewhere/far/project/results/two/timeseries.csv")),
              read_text(path("again/timeseries.csv")));
}

TEST_F(Moved, AMissingInputIsOneClearError) {
    move_project();
    fs::remove(folder_ / "elsewhere/far/project/data/perimeter.geojson");
    const Outcome outcome =
        refusal_of(frana({"run", "elsewhere/far/project/results/one/scene.ini", "--out", "again"}),
                   {"scene.ini: release.perimeter", path("elsewhere/far/project/data/perimeter.geojson")});
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "again"));
    // The file at another place, named on the command line.
    write_polygon("other", {{20, 55}, {70, 55}, {70, 95}, {20, 95}});
    succeeded(frana({"check", "elsewhere/far/project/results/one/scene.ini", "--set",
                     "release.perimeter=" + path("other.geojson")}));
}

TEST_F(Moved, AnotherContentIsWarnedOf) {
    move_project();
    write("elsewhere/far/project/data/perimeter.geojson",
          read_text(path("elsewhere/far/project/data/perimeter.geojson")) + "\n");
    const Outcome outcome = succeeded(frana({"run", "elsewhere/far/project/results/one/scene.ini", "--out", "again"}));
    EXPECT_NE(outcome.err.find("release.perimeter: " + path("elsewhere/far/project/data/perimeter.geojson") +
                               " changed since this result"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(read_text(path("again/log.txt")).find("changed since this result"), std::string::npos);
}

TEST_F(Moved, AFinishedResultIsRecognisedAfterTheMove) {
    move_project();
    succeeded(
        frana({"run", "elsewhere/far/project/scene.ini", "--out", "elsewhere/far/project/results/one", "--resume"}));
}

}  // namespace
}  // namespace frana::test
