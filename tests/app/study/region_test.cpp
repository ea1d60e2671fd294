// SPDX-License-Identifier: Apache-2.0
// Regions: many slopes, each of which fails alone.
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>

#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "gis/vector/vector_in.h"
#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// A slope with the columns of the test's regions.
struct TestSlope {
    std::string name, scenario, years, thickness, friction;  ///< as JSON
    double west, south, side;
};

class Region : public Ensemble {
  protected:
    Region() {
        write("scene.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = slopes.geojson\nthickness = 1\n[material]\n"
              "friction-angle = 18\nturbulence = 500\n[time]\nend = 20\nstop-when-still = off\n" +
                  k_numbers_only + "charts = off\n");
    }
    void write_slopes(const std::vector<TestSlope>& slopes) const {
        std::vector<TestFeature> features;
        for (const TestSlope& s : slopes)
            features.push_back({"Polygon", box(s.west, s.south, s.west + s.side, s.south + s.side),
                                R"("NAME": ")" + s.name + R"(", "SCENARIO": ")" + s.scenario + R"(", "YEARS": )" +
                                    s.years + R"(, "THICK": )" + s.thickness + R"(, "MU": )" + s.friction});
        write_features("slopes", features);
    }
    void write_region(const std::string& more = "") const {
        write("region.ini", "[region]\nscene = scene.ini\nname = NAME\nscenario = SCENARIO\n" + more +
                                "[columns]\nrelease.thickness = THICK\nmaterial.friction-coefficient = MU\n");
    }
    [[nodiscard]] Outcome batch(const std::vector<std::string>& more = {}, const std::string& out = "out") const {
        return frana(with_more({"batch", "region.ini", "--out", out, "--quiet"}, more));
    }
    /// A point in the middle of every cell of the sixteenth row, and, if asked, an area that all slopes reach.
    void write_houses(bool with_area = false) const {
        std::vector<TestFeature> features;
        for (int column = 0; column < k_columns; ++column)
            features.push_back({"Point", {{(column + 0.5) * k_cell, 72.5}}});
        if (with_area) features.push_back({"Polygon", box(5, 10, k_columns * k_cell - 5, 130)});
        write_features("houses", features);
    }
    static std::string cell_of(const gis::Table& table, const std::vector<std::string>& row, const std::string& name) {
        const auto found = std::find(table.columns.begin(), table.columns.end(), name);
        EXPECT_NE(found, table.columns.end()) << name;
        return row[static_cast<std::size_t>(found - table.columns.begin())];
    }
    /// Objects of one cell have what the maps of the scenarios and of the degree have there.
    void expect_objects_as_maps(const std::vector<std::string>& scenarios) const {
        const gis::Table table = gis::read_table(path("out/exposure.csv"), "exposure");
        const auto expect_map = [&](const std::string& name, const std::string& map) {
            const Raster values = raster("out/" + map + ".tif");
            int some = 0;
            for (std::int64_t i = 0; i < k_columns; ++i) {
                const double value = values.at(15, i);
                const std::string cell = cell_of(table, table.rows[static_cast<std::size_t>(i)], name);
                EXPECT_NEAR(std::stod(cell), std::isnan(value) ? 0 : value, 1e-6) << name << ' ' << i;
                some += value > 0 ? 1 : 0;
            }
            EXPECT_GE(some, 3) << name;
        };
        for (const std::string& scenario : scenarios)
            for (const auto& [name, map] :
                 {std::pair{"max_depth_m", "max_depth"}, std::pair{"max_velocity_ms", "max_velocity"},
                  std::pair{"max_pressure_kpa", "max_pressure"}, std::pair{"intensity", "intensity"}})
                expect_map(scenario + "_" + name, std::string("scenario_") + map + "_" + scenario);
        expect_map("hazard_degree", "hazard_degree");
        for (const auto& row : table.rows)
            EXPECT_EQ(cell_of(table, row, "degree_source").empty(),
                      std::stod(cell_of(table, row, "hazard_degree")) == 0);
    }
    [[nodiscard]] Raster raster(const std::string& name) const { return gis::read_result_raster(path(name)); }
    static std::vector<TestSlope> three() {
        return {{"a", "often", "30", "1", "0.3", 20, 20, 20},
                {"b", "often", "30", "1.5", "0.25", 25, 45, 25},
                {"c", "rare", "300", "2", "0.2", 20, 95, 30}};
    }
};

