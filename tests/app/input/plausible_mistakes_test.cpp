// SPDX-License-Identifier: Apache-2.0
// Valid values and files that are mistakes of daily practice: told with what was probably meant.
#include <cmath>
#include <numbers>
#include <regex>

#include "app/input/check_inputs.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_in.h"
#include "simulation/arrivals.h"
#include "support/checked_scene.h"
#include "support/files.h"

namespace frana::test {
namespace {

class Mistakes : public CheckedScene {
  protected:
    static double slope(int column) { return 300 - 0.5 * std::min((column + 0.5) * k_cell, 200.0); }
    void SetUp() override {
        write_scene(k_numbers_only);
        write_features("line", {{"LineString", {{30, 60}, {30, 90}}}});
    }
    /// The warnings about a scene that can run.
    [[nodiscard]] std::string told(const Sets& sets) const {
        const Checked checked = check(sets);
        EXPECT_FALSE(checked.is_refused()) << checked.told();
        return checked.told();
    }
    [[nodiscard]] std::string told(const std::function<double(int, int)>& elevation) const {
        write_dtm(elevation);
        return told(Sets{});
    }
    [[nodiscard]] Checked inflow(const std::string& csv) const {
        write("flood.csv", csv);
        return check({"inflow.line=line.geojson", "inflow.hydrograph=flood.csv"});
    }
    [[nodiscard]] Outcome check_in_program(const std::vector<std::string>& sets) const {
        return frana(with_sets({"check", "scene.ini"}, sets));
    }
};

TEST_F(Mistakes, RangesAndTablesOfAStudyAreRefusedAsThoseOfAScene) {
    const std::string study = "[study]\nscene = scene.ini\n";
    write("study.ini", study + "samples = 8\nsampling = sobol\n[vary]\nmaterial.friction-angle = uniform(0.2, 0.4)\n");
    refusal_of(frana({"check", "study.ini"}), {"material.friction-angle", "as a coefficient is"});
    write("samples.csv", "material.friction-angle,material.turbulence\n12,5,500\n");
    write("study.ini", study + "sampling = table:samples.csv\n");
    refusal_of(frana({"check", "study.ini"}), {"samples.csv", "line 2 has 3 fields under 2 columns"});
}

TEST_F(Mistakes, UnusualValuesAreToldWithWhatWasMeant) {
    struct Case {
        std::vector<std::string> keys;
        std::vector<std::string> words;
    };
    write_polygon("dam", {{150, 30}, {160, 30}, {160, 120}, {150, 120}});
    for (const Case& one : std::vector<Case>{
             {{"release.velocity=90"}, {"release.velocity = 90 is unusual", "km/h, write 25"}},
             {{"material.density=20"}, {"material.density = 20 is unusual", "write 2039"}},
             {{"material.turbulence=5"}, {"material.turbulence = 5 is unusual"}},
             {{"material.turbulence=30"}, {"material.turbulence = 30 is unusual"}},
             {{"terrain.obstacles=dam.geojson", "terrain.obstacle-height=220"},
              {"terrain.obstacle-height = 220 is unusual", "above the ground"}},
             {{"material.turbulence=20000"}, {"material.turbulence = 20000 is unusual", "100 to 4 000"}},
             {{"material.density=5000"}, {"material.density = 5000 is unusual: debris has"}},
             {{"release.thickness=250"}, {"250 m thick", "if in cm, write 2.5"}},
             {{"release.thickness=30"}, {"release 30 m thick, 44.7 m wide: if in cm, write 0.3"}},
             {{"release.thickness=50"}, {"if in cm, write 0.5"}},
             {{"release.thickness=1500"}, {"if in mm, write 1.5"}},
             {{"release.thickness=80"}, {"if in cm, write 0.8"}},
             {{"material.bed-friction=coulomb, turbulence, cohesion", "material.cohesion=5"},
              {"material.cohesion = 5 is unusual: if it is in kPa, write 5000"}},
             {{"material.bed-friction=coulomb, turbulence, bingham", "material.viscosity=50",
               "material.yield-stress=2"},
              {"material.yield-stress = 2 is unusual: if it is in kPa, write 2000"}},
             {{"material.surface-pressure=101325"}, {"material.surface-pressure = 101325 is unusual", "write 0"}},
             {{"entrainment.erosion=shear-stress", "entrainment.erodible-depth=150"},
              {"entrainment.erodible-depth = 150 is unusual: if it is in cm, write 1.5"}},
         }) {
        const std::string text = told(one.keys);
        expect_words(text, one.words);
        expect_no_words(text, {"half a cell off", "509"});
    }
    EXPECT_EQ(told(Sets{}), "");
    EXPECT_EQ(told({"release.velocity=10", "release.direction=90", "material.density=300"}), "");
    EXPECT_EQ(told({"material.bed-friction=coulomb, turbulence, cohesion", "material.cohesion=200"}), "");
}

// The outline has 2 000 m2; in the scene it is 2 m thick.
TEST_F(Mistakes, AVolumeOfAnotherUnitThanItsThicknessIsTold) {
    for (const auto& [volume, times] : {std::pair{"40000", "10 times"}, {"33000", "10 times"}, {"4", "0.001 times"}})
        expect_words(check({std::string("release.volume=") + volume}).told(),
                     {std::string("release.volume is ") + times + " outline x thickness: is its unit m3?"});
    for (const char* good : {"1000", "4000", "12000"})
        EXPECT_EQ(told({std::string("release.volume=") + good}).find("outline x thickness"), std::string::npos);
    EXPECT_EQ(told({"release.thickness=1", "release.volume=20000"}).find("outline x thickness"), std::string::npos)
        << "a thickness of 1 only stands for a shape";
}

TEST_F(Mistakes, ASchemeOfAnotherProcessIsTold) {
    const auto of = [&](const std::string& scheme, const std::string& density) {
        return told({"hazard.scheme=" + scheme, "material.density=" + density});
    };
    expect_words(of("swiss-avalanche", "2000"), {"hazard.scheme = swiss-avalanche does not fit material.density"});
    expect_words(of("austrian-torrent", "300"), {"hazard.scheme = austrian-torrent does not fit material.density"});
    EXPECT_EQ(of("swiss-avalanche", "300"), "");
    EXPECT_EQ(of("austrian-torrent", "1100"), "");
}

TEST_F(Mistakes, AZoneWithoutFrictionIsTold) {
    write_dtm([](int, int column) { return column < 30 ? 0 : 0.3; }, true, "mu.asc");
    expect_words(told({"zones.friction-coefficient=raster:mu.asc"}),
                 {"zones.friction-coefficient = 0 is unusual: that ground has no friction"});
    EXPECT_EQ(told({"material.friction-angle=0"}).find("unusual"), std::string::npos) << "the user's word";
}

TEST_F(Mistakes, ATablesVolumeInThousandsIsTold) {
    write("own.ini", own_friction_table(0.2));
    write("table.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
          "friction-table = own.ini\nreturn-period = 30\ndensity = 300\n[time]\nend = 4\n" +
              k_numbers_only);
    const auto of = [&](const std::string& volume) {
        return check({"material.table-volume=" + volume}, "table.ini").told();
    };
    expect_words(of("25"), {"material.table-volume = 25 is unusual: if it is in 1000 m3, write 25000"});
    EXPECT_EQ(of("25000"), "");
}

TEST_F(Mistakes, TheLikelyCauseComesFirst) {
    const std::string text = told({"release.thickness=150"});
    EXPECT_EQ(text.find("release 150 m thick, 44.7 m wide: if in cm, write 1.5"), 0U) << text;
}

// A gap that stands for a building holds the flow as well as one of the survey.
TEST_F(Mistakes, GroundWithoutElevationThatHoldsTheFlowAsAWallIsTold) {
    write_dtm([](int, int column) { return column >= 24 && column < 28 ? -9999.0 : 300 - 2.0 * column; });
    const auto told = [&](const std::string& name, const std::string& end) {
        return frana({"run", "scene.ini", "--out", name, "--set", "terrain.nodata-policy=wall", "--set",
                      "time.end=" + end})
            .err;
    };
    expect_words(told("held", "30"), {"terrain.nodata-policy = wall holds flow "});
    EXPECT_EQ(told("free", "1").find("wall holds flow"), std::string::npos) << "the flow has not come there";
}

TEST_F(Mistakes, AReleaseThatDoesNotMoveIsTold) {
    const auto told = [&](const std::string& name, const std::string& yield) {
        return frana({"run", "scene.ini", "--out", name, "--set", "material.bed-friction=coulomb, turbulence, bingham",
                      "--set", "material.viscosity=10", "--set", "material.yield-stress=" + yield})
            .err;
    };
    expect_words(told("held", "500000"), {"nothing moved: check material, release and DTM"});
    EXPECT_EQ(told("free", "200").find("nothing moved"), std::string::npos);
}

TEST_F(Mistakes, AGaugeThatStaysDryIsNamed) {
    write_features("gauges", {{"Point", {{250, 10}}, named("bridge")}, {"Point", {{45, 75}}, named("head")}});
    const Outcome run =
        succeeded(frana({"run", "scene.ini", "--out", "result", "--set", "output.gauges=gauges.geojson"}));
    expect_words(run.err, {"gauges not reached: bridge\n"});
}

TEST_F(Mistakes, CheckOfARegionPrintsDensityAndDefaults) {
    write("region.ini", "[region]\nscene = scene.ini\n");
    write("study.ini", "[study]\nscene = scene.ini\nsamples = 2\n[vary]\nmaterial.friction-angle = uniform(16, 20)\n");
    for (const std::string file : {"region.ini", "study.ini"}) {
        const Outcome check = succeeded(frana({"check", file}));
        expect_words(check.out, {"density", "kg/m3, from:", "at default", "numerics.minimum-depth = "});
        expect_words(frana({"check", file, "--json"}).out, {"density_kg_m3", "left_at_default"});
    }
}

TEST_F(Mistakes, ElevationsAsThicknessAreTold) {
    // A constant and an attribute, at the release's own height; a raster is refused.
    write("high.geojson",
          std::regex_replace(read_text(path("perimeter.geojson")), std::regex("\"depth\": ?2"), "\"depth\":280"));
    for (const std::vector<std::string>& keys : std::vector<std::vector<std::string>>{
             {"release.thickness=280"}, {"release.perimeter=high.geojson", "release.thickness=attribute:depth"}}) {
        const std::string text = told(keys);
        expect_words(text, {"release 280 m thick: that is the ground's elevation"});
        EXPECT_EQ(text.find("in cm"), std::string::npos) << text;
    }
}

// A byte raster's rim of 255 that it does not declare as no data.
TEST_F(Mistakes, AReleaseScaledFarFromItsThicknessIsTold) {
    const auto rim = [](int row, int column) {
        return row > 10 && row < 19 && column > 3 && column < 14 ? 2.0 : 255.0;
    };
    write_dtm(rim, true, "thickness.asc");
    const std::string raster = "release.thickness=raster:thickness.asc", cells = "terrain.cell-size=4";
    expect_words(told({raster, cells}), {"thickness scaled by 0.", "nodata"});
    write_dtm([](int, int column) { return column > 6 ? 2.0 : 255.0; }, true, "rim.asc");
    expect_words(told({"release.thickness=raster:rim.asc"}), {"release up to 255 m thick: declare 255 as nodata"});
    EXPECT_EQ(told({raster, cells, "release.volume=3000"}).find("scaled by"), std::string::npos)
        << "the volume was asked for";
    expect_words(told({"release.thickness=raster:rim.asc", "release.volume=3000"}), {"255 m thick"});
    write_dtm([](int, int) { return 2.0; }, true, "thickness.asc");
    EXPECT_EQ(told({raster, cells}).find("scaled by"), std::string::npos);
}

TEST_F(Mistakes, UnitsOfAHydrographAreConverted) {
    const auto volume = [&](const std::string& csv) {
        const Checked checked = inflow(csv);
        EXPECT_FALSE(checked.is_refused()) << csv << checked.told();
        return checked.prepared ? volume_of(checked.prepared->scene.inflows.at(0), 1e9) : 0;
    };
    for (const std::string same :
         {"time,discharge,velocity\n0,2,1\n3.6,2,1\n", "time_s,discharge_m3s,velocity_ms\n0,2,1\n3.6,2,1\n",
          "time [min],discharge [l/s],velocity\n0,2000,1\n0.06,2000,1\n",
          "time_h;discharge (m3/s);velocity_km/h\n0;2;3.6\n0.001;2;3.6\n",
          "time,volume_m3,velocity\n0,0,1\n3.6,7.2,1\n", "Time_S,Discharge_m³/s,Velocity_m/s\n0,2,1\n3.6,2,1\n",
          "time,discharge,\n0,2,\n3.6,2,\n"})  // separators at the end of lines
        EXPECT_NEAR(volume(same), 7.2, 1e-9) << same;
}

TEST_F(Mistakes, AHydrographOfOtherUnitsThanUnderstoodIsTold) {
    struct Case {
        std::string csv, words;
    };
    const auto of = [&](const std::string& csv) {
        write("flood.csv", csv);
        return told({"inflow.line=line.geojson", "inflow.hydrograph=flood.csv", "time.end=400"});
    };
    for (const Case& one : std::vector<Case>{
             {"time,discharge\n0,0\n0.5,20\n3,0\n", "hydrograph ends at 3 s of 400 s: time_s or time_h?"},
             {"time,discharge\n0,0\n50,100000\n60,0\n", "m deep on its line: discharge_l/s?"},
             {"time,discharge,velocity\n0,0,10\n50,9,36\n60,0,10\n",
              "hydrograph velocity = 36 is unusual: if it is in km/h, write 10"},
         })
        expect_words(of(one.csv), {one.words});
    for (const std::string good : {"time_s,discharge\n0,0\n2,2\n3,0\n", "time_min,discharge_l/s\n0,0\n1,9000\n2,0\n",
                                   "time,discharge,velocity\n0,0,5\n50,9,5\n60,0,5\n"})
        EXPECT_EQ(of(good).find("hydrograph"), std::string::npos) << good << of(good);
}

TEST_F(Mistakes, AnUnusualTurbulenceOfZonesIsTold) {
    for (const std::string xi : {"5", "20000"}) {
        write_dtm([&](int, int) { return std::stod(xi); }, true, "xi.asc");
        expect_words(told({"material.turbulence=500", "zones.turbulence=raster:xi.asc"}),
                     {"zones.turbulence = " + xi + " is unusual"});
    }
    write("zones.vrt",
          "<OGRVRTDataSource><OGRVRTLayer name=\"zones\"><SrcDataSource>" + path("zones.csv") +
              "</SrcDataSource><LayerSRS>EPSG:32632</LayerSRS><Field name=\"xi\" src=\"xi\" type=\"Real\"/>"
              "</OGRVRTLayer></OGRVRTDataSource>");
    write("zones.csv",
          "WKT,xi\n\"POLYGON((527100 5094010,527200 5094010,527200 5094140,527100 5094140,527100 5094010))\",5\n");
    expect_words(told({"material.turbulence=500", "terrain.friction-zones=zones.vrt"}),
                 {"zones.turbulence = 5 is unusual"});
}

TEST_F(Mistakes, AHydrographThatGoesOnAfterTheEndIsTold) {
    // Of 9 m3 the first 1.08 flow in.
    const Checked late = inflow("time,discharge\n3,1\n9,2\n");
    EXPECT_FALSE(late.is_refused());
    expect_words(late.told(), {"88 % of the hydrograph's 9 m3 after time.end = 4 s"});
    EXPECT_EQ(inflow("time,discharge\n0,1\n4,2\n").told().find("of the hydrograph's"), std::string::npos);
}

TEST_F(Mistakes, CheckTellsThatTheTrialLeavesTheDtm) {
    EXPECT_EQ(check_in_program({"time.end=60"}).err.find("leaves the DTM"), std::string::npos);
    const Outcome cut =
        check_in_program({"time.end=60", "terrain.bounds=527000 5094000 527120 5094150", "material.friction-angle=3"});
    expect_words(cut.err, {"% of the volume leaves the DTM: use a larger DTM"});
    write_dtm([](int, int column) { return column >= 18 ? -9999.0 : 300 - 2.0 * column; });
    const Outcome hole = check_in_program({"time.end=60", "material.friction-angle=3"});
    expect_words(hole.err, {"the trial reached cells without elevation", "terrain.nodata-policy"});
}

TEST_F(Mistakes, ARunTellsOfExposedThingsOffItsGround) {
    write_polygon("house", {{9000, 30}, {9020, 30}, {9020, 50}, {9000, 50}});
    const Outcome run =
        succeeded(frana({"run", "scene.ini", "--out", "result", "--set", "output.exposure=house.geojson"}));
    expect_words(run.err, {"1 of 1 exposed features not on mapped ground"});
    write("study.ini",
          "[study]\nscene = scene.ini\nsamples = 2\n[set]\noutput.exposure = house.geojson\n[vary]\n"
          "material.friction-angle = uniform(16, 20)\n");
    expect_words(frana({"ensemble", "study.ini", "--out", "study"}).err,
                 {"1 of 1 exposed features not on mapped ground"});
}

// The raster fills a quarter of the outline.
TEST_F(Mistakes, TheReleasedAreaIsThatOfTheThickness) {
    write_dtm([](int row, int column) { return row < 15 && column < 9 ? 2 : 0; }, true, "thickness.asc");
    const Checked checked = check({"release.thickness=raster:thickness.asc"});
    ASSERT_FALSE(checked.is_refused()) << checked.told();
    EXPECT_EQ(app::released_area(checked.prepared->scene), 500);
}

// The slope falls by half: atan(0.5) is 26.6 degrees; the release lies from x = 20 to 70 m.
TEST_F(Mistakes, CheckAndResultTellElevationsAndSlopes) {
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

TEST_F(Mistakes, ElevationsInDecimetresAreReportedAndTheUnitIsAKey) {
    write_scene(k_numbers_only);
    write_dtm([](int, int column) { return 10 * slope(column); });
    const Outcome wrong = succeeded(frana({"check", "scene.ini"}));
    expect_words(wrong.err, {"mean slope of the release 79°", "terrain.vertical-unit", "mean slope of the path"});
    const Outcome right = succeeded(frana({"check", "scene.ini", "--set", "terrain.vertical-unit=decimetre"}));
    EXPECT_EQ(right.err.find("vertical"), std::string::npos) << right.err;
    expect_words(right.out, {"slope 27 degrees on average"});
}

TEST_F(Mistakes, AFlatReleaseIsReported) {
    write_scene(k_numbers_only);
    write_dtm([](int, int) { return 300.0; });
    expect_words(check().told(), {"mean slope of the release", "check CRS"});
}

// Metres read as feet: the slope of 26.6 degrees becomes one of 8.7.
TEST_F(Mistakes, AReleaseThatItsFrictionHoldsIsReported) {
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

TEST_F(Mistakes, AFrameOfZerosIsReported) {
    write_scene(k_numbers_only);
    write_dtm([](int row, int column) {
        const bool frame = row < 2 || column < 2 || row >= k_rows - 2 || column >= k_columns - 2;
        return frame ? 0 : slope(column);
    });
    expect_words(check().told(), {"cells of 0 stand out", "terrain.nodata-value = 0"});
}

TEST_F(Mistakes, ADifferenceNeedsTheGroundThatTheKeySays) {
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

TEST_F(Mistakes, AnOutlineThatIsTheReleaseIsQuestioned) {
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
TEST_F(Mistakes, ScarIsTheSameSectionAsObserved) {
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
TEST_F(Mistakes, AThicknessInAnotherCrsKeepsItsVolume) {
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
TEST_F(Mistakes, AThicknessBeyondThePerimeterIsToldWithBothVolumes) {
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

TEST_F(Mistakes, ANumberSignInAFolderIsNoComment) {
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

TEST_F(Mistakes, HigherThanAnyIsReportedWithItsPlace) {
    expect_words(told([](int, int column) { return 100 * (slope(column) - 8.75); }),
                 {"29000 m at", "above any mountain", "527002.5", "check its unit"});
    expect_words(told([](int, int column) { return column > 50 ? 9999 : slope(column); }),
                 {"270 cells of 9999", "above any mountain"});
}

TEST_F(Mistakes, SlopesOfAWrongUnitAreReported) {
    // 2000 m over 300 m: feet for metres are a factor of three, kilometres for metres one of a thousand.
    expect_words(told([](int, int column) { return 2000 - 35.0 * column; }),
                 {"median slope 81.9°", "terrain.vertical-unit"});
}

TEST_F(Mistakes, SingleCellsFarFromAllNeighboursAreReportedAndCounted) {
    expect_words(told([](int row, int column) { return slope(column) + (row == 12 && column == 30 ? 50 : 0); }),
                 {"1 single cells", "47.5 m at 527152.5, 5094087.5 (row 12, column 30)"});
    expect_words(told([](int row, int column) {
                     return slope(column) + (row % 4 == 2 && column % 4 == 2 && column > 20 ? -30 : 0);
                 }),
                 {"70 single cells", "-27.5 m at", "; ..."});
    // Slopes, steps and ridges one cell wide are no needles.
    const std::string ridge =
        told([](int row, int column) { return slope(column) + (row == 25 || column > 50 ? 60 : 0); });
    EXPECT_EQ(ridge.find("single cell"), std::string::npos) << ridge;
    expect_words(ridge, {"step of 60 m"});  // as between two tiles
}

}  // namespace
}  // namespace frana::test
