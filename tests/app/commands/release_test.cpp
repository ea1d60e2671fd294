// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "support/checked_scene.h"

namespace frana::test {
namespace {

class Release : public CheckedScene {
  protected:
    [[nodiscard]] gis::PolygonLayer layer(const std::string& name = "release.gpkg") const {
        return gis::read_polygons(path(name), "", "layer");
    }
    void expect_refused(const std::vector<std::string>& more, const std::string& words) const {
        refusal_of(refused(with_more({"release", "dtm.asc"}, more)), {words});
        EXPECT_FALSE(std::filesystem::exists(path("release.gpkg"))) << words;
    }
};

// The slope of TinyScene falls by 1 in 2 over the first 40 columns; the outermost cells have no slope.
TEST_F(Release, CellsThatFailBecomeALayerThatARunAndARegionTakeAsItIs) {
    const Outcome outcome = succeeded(frana({"release", "dtm.asc", "--thickness", "1.5", "--friction-angle", "30",
                                             "--saturation", "1", "--density", "2000"}));
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("a screening, not a prediction"), std::string::npos) << outcome.err;
    const Raster factor = gis::read_result_raster(path("release_factor.tif"));
    const double expected = 0.5 * std::tan(30 * std::numbers::pi / 180) / 0.5;
    EXPECT_NEAR(factor.at(15, 20), expected, 1e-6);  // Float32
    EXPECT_TRUE(std::isnan(factor.at(0, 20)));
    const gis::PolygonLayer areas = layer();
    ASSERT_EQ(areas.features.size(), 1U);
    const Feature& one = areas.features.front();
    // Columns 1 to 39; the slope of the last, at the foot, is 0.375, that of the next 0.125.
    EXPECT_EQ(area(one.shape.areas), 39 * 28 * 25);
    EXPECT_NEAR(one.numbers.at("area_m2"), area(one.shape.areas), 1e-9);
    EXPECT_NEAR(one.numbers.at("volume_m3"), 1.5 * area(one.shape.areas), 1e-6);
    EXPECT_NEAR(one.numbers.at("thickness_vertical_m"), 1.5, 1e-12);
    EXPECT_NEAR(one.numbers.at("least_factor"), expected, 1e-12);
    EXPECT_NEAR(one.numbers.at("mean_factor"), expected * (38 + 0.5 / 0.375) / 39, 1e-12);
    EXPECT_NE(read_text(path("release.gpkg")).find("Screening of possible releases"), std::string::npos);