/// The value of a raster on another grid with the same lattice; NaN outside.
double value_at(const Raster& from, const GridSpec& grid, std::int64_t row, std::int64_t column) {
    const Point centre = grid.cell_centre(row, column);
    const auto r = static_cast<std::int64_t>(std::floor((from.grid.north - centre.y) / from.grid.cell_size)),
               c = static_cast<std::int64_t>(std::floor((centre.x - from.grid.west) / from.grid.cell_size));
    if (r < 0 || c < 0 || r >= from.grid.rows || c >= from.grid.columns) return std::nan("");
    return from.at(r, c);
}

// Every slope is the run of the scene with its values; union and scenario have the greatest of them in each cell.
TEST_F(Region, UnionIsTheGreatestOfTheRuns) {
    write_slopes(three());
    write_region();
    succeeded(batch({"--threads", "2"}));
    const Rows rows = members();
    ASSERT_EQ(rows.size(), 3U);
    std::vector<Raster> depth, velocity, pressure;
    for (const auto& row : rows) {
        ASSERT_EQ(row.at("status"), "finished") << row.at("reason");
        std::vector<std::string> arguments{"run",         "scene.ini", "--out", "alone",
                                           "--overwrite", "--quiet",   "--set", "time.end=" + row.at("time.end")};
        for (const std::string key :
             {"release.perimeter-filter", "release.thickness", "material.friction-coefficient"}) {
            arguments.insert(arguments.end(), {"--set", key + "=" + row.at(key)});
        }
        const Outcome alone = succeeded(frana(arguments));
        depth.push_back(raster("alone/max_depth.tif"));
        velocity.push_back(raster("alone/max_velocity.tif"));
        pressure.push_back(raster("alone/max_pressure.tif"));
    }
    const Raster all = raster("out/union_max_depth.tif"), fast = raster("out/union_max_velocity.tif"),
                 hard = raster("out/union_max_pressure.tif"), hits = raster("out/hit_count.tif"),
                 worst = raster("out/worst_source.tif"), often = raster("out/scenario_max_depth_often.tif"),
                 rare = raster("out/scenario_max_depth_rare.tif");
    int several = 0, reached = 0;
    const auto greatest = [](double a, double b) { return std::fmax(a, b); };
    const auto same = [](double a, double b) { return (std::isnan(a) && std::isnan(b)) || a == b; };
    for (std::int64_t row = 0; row < all.grid.rows; ++row)
        for (std::int64_t column = 0; column < all.grid.columns; ++column) {
            const auto value = [&](const Raster& one) { return value_at(one, all.grid, row, column); };
            double most = std::nan(""), speed = most, push = most, count = 0, number = most;
            for (std::size_t m = 0; m < 3; ++m) {
                if (std::isnan(value(depth[m]))) continue;
                count += 1;
                if (std::isnan(most) || value(depth[m]) > most) number = static_cast<double>(m);
                most = greatest(most, value(depth[m]));
                speed = greatest(speed, value(velocity[m]));
                push = greatest(push, value(pressure[m]));
            }
            several += count > 1;
            reached += count > 0;
            ASSERT_TRUE(same(all.at(row, column), most)) << row << ' ' << column;
            ASSERT_TRUE(same(fast.at(row, column), speed)) << row << ' ' << column;
            ASSERT_TRUE(same(hard.at(row, column), push)) << row << ' ' << column;
            ASSERT_TRUE(same(worst.at(row, column), number)) << row << ' ' << column;
            ASSERT_TRUE(same(often.at(row, column), greatest(value(depth[0]), value(depth[1]))))
                << row << ' ' << column;
            ASSERT_TRUE(same(rare.at(row, column), value(depth[2]))) << row << ' ' << column;
            ASSERT_TRUE(count == 0 || hits.at(row, column) == count) << row << ' ' << column;
        }
    EXPECT_GT(several, 10);
    EXPECT_GT(reached, 100);
    const gis::PolygonLayer slopes = gis::read_polygons(path("out/members.gpkg") + "|layer=slopes", "", "test");
    ASSERT_EQ(slopes.features.size(), 3U);
    EXPECT_EQ(slopes.features[2].texts.at("name"), "c");
    EXPECT_EQ(slopes.features[2].texts.at("scenario"), "rare");
    EXPECT_EQ(slopes.features[1].numbers.at("max_depth_m"), std::stod(rows[1].at("max_depth_m")));
    EXPECT_TRUE(fs::exists(path("out/result.qgz")));
    EXPECT_TRUE(fs::exists(path("out/region.ini")));
}

