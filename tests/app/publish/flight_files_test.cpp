// SPDX-License-Identifier: Apache-2.0
// Flight over an edge, in a run's files.
#include <algorithm>
#include <cmath>

#include "app/pictures/map_layer.h"
#include "app/pictures/result_reader.h"
#include "gis/raster/raster_in.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

// 10 m/s on level ground, over an edge of 40 m across the middle of the DTM: a parabola of 28.6 m.
class FlightFiles : public TinyScene {
  protected:
    FlightFiles() {
        write_dtm([](int, int column) { return column < k_columns / 2 ? 140.0 : 100.0; });
        write_scene("[numerics]\ncurvature = on\n" + k_numbers_only);
    }
    [[nodiscard]] Outcome run(const std::string& flight, const std::vector<std::string>& more = {}) const {
        return frana(with_sets({"run",
                                "scene.ini",
                                "--out",
                                "result",
                                "--overwrite",
                                "--set",
                                "numerics.flight=" + flight,
                                "--set",
                                "release.perimeter=near.geojson",
                                "--set",
                                "release.velocity=10",
                                "--set",
                                "release.direction=90",
                                "--set",
                                "material.friction-angle=0",
                                "--set",
                                "material.turbulence=1e9",
                                "--set",
                                "release.thickness=0.2",
                                "--set",
                                "time.end=8"},
                               more));
    }
};

// Of many runs no page tells the flights of each: it is a warning.
TEST_F(FlightFiles, OfAStudyAreAWarning) {
    write_polygon("near", {{100, 50}, {130, 50}, {130, 90}, {100, 90}});
    write("study.ini",
          "[study]\nscene = scene.ini\nsamples = 2\n[set]\nrelease.perimeter = near.geojson\nrelease.direction = 90\n"
          "material.friction-angle = 0\nmaterial.turbulence = 1e9\nrelease.thickness = 0.2\ntime.end = 8\n"
          "[vary]\nrelease.velocity = uniform(9, 10)\n");
    const Outcome outcome = succeeded(frana({"ensemble", "study.ini", "--out", "result"}));
    EXPECT_NE(outcome.err.find("2 of 2 runs warn, most of all member"), std::string::npos) << outcome.err;
    EXPECT_NE(read_text(path("result/summary.json")).find("m3 flew over edges"), std::string::npos);
    EXPECT_EQ(json_number(read_text(path("result/summary.json")), "run_troubles.flew"), 2);
    const auto notes = app::ResultReader(path("result")).map_source().notes;
    EXPECT_EQ(std::count(notes.begin(), notes.end(), "What flies higher above the ground than a house is not shown"),
              1);
}

// `converge` has no pages either: it warns of each resolution.
TEST_F(FlightFiles, OfResolutionsAreWarnings) {
    write_polygon("near", {{100, 50}, {130, 50}, {130, 90}, {100, 90}});
    const Outcome outcome =
        succeeded(frana({"converge", "scene.ini", "--set", "release.perimeter=near.geojson", "--set",
                         "release.velocity=10", "--set", "release.direction=90", "--set", "material.friction-angle=0",
                         "--set", "material.turbulence=1e9", "--set", "release.thickness=0.2", "--set", "time.end=8"}));
    EXPECT_NE(outcome.err.find("m3 flew over edges"), std::string::npos) << outcome.err;
}

TEST_F(FlightFiles, AgreeWithTheParabola) {
    write_polygon("near", {{100, 50}, {130, 50}, {130, 90}, {100, 90}});
    const Outcome outcome = succeeded(run("on", {"output.report=on"}));
    EXPECT_NE(outcome.err.find("material flew over edges"), std::string::npos) << outcome.err;
    const std::string summary = read_text(path("result/summary.json"));
    const double length = 10 * std::sqrt(2 * 40 / 9.81);
    // Its tips are faster and slower by 2 sqrt(g h) = 2.8 m/s, its middle is not; tips of 1 cm depth fly as well.
    EXPECT_NEAR(json_number(summary, "mean_length_m"), length, 0.03 * length);
    // The edge is two cells wide: at its foot the parabola has fallen by g/2 (10 m / 10 m/s)^2.
    EXPECT_NEAR(json_number(summary, "highest_m"), 40, 4.9);
    EXPECT_GT(json_number(summary, "volume_m3"), 0);

    const Raster jumps = gis::read_result_raster(path("result/jump_height.tif"));
    const Raster depth = gis::read_result_raster(path("result/max_depth.tif"));
    ASSERT_EQ(jumps.values.size(), depth.values.size());
    double highest = 0;
    std::size_t only_flown_over = 0;
    for (std::int64_t row = 0; row < jumps.grid.rows; ++row) {
        for (std::int64_t column = 0; column < jumps.grid.columns; ++column) {
            const double height = jumps.at(row, column);
            if (std::isnan(height)) continue;
            highest = std::max(highest, height);
            EXPECT_GE(column, k_columns / 2 - 1);  // nothing flies before the edge
            only_flown_over += std::isnan(depth.at(row, column)) ? 1 : 0;
        }
    }
    EXPECT_NEAR(highest, json_number(summary, "highest_m"), 1e-3);
    EXPECT_GT(only_flown_over, 0U);
    const auto notes = app::read_map_layer(path("result/max_depth.tif"), Words(Language::english)).notes;
    EXPECT_EQ(notes, std::vector<std::string>{"What flies higher above the ground than a house is not shown"});
    EXPECT_NE(read_text(path("result/report.html")).find("flew over edges"), std::string::npos);
    for (const char* style : {"jump_height.qml", "jump_height.sld"})
        EXPECT_TRUE(std::filesystem::exists(path(std::string("result/") + style))) << style;
}

// A house stands in what flies low, and not below what flies high.
TEST_F(FlightFiles, CountInClassesWhereTheyAreLow) {
    write_polygon("near", {{100, 50}, {130, 50}, {130, 90}, {100, 90}});
    for (const bool low : {false, true}) {
        SCOPED_TRACE(low);
        succeeded(run("on", {"hazard.scheme=swiss-debris-flow", "hazard.minimum-depth=0.01",
                             std::string("numerics.flight-clearance=") + (low ? "100" : "0")}));
        const Raster classes = gis::read_result_raster(path("result/hazard.tif"));
        const Raster depth = gis::read_result_raster(path("result/max_depth.tif"));
        const Raster jumps = gis::read_result_raster(path("result/jump_height.tif"));
        int flown_over = 0, with_class = 0;
        for (std::size_t cell = 0; cell < depth.values.size(); ++cell) {
            if (!std::isnan(depth.values[cell]) || !(jumps.values[cell] > 1)) continue;
            ++flown_over;
            with_class += classes.values[cell] > 0 ? 1 : 0;
        }
        EXPECT_GT(flown_over, 0);
        if (low)
            EXPECT_GT(with_class, flown_over / 2);  // the rest by films thinner than the minimum
        else
            EXPECT_EQ(with_class, 0);
    }
}

TEST_F(FlightFiles, DoNotExistWithoutFlight) {
    write_polygon("near", {{100, 50}, {130, 50}, {130, 90}, {100, 90}});
    succeeded(run("on"));
    succeeded(run("off"));
    EXPECT_FALSE(std::filesystem::exists(path("result/jump_height.tif")));
    EXPECT_FALSE(json_has(read_text(path("result/summary.json")), "jumps"));
}

}  // namespace
}  // namespace frana::test
