// SPDX-License-Identifier: Apache-2.0
// Valid files that do not mean what the scene takes them for: a wrong unit, a wrong ground, a wrong outline, another
// CRS.
#include <cmath>
#include <numbers>

#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_in.h"
#include "support/checked_scene.h"
#include "support/files.h"

namespace frana::test {
namespace {

class SuspiciousInput : public CheckedScene {
  protected:
    static double slope(int column) { return 300 - 0.5 * std::min((column + 0.5) * k_cell, 200.0); }
};

// The slope falls by half: atan(0.5) is 26.6 degrees; the release lies from x = 20 to 70 m.
TEST_F(SuspiciousInput, CheckAndResultTellElevationsAndSlopes) {
    write_scene(k_pages_only);
    const Outcome check = succeeded(frana({"check", "scene.ini"}));
    expect_words(check.out, {"release          ", " m, slope 27 degrees on average, 27 at most", "path             "});
    ran();
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_NEAR(json_number(summary, "ground.release.mean_slope_deg"), 26.565, 1e-3);
    EXPECT_NEAR(json_number(summary, "ground.release.steepest_slope_deg"), 26.565, 1e-3);
    // Centres of cells from 22.5 to 67.5 m.
    EXPECT_NEAR(json_number(summary, "ground.release.highest_m"), 300 - 0.5 * 22.5, 1e-6);
    EXPECT_NEAR(json_number(summary, "ground.release.lowest_m"), 300 - 0.5 * 67.5, 1e-6);
    EXPECT_LE(json_number(summary, "ground.path.lowest_m"), json_number(summary, "ground.release.lowest_m"));
    expect_words(read_text(path("result/report.html")), {"Steepest slope", "Path"});
}

TEST_F(SuspiciousInput, ElevationsInDecimetresAreReportedAndTheUnitIsAKey) {
    write_scene(k_numbers_only);
    write_dtm([](int, int column) { return 10 * slope(column); });
    const Outcome wrong = succeeded(frana({"check", "scene.ini"}));
    expect_words(wrong.err, {"mean slope of the release 79°", "terrain.vertical-unit", "mean slope of the path"});
    const Outcome right = succeeded(frana({"check", "scene.ini", "--set", "terrain.vertical-unit=decimetre"}));
    EXPECT_EQ(right.err.find("vertical"), std::string::npos) << right.err;
    expect_words(right.out, {"slope 27 degrees on average"});
}

TEST_F(SuspiciousInput, AFlatReleaseIsReported) {
    write_scene(k_numbers_only);
    write_dtm([](int, int) { return 300.0; });
    expect_words(check().told(), {"mean slope of the release", "check CRS"});
}

// Metres read as feet: the slope of 26.6 degrees becomes one of 8.7.
TEST_F(SuspiciousInput, AReleaseThatItsFrictionHoldsIsReported) {
    write_scene(k_pages_only);
    EXPECT_EQ(check().told(), "");
    const auto with = [&](const std::string& more) { return check({more}).told(); };
    expect_words(with("terrain.vertical-unit=foot"),
                 {"release slope 8.7° under its friction 15°: check terrain.vertical-unit"});
    write_dtm([](int, int column) { return 0.3048 * slope(column); });
    const std::string low = with("time.end=20");
    expect_words(low, {"° under its friction "});
    // Nothing can be known of a mass whose friction is less, or that is thrown.
    EXPECT_EQ(with("material.friction-angle=5").find("under its friction"), std::string::npos);
    EXPECT_EQ(with("release.velocity=10").find("under its friction"), std::string::npos);
    ran("low");
    expect_words(read_text(path("low/report.html")), {"° under its friction "});
}

TEST_F(SuspiciousInput, AFrameOfZerosIsReported) {
    write_scene(k_numbers_only);
    write_dtm([](int row, int column) {
        const bool frame = row < 2 || column < 2 || row >= k_rows - 2 || column >= k_columns - 2;
        return frame ? 0 : slope(column);
    });
    expect_words(check().told(), {"cells of 0 stand out", "terrain.nodata-value = 0"});
}

TEST_F(SuspiciousInput, ADifferenceNeedsTheGroundThatTheKeySays) {
    write_dtm({}, true, "before.asc");
    write_dtm([](int, int column) { return slope(column) - (column < 20 ? 2 : 0); }, true, "after.asc");
    write_scene(k_numbers_only);
    const auto on = [&](const std::string& dtm, const std::string& contains) {
        return check({"release.thickness=difference:before.asc,after.asc", "terrain.dtm=" + dtm,
                      "release.dtm-contains-release=" + contains});
    };
    EXPECT_FALSE(on("before.asc", "on").is_refused());
    EXPECT_FALSE(on("after.asc", "off").is_refused());
    write_dtm([](int, int column) { return slope(column) + 40; }, true, "other.asc");
    expect_words(on("other.asc", "on").told(), {"DTM 2100 % from after to before"});
}

TEST_F(SuspiciousInput, AnOutlineThatIsTheReleaseIsQuestioned) {
    write_scene(k_numbers_only + "[observed]\nperimeter = perimeter.geojson\n");
    expect_words(check().told(), {"scene.ini: observed.perimeter matches the release to 100 %"});
    write_polygon("covered", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
    const std::string told = check({"observed.perimeter=covered.geojson"}).told();
    EXPECT_EQ(told.find("matches the release"), std::string::npos) << told;
    // compare asks the same of its own outline.
    write_scene(k_numbers_only);
    ran();
    const auto compare = [&](const std::string& outline) {
        return frana({"compare", "result", "--observed", outline, "--out", "compared", "--overwrite", "--json",
                      "--size", "640x480"});
    };
    const Outcome release = succeeded(compare("perimeter.geojson"));
    expect_words(release.err, {"perimeter.geojson matches the release to 100 %"});
    expect_words(release.out, {"perimeter.geojson matches the release to 100 %"});
    const Outcome covered = succeeded(compare("covered.geojson"));
    EXPECT_EQ(covered.err.find("matches the release"), std::string::npos) << covered.err;
}

// The second name stays: no warning, and errors use the user's word.
TEST_F(SuspiciousInput, ScarIsTheSameSectionAsObserved) {
    write_polygon("covered", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
    write_scene(k_numbers_only + "[scar]\nperimeter = covered.geojson\nthreshold = 0.2\n");
    const Outcome run = ran();
    EXPECT_EQ(run.err, "");
    const std::string echoed = read_text(path("result/scene.ini"));
    expect_words(echoed, {"[observed]\n", "covered.geojson\n", "threshold = 0.2\n"});
    EXPECT_EQ(echoed.find("[scar]"), std::string::npos);
    const Outcome compared = succeeded(
        frana({"compare", "result", "--observed", "covered.geojson", "--out", "compared", "--size", "640x480"}));
    EXPECT_EQ(json_number(read_text(path("compared/comparison.json")), "threshold_m"), 0.2);
}

/// Area of a cell of `side` degrees on the ellipsoid WGS 84 [m2].
double degree_cell_area(double side, double latitude) {
    constexpr double k_a = 6378137, k_e2 = 0.00669437999014;
    const double radian = std::numbers::pi / 180, sine = std::sin(latitude * radian),
                 w = std::sqrt(1 - k_e2 * sine * sine), meridian = k_a * (1 - k_e2) / (w * w * w), normal = k_a / w;
    return meridian * normal * std::cos(latitude * radian) * std::pow(side * radian, 2);
}

// Its cells lie askew on the working grid: interpolated there, its edges would be lost.
TEST_F(SuspiciousInput, AThicknessInAnotherCrsKeepsItsVolume) {
    write_polygon("around", {{5, 40}, {120, 40}, {120, 120}, {5, 120}});
    write_scene(k_numbers_only);
    const std::string utm = gis::crs_from_user("EPSG:32632", "");
    struct Case {
        std::string crs;
        double cell;  ///< in the unit of the CRS
    };
    for (const auto& [crs, cell] : {Case{"EPSG:3003", 5}, Case{"EPSG:4326", 5e-5}}) {
        const gis::CrsTransform to_own(utm, gis::crs_from_user(crs, ""));
        const Point corner = to_own({k_west + 30, k_south + 100});
        gis::test::TestRaster raster;
        raster.columns = 10;
        raster.rows = 8;
        raster.west = corner.x;
        raster.north = corner.y;
        raster.cell_x = raster.cell_y = cell;
        raster.crs = crs;
        raster.values.assign(80, 2);
        gis::test::make_raster(path("thickness.tif"), raster);
        succeeded(
            frana({"run", "scene.ini", "--out", "result", "--overwrite", "--quiet", "--set", "time.end=0.1", "--set",
                   "release.perimeter=around.geojson", "--set", "release.thickness=raster:thickness.tif"}));
        // Areas on the map of UTM are those on the ellipsoid by 0.9996 squared here, 27 km from its central meridian;
        // Monte Mario's ellipsoid is larger by 4e-5.
        const double expected = 160 * (crs == "EPSG:4326" ? 0.9996 * 0.9996 * degree_cell_area(cell, corner.y) : 25);
        const double released = json_number(read_text(path("result/summary.json")), "volume.initial_m3");
        EXPECT_NEAR(released / expected, 1, 3e-4) << crs;
        EXPECT_NE(read_text(path("result/log.txt")).find("thickness raster "), std::string::npos) << crs;
    }
}

// 50 m x 40 m of 2 m thickness, of which the perimeter has all but the eastern fifth: 800 of 4 000 m3.
TEST_F(SuspiciousInput, AThicknessBeyondThePerimeterIsToldWithBothVolumes) {
    write_scene(k_numbers_only);
    gis::test::TestRaster raster;
    raster.columns = 10;
    raster.rows = 8;
    raster.west = k_west + 30;
    raster.north = k_south + 100;
    raster.cell_x = raster.cell_y = 5;
    raster.crs = "EPSG:32632";
    raster.values.assign(80, 2);
    gis::test::make_raster(path("thickness.tif"), raster);
    const auto told = [&](double east) {
        write_polygon("part", {{30, 60}, {east, 60}, {east, 100}, {30, 100}});
        return check({"release.perimeter=part.geojson", "release.thickness=raster:thickness.tif"}).told();
    };
    expect_words(told(70), {"thickness raster 4 000 m3", "perimeter 3 200 m3", "20 %"});
    const std::string of_this_mass = "lie beyond it";
    EXPECT_EQ(told(80).find(of_this_mass), std::string::npos) << "all is inside";
    EXPECT_EQ(told(45).find(of_this_mass), std::string::npos) << "a raster of all ground, of which this is a part";
}

TEST_F(SuspiciousInput, ANumberSignInAFolderIsNoComment) {
    const std::filesystem::path folder = folder_ / "Flache#1";
    std::filesystem::create_directories(folder);
    for (const char* file : {"dtm.asc", "dtm.prj", "perimeter.geojson", "scene.ini"})
        std::filesystem::copy(folder_ / file, folder / file);
    const std::string scene = folder.string() + "/scene.ini";
    const Outcome run =
        succeeded(frana({"run", scene, "--out", "out#1/result", "--quiet", "--set", "output.animation=off", "--set",
                         "output.maps=max_depth", "--set", "output.map-size=640x480"}));
    // The echo repeats it, a page is drawn from it, and a comment is still one.
    succeeded(frana({"run", "out#1/result/scene.ini", "--out", "again", "--quiet"}));
    const auto depths = [&](const std::string& result) {
        std::vector<double> values = gis::read_result_raster(path(result + "/max_depth.tif")).values.dense();
        for (double& depth : values)
            if (std::isnan(depth)) depth = 0;
        return values;
    };
    EXPECT_EQ(depths("again"), depths("out#1/result"));
    succeeded(frana({"render", "out#1/result", "--map", "max_depth", "--size", "640x480"}));
    write_scene("#[time]\n[output]\ntitle = Slope#2 # and more\nmaps = off\nanimation = off\n");
    ran("titled");
    EXPECT_NE(read_text(path("titled/scene.ini")).find("\ntitle = Slope#2\n"), std::string::npos);
}

}  // namespace
}  // namespace frana::test