TEST_F(Region, SameBitsForAnyNumberOfThreadsAndAfterAKill) {
    write_slopes({{"a", "x", "30", "1", "0.3", 20, 20, 20},
                  {"b", "x", "30", "1.5", "0.25", 25, 45, 25},
                  {"c", "y", "300", "2", "0.2", 20, 95, 30},
                  {"d", "y", "300", "2", "0.22", 30, 60, 30},
                  {"e", "y", "300", "1", "0.24", 30, 30, 30},
                  {"f", "y", "300", "1.2", "0.26", 40, 80, 20}});
    write_region();
    succeeded(batch({"--threads", "1"}, "one"));
    succeeded(batch({"--threads", "3"}, "three"));
    expect_same("one", "three");
    std::size_t kept = 0;  // on a busy machine the kill may come when all is computed: then again
    for (int tries = 0; tries < 20 && (kept == 0 || kept == 6); ++tries) {
        for (const char* folder : {"killed", "killed.partial"}) fs::remove_all(path(folder));
        StartedProgram program(folder_.string(), {"batch", "region.ini", "--out", "killed", "--threads", "1"});
        program.wait_until([&] { return !records().empty(); });
        program.send(SIGKILL);
        (void)program.wait();
        kept = records().size();
    }
    EXPECT_TRUE(kept > 0 && kept < 6) << kept;
    succeeded(batch({"--resume"}, "killed"));
    expect_same("one", "killed");
}

// A mosaic of two files: only what is cut from both together is the terrain.
TEST_F(Region, TerrainIsCutFromAMosaic) {
    write_slopes(three());
    write_region();
    succeeded(batch({}, "one"));
    const Raster whole = raster("dtm.asc");
    constexpr int k_seam = 9;  // under the slopes
    const auto part = [&](bool west) {
        return [&, west](int row, int column) {
            return (column < k_seam) == west ? whole.at(row, column) : 5000.0;  // what the mosaic must not show
        };
    };
    write_dtm(part(true), true, "west.asc");
    write_dtm(part(false), true, "east.asc");
    const auto source = [](const std::string& file, int from, int count) {
        const std::string rectangle = "Rect xOff=\"" + std::to_string(from) + "\" yOff=\"0\" xSize=\"" +
                                      std::to_string(count) + "\" ySize=\"" + std::to_string(k_rows) + "\"/>";
        return "<SimpleSource><SourceFilename relativeToVRT=\"1\">" + file +
               "</SourceFilename><SourceBand>1</SourceBand><Src" + rectangle + "<Dst" + rectangle + "</SimpleSource>";
    };
    char place[200];
    std::snprintf(place, sizeof place, "%.1f, %.1f, 0, %.1f, 0, %.1f", k_west, k_cell, k_south + k_rows * k_cell,
                  -k_cell);
    write("mosaic.vrt", "<VRTDataset rasterXSize=\"" + std::to_string(k_columns) + "\" rasterYSize=\"" +
                            std::to_string(k_rows) + "\"><SRS>EPSG:32632</SRS><GeoTransform>" + place +
                            "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\">" +
                            source("west.asc", 0, k_seam) + source("east.asc", k_seam, k_columns - k_seam) +
                            "</VRTRasterBand></VRTDataset>");
    std::string scene = read_text(path("scene.ini"));
    scene.replace(scene.find("dtm.asc"), 7, "mosaic.vrt");
    write("scene.ini", scene);
    succeeded(batch({}, "mosaic"));
    const Raster one = raster("one/union_max_depth.tif"), mosaic = raster("mosaic/union_max_depth.tif");
    ASSERT_EQ(one.values.size(), mosaic.values.size());
    for (std::size_t cell = 0; cell < one.values.size(); ++cell)
        ASSERT_TRUE(one.values[cell] == mosaic.values[cell] ||
                    (std::isnan(one.values[cell]) && std::isnan(mosaic.values[cell])))
            << cell;
}

