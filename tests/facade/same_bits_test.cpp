// SPDX-License-Identifier: Apache-2.0
// The library gives what `frana run` gives of the same scene: to the last bit in memory, and what its files hold.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/input/prepare.h"
#include "app/input/share_directory.h"
#include "facade/frana.h"
#include "gis/raster/raster_in.h"
#include "params/scene/read_scene.h"
#include "simulation/simulation.h"
#include "support/program.h"

namespace frana::test {
namespace {

const std::vector<std::pair<std::string, std::string>> k_time{{"time.end", "25"}, {"time.frame-interval", "10"}};

/// The sample on larger cells, as frana run has it in memory.
app::Prepared prepared_sample() {
    std::vector<std::string> sets{"terrain.cell-size=20"};
    for (const auto& [key, value] : k_time) sets.push_back(key + "=" + value);
    app::RunLog log(true);
    return app::prepare(read_scene(FRANA_SAMPLE_DIR "/scene.ini", sets, app::share_directory()), log);
}

facade::Values values_of(const Raster& raster) {
    return {{raster.values.data(), raster.values.size()}, {}};
}

/// The same from values in memory.
facade::Scene scene_of(const app::Prepared& sample) {
    const GridSpec& grid = sample.scene.grid;
    facade::Scene scene({grid.west, grid.north, grid.cell_size, grid.rows, grid.columns},
                        values_of(sample.scene.terrain));
    scene.set("material.preset", "bindo");
    scene.set("release.dtm-contains-release", "on");
    for (const auto& [key, value] : k_time) scene.set(key, value);
    for (const ReleaseArea& area : sample.scene.release) {
        facade::Release release;
        for (const Polygon& polygon : area.outline) {
            facade::Polygon& own = release.outline.emplace_back();
            for (const Point& p : polygon.outer) own.outer.push_back({p.x, p.y});
            for (const Ring& hole : polygon.holes) {
                own.holes.emplace_back();
                for (const Point& p : hole) own.holes.back().push_back({p.x, p.y});
            }
        }
        release.thicknesses = values_of(*area.thickness_raster);
        release.volume = area.volume;
        release.name = area.name;
        scene.add_release(std::move(release));
    }
    return scene;
}

TEST(SameBits, AsTheFilesOfFranaRun) {
    const app::Prepared sample = prepared_sample();
    const std::string folder = testing::TempDir() + "facade_same_bits";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::vector<std::string> arguments{"run",
                                       FRANA_SAMPLE_DIR "/scene.ini",
                                       "--out",
                                       "result",
                                       "--quiet",
                                       "--set",
                                       "terrain.cell-size=20",
                                       "--set",
                                       "output.maps=off",
                                       "--set",
                                       "output.animation=off",
                                       "--set",
                                       "output.report=off",
                                       "--set",
                                       "output.charts=off"};
    for (const auto& [key, value] : k_time) {
        arguments.emplace_back("--set");
        arguments.push_back(key + "=" + value);
    }
    succeeded(run_program(folder, arguments));
    const facade::Result result = facade::run(scene_of(sample));
    for (const char* name : {"max_depth", "max_velocity", "arrival_time", "final_depth", "max_pressure"}) {
        const Raster file = gis::read_result_raster(folder + "/result/" + name + ".tif");
        const facade::Raster raster = result.raster(name);
        std::int64_t flowed = 0;
        for (std::int64_t row = 0; row < raster.grid.rows; ++row) {
            for (std::int64_t column = 0; column < raster.grid.columns; ++column) {
                const double expected = raster.at(row, column), read = file.at(row, column);
                ASSERT_EQ(std::isnan(read), std::isnan(expected)) << name;
                if (std::isnan(read)) continue;
                ASSERT_EQ(read, static_cast<double>(static_cast<float>(expected))) << name;
                ++flowed;
            }
        }
        EXPECT_GT(flowed, 100) << name;
    }
    const Json file = parse_json(read_text(folder + "/result/summary.json")), own = Json::parse(result.summary());
    EXPECT_GE(own.size(), 20U);
    for (const auto& [key, value] : own.items()) EXPECT_EQ(file[key], value) << key;
}

}  // namespace
}  // namespace frana::test
