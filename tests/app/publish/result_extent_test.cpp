// SPDX-License-Identifier: Apache-2.0
// Rasters of what was reached, or of the whole map: the same values at the same coordinates, all rasters of a result on
// the same cells, and every command works with them.
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "analysis/trace.h"
#include "core/json.h"
#include "core/raster.h"
#include "gis/raster/raster_in.h"
#include "started_program.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class ResultExtent : public TinyScene {
  protected:
    ResultExtent() {
        write_polygon("scar", {{20, 60}, {150, 60}, {150, 90}, {20, 90}});
        write_scene(
            "[output]\nmaps = max_depth\nmap-size = 640x480\nanimation = off\nreport = off\n"
            "[scar]\nperimeter = "
            "scar.geojson\n[entrainment]\nerosion = growth\ngrowth-rate = 0.02\nerodible-depth = 1\n");
    }
    [[nodiscard]] static std::vector<std::string> command(const std::string& extent, const std::string& result,
                                                          const std::vector<std::string>& more = {}) {
        return with_more({"run", "scene.ini", "--out", result, "--quiet", "--set", "output.extent=" + extent, "--set",
                          "terrain.cell-size=2.5", "--set", "time.end=1.5", "--set", "time.frame-interval=0.5"},
                         more);
    }
    [[nodiscard]] Outcome run(const std::string& extent, const std::string& result,
                              const std::vector<std::string>& more = {}) const {
        return frana(command(extent, result, more));
    }
    /// The GeoTIFFs of a result that the run writes, relative to it.
    [[nodiscard]] std::vector<std::string> rasters(const std::string& result) const {
        std::vector<std::string> list;
        for (const auto& entry : fs::recursive_directory_iterator(path(result)))
            if (entry.path().extension() == ".tif" && entry.path().string().find("/maps/") == std::string::npos)
                list.push_back(entry.path().lexically_relative(path(result)).string());
        return list;
    }
    void expect_same_at_coordinates(const std::string& part_of, const std::string& whole_of) const {
        const std::vector<std::string> files = rasters(part_of);
        EXPECT_EQ(files.size(), rasters(whole_of).size());
        EXPECT_GE(files.size(), 16U);
        const GridSpec shared = gis::read_result_raster(path(part_of + "/max_depth.tif")).grid;
        for (const std::string& file : files) {
            const Raster part = gis::read_result_raster(path(part_of + "/" + file)),
                         whole = gis::read_result_raster(path(whole_of + "/" + file));
            EXPECT_TRUE(part.grid.same_cells(shared)) << file;
            const auto down = std::llround((whole.grid.north - part.grid.north) / part.grid.cell_size),
                       right = std::llround((part.grid.west - whole.grid.west) / part.grid.cell_size);
            std::int64_t values = 0, all = 0;
            for (std::int64_t row = 0; row < part.grid.rows; ++row) {
                for (std::int64_t column = 0; column < part.grid.columns; ++column) {
                    const double a = part.at(row, column), b = whole.at(row + down, column + right);
                    values += !std::isnan(a);
                    ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << file << " " << row << " " << column;
                }
            }
            whole.values.for_each_stored([&](std::size_t, double value) { all += !std::isnan(value); });
            if (file != "dtm.tif" && file != "bed.tif" && file != "comparison.tif") {
                EXPECT_EQ(values, all) << file;
            }
        }
    }
};

