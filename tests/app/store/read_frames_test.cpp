// SPDX-License-Identifier: Apache-2.0
// frames.zarr and frames.nc as users open them.
#include <ogr_spatialref.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/store/frame_store.h"
#include "core/json.h"
#include "gis/raster/raster_in.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class ReadFrames : public TinyScene {
  protected:
    // Both quantities of every GeoTIFF frame in one file each, for Python to compare.
    void write_expected(const std::string& scene) const {
        const std::vector<app::StoredFrame> stored = app::stored_frames(path("result/frames"));
        ASSERT_EQ(stored.size(), 4U);
        Json json{{"scene", scene}, {"time", Json::array()}, {"x", Json::array()}, {"y", Json::array()}};
        for (const app::StoredFrame& frame : stored) json["time"].push_back(frame.time);
        GridSpec grid;
        for (const std::string name : {"depth", "velocity"}) {
            std::ofstream out(path("result/" + name + ".f32"), std::ios::binary);
            for (const app::StoredFrame& frame : stored) {
                const Raster raster = gis::read_result_raster(frame.raster_file(name));
                grid = raster.grid;
                for (const double value : raster.values) {
                    const auto single = static_cast<float>(value);
                    out.write(reinterpret_cast<const char*>(&single), sizeof single);
                }
            }
        }
        for (std::int64_t i = 0; i < grid.columns; ++i) json["x"].push_back(grid.cell_centre(0, i).x);
        for (std::int64_t i = 0; i < grid.rows; ++i) json["y"].push_back(grid.cell_centre(i, 0).y);
        write("expected.json", frana::json_text(json));
    }
};

TEST_F(ReadFrames, XarrayFindsTheFramesTheirPlacesAndTheirCrs) {
    // A name beyond ASCII, as is the degree sign in the CRS's area of use.
    const std::string scene = "Dürrenbühl";
    write(scene + ".ini", read_text(path("scene.ini")));
    const Outcome run =
        frana({"run", scene + ".ini", "--out", "result", "--threads", "2", "--set", "time.frame-interval=0.5", "--set",
               "output.formats=geotiff,netcdf,zarr", "--set", "output.maps=off", "--set", "output.animation=off",
               "--set", "time.end=1.5", "--set", "terrain.cell-size=0.8"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    write_expected(scene);
    const std::string messages = path("python.txt"), command = std::string("/usr/bin/python3 '") + FRANA_SOURCE_DIR +
                                                               "/tests/app/store/read_frames.py' '" + path("result") +
                                                               "' '" + path("expected.json") + "' >'" + messages +
                                                               "' 2>'" + path("python_errors.txt") + "'";
    const int status = std::system(command.c_str());
    const std::string text = read_text(messages);
    if (WEXITSTATUS(status) == 77) GTEST_SKIP() << text;
    EXPECT_EQ(status, 0) << read_text(path("python_errors.txt"));
    OGRSpatialReference utm;
    utm.importFromEPSG(32632);
    std::istringstream lines(text);
    std::size_t found = 0;
    for (std::string line; std::getline(lines, line); ++found) {
        OGRSpatialReference crs;
        EXPECT_EQ(crs.importFromWkt(line.c_str()), OGRERR_NONE) << line;
        const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT", nullptr};
        EXPECT_TRUE(crs.IsSame(&utm, options)) << line;
    }
    EXPECT_EQ(found, 8U);  // two files, two quantities, two words
}

}  // namespace
}  // namespace frana::test