// Polygons without geometry and one that crosses itself keep their place in the table; the others are done.
TEST_F(Region, PolygonsWithoutAnAreaFailAlone) {
    std::vector<TestSlope> slopes = three();
    slopes.insert(slopes.begin() + 1, {"none", "rare", "300", "2", "0.2", 30, 70, 20});
    slopes.insert(slopes.begin() + 2, {"tie", "rare", "300", "2", "0.2", 40, 70, 20});
    write_slopes(slopes);
    std::string text = read_text(path("slopes.geojson"));
    const auto geometry_of = [&](const std::string& name) {
        const std::size_t from = text.find(R"("geometry": )", text.find("\"" + name + "\"")) + 12;
        return std::pair{from, text.find("]]}", from) + 3 - from};
    };
    const auto [tie, tie_length] = geometry_of("tie");
    const auto corner = [](double x, double y) {
        return "[" + std::to_string(k_west + x) + ", " + std::to_string(k_south + y) + "]";
    };
    text.replace(tie, tie_length,
                 R"({"type": "Polygon", "coordinates": [[)" + corner(40, 70) + ", " + corner(60, 90) + ", " +
                     corner(60, 70) + ", " + corner(40, 90) + ", " + corner(40, 70) + "]]}");
    const auto [none, none_length] = geometry_of("none");
    text.replace(none, none_length, "null");
    write("slopes.geojson", text);
    write_region();
    const Outcome check = succeeded(frana({"check", "region.ini"}));
    EXPECT_NE(check.out.find("5, of which 2 fail"), std::string::npos) << check.out;
    const Outcome outcome = batch();
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;  // more than a twentieth failed
    const Rows rows = members();
    ASSERT_EQ(rows.size(), 5U);
    for (const std::size_t i : {0U, 3U, 4U}) EXPECT_EQ(rows[i].at("status"), "finished") << i;
    EXPECT_NE(rows[1].at("reason").find("no geometry"), std::string::npos) << rows[1].at("reason");
    EXPECT_NE(rows[2].at("reason").find("crosses itself"), std::string::npos) << rows[2].at("reason");
}

