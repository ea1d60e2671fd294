// SPDX-License-Identifier: Apache-2.0
// What a flow does to buildings, roads and people.
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>

#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "core/geometry.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "study/tiny_study.h"

namespace frana::test {
namespace {

class Exposure : public Ensemble {
  protected:
    Exposure() { write_scene("stop-when-still = off\n" + k_numbers_only + k_keys); }

    /// In degrees, so that nothing fits the cells by chance; corners are offsets from the DTM's corner.
    void write_exposed() const {
        const gis::CrsTransform to_degrees(gis::crs_from_user("EPSG:32632", ""), gis::crs_from_user("EPSG:4326", ""));
        const auto place = [&](double x, double y) {
            const Point p = to_degrees({k_west + x, k_south + y});
            char text[100];
            std::snprintf(text, sizeof text, "[%.12f, %.12f]", p.x, p.y);
            return std::string(text);
        };
        const auto box = [&](double x, double y, double side) {
            return "[[" + place(x, y) + ", " + place(x + side, y) + ", " + place(x + side, y + side) + ", " +
                   place(x, y + side) + ", " + place(x, y) + "]]";
        };
        const auto feature = [](const std::string& name, const std::string& people, const std::string& geometry) {
            return R"({"type": "Feature", "properties": {"what": ")" + name + R"(", "people": )" + people +
                   R"(, "reached": "before"}, "geometry": )" + geometry + "}";
        };
        const auto shape = [](const std::string& type, const std::string& coordinates) {
            return R"({"type": ")" + type + R"(", "coordinates": )" + coordinates + "}";
        };
        write("exposed.geojson",
              R"({"type": "FeatureCollection", "features": [)" +
                  feature("house", "4", shape("Polygon", box(81, 71, 8))) + "," +
                  feature("barn", "0", shape("Polygon", box(280, 130, 8))) + "," +
                  feature("road", "10", shape("LineString", "[" + place(97.5, 5) + ", " + place(97.5, 145) + "]")) +
                  "," + feature("people", "7", shape("Point", place(92, 73))) + "," +
                  feature("rim", "1", shape("Polygon", box(-4, 71, 8))) + "," +
                  feature("elsewhere", "2", shape("Point", place(5000, 73))) + "," +
                  feature("drawn nowhere", "null", "null") + "]}");
    }
    [[nodiscard]] Rows rows(const std::string& result) const { return rows_of(path(result + "/exposure.csv")); }
    /// The greatest value of a raster in a rectangle, by offsets from the DTM's corner: of the cells that it overlaps.
    static double greatest(const Raster& raster, double west, double south, double east, double north) {
        double most = 0;
        for (std::int64_t row = 0; row < raster.grid.rows; ++row)
            for (std::int64_t column = 0; column < raster.grid.columns; ++column) {
                const Point c = raster.grid.cell_centre(row, column);
                const double x = c.x - k_west, y = c.y - k_south, half = k_cell / 2;
                if (x + half > west && x - half < east && y + half > south && y - half < north)
                    most = std::fmax(most, raster.at(row, column));
            }
        return most;
    }
    const std::string k_keys = "exposure = exposed.geojson\nexposure-name = what\nexposure-count = people\n";
};

TEST_F(Exposure, OfARunIsThatOfTheCellsTouched) {
    write_exposed();
    ran("out");
    const Rows all = rows("out");
    ASSERT_EQ(all.size(), 7U) << "a feature is lost";
    const Raster depth = gis::read_result_raster(path("out/max_depth.tif")),
                 speed = gis::read_result_raster(path("out/max_velocity.tif")),
                 pressure = gis::read_result_raster(path("out/max_pressure.tif"));
    const auto number = [&](std::size_t i, const std::string& key) { return std::stod(all[i].at(key)); };
    // The table has the run's double values, rasters are Float32.
    constexpr double k_float = 1e-6;
    const auto expect = [&](std::size_t i, const Raster& raster, const std::string& key, double west, double south,
                            double east, double north) {
        const double expected = greatest(raster, west, south, east, north);
        EXPECT_GT(expected, 0) << all[i].at("exposed");
        EXPECT_NEAR(number(i, key), expected, k_float * expected) << all[i].at("exposed") << ' ' << key;
    };
    expect(0, depth, "max_depth_m", 81, 71, 89, 79);
    expect(0, speed, "max_velocity_ms", 81, 71, 89, 79);
    expect(0, pressure, "max_pressure_kpa", 81, 71, 89, 79);
    expect(2, depth, "max_depth_m", 97, 5, 98, 145);
    expect(3, depth, "max_depth_m", 91.9, 72.9, 92.1, 73.1);
    EXPECT_GT(number(0, "arrival_s"), 0);
    EXPECT_EQ(all[1].at("max_depth_m"), "0") << "not reached";
    EXPECT_EQ(all[1].at("arrival_s"), "");
    EXPECT_EQ(all[1].at("reached"), "0");
    EXPECT_EQ(all[4].at("place"), "partly outside the map");
    for (const std::size_t i : {5U, 6U}) EXPECT_EQ(all[i].at("max_depth_m"), "") << i;
    EXPECT_EQ(all[5].at("place"), "outside the map");
    EXPECT_EQ(all[6].at("place"), "no geometry");
    EXPECT_EQ(all[0].at("input_reached"), "before") << "an attribute with the name of a figure";
    EXPECT_EQ(all[3].at("exposed"), "people");
    const std::string summary = read_text(path("out/summary.json"));
    EXPECT_EQ(json_number(summary, "exposure.features"), 7);
    EXPECT_EQ(json_number(summary, "exposure.reached"), 3);
    EXPECT_EQ(json_number(summary, "exposure.off_map"), 2);
    EXPECT_EQ(json_number(summary, "exposure.count_reached"), 21);
    const gis::PolygonLayer areas = gis::read_polygons(path("out/exposure.gpkg") + "|layer=exposure_areas", "", "test");
    ASSERT_EQ(areas.features.size(), 3U);
    EXPECT_NEAR(areas.features[0].numbers.at("max_depth_m"), number(0, "max_depth_m"), 0);
    EXPECT_NEAR(area(areas.features[0].shape.areas), 64, 0.1) << "in the working CRS";
    for (const std::string layer : {"exposure_lines", "exposure_points"})
        EXPECT_EQ(gis::filled_layers(path("out/exposure.gpkg"), "test").count(layer), 1U) << layer;
}

// Of two members, one reaches farther: the probability of a feature is that of its own, not of one of its cells.
TEST_F(Exposure, OfAnEnsembleHasProbabilities) {
    write_exposed();
    write_study("sampling = table:values.csv\nkeep = all\n", "");
    write("values.csv", "material.friction-angle,weight\n8,3\n26,1\n");
    succeeded(run());
    const Rows all = rows("out");
    ASSERT_EQ(all.size(), 7U);
    for (const std::size_t feature : {0U, 2U, 3U}) {
        double reached = 0, deep = 0, most = 0;
        for (int member = 0; member < 2; ++member) {
            const Raster depth =
                gis::read_result_raster(path("out/members/member_000000" + std::to_string(member) + "/max_depth.tif"));
            const double here = feature == 0   ? greatest(depth, 81, 71, 89, 79)
                                : feature == 2 ? greatest(depth, 97, 5, 98, 145)
                                               : greatest(depth, 91.9, 72.9, 92.1, 73.1);
            const double weight = member == 0 ? 0.75 : 0.25;
            reached += here > 0 ? weight : 0;
            deep += here > 0.5 ? weight : 0;
            most = std::max(most, here);
        }
        EXPECT_EQ(std::stod(all[feature].at("probability_reached")), reached) << feature;
        EXPECT_EQ(std::stod(all[feature].at("probability_depth_0.5")), deep) << feature;
        EXPECT_EQ(std::stod(all[feature].at("max_depth_m")), most) << feature;
    }
    EXPECT_EQ(all[1].at("probability_reached"), "0");
    EXPECT_EQ(all[5].at("probability_reached"), "");
}

// Two members of three: the slippery one comes to cells without elevation and fails, after it has hit the road. What
// failed has hit, and may have hit more.
TEST_F(Exposure, OfRunsThatFailedCountsAndIsABound) {
    write_exposed();
    write_dtm([](int, int column) { return column > 22 ? -9999 : 300 - 0.5 * (column + 0.5) * k_cell; });
    write_study("sampling = table:values.csv\n", "[set]\ntime.end = 40\n");
    write("values.csv", "material.friction-angle\n2\n26\n26.5\n");
    const Outcome outcome = run();
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;  // more than 5 % failed
    const auto road = rows("out")[2];
    EXPECT_EQ(road.at("reached"), "1");
    EXPECT_GT(std::stod(road.at("max_depth_m")), 0);
    const double p = std::stod(road.at("probability_reached"));  // of the two that finished
    EXPECT_NEAR(std::stod(road.at("probability_reached_upper")), (1 + 2 * p) / 3, 1e-12);
    EXPECT_TRUE(json_value(read_text(path("out/summary.json")), "exposure.lower_bound").get<bool>());
}

// A building far outside does not make the flow a dot on the map.
TEST_F(Exposure, FarFeaturesDoNotSetTheMapsScale) {
    write_exposed();
    write(
        "far.geojson",
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"what": "far", "people": 1}, "geometry": )"
        R"({"type": "Polygon", "coordinates": [[[11, 46.5], [11.001, 46.5], [11.001, 46.501], [11, 46.5]]]}}]})");
    const auto width = [&](const std::string& exposed) {
        succeeded(frana({"run", "scene.ini", "--out", "out", "--quiet", "--overwrite", "--set",
                         "output.exposure=" + exposed + ".geojson", "--set", "output.maps=max_depth", "--set",
                         "output.map-formats=pdf"}));
        double place[6] = {};
        const GDALDatasetUniquePtr map(GDALDataset::Open(path("out/maps/max_depth.pdf").c_str(), GDAL_OF_RASTER));
        EXPECT_TRUE(map && map->GetGeoTransform(place) == CE_None);
        return place[1];
    };
    EXPECT_EQ(width("far"), width("exposed"));
}