TEST_F(ResultExtent, HoldsTheValuesOfTheWholeMap) {
    for (const char* extent : {"map", "reached"}) {
        succeeded(run(extent, extent));
    }
    const Raster whole = gis::read_result_raster(path("map/max_depth.tif")),
                 part = gis::read_result_raster(path("reached/max_depth.tif"));
    EXPECT_EQ(whole.grid.columns, 120);
    EXPECT_LT(part.grid.columns, 100);
    expect_same_at_coordinates("reached", "map");
    for (const char* name : {"reached/frames.whole", "reached/frames.cut"})
        EXPECT_FALSE(fs::exists(path(name))) << name;
    // Everything but the rasters' extent is the same.
    for (const char* file : {"timeseries.csv", "profiles.csv", "comparison.json", "frames/frames.csv"})
        EXPECT_EQ(read_text(path("map/" + std::string(file))), read_text(path("reached/" + std::string(file)))) << file;
    const Json of_map = Json::parse(read_text(path("map/summary.json"))),
               of_part = Json::parse(read_text(path("reached/summary.json")));
    EXPECT_EQ(of_map["grid"]["columns"], 120);
    EXPECT_EQ(of_part["grid"]["columns"], part.grid.columns);
    EXPECT_EQ(of_part["map"]["columns"], 120);
    EXPECT_FALSE(of_map.contains("map"));
    for (const char* key : {"runout", "flows", "covered_area_m2", "volume", "max_depth_m", "max_velocity_p99_ms"})
        EXPECT_EQ(of_map[key], of_part[key]) << key;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"render", "reached", "--map", "max_velocity", "--map", "depth@1", "--size",
                                   "640x480"},
          {"render", "reached", "--view", "3d", "--size", "640x480", "--out", "view"},
          {"render", "reached", "--animation", "film.gif", "--size", "640x480"},
          {"compare", "reached", "--scar", "scar.geojson", "--size", "640x480", "--out", "again"},
          {"run", "scene.ini", "--out", "reached", "--resume", "--set", "output.extent=reached", "--set",
           "terrain.cell-size=2.5", "--set", "time.end=1.5", "--set", "time.frame-interval=0.5"}}) {
        succeeded(frana(words));
    }
    succeeded(run("reached", "reached", {"--overwrite"}));
    expect_same_at_coordinates("reached", "map");
}

// What --resume continues are frames of the whole map.
TEST_F(ResultExtent, OfAResumedRunIsThatOfAStraightOne) {
    const Outcome straight = succeeded(run("reached", "straight"));
    // Stopped after its first frames, and killed where the frames are cut, if it is seen there.
    StartedProgram first(folder_.string(), command("reached", "resumed"));
    ASSERT_TRUE(first.wait_until([&] { return fs::exists(path("resumed.partial/frames/depth_0001.tif")); }));
    first.send(SIGINT);
    ASSERT_EQ(first.wait().exit_code, 130);
    StartedProgram second(folder_.string(), command("reached", "resumed", {"--resume"}));
    if (second.wait_until([&] {
            return fs::exists(path("resumed.partial/frames.whole")) || fs::exists(path("resumed/frames.whole"));
        }))
        second.send(SIGKILL);
    const int killed = second.wait().exit_code;
    ASSERT_TRUE(killed == 0 || killed == -SIGKILL) << killed;
    succeeded(run("reached", "resumed", {"--resume"}));
    expect_same_at_coordinates("resumed", "straight");
    EXPECT_EQ(gis::read_result_raster(path("resumed/max_depth.tif")).grid.columns,
              gis::read_result_raster(path("straight/max_depth.tif")).grid.columns);
}

// On an even slope a release is deepest where it waited; where a trough gathers it, the flow is.
TEST_F(ResultExtent, DepthOutsideTheReleaseIsALayerWhereTheReleaseHidesIt) {
    write_scene();
    ran("hidden", {"time.end=1.5"});
    const Raster all = gis::read_result_raster(path("hidden/max_depth.tif")),
                 release = gis::read_result_raster(path("hidden/release.tif")),
                 outside = gis::read_result_raster(path("hidden/outside_depth.tif"));
    std::int64_t cells = 0;
    for (std::int64_t row = 0; row < all.grid.rows; ++row)
        for (std::int64_t column = 0; column < all.grid.columns; ++column) {
            const double here = outside.at(row, column), depth = all.at(row, column);
            const bool is_blank = release.at(row, column) > 0 || std::isnan(depth);
            ASSERT_TRUE(is_blank ? std::isnan(here) : here == depth) << row << ' ' << column;
            cells += !is_blank;
        }
    EXPECT_GT(cells, 0);
    EXPECT_LT(maximum(outside), maximum(all));
    write_dtm(
        [](int row, int column) { return 300 - 2.5 * column + 1.0 * std::max(0, column - 18) * std::abs(row - 15); });
    ran("shown", {"release.thickness=0.3", "time.end=12"});
    EXPECT_GT(maximum(gis::read_result_raster(path("shown/max_depth.tif"))), 0.3);
    EXPECT_FALSE(fs::exists(path("shown/outside_depth.tif")));
}

}  // namespace
}  // namespace frana::test
