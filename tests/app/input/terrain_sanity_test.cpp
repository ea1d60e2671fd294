// SPDX-License-Identifier: Apache-2.0
// Impossible terrain: wrong units, missing nodata values, single wrong cells; releases and paths that no run can use.
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class Terrain : public TinyScene {
  protected:
    static double slope(int column) { return 300 - 0.5 * std::min((column + 0.5) * k_cell, 200.0); }

    [[nodiscard]] Outcome check(const std::function<double(int, int)>& elevation) const {
        write_dtm(elevation);
        return frana({"check", "scene.ini"});
    }
    static void expect_warning(const Outcome& outcome, int code, const std::vector<std::string>& words) {
        EXPECT_EQ(outcome.exit_code, code) << outcome.err;
        for (const std::string& word : words)
            EXPECT_NE(outcome.err.find(word), std::string::npos) << word << "\n" << outcome.err;
    }
};

TEST_F(Terrain, BeyondAllGroundIsRefused) {
    expect_warning(check([](int row, int column) { return row == 20 && column == 40 ? 1e38 : slope(column); }), 2,
                   {"terrain.dtm", "dtm.asc", "an impossible elevation", "1e+38 m at 527202.5, 5094047.5",
                    "row 20, column 40", "-500 to 100 000 m", "terrain.nodata-value"});
    // Declared, it is no longer an elevation.
    EXPECT_EQ(frana({"check", "scene.ini", "--set", "terrain.nodata-value=1e38"}).exit_code, 0);
    expect_warning(check([](int, int column) { return column > 50 ? -2e5 : slope(column); }), 2, {"-200000 m at"});
    // In an edge strip outside the grid it does not matter.
    EXPECT_EQ(frana({"check", "scene.ini", "--set", "terrain.bounds=527000 5094000 527250 5094150"}).exit_code, 0);
}

TEST_F(Terrain, HigherAndLowerThanAnyIsReportedWithItsPlace) {
    expect_warning(check([](int, int column) { return 100 * (slope(column) - 8.75); }), 0,
                   {"29000 m at", "higher than any mountain", "527002.5", "terrain.vertical-unit"});
    expect_warning(check([](int, int column) { return slope(column) - 900; }), 2,
                   {"an impossible elevation", "-700 m at", "-500 to 100 000 m", "terrain.nodata-value"});
    expect_warning(check([](int, int column) { return column > 50 ? 9999 : slope(column); }), 0,
                   {"270 cells have the value 9999", "higher than any mountain"});
}

TEST_F(Terrain, SlopesOfAWrongUnitAreReported) {
    // 2000 m over 300 m: feet for metres are a factor of three, kilometres for metres one of a thousand.
    expect_warning(check([](int, int column) { return 2000 - 35.0 * column; }), 0,
                   {"half of the ground is steeper than 81.9 degrees", "terrain.vertical-unit"});
}

TEST_F(Terrain, SingleCellsFarFromAllNeighboursAreReportedAndCounted) {
    expect_warning(check([](int row, int column) { return slope(column) + (row == 12 && column == 30 ? 50 : 0); }), 0,
                   {"1 single cell stands", "47.5 m at 527152.5, 5094087.5 (row 12, column 30)"});
    expect_warning(check([](int row, int column) {
                       return slope(column) + (row % 4 == 2 && column % 4 == 2 && column > 20 ? -30 : 0);
                   }),
                   0, {"70 single cells stand", "-27.5 m at", "; ..."});
    // Slopes, steps and ridges one cell wide are no needles.
    const Outcome ridge =
        check([](int row, int column) { return slope(column) + (row == 25 || column > 50 ? 60 : 0); });
    EXPECT_EQ(ridge.err.find("single cell"), std::string::npos) << ridge.err;
    expect_warning(ridge, 0, {"a straight step of 60 m"});  // as between two tiles
}

TEST_F(Terrain, AReleaseThinnerThanAnyIsRefusedBeforeItRuns) {
    for (const std::string key : {"release.thickness=1e-308", "release.volume=1e-300"})
        expect_warning(frana({"run", "scene.ini", "--out", "result", "--set", key}), 2,
                       {"thinner than any landslide", "m;"});
    EXPECT_FALSE(std::filesystem::exists(folder_ / "result"));
}

TEST_F(Terrain, APathWithALineBreakIsRefusedBeforeItRuns) {
    std::filesystem::create_directory(folder_ / "two\nlines");
    for (const std::string name : {"dtm.asc", "dtm.prj", "perimeter.geojson", "scene.ini"})
        std::filesystem::copy(folder_ / name, folder_ / "two\nlines" / name);
    expect_warning(frana({"run", "two\nlines/scene.ini", "--out", "result"}), 2, {"two?lines/scene.ini", "line break"});
    expect_warning(frana({"run", "scene.ini", "--out", "result", "--set", "output.title=two\nlines"}), 2,
                   {"output.title", "line break"});
    EXPECT_FALSE(std::filesystem::exists(folder_ / "result"));
}

}  // namespace
}  // namespace frana::test