// What a mayor asks first: how many are reached, in the log, in the report and on the map.
TEST_F(Exposure, IsAnsweredInTheLanguageOfTheScene) {
    write_exposed();
    const std::vector<std::string> report{"--quiet",          "--set", "output.maps=max_depth", "--set",
                                          "output.report=on", "--set", "output.language=de"};
    succeeded(frana(with_more({"run", "scene.ini", "--out", "out"}, report)));
    EXPECT_NE(read_text(path("out/log.txt")).find("Exposed features reached: ≥ 3 of 7; Count: ≥ 21 of 25"),
              std::string::npos);
    const std::string page = read_text(path("out/report.html"));
    const std::size_t answer = page.find("Erreichte exponierte Objekte: ≥ 3 von 7; Anzahl: ≥ 21 von 25");
    ASSERT_NE(answer, std::string::npos);
    EXPECT_LT(answer, page.find("<h2 id=\"maps\"")) << "the answer comes first";
    const std::string section = page.substr(page.find("<h2 id=\"exposure\""));
    const std::string table = section.substr(0, section.find("</table>"));
    for (const std::string reached : {"house", "road", "people"})
        EXPECT_NE(table.find("<td>" + reached + "</td>"), std::string::npos) << reached;
    for (const std::string other : {"barn", "rim", "elsewhere"})
        EXPECT_EQ(table.find("<td>" + other + "</td>"), std::string::npos) << other;
}

TEST(ExposureLayers, TellReachedFromNotReached) {
    int layers = 0;
    for (const app::VectorLayer& row : app::vector_layers()) {
        if (row.file != app::k_exposure_file) continue;
        ++layers;
        const gis::StyleText style = row.style(Words(Language::german));
        for (const std::string& text : {style.qml, style.sld})
            expect_words(text, {"Exponiert, erreicht", "Exponiert, nicht erreicht", "Exponiert, unbekannt"});
        EXPECT_NE(style.qml.find("attr=\"reached\""), std::string::npos) << row.name;
    }
    EXPECT_EQ(layers, 3);
}

TEST_F(Exposure, CheckCountsFeaturesAndWarnsOfThoseOffTheMap) {
    write_exposed();
    const Outcome outcome = succeeded(frana({"check", "scene.ini"}));
    EXPECT_NE(outcome.out.find("features: 7"), std::string::npos) << outcome.out;
    expect_words(outcome.err, {"2 of 7 exposed features not on mapped ground", "elsewhere"});
}

}  // namespace
}  // namespace frana::test