// One without terrain, the largest of all, one with an impossible value, one without a value: the others are done.
TEST_F(Region, FailedSlopesAreListedAndTheRestIsDone) {
    std::vector<TestSlope> slopes = three();
    slopes.push_back({"far", "rare", "300", "2", "0.2", 5000, 95, 40});
    slopes.push_back({"steep", "rare", "300", "2", "77", 40, 60, 30});
    slopes.push_back({"blank", "rare", "300", "null", "0.2", 40, 60, 30});
    write_slopes(slopes);
    write_region("[set]\noutput.report = on\n");
    const Outcome check = succeeded(frana({"check", "region.ini"}));
    expect_words(check.out, {"6, of which 3 fail", "3 far", "4 steep", "5 blank", "column THICK", "memory"});
    const Outcome document = frana({"check", "region.ini", "--json"});
    expect_words(document.out, {R"("slopes": [)", R"("name": "far")", R"("scenario": "often")"});
    const Outcome outcome = batch();
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;  // more than a twentieth failed
    const std::string first = parse_json(read_text(path("out/summary.json")))["warnings"][0];
    EXPECT_NE(first.find("3 of 6 runs failed"), std::string::npos) << first;
    const std::string page = read_text(path("out/report.html")),
                      section = page.substr(page.find("<h2 id=\"failures\""));
    expect_words(section.substr(0, section.find("</table>")), {"<td>3, far, rare</td>", "reason", "column THICK"});
    const Rows rows = members();
    ASSERT_EQ(rows.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(rows[i].at("status"), i < 3 ? "finished" : "failed") << i;
    EXPECT_NE(rows[4].at("reason").find("material.friction-coefficient"), std::string::npos) << rows[4].at("reason");
    EXPECT_NE(rows[5].at("reason").find("column THICK"), std::string::npos) << rows[5].at("reason");
    EXPECT_FALSE(rows[3].at("reason").empty());
    EXPECT_GT(raster("out/union_max_depth.tif").grid.rows, 0);
    const gis::PolygonLayer layer = gis::read_polygons(path("out/members.gpkg") + "|layer=slopes", "", "test");
    EXPECT_EQ(layer.features.size(), 6U);
    EXPECT_EQ(layer.features[4].texts.at("status"), "failed");
}

// Twelve creeks were cut after 60 s of 900, exit 0 and no warning. Of a region any slope is in the first line.
TEST_F(Region, SlopesThatWereCutAreTold) {
    write_slopes(three());
    write_polygon("house", {{118, 50}, {128, 50}, {128, 60}, {118, 60}});
    write_region("[set]\ntime.end = 0.6\noutput.report = on\noutput.exposure = house.geojson\n");  // they run on to 6 s
    succeeded(batch());
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_EQ(summary["run_troubles"]["cut"], 3);
    EXPECT_NE(summary["warnings"][0].get<std::string>().find("3 of 3 runs cut while moving"), std::string::npos);
    for (const auto& row : members()) {
        EXPECT_EQ(row.at("stop_reason"), "end-time");
        EXPECT_GE(std::stoi(row.at("warnings")), 1);
    }
    const gis::Table exposed = gis::read_table(path("out/exposure.csv"), "exposure");
    const auto house = [&](const std::string& column) {
        const auto place = std::find(exposed.columns.begin(), exposed.columns.end(), column) - exposed.columns.begin();
        return exposed.rows.at(0).at(static_cast<std::size_t>(place));
    };
    EXPECT_LT(std::stoi(house("sources")), 3);
    EXPECT_EQ(house("sources_upper"), "3") << "all of them might have come";
    const std::string report = read_text(path("out/report.html"));
    EXPECT_LT(report.find("3 of 3 runs cut while moving"), report.find("id=\"answer\""));
    EXPECT_NE(report.find("Farthest run-out [m]"), std::string::npos);
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("out/members.gpkg").c_str(), GDAL_OF_VECTOR));
    OGRLayer* const slopes = file->GetLayerByName("slopes");
    ASSERT_NE(slopes, nullptr);
    for (const auto& slope : *slopes) EXPECT_GT(slope->GetFieldAsDouble("moving_fraction"), 0.5);
    EXPECT_EQ(batch({"--overwrite", "--strict"}).exit_code, 3);
}

// Terrain that ends 10 m below slopes whose flows come 100 m far.
TEST_F(Region, SlopesThatLeaveTheGroundAreTold) {
    write_slopes(three());
    const auto text = [](double value) { return std::to_string(value) + " "; };
    write_region("[set]\nterrain.bounds = " + text(k_west) + text(k_south) + text(k_west + 60) + text(k_south + 150) +
                 "\n");
    succeeded(batch());
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_EQ(summary["run_troubles"]["left_ground"], 3);
    EXPECT_NE(summary["warnings"][0].get<std::string>().find("3 of 3 runs left the domain"), std::string::npos);
    for (const auto& row : members()) EXPECT_GT(std::stod(row.at("left_domain_fraction")), 0.5);
    EXPECT_EQ(batch({"--overwrite", "--strict"}).exit_code, 3);
}

