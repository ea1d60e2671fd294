// SPDX-License-Identifier: Apache-2.0
// Studies in which every polygon of the release perimeter is a member.
#include <algorithm>
#include <cmath>

#include "gis/raster/raster_in.h"
#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class PolygonMembers : public Ensemble {};

// Three sources, one without a layer filter of its own: each is the run of the scene with that polygon alone, and the
// maps are the greatest of the three.
TEST_F(PolygonMembers, EachPolygonIsAScenarioOfItsOwn) {
    const auto ring = [](double west, double south, double side) {
        const auto corner = [&](double x, double y) {
            return "[" + std::to_string(k_west + x) + ", " + std::to_string(k_south + y) + "]";
        };
        return "[[" + corner(west, south) + ", " + corner(west + side, south) + ", " +
               corner(west + side, south + side) + ", " + corner(west, south + side) + ", " + corner(west, south) +
               "]]";
    };
    std::string features;
    const std::pair<double, double> places[] = {{20, 20}, {20, 100}, {25, 60}};
    for (int i = 0; i < 3; ++i)
        features += std::string(i == 0 ? "" : ", ") + R"({"type": "Feature", "properties": {"name": "s)" +
                    std::to_string(i) + R"("}, "geometry": {"type": "Polygon", "coordinates": )" +
                    ring(places[i].first, places[i].second, i == 2 ? 40 : 20) + "}}";
    write(
        "perimeter.geojson",
        R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:32632"}}, "features": [)" +
            features + "]}");
    write_study("per-polygon = on\n", "");
    const Outcome outcome = run({"--threads", "2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Rows rows = members();
    ASSERT_EQ(rows.size(), 3U);
    std::vector<Raster> depths;
    for (const auto& row : rows) {
        ASSERT_EQ(row.at("status"), "finished") << row.at("reason");
        const Outcome alone = frana({"run", "scene.ini", "--out", "alone", "--overwrite", "--quiet", "--set",
                                     "time.end=" + row.at("time.end"), "--set",
                                     "release.perimeter-filter=" + row.at("release.perimeter-filter")});
        ASSERT_EQ(alone.exit_code, 0) << alone.err;
        const std::string summary = read_text(path("alone/summary.json"));
        EXPECT_EQ(std::stod(row.at("covered_area_m2")), json_number(summary, "covered_area_m2"));
        EXPECT_EQ(std::stod(row.at("volume_m3")), json_number(summary, "volume.entered_m3"));
        depths.push_back(gis::read_result_raster(path("alone/max_depth.tif")));
    }
    const Raster depth = gis::read_result_raster(path("out/union_max_depth.tif")),
                 hits = gis::read_result_raster(path("out/hit_count.tif")),
                 worst = gis::read_result_raster(path("out/worst_source.tif"));
    int several = 0;
    for (std::size_t cell = 0; cell < depth.values.size(); ++cell) {
        double greatest = 0, count = 0, number = 0;
        for (std::size_t m = 0; m < depths.size(); ++m) {
            const double value = depths[m].values[cell];
            if (!(value > 0)) continue;
            ++count;
            if (value > greatest) number = static_cast<double>(m);
            greatest = std::max(greatest, value);
        }
        several += count > 1;
        if (count == 0) {
            EXPECT_TRUE(std::isnan(depth.values[cell])) << cell;
            continue;
        }
        EXPECT_EQ(depth.values[cell], greatest) << cell;
        EXPECT_EQ(hits.values[cell], count) << cell;
        EXPECT_EQ(worst.values[cell], number) << cell;
    }
    EXPECT_GT(several, 20);
    EXPECT_TRUE(fs::exists(path("out/union_max_velocity.tif")));
    EXPECT_NE(read_text(path("out/report.html")).find("sources were computed, each failing alone"), std::string::npos);
    EXPECT_FALSE(fs::exists(path("out/probability_depth_0.5.tif")));
}

TEST_F(PolygonMembers, PerPolygonRefusesWhatHasNoEffect) {
    write_study("per-polygon = on\nsamples = 20\nuntil = 0.1\n", k_two_keys);
    const Outcome outcome = run();
    EXPECT_EQ(outcome.exit_code, 2);
    for (const std::string words :
         {"study.samples", "study.until", "vary.material.turbulence", "has no effect with study.per-polygon"})
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace frana::test