    succeeded(frana({"new", "dtm.asc", "release.gpkg", "--thickness", "attribute:thickness_vertical_m", "--preset",
                     "debris-flow", "--out", "my.ini", "--region", "region.ini"}));
    const Outcome run = succeeded(frana({"run", "my.ini", "--out", "run", "--quiet", "--set", "time.end=1", "--set",
                                         "output.maps=off", "--set", "output.animation=off"}));
    const double volume = one.numbers.at("volume_m3");
    EXPECT_NEAR(json_number(read_text(path("run/summary.json")), "volume.initial_m3"), volume, 1e-9 * volume);
    const Outcome region = succeeded(frana({"batch", "region.ini", "--out", "region", "--quiet"}));
    EXPECT_EQ(json_number(read_text(path("region/summary.json")), "finished"), 1);
}

TEST_F(Release, LimitsOfSlopeAloneServeAvalanches) {
    succeeded(frana({"release", "dtm.asc", "--thickness", "1", "--least-slope", "25", "--greatest-slope", "55", "--out",
                     "snow.gpkg"}));
    EXPECT_EQ(files().size(), 5U) << "no factor without a strength";
    const gis::PolygonLayer areas = layer("snow.gpkg");
    ASSERT_EQ(areas.features.size(), 1U);
    EXPECT_EQ(areas.features[0].numbers.count("least_factor"), 0U);
    // None is an empty layer, in place of an older one.
    const Outcome none =
        succeeded(frana({"release", "dtm.asc", "--thickness", "1", "--least-slope", "25", "--greatest-slope", "55",
                         "--least-area", "1e6", "--out", "snow.gpkg", "--overwrite"}));
    EXPECT_NE(none.err.find("areas: 0"), std::string::npos) << none.err;
    EXPECT_EQ(none.err.find("next:"), std::string::npos) << none.err;
}

// Soil only in the west, twice as thick in the north; none where the raster has 0.
TEST_F(Release, ValuesByPlace) {
    write_dtm([](int row, int column) { return column >= 20 ? 0 : row < 15 ? 2.0 : 1.0; }, true, "soil.asc");
    succeeded(frana({"release", "dtm.asc", "--thickness", "raster:soil.asc", "--friction-angle", "20"}));
    const gis::PolygonLayer areas = layer();
    ASSERT_EQ(areas.features.size(), 1U);
    EXPECT_EQ(area(areas.features[0].shape.areas), 19 * 28 * 25);
    EXPECT_NEAR(areas.features[0].numbers.at("volume_m3"), 25 * 19 * (14 * 2 + 14), 1e-6);
    EXPECT_NEAR(areas.features[0].numbers.at("thickness_vertical_m"), 1.5, 1e-12);
    succeeded(
        frana({"release", "dtm.asc", "--thickness", "raster:soil.asc", "--least-slope", "20", "--out", "snow.gpkg"}));
    ASSERT_EQ(layer("snow.gpkg").features.size(), 1U);
    EXPECT_EQ(area(layer("snow.gpkg").features[0].shape.areas), 19 * 28 * 25);
}

TEST_F(Release, PlausibleMistakesAreRefusedWithTheUnit) {
    const std::vector<std::string> soil{"--thickness", "1", "--friction-angle", "30"};
    const auto with = [&](const std::string& option, const std::string& value) {
        std::vector<std::string> all = soil;
        all.insert(all.end(), {option, value});
        return all;
    };
    expect_refused({"--thickness", "1", "--friction-angle", "0.61"}, "--friction-angle: is not plausible (value 0.61");
    expect_refused({"--thickness", "150", "--friction-angle", "30"}, "80 cm is 0.8");
    expect_refused({"--thickness", "0", "--friction-angle", "30"}, "--thickness: is not plausible");
    expect_refused(with("--cohesion", "5"), "5 kPa is 5000");
    expect_refused(with("--saturation", "50"), "50 % is 0.5");
    expect_refused(with("--density", "1.8"), "1.8 g/cm3");
    expect_refused(with("--density", "18"), "17.7 kN/m3");
    expect_refused({"--thickness", "1", "--friction-angle", "45", "--saturation", "1", "--density", "300"},
                   "is less than that of its water alone (value 300");
    expect_refused(with("--convexity", "6"), "6 per 100 m is 0.06");
    expect_refused(with("--least-slope", "0.5"), "28, not 0.5");
    expect_refused(with("--greatest-slope", "1.4"), "55, not 1.4");
    expect_refused({"--thickness", "1", "--least-slope", "55", "--greatest-slope", "28"}, "is not less than");
    expect_refused(with("--least-slope", "raster:dtm.asc"), "is not plausible");
    expect_refused(with("--set", "time.end=3"), "is not of the section [terrain]");
    expect_refused(with("--set", "terrain.cell-sise=3"), "cell-size");
    expect_refused(with("--out", "release.shp"), "is not a GeoPackage");
    expect_refused({"--least-slope", "25", "--greatest-slope", "55"}, "--thickness: is required");
    expect_refused({"--thickness", "1"}, "--friction-angle: is required, or --least-slope");
    expect_refused({"--thickness", "1", "--least-slope", "25", "--greatest-slope", "55", "--saturation", "1"},
                   "has no effect");
    write_dtm([](int, int) { return 50; }, true, "wet.asc");
    expect_refused(with("--saturation", "raster:wet.asc"), "has a value that is not plausible (value 50");
    expect_refused(with("--saturation", "raster:missing.asc"), "missing.asc");
    refusal_of(
        refused({"release", "nowhere.tif", "--thickness", "1", "--least-slope", "25", "--greatest-slope", "55"}));
}

TEST_F(Release, ReplacesNothingUnasked) {
    write("release_factor.tif", "mine");
    expect_refused({"--thickness", "1", "--friction-angle", "20"}, "release_factor.tif");
    EXPECT_EQ(read_text(path("release_factor.tif")), "mine");
    succeeded(frana({"release", "dtm.asc", "--thickness", "1", "--friction-angle", "20", "--overwrite"}));
}

}  // namespace
}  // namespace frana::test