// One text makes the whole column one of texts.
TEST_F(Region, OneTextInAColumnFailsThatSlopeAloneByItsNumberInTheFile) {
    std::vector<TestSlope> slopes = three();
    slopes[1].thickness = "\"unknown\"";
    slopes.push_back({"d", "rare", "300", "-2", "0.2", 40, 60, 20});
    write_slopes(slopes);
    write("region.ini", "[region]\nscene = scene.ini\nname = NAME\n");
    write("scene.ini",
          std::regex_replace(read_text(path("scene.ini")), std::regex("thickness = 1"), "thickness = attribute:THICK"));
    const Outcome check = frana({"check", "region.ini", "--json"});
    const auto foreseen = nlohmann::json::parse(check.out).at("slopes");
    const Outcome outcome = batch();
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;  // more than a twentieth failed
    const Rows rows = members();
    ASSERT_EQ(rows.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(foreseen.at(i).at("problem").is_null(), i % 2 == 0) << i;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(rows[i].at("status"), i % 2 == 0 ? "finished" : "failed") << i;
    EXPECT_NE(rows[1].at("reason").find("THICK"), std::string::npos) << rows[1].at("reason");
    EXPECT_NE(rows[3].at("reason").find("feature 3 of slopes"), std::string::npos) << rows[3].at("reason");
}

// A matrix colours more than another: the scheme asks which, and the map names it.
TEST_F(Region, TheMatrixOfTheProcessIsAskedFor) {
    write_slopes(three());
    const std::string scene = read_text(path("scene.ini")) + "[hazard]\nscheme = swiss-debris-flow\n";
    write("scene.ini", scene);
    write_region("return-period = YEARS\n");
    refusal_of(batch(), {"hazard.process: is not given", "all, channel-debris-flow"});
    double red[2] = {};
    for (const int of_channel : {0, 1}) {
        write("scene.ini", scene + "process = " + (of_channel == 1 ? "channel-debris-flow\n" : "all\n"));
        succeeded(batch({"--overwrite"}));
        for (const double degree : raster("out/hazard_degree.tif").values) red[of_channel] += degree == 4 ? 1 : 0;
        EXPECT_EQ(
            gis::read_raster_text(path("out/hazard_degree.tif")).metadata.at("HAZARD_SOURCE"),
            of_channel == 1 ? "Canton of Ticino, debris flow in a channel" : "Canton of Bern, all processes together");
    }
    EXPECT_GT(red[0], red[1]);
    write("scene.ini", scene + "process = flood\n");
    EXPECT_NE(batch({"--overwrite"}).err.find("is no process of swiss-debris-flow"), std::string::npos);
}

TEST_F(Region, MistakesAreRefusedBeforeAnythingRuns) {
    write_slopes(three());
    write("region.ini", "[region]\nscene = scene.ini\nname = NAMES\n[columns]\nrelease.thickness = DEPTH\n");
    refusal_of(batch(), {"region.name", "Did you mean NAME", "columns.release.thickness", "DEPTH"});
    write_region("return-period = YEARS\n");
    refusal_of(batch(), {"hazard.scheme"});
    for (const std::string command : {"ensemble", "run"})
        EXPECT_NE(frana({command, "region.ini"}).err.find("frana batch"), std::string::npos) << command;
    EXPECT_NE(frana({"batch", "scene.ini"}).err.find("[region]"), std::string::npos);
    std::vector<TestSlope> slopes = three();
    slopes[1].years = "100";  // of the same scenario
    write_slopes(slopes);
    EXPECT_NE(batch().err.find("several return periods"), std::string::npos);
    EXPECT_FALSE(fs::exists(path("out")));
}

// One event has one return period: one of the friction table that differs is refused; without it the event's counts.
TEST_F(Region, AFrictionTableIsReadByTheReturnPeriodOfTheEvent) {
    write_slopes(three());
    const std::string plain =
        std::regex_replace(read_text(path("scene.ini")), std::regex("friction-angle = 18\nturbulence = 500"),
                           "friction-table = ngi-avalanche");
    write("own.ini", own_scheme("depth > ", "0.3 m", "0.8 m"));
    const auto write_with = [&](const std::string& period, const std::string& column) {
        write("scene.ini", std::regex_replace(plain, std::regex("(ngi-avalanche)"), "$1\n" + period) +
                               "[hazard]\nscheme = own.ini\n");
        write("region.ini",
              "[region]\nscene = scene.ini\nname = NAME\nscenario = SCENARIO\n"
              "return-period = YEARS\n" +
                  column);
    };
    for (const auto& [period, column] : {std::pair<std::string, std::string>{"return-period = 300\n", ""},
                                         {"", "[columns]\nmaterial.return-period = THICK\n"}}) {
        write_with(period, column);
        refusal_of(batch(), {"region.return-period: differs from material.return-period"});
    }
    write_with("", "");
    succeeded(batch());
    for (const auto& row : members()) EXPECT_EQ(row.at("material.return-period"), row.at("return_period"));
    EXPECT_NE(read_text(path("out/region.ini")).find("material.return-period = YEARS"), std::string::npos);
}

// Paths with a column for each scenario are, to the bit, polygons with a row for each event.
TEST_F(Region, PathsTimesScenariosAreTheirEvents) {
    std::vector<TestSlope> events;
    for (const auto& [scenario, years, thick] :
         {std::array{"30", "30", "1"}, std::array{"100", "100", "1.5"}, std::array{"300", "300", "2"}})
        for (TestSlope path : three()) {
            if (path.name == "c" && years == std::string("30")) continue;  // it has no such event
            path.scenario = scenario;
            path.years = years;
            path.thickness = thick;
            events.push_back(path);
        }
    write("own.ini", own_scheme("depth > ", "0.3 m", "0.8 m"));
    write("scene.ini", std::regex_replace(read_text(path("scene.ini")), std::regex("thickness = 1\n"), "") +
                           "formats = geotiff, shp, kmz, dxf\nexposure = houses.geojson\n[hazard]\nscheme = own.ini\n");
    write_houses();
    write_slopes(events);
    write_region("return-period = YEARS\n");
    succeeded(batch({}, "events"));
    std::vector<TestSlope> paths = three();
    for (TestSlope& one : paths)
        one.thickness = std::string(R"(0, "D30": )") + (one.name == "c" ? "null" : "1") + R"(, "D100": 1.5, "D300": 2)";
    write_slopes(paths);
    write("region.ini",
          "[region]\nscene = scene.ini\nname = NAME\n[set]\noutput.report = on\n[columns]\n"
          "material.friction-coefficient = MU\n"
          "[scenario 300]\nrelease.thickness = D300\n[scenario 30]\nrelease.thickness = D30\n"
          "[scenario 100]\nrelease.thickness = D100\n");
    succeeded(batch());
    const Rows rows = members();
    ASSERT_EQ(rows.size(), 8U);
    std::string order;
    for (const auto& row : rows) order += row.at("name") + row.at("return_period") + " ";
    EXPECT_EQ(order, "a30 a100 a300 b30 b100 b300 c100 c300 ");
    for (const std::string name : {"scenario_max_depth_30", "scenario_max_velocity_100", "scenario_max_depth_300",
                                   "scenario_hit_count_30", "hazard_degree", "union_max_depth"}) {
        const Raster one = raster("out/" + name + ".tif"), other = raster("events/" + name + ".tif");
        for (std::size_t cell = 0; cell < one.values.size(); ++cell)
            ASSERT_TRUE(one.values[cell] == other.values[cell] ||
                        (std::isnan(one.values[cell]) && std::isnan(other.values[cell])))
                << name << ' ' << cell;
    }
    expect_objects_as_maps({"30", "100", "300"});
    const std::string report = read_text(path("out/report.html"));
    EXPECT_LT(report.find("30: Intensity"), report.find("100: Intensity"));
    EXPECT_LT(report.find("100: Intensity"), report.find("300: Intensity"));
    // The zones of the degree, and of each scenario's intensity.
    for (const std::string name : {"hazard_degree_zones", "scenario_intensity_300_zones"}) {
        const gis::PolygonLayer zones =
            gis::read_polygons(path("out/" + name + ".gpkg|layer=generalised"), "", "zones");
        EXPECT_FALSE(zones.features.empty()) << name;
        for (const Feature& zone : zones.features) EXPECT_GT(zone.numbers.at("cells_m2"), 0);
        for (const char* ending : {".shp", ".dbf", ".kmz", ".dxf"})
            EXPECT_TRUE(fs::exists(path("out/" + name + ending))) << name << ending;
    }
}

// A step of fragility costs the whole value of each object whose map is above it, scenario by scenario.
TEST_F(Region, DamageOfAScenarioIsThatOfItsMap) {
    write_slopes(three());
    write_houses();
    write("fragility.csv", "state,loss_ratio,quantity,unit,median,beta\nlost,0.5,depth,m,0.4,0\n");
    write("scene.ini",
          read_text(path("scene.ini")) + "exposure = houses.geojson\n[exposure]\nfragility = fragility.csv\n");
    write_region();
    succeeded(batch());
    const gis::Table table = gis::read_table(path("out/exposure.csv"), "exposure");
    const Json exposure = parse_json(read_text(path("out/summary.json")))["exposure"];
    for (const std::string scenario : {"often", "rare"}) {
        const Raster depth = raster("out/scenario_max_depth_" + scenario + ".tif");
        const std::string name = scenario + "_expected_damage";
        const auto column = std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin();
        double sum = 0;
        for (std::int64_t i = 0; i < k_columns; ++i) {
            const double expected = depth.at(15, i) > 0.4 ? 0.5 : 0;
            EXPECT_EQ(std::stod(table.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(column)]), expected);
            sum += expected;
        }
        EXPECT_GT(sum, 0);
        EXPECT_NEAR(exposure[name]["value"].get<double>(), sum, 1e-12);
    }
}

