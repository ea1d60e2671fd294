// SPDX-License-Identifier: Apache-2.0
// Inflow, gauges and cross-sections of the library: the bits of `frana run`, and its refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "app/input/prepare.h"
#include "app/input/share_directory.h"
#include "facade/frana.h"
#include "gis/access/table_in.h"
#include "params/scene/read_scene.h"
#include "simulation/simulation.h"
#include "small_scene.h"
#include "support/problems.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using facade::Series;

/// A slide, and a flood that comes through a line with the speed of the file, or without.
class InflowAndRecords : public TinyScene {
  protected:
    InflowAndRecords() {
        write_features("line", {{"LineString", {{20, 20}, {20, 45}}, named("flood")}});
        write_features("gauge", {{"Point", {{78, 72}}, named("bridge")}});
        write_features("section", {{"LineString", {{74, 120}, {74, 30}}, named("road")}});
    }
    void write_all(const std::string& hydrograph, const std::string& more = "") const {
        write("flood.csv", hydrograph);
        write_scene("frame-interval = 2\n[inflow]\nline = line.geojson\nhydrograph = flood.csv\n" + more +
                    k_numbers_only + "gauges = gauge.geojson\ncross-sections = section.geojson\n");
    }
    [[nodiscard]] app::Prepared prepared() const {
        app::RunLog log(true);
        return app::prepare(read_scene(path("scene.ini"), {}, app::share_directory()), log);
    }
    /// The same from values in memory.
    [[nodiscard]] static facade::Scene scene_of(const app::Prepared& prepared) {
        const GridSpec& grid = prepared.scene.grid;
        const auto& z = std::as_const(prepared.scene.terrain.values);
        facade::Scene scene({grid.west, grid.north, grid.cell_size, grid.rows, grid.columns},
                            {{z.data(), z.size()}, {}});
        scene.set("material.friction-angle", 15);
        scene.set("material.turbulence", 500);
        scene.set("time.end", 4);
        scene.set("time.frame-interval", 2);
        const facade::Ring ring{{k_west + 20, k_south + 55},
                                {k_west + 70, k_south + 55},
                                {k_west + 70, k_south + 95},
                                {k_west + 20, k_south + 95}};
        scene.add_release({.outline = {{ring}}, .thickness = 2});
        scene.add_gauge({{527078, 5094072}, "bridge"});
        scene.add_section({{{527074, 5094120}, {527074, 5094030}}, "road"});
        return scene;
    }
    static facade::Inflow flood(std::vector<facade::HydrographPoint> hydrograph) {
        return {.line = {{527020, 5094020}, {527020, 5094045}}, .hydrograph = std::move(hydrograph)};
    }
    void expect_same(const app::Prepared& prepared, const facade::Scene& scene) const {
        const RunResult expected = run(prepared.scene, {});
        const facade::Result result = facade::run(scene, {.threads = 2});
        for (const auto& [name, raster] : {std::pair{"max_depth", &expected.raster("max_depth")},
                                           {"max_velocity", &expected.raster("max_velocity")},
                                           {"arrival_time", &expected.raster("arrival_time")}}) {
            const auto cells = result.raster(name).cells;
            const auto dense = std::as_const(raster->values).dense();
            ASSERT_EQ(cells.size(), dense.size());
            EXPECT_EQ(std::memcmp(cells.data(), dense.data(), cells.size_bytes()), 0) << name;
        }
        EXPECT_EQ(result.number("volume.inflow_m3"), expected.volume_inflow);
        ran("out");
        expect_table("gauges.csv", "bridge", result.gauges());
        expect_table("sections.csv", "road", result.sections());
        std::filesystem::remove_all(path("out"));
    }
    /// Tables of a result have every digit.
    void expect_table(const std::string& file, const std::string& name,
                      const std::vector<facade::Record>& records) const {
        const gis::Table table = gis::read_table(path("out/" + file), "table");
        ASSERT_EQ(records.size(), 1U);
        EXPECT_EQ(records[0].name, name);
        ASSERT_EQ(records[0].columns.size() + 1, table.columns.size()) << "time, name, values";
        double greatest = 0;
        for (std::size_t c = 0; c < records[0].columns.size(); ++c) {
            const Series& column = records[0].columns[c];
            const std::size_t at = c == 0 ? 0 : c + 1;
            EXPECT_TRUE(table.columns[at].starts_with(column.name + "_")) << table.columns[at];
            ASSERT_EQ(column.values.size(), table.rows.size());
            for (std::size_t row = 0; row < table.rows.size(); ++row)
                ASSERT_EQ(column.values[row], std::strtod(table.rows[row][at].c_str(), nullptr))
                    << file << " " << column.name << " row " << row;
            for (const double value : column.values)
                if (c > 0) greatest = std::max(greatest, std::abs(value));
        }
        EXPECT_GT(table.rows.size(), 10U);
        EXPECT_GT(greatest, 1.0) << "something came";
    }
};

TEST_F(InflowAndRecords, AsFranaRunWithVelocities) {
    write_all("time_s,discharge_m3s,velocity_ms\n0,20,3\n2,60,5\n4,0,1\n");
    const app::Prepared sample = prepared();
    facade::Scene scene = scene_of(sample);
    scene.add_inflow(flood({{0, 20, 3}, {2, 60, 5}, {4, 0, 1}}));
    EXPECT_TRUE(scene.check().empty());
    expect_same(sample, scene);
}

