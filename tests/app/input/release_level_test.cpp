// SPDX-License-Identifier: Apache-2.0
// Lakes from files: release.level.
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "gis/access/gdal_session.h"
#include "gis/raster/raster_in.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using Json = nlohmann::json;

constexpr double k_level = 1012.5;

class ReleaseLevel : public TinyScene {
  protected:
    ReleaseLevel() { write_basin(true); }
    // A basin with an island with slopes of 60 degrees, and noise of half a metre; @param shores noise there, too
    void write_basin(bool shores) const {
        write_dtm([&](int row, int column) {
            std::mt19937 random(static_cast<unsigned>(60 * row + column));
            const double x = 5 * column - 150, y = 5 * row - 75;
            const double z = 1000 + 30 * (x * x / (140 * 140) + y * y / (65 * 65)) +
                             40 * std::exp(-((x + 30) * (x + 30) + y * y) / 400);
            const double noise = std::uniform_real_distribution(-0.5, 0.5)(random);
            return z + (shores || z < k_level - 3 ? noise : 0);
        });
        write_polygon("lake", {{2, 2}, {298, 2}, {298, 148}, {2, 148}});
    }
    void write_lake(const std::string& release, const std::string& more = "") const {
        write("scene.ini", "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = lake.geojson\n" + release +
                               "\n[material]\nfriction-coefficient = 0\ndensity = 1000\n[numerics]\nboundary = wall\n" +
                               more + "[time]\nend = 30\n" + k_numbers_only);
    }
};

TEST_F(ReleaseLevel, IsStillOnRoughGroundRoundAnIsland) {
    write_lake("level = 1012.5");
    for (const std::string scheme : {"default", "finite-volume"}) {
        write_basin(scheme == "finite-volume");  // particles take some shores that bend from cell to cell for fronts
        succeeded(frana({"run", "scene.ini", "--quiet", "--out", scheme, "--set", "numerics.scheme=" + scheme}));
        const Json summary = Json::parse(read_text(path(scheme + "/summary.json")));
        EXPECT_GT(summary.at("steps").get<int>(), 1);
        EXPECT_LT(summary.at("max_velocity_ms").get<double>(), 1e-12) << scheme;
        // The surface of what is computed: cells away from the shore hold the level.
        const Raster ground = gis::read_result_raster(path("dtm.asc")),
                     depth = gis::read_result_raster(path(scheme + "/max_depth.tif"));
        double volume = 0;
        for (const double z : ground.values) volume += 25 * std::max(0.0, k_level - z);
        EXPECT_NEAR(summary.at("volume").at("initial_m3").get<double>(), volume, 0.03 * volume)
            << scheme;  // particles: the shore is within the cells
        EXPECT_NEAR(depth.at(15, 40), k_level - ground.at(15, 40), 0.1);
    }
}

TEST_F(ReleaseLevel, MayBelongToEachPolygon) {
    write_lake("level = attribute:depth");
    refusal_of(frana({"check", "scene.ini"}), {"the level lies below the ground"});
}

// 30 m too high, as ellipsoidal heights are, it drowns the rim of the basin; right, it ends at its shore.
TEST_F(ReleaseLevel, AboveTheRimIsTold) {
    const auto told = [&](const std::string& level) {
        write_lake("level = " + level);
        const Outcome outcome = succeeded(frana({"check", "scene.ini"}));
        return outcome.err.find("% of the perimeter: check it") != std::string::npos;
    };
    EXPECT_TRUE(told("1062.5"));
    EXPECT_FALSE(told("1012.5"));
}

TEST_F(ReleaseLevel, StandsAlone) {
    write_lake("level = 1012.5\nthickness = 2\nvolume = 1000\nthickness-direction = normal\ndtm-contains-release = on");
    refusal_of(frana({"check", "scene.ini"}),
               {"release.thickness", "release.volume", "release.thickness-direction", "release.dtm-contains-release"});
}

}  // namespace
}  // namespace frana::test