// The degree in each cell is the worst over the scenarios of the matrix with that scenario's intensity.
TEST_F(Region, DegreeOfHazardOverTheScenarios) {
    write_slopes(three());
    write("own.ini", own_scheme("depth > ", "0.3 m", "0.8 m"));
    write("scene.ini", read_text(path("scene.ini")) +
                           "exposure = houses.geojson\n[hazard]\nscheme = "
                           "own.ini\n");
    write_region("return-period = YEARS\n[set]\noutput.report = on\n");
    write_houses(true);
    succeeded(batch());
    expect_objects_as_maps({"often", "rare"});
    EXPECT_NE(read_text(path("out/report.html")).find("often: Intensity"), std::string::npos);
    // Each object names all scenarios that lead to its degree, the most frequent first.
    const int at_30[] = {0, 3, 4, 4}, at_300[] = {0, 2, 3, 4};  // none, weak, medium, strong; 2 yellow, 3 blue, 4 red
    const gis::Table objects = gis::read_table(path("out/exposure.csv"), "exposure");
    std::set<std::string> named;
    for (const auto& row : objects.rows) {
        const int leads[] = {at_30[std::stoi(cell_of(objects, row, "often_intensity"))],
                             at_300[std::stoi(cell_of(objects, row, "rare_intensity"))]},
                  worst = std::max(leads[0], leads[1]);
        std::string expected = leads[0] == worst && worst > 0 ? "often" : "";
        if (leads[1] == worst && worst > 0) expected += expected.empty() ? "rare" : ", rare";
        EXPECT_EQ(cell_of(objects, row, "degree_scenario"), expected);
        named.insert(expected);
    }
    EXPECT_TRUE(named.contains("often, rare")) << named.size();
    const Raster degree = raster("out/hazard_degree.tif"), often = raster("out/scenario_max_depth_often.tif"),
                 rare = raster("out/scenario_max_depth_rare.tif");
    const auto intensity = [](double depth) { return depth > 0.1F ? 1 + (depth > 0.3F) + (depth > 0.8F) : 0; };
    std::map<int, int> found;
    for (std::size_t cell = 0; cell < degree.values.size(); ++cell) {
        const int expected = std::max(at_30[intensity(often.values[cell])], at_300[intensity(rare.values[cell])]);
        const double value = degree.values[cell];
        ASSERT_EQ(std::isnan(value) ? 0 : static_cast<int>(value), expected) << cell;
        ++found[expected];
    }
    EXPECT_EQ(found.size(), 4U) << "not all degrees occur";
    EXPECT_TRUE(fs::exists(path("out/hazard_degree_zones.gpkg")));
    EXPECT_NE(read_text(path("out/hazard_degree.qml")).find("strong \u2264 300 a"), std::string::npos);
    EXPECT_TRUE(fs::exists(path("out/scenario_intensity_rare.tif")));
}

}  // namespace
}  // namespace frana::test