// A file of volumes is a hydrograph of steps.
TEST_F(InflowAndRecords, AsFranaRunAtTheCriticalSpeedInADirectionAndAtIntervals) {
    write_all("time_s,volume_m3\n0,0\n2,80\n4,120\n", "direction = 80\n");
    write("scene.ini", read_text(path("scene.ini")) + "sample-interval = 0.25\n");
    const app::Prepared sample = prepared();
    facade::Scene scene = scene_of(sample);
    facade::Inflow steps = flood({{0, 40}, {2, 40}, {2, 20}, {4, 20}});
    steps.direction = 80;
    scene.add_inflow(steps);
    scene.set("output.sample-interval", 0.25);
    expect_same(sample, scene);
}

TEST_F(InflowAndRecords, AnInflowNeedsNoRelease) {
    const std::vector<double> z = small_slope();
    facade::Scene scene(k_small_grid, {z});
    scene.set("material.friction-coefficient", 0.1);
    scene.set("time.end", 8);
    scene.add_inflow({.line = {{600020, 5000040}, {600020, 5000080}}, .hydrograph = {{0, 10}, {8, 10}}});
    const facade::Result result = facade::run(scene);
    EXPECT_NEAR(result.number("volume.inflow_m3"), 80, 1e-9) << "10 m3/s for 8 s";
    EXPECT_EQ(result.number("volume.initial_m3"), 0);
    EXPECT_TRUE(result.gauges().empty());
    const std::vector<Series> series = result.series();
    const auto found =
        std::find_if(series.begin(), series.end(), [](const Series& column) { return column.name == "volume_inflow"; });
    ASSERT_NE(found, series.end());
    EXPECT_GT(found->values.back(), 70) << "the last row of particles enters as the run ends";
    EXPECT_LE(found->values.back(), 80);
}

std::vector<facade::Problem> problems_of(const facade::Scene& scene) {
    try {
        static_cast<void>(scene.check());
    } catch (const facade::Error& error) {
        return error.problems();
    }
    return {};
}

TEST(InflowAndRecordsRefused, InWords) {
    const std::vector<double> z = small_slope();
    const std::vector<facade::Point> line{{600020, 5000040}, {600020, 5000080}};
    struct Wrong {
        facade::Inflow inflow;
        std::string where, value, limit;  ///< of the problem
    };
    const std::string range = "0 to 1e+12";
    for (const auto& [inflow, where, value, limit] : std::vector<Wrong>{
             {{.line = {{600020, 5000040}}, .hydrograph = {{0, 1}, {2, 1}}},
              "inflow 1",
              "1 points",
              "2 or more, finite"},
             {{.line = {{600020, NAN}, {600020, 5000080}}, .hydrograph = {{0, 1}, {2, 1}}},
              "inflow 1",
              "2 points",
              "2 or more, finite"},
             {{.line = line, .hydrograph = {{0, 1}}}, "inflow 1", "1", "2 or more"},
             {{.line = line, .hydrograph = {{0, 1}, {2, -1}}}, "inflow 1", "", range},
             {{.line = line, .hydrograph = {{0, 1}, {NAN, 1}}}, "inflow 1", "", range},
             {{.line = line, .hydrograph = {{2, 1}, {1, 1}}}, "inflow 1", "1 s", "2 s or later"},
             {{.line = line, .hydrograph = {{0, 1, 0}, {1, 1, 0}}}, "inflow 1", "at 0 s", "greater than 0 m/s"},
             {{.line = line, .hydrograph = {{0, 0}, {1, 0}}}, "inflow 1", "", ""},
             {{.line = line, .hydrograph = {{0, 1}, {1, 1}}, .direction = 400},
              "inflow 1: direction",
              "400 degrees",
              "0 to 360"},
             {{.line = line, .hydrograph = {{0, 1, 1e11}, {5, 1, 1e11}}}, "inflow 1", "5.25e+12", "at most 1e+09"},
             {{.line = {{600020, 5000040}, {600020, 5000400}}, .hydrograph = {{0, 1}, {1, 1}}},
              "inflow.line",
              "(600020.0, 5000121.0)",
              ""}}) {
        facade::Scene scene = small_scene(z);
        scene.add_inflow(inflow);
        const auto problems = problems_of(scene);
        ASSERT_EQ(problems.size(), 1U) << where << value;
        EXPECT_TRUE(has_problem(problems, where, value, limit));
        EXPECT_EQ(problems[0].limit, limit) << where << value;
        EXPECT_FALSE(problems[0].remedy.empty()) << where << value;
    }
    facade::Scene marks = small_scene(z);
    marks.set("output.sample-interval", 1);
    EXPECT_TRUE(has_problem(problems_of(marks), "output.sample-interval", "1"));
    marks.add_gauge({{600020, 5000040}, "a"});
    EXPECT_TRUE(problems_of(marks).empty());
    marks.add_gauge({{600021, 5000040}, "a"});
    marks.add_gauge({{1, 5000040}});
    marks.add_section({{{600020, 5000040}}, "b"});
    marks.add_section({{{600020, 5000040}, {NAN, 0}}});
    marks.add_section({{{600020, 5000040}, {1, 5000040}}});
    const auto problems = problems_of(marks);
    EXPECT_EQ(problems.size(), 5U);
    EXPECT_TRUE(has_problem(problems, "gauges", "a"));
    EXPECT_TRUE(has_problem(problems, "gauges", "gauge 3 at 1, 5000040"));
    EXPECT_TRUE(has_problem(problems, "cross-section b", "1 points", "2 or more, finite"));
    EXPECT_TRUE(has_problem(problems, "cross-section 2", "2 points", "2 or more, finite"));
    EXPECT_TRUE(has_problem(problems, "cross-sections", "cross-section 3 at 1, 5000040"));
}

}  // namespace
}  // namespace frana::test
