// SPDX-License-Identifier: Apache-2.0
// Data surveyed on site, from files to results: zones, obstacles, walls, slip surfaces, late areas, inflow.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/publish/summary.h"
#include "gis/raster/raster_in.h"
#include "support/checked_scene.h"

namespace frana::test {
namespace {

class Site : public CheckedScene {
  protected:
    /// Runs the scene with these lines appended and returns its messages; fails unless the run succeeds. Keys that the
    /// tiny scene already has are given in `sets`.
    std::string run_with(const std::string& lines, const std::string& out = "out",
                         const std::vector<std::string>& sets = {}) {
        write_scene(lines + k_numbers_only);
        // Eight seconds: the mass then reaches 130 m.
        return succeeded(
                   frana(with_sets({"run", "scene.ini", "--out", out, "--overwrite", "--set", "time.end=8"}, sets)))
            .err;
    }
    [[nodiscard]] Raster result(const std::string& name, const std::string& out = "out") const {
        return gis::read_result_raster(path(out + "/" + name + ".tif"));
    }
    [[nodiscard]] double summary(const std::string& key, const std::string& out = "out") const {
        return json_number(read_text(path(out + "/summary.json")), key);
    }
};

TEST_F(Site, ZonesHoldTheFlowWhereTheyAreRough) {
    run_with("");
    const double reach = summary("horizontal_m");
    // From 75 m on, five metres below the release, the bed is rougher (50 degrees) than the slope is steep (27).
    write_features("zones", {{"Polygon", box(75, 0, 300, 150), R"("phi": 50)"}});
    const std::string reported = run_with("[terrain]\nfriction-zones = zones.geojson\n");
    EXPECT_EQ(reported.find("overlap"), std::string::npos) << reported;
    EXPECT_LT(summary("horizontal_m"), 0.8 * reach);
    const std::string log = read_text(path("out/log.txt"));
    expect_words(log, {"column phi taken for zones.friction-angle", "outside all zones"});
    // The same by name, as a coefficient.
    const std::string tangent = std::to_string(std::tan(50 * std::numbers::pi / 180));
    write_features("zones", {{"Polygon", box(75, 0, 300, 150), R"("rough": )" + tangent}});
    run_with("[terrain]\nfriction-zones = zones.geojson\n[zones]\nfriction-coefficient = attribute:rough\n", "named");
    EXPECT_NEAR(summary("horizontal_m", "named"), summary("horizontal_m"), 1e-9);
}

TEST_F(Site, OverlapsAndGapsOfZonesAreReported) {
    write_features("zones", {{"Polygon", box(0, 0, 100, 150), R"("mu": 0.2)"},
                             {"Polygon", box(90, 0, 300, 50), R"("mu": 0.3)"},
                             {"Polygon", box(90, 60, 300, 150), R"("mu": 0.3)"},
                             {"Polygon", box(250, 50, 300, 60), R"("mu": 0.3)"}});
    const std::string reported = run_with("[terrain]\nfriction-zones = zones.geojson\n");
    // 10 m x 140 m are in two zones; a strip of 10 m x 150 m is in none and enclosed.
    expect_words(reported, {"zones overlap on 1 400 m2", "gaps between the zones on 1 500 m2"});
}

TEST_F(Site, ZonesByRasterHaveTheirDefaultOutside) {
    // 50 degrees from 75 m on, no value above.
    write_dtm([](int, int column) { return column >= 15 ? 50.0 : -9999.0; }, true, "phi.asc");
    run_with("");
    const double reach = summary("horizontal_m");
    const std::string reported = run_with("[zones]\nfriction-angle = raster:phi.asc\n");
    EXPECT_NE(reported.find("zones.friction-angle: no value on"), std::string::npos) << reported;
    EXPECT_LT(summary("horizontal_m"), 0.8 * reach);
}

TEST_F(Site, ZonesOfTurbulenceCohesionErodibleDepthAndForest) {
    run_with("");
    const double fastest = summary("max_velocity_ms");
    // Very high drag below the release: v^2 = xi h (sin - mu cos) stays below 1 m2/s2 for 4 m of depth.
    write_features("zones", {{"Polygon", box(70, 0, 300, 150), R"("xi": 0.5)"}});
    run_with("[terrain]\nfriction-zones = zones.geojson\n", "drag");
    EXPECT_LT(summary("max_velocity_ms", "drag"), 0.9 * fastest);
    // Cohesion holds 2 m of 2000 kg/m3 where it exceeds its weight along the slope, about 20 kPa.
    write_features("zones", {{"Polygon", box(0, 0, 300, 150), R"("cohesion": 60000)"}});
    run_with(
        "[terrain]\nfriction-zones = zones.geojson\n[material]\nbed-friction = voellmy, cohesion\n"
        "cohesion = 0\n",
        "held");
    EXPECT_EQ(summary("max_velocity_ms", "held"), 0);
    // The erodible depth comes from a raster: none up to 100 m, 0.5 m beyond.
    write_dtm([](int, int column) { return column >= 20 ? 0.5 : 0.0; }, true, "layer.asc");
    run_with("[entrainment]\nerosion = growth\ngrowth-rate = 0.05\n[zones]\nerodible-depth = raster:layer.asc\n",
             "eroded");
    EXPECT_GT(summary("eroded_m3", "eroded"), 1);
    EXPECT_LT(summary("relative_error", "eroded"), 1e-12);
    const Raster eroded = result("eroded_depth", "eroded");
    for (std::int64_t r = 0; r < eroded.grid.rows; ++r)
        for (std::int64_t c = 0; c < eroded.grid.columns; ++c) {
            // A node is at a cell's corner: half a cell of the erodible layer's edge is on the other side.
            const double depth = eroded.at(r, c);
            EXPECT_FALSE(depth > (c < 19 ? 0 : 0.5 + 1e-6)) << r << ", " << c;
        }
    // Forest from 100 m on holds some of what comes.
    write_features("zones", {{"Polygon", box(100, 0, 300, 150), R"("detrainment": 400)"}});
    run_with(
        "[terrain]\nfriction-zones = zones.geojson\n[entrainment]\ndetrainment = on\n"
        "detrainment-coefficient = 0\n",
        "forest");
    EXPECT_GT(summary("detrained_m3", "forest"), 1);
    EXPECT_LT(summary("relative_error", "forest"), 1e-12);
    const Raster held = result("deposited_depth", "forest");
    for (std::int64_t r = 0; r < held.grid.rows; ++r)
        for (std::int64_t c = 0; c < 19; ++c) EXPECT_FALSE(held.at(r, c) > 0) << r << ", " << c;
}

// A straight channel of curvature 0.01 across its axis: at a distance y from it the slope is (0.5, 0.01 y), and the
// curvature across the slope 0.01 0.25 / (0.25 + (0.01 y)^2), between the table's open slopes and channels.
TEST_F(Site, AFrictionTableGivesEveryCellItsFriction) {
    const auto from_axis = [](std::int64_t row) { return (static_cast<double>(k_rows - row) - 0.5) * k_cell - 75; };
    const auto elevation = [&](std::int64_t row, std::int64_t column) {
        return 1600 - 0.5 * (static_cast<double>(column) + 0.5) * k_cell + 0.005 * from_axis(row) * from_axis(row);
    };
    write_dtm([&](int row, int column) { return elevation(row, column); });
    const std::vector<std::string> table{"material.friction-table=ngi-avalanche", "material.return-period=300"};
    run_with("", "out", table);
    const Raster mu = result("mu"), xi = result("xi");
    // Up to 5000 m3, 300 years: open slope and channel, from 1000 to 1500 m and above.
    const double mu_of[2][2] = {{0.290, 0.330}, {0.275, 0.310}};  // NOLINT(modernize-avoid-c-arrays)
    const double xi_of[2][2] = {{1400, 1180}, {1500, 1250}};      // NOLINT(modernize-avoid-c-arrays)
    for (std::int64_t r = 2; r < k_rows - 2; ++r)
        for (std::int64_t c = 2; c < k_columns - 2; ++c) {
            const int band = elevation(r, c) >= 1500 ? 1 : 0;
            const double curvature = 0.01 * 0.25 / (0.25 + std::pow(0.01 * from_axis(r), 2)),
                         weight = (curvature - 0.002) / 0.008;
            // The precision of a file's floats.
            EXPECT_NEAR(mu.at(r, c), mu_of[band][0] + weight * (mu_of[band][1] - mu_of[band][0]), 1e-6);
            EXPECT_NEAR(xi.at(r, c), 1 / ((1 - weight) / xi_of[band][0] + weight / xi_of[band][1]), 1e-3);
        }
    EXPECT_NEAR(mu.at(0, 20), 0.26, 1e-6) << "no curvature at the edge: flat, above 1500 m";
    const std::string log = read_text(path("out/log.txt"));
    EXPECT_NE(log.find("300 years, 4 000 m³ (class < 5 000 m³); source NGI"), std::string::npos) << log;
    const Json told = parse_json(read_text(path("out/summary.json")))["friction_table"];
    EXPECT_EQ(told["source_read"], true);
    EXPECT_EQ(told["curvature_spacing_m"], 10);
    EXPECT_TRUE(told["volume_from_m3"].is_null());
    EXPECT_EQ(told["volume_to_m3"], 5000);
    // A table of the program's own is an input like others, with its hash.
    std::string recorded;
    const Json inputs = parse_json(read_text(path("out/inputs.json")))["files"];
    for (const Json& file : inputs)
        if (file["key"] == "material.friction-table")
            recorded = file["place"].get<std::string>() + file["xxh128"].get<std::string>();
    EXPECT_NE(recorded.find("friction/ngi-avalanche.ini"), std::string::npos) << recorded;
    double area = 0;
    for (const Json& one : told["areas"]) area += one["area_m2"].get<double>();
    EXPECT_NEAR(area, summary("covered_area_m2"), 1e-6);
    // Another volume, other bands, factors; the friction acts on the flow.
    run_with("", "other",
             {table[0], table[1], "material.table-volume=60000", "material.altitude-limits=1000 2000",
              "material.table-friction-factor=0.5"});
    EXPECT_NEAR(result("mu", "other").at(0, 20), 0.5 * 0.15, 1e-6);
    EXPECT_EQ(parse_json(read_text(path("other/summary.json")))["friction_table"]["friction_factor"], 0.5);
    EXPECT_GT(summary("horizontal_m", "other"), summary("horizontal_m"));
}

// 27 degrees all the way: no 10 degree point. With gentle ground from 80 m on there is one.
TEST_F(Site, AlphaBetaIsToldWhereThePathBecomesGentle) {
    run_with("", "steep");
    const Json steep = parse_json(read_text(path("steep/summary.json")))["runout"];
    EXPECT_GT(steep["path_m"], 0);
    EXPECT_FALSE(steep.contains("beta_deg")) << steep;
    write_dtm([&](int, int column) {
        const double x = (column + 0.5) * k_cell;
        return 1000 - 0.5 * std::min(x, 80.0) - 0.05 * std::max(x - 80, 0.0);
    });
    run_with("", "out", {"material.friction-angle=5", "output.report=on"});
    const Json gentle = parse_json(read_text(path("out/summary.json")))["runout"];
    const double beta = gentle["beta_deg"];
    EXPECT_GT(beta, 15);
    EXPECT_LT(beta, 30) << "the slope, and the thickness of what failed";
    EXPECT_NEAR(gentle["alpha_beta_deg"], 0.96 * beta - 1.4, 1e-9);
    EXPECT_EQ(gentle["alpha_beta_deviation_deg"], 2.3);
    EXPECT_NE(read_text(path("out/report.html")).find("α (Lied, Bakkehøi 1980), β = "), std::string::npos);
}

// 4000 m3 released, and 1000 m3 each second: 5000, 25 000 and 60 000 m3 separate the classes. On cells of 8 m the
// elevations for the curvature are 8 m apart, not 10.
TEST_F(Site, InflowCountsForTheVolumeOfAFrictionTable) {
    write_features("line", {{"LineString", {{60, 60}, {60, 90}}, R"("name": "gully")"}});
    write("flood.csv", "time,discharge,velocity\n0,1000,5\n50,1000,5\n");
    const std::string inflow = "[inflow]\nline = line.geojson\nhydrograph = flood.csv\n";
    const auto of = [&](double end, const std::string& more) {
        write_scene(more + k_numbers_only);
        const Checked checked = check({"time.end=" + std::to_string(end), "terrain.cell-size=8",
                                       "material.friction-table=ngi-avalanche", "material.return-period=300"});
        EXPECT_FALSE(checked.is_refused()) << checked.told();
        return app::friction_json(*checked.prepared->friction, {});
    };
    EXPECT_NEAR(of(10, "")["volume_m3"], 4000, 1);
    const Json table = of(10, inflow);
    EXPECT_NEAR(table["volume_m3"], 14000, 1);
    EXPECT_EQ(table["name"], "ngi-avalanche");
    EXPECT_EQ(table["volume_from_m3"], 5000);
    EXPECT_EQ(table["volume_to_m3"], 25000);
    EXPECT_EQ(table["curvature_spacing_m"], 8);
    EXPECT_NEAR(of(40, inflow)["volume_m3"], 44000, 1);
    const Outcome close = frana({"check", "scene.ini", "--set", "material.friction-table=ngi-avalanche", "--set",
                                 "material.return-period=300", "--set", "material.table-volume=24500"});
    EXPECT_NE(close.out.find("24 500 m³ (class 5 000 – 25 000 m³; ± 5 %: 25 000 – 60 000 m³)"), std::string::npos)
        << close.out;
    const Outcome shown = frana({"check", "scene.ini", "--set", "material.friction-table=ngi-avalanche", "--set",
                                 "material.return-period=300"});
    expect_words(shown.out, {"NGI, Voellmy friction", "(class 5 000 – 25 000 m³)", "ngi-avalanche.ini",
                             "300 kg/m3, from: friction table"});
    // What decides a number and was left alone is told, by a first reader's screen and by the report.
    write_scene(k_pages_only);
    const Json alone = parse_json(frana({"check", "scene.ini", "--json"}).out)["left_at_default"];
    ran("alone", {"time.end=1"});
    const std::string report = read_text(path("alone/report.html"));
    for (const std::string one : {"material.density = 2000 kg/m3", "output.trace-threshold = 0.1 m"}) {
        EXPECT_NE(alone.dump().find(one), std::string::npos) << alone;
        EXPECT_NE(report.find(one), std::string::npos);
    }
    EXPECT_EQ(report.find("time.end = "), std::string::npos) << "given";
}

TEST_F(Site, ForestAndZonesChangeTheValuesOfAFrictionTable) {
    write("own.ini", own_friction_table(0.2));
    write_features("wood", {{"Polygon", box(100, 0, 400, 150), R"("kind": "oak")"}});  // reaches beyond the DTM
    write_features("zones", {{"Polygon", box(200, 0, 300, 150), R"("mu": 0.5)"}});
    run_with("[terrain]\nfriction-zones = zones.geojson\n", "out",
             {"material.friction-table=own.ini", "material.return-period=30", "material.forest=wood.geojson"});
    const Raster mu = result("mu"), xi = result("xi");
    EXPECT_NEAR(mu.at(15, 19), 0.2, 1e-7);
    EXPECT_NEAR(xi.at(15, 19), 1000, 1e-3);
    EXPECT_NEAR(mu.at(15, 20), 0.25, 1e-7);
    EXPECT_NEAR(xi.at(15, 20), 400, 1e-3);
    EXPECT_NEAR(mu.at(15, 40), 0.5, 1e-7);
    EXPECT_NEAR(xi.at(15, 40), 400, 1e-3);
}

// RAMMS's yield term resists with (1 - mu) N_0: less where mu is greater.
TEST_F(Site, ZonesOfFrictionForRammsYield) {
    const std::string lines =
        "[terrain]\nfriction-zones = zones.geojson\n[material]\nbed-friction = ramms-yield\n"
        "ramms-yield-stress = 20000\n";
    const std::vector<std::string> no_voellmy{"material.turbulence=off", "material.friction-angle=6"};
    write_features("zones", {{"Polygon", box(0, 0, 300, 150), R"("mu": 0.1051042352656764)"}});
    run_with(lines, "same", no_voellmy);
    write_features("zones", {{"Polygon", box(0, 0, 300, 150), R"("mu": 0.9)"}});
    run_with(lines, "weak", no_voellmy);
    EXPECT_GT(summary("max_velocity_ms", "weak"), 1.5 * summary("max_velocity_ms", "same"));
    // As friction-angle = 6 everywhere.
    write_scene(lines.substr(lines.find("[material]")) + k_numbers_only);
    succeeded(frana({"run", "scene.ini", "--out", "uniform", "--set", "time.end=8", "--set", no_voellmy[0], "--set",
                     no_voellmy[1]}));
    EXPECT_NEAR(summary("max_velocity_ms", "uniform"), summary("max_velocity_ms", "same"), 1e-9);
}

TEST_F(Site, EveryFileIsInTheTableOfTheCheckAndInTheReport) {
    write_features("zones", {{"Polygon", box(75, 0, 300, 150), R"("phi": 30)"}});
    write_features("dam", {{"Polygon", box(200, 0, 215, 150), R"("h": 5)"}});
    write_features("house", {{"Polygon", box(240, 40, 255, 60)}});
    write_features("line", {{"LineString", {{30, 100}, {30, 130}}}});
    write("flood.csv", "time_s,discharge_m3s,velocity_ms\n0,10,2\n3,10,2\n");
    write_features("tongue", {{"Polygon", box(80, 40, 150, 110)}});
    const std::string lines =
        "[terrain]\nfriction-zones = zones.geojson\nobstacles = dam.geojson\nobstacle-height = attribute:h\n"
        "walls = house.geojson\n[inflow]\nline = line.geojson\nhydrograph = flood.csv\n"
        "[scar]\ndeposit = tongue.geojson\n";
    write_scene(lines + k_numbers_only);
    const Outcome check = succeeded(frana({"check", "scene.ini"}));
    ran("out", {"time.end=0.5", "output.report=on"});
    const std::string report = read_text(path("out/report.html"));
    for (const std::string words :
         {"DTM", "dtm.asc", "Release perimeter", "Zones", "zones.geojson", "Obstacles", "dam.geojson", "Walls",
          "house.geojson", "Inflow line", "line.geojson", "Hydrograph", "flood.csv", "Surveyed deposit",
          "tongue.geojson", "WGS 84 / UTM zone 32N", "polygons: 1", "lines: 1"}) {
        EXPECT_NE(check.out.find(words), std::string::npos) << words << " in " << check.out;
        EXPECT_NE(report.find(words), std::string::npos) << words;
    }
}

TEST_F(Site, ObstaclesRaiseTheBedAndHoldTheFlow) {
    run_with("");
    const double reach = summary("horizontal_m");
    // A dam one metre thick is thinner than a cell, and still has no gap.
    write_features("dam", {{"Polygon", box(101, 0, 102, 150), R"("h": 25)"}});
    const std::string reported = run_with("[terrain]\nobstacles = dam.geojson\nobstacle-height = attribute:h\n", "dam");
    EXPECT_NE(reported.find("smaller cells"), std::string::npos) << reported;
    EXPECT_LT(summary("horizontal_m", "dam"), reach);
    const Raster before = result("dtm"), after = result("dtm", "dam");
    for (std::int64_t r = 0; r < after.grid.rows; ++r) EXPECT_NEAR(after.at(r, 20) - before.at(r, 20), 25, 1e-4) << r;
    EXPECT_NEAR(after.at(3, 19), before.at(3, 19), 1e-9);
}

TEST_F(Site, WallsAreNotPassed) {
    write_features("houses", {{"Polygon", box(110, 0, 125, 150)}});
    run_with("[terrain]\nwalls = houses.geojson\n");
    const Raster depth = result("max_depth");
    EXPECT_GT(depth.at(14, 21), 0.5);  // it reached the wall
    for (std::int64_t r = 0; r < depth.grid.rows; ++r)
        for (std::int64_t c = 22; c < depth.grid.columns; ++c) EXPECT_TRUE(std::isnan(depth.at(r, c)));
    EXPECT_EQ(summary("entered_no_data"), 0);
    EXPECT_LT(summary("relative_error"), 1e-12);
}

TEST_F(Site, LateAreasHaveTheirOwnStartVelocityAndVolume) {
    write_features("areas", {{"Polygon", box(20, 20, 60, 60), R"("d": 2, "t": 0, "v": 0, "m3": 4000)"},
                             {"Polygon", box(20, 90, 60, 130), R"("d": 2, "t": 1.5, "v": 8, "m3": 2500)"}});
    run_with("[release]\nstart = attribute:t\nvelocity = attribute:v\nvolume = attribute:m3\n", "out",
             {"release.perimeter=areas.geojson", "release.thickness=attribute:d"});
    EXPECT_NEAR(summary("initial_m3"), 4000, 1e-8);
    EXPECT_NEAR(summary("entered_m3"), 6500, 1e-8);
    EXPECT_LT(summary("relative_error"), 1e-12);
    const Raster arrival = result("arrival_time");
    EXPECT_NEAR(arrival.at(8, 8), 1.5, 0.2);
    const std::string log = read_text(path("out/log.txt"));
    EXPECT_NE(log.find("release 2: 2 500 m3, 1 600 m2, at 1.5 s"), std::string::npos) << log;
}

TEST_F(Site, SlipSurfaceIsFittedAndRemovedFromTheGround) {
    run_with("[release]\nslip-depth = 6\ndtm-contains-release = on\n", "out", {"release.thickness=slip-surface"});
    const Raster dtm = result("dtm"), bed = result("bed");
    double deepest = 0;
    for (std::size_t i = 0; i < bed.values.size(); ++i) deepest = std::max(deepest, dtm.values[i] - bed.values[i]);
    // The deepest cell's centre is 3.5 m from the centroid of an outline 20 m wide: 6 sqrt(1 - r^2) > 5.7.
    EXPECT_GT(deepest, 5.5);
    EXPECT_LT(deepest, 6.0 + 1e-4);
    EXPECT_NE(read_text(path("out/log.txt")).find("ellipsoid, 6 m deep"), std::string::npos);
    run_with("[release]\nvolume = 7000\ndtm-contains-release = on\n", "out", {"release.thickness=slip-surface"});
    EXPECT_NEAR(summary("initial_m3"), 7000, 1e-8);
}

TEST_F(Site, SlipSurfaceFromARaster) {
    // 3 m under the slope everywhere.
    write_dtm([](int, int column) { return 297 - 0.5 * std::min((column + 0.5) * k_cell, 200.0); }, true, "slip.asc");
    run_with("[release]\ndtm-contains-release = on\n", "out", {"release.thickness=slip-surface:slip.asc"});
    EXPECT_NEAR(summary("initial_m3"), 3 * 50 * 40, 1e-6);
}

TEST_F(Site, HydrographFlowsInCompletely) {
    write_features("line", {{"LineString", {{30, 60}, {30, 90}}}});
    write("flood.csv", "time_s,discharge_m3s,velocity_ms\n0,0,0\n1,120,6\n3,0,0\n");
    const std::string scene =
        "[terrain]\ndtm = dtm.asc\n[inflow]\nline = line.geojson\nhydrograph = flood.csv\n[material]\n"
        "friction-angle = 5\n[time]\nend = 4\n";
    write("flood.ini", scene + k_numbers_only);
    succeeded(frana({"run", "flood.ini", "--out", "flood"}));
    EXPECT_EQ(summary("initial_m3", "flood"), 0);
    EXPECT_NEAR(summary("inflow_m3", "flood"), 180, 180e-12);
    EXPECT_LT(summary("relative_error", "flood"), 1e-12);
    // The same volumes, given as a volume; at the critical speed.
    write("flood.csv", "time;volume\n0;0\n1;60\n3;180\n");
    const Outcome again = succeeded(frana({"run", "flood.ini", "--out", "again"}));
    EXPECT_NEAR(summary("inflow_m3", "again"), 180, 180e-12);
    const Outcome check = frana({"check", "flood.ini"});
    EXPECT_NE(check.out.find("180 m3 until the end"), std::string::npos) << check.out;
}

}  // namespace
}  // namespace frana::test
