// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_in.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "gis/crs/crs.h"
#include "perimeter_layer.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::gis {
namespace {

using test::error_of;
using test::Folder;
using test::k_where;
using test::make_vector;
using test::total_area;
using test::utm;

TEST(ReadPolygons, KeepsHolesPartsAndAttributes) {
    const Folder folder;
    const std::string path = folder.file("a.gpkg");
    make_vector(path, "GPKG", "EPSG:32632",
                {"POLYGON((0 0,100 0,100 100,0 100,0 0),(20 20,40 20,40 40,20 40,20 20))",
                 "MULTIPOLYGON(((200 0,210 0,210 10,200 10,200 0)),((300 0,320 0,320 10,300 10,300 0)))"});
    const PolygonLayer layer = read_polygons(path, utm(), k_where);
    ASSERT_EQ(layer.features.size(), 2U);
    EXPECT_EQ(layer.features[0].shape.areas[0].holes.size(), 1U);
    EXPECT_EQ(layer.features[1].shape.areas.size(), 2U);
    EXPECT_EQ(layer.features[1].numbers.at("thick"), 20);
    EXPECT_EQ(layer.features[1].texts.at("name"), "slope");
    EXPECT_EQ(total_area(layer), 10000 - 400 + 100 + 200);
    EXPECT_EQ(layer.bounds.east, 320);
    EXPECT_EQ(layer.layer_name, "shapes");
    EXPECT_EQ(layer.crs_label, "EPSG:32632 (WGS 84 / UTM zone 32N)");
    EXPECT_TRUE(layer.warnings.empty());
    EXPECT_EQ(layer.features[0].shape.areas[0].outer.size(), 4U) << "the closing point is not repeated";
}

TEST(ReadPolygons, ShiftsTheDatum) {
    const Folder folder;
    make_vector(folder.file("scar.shp"), "ESRI Shapefile", "EPSG:3003",
                {"POLYGON((1529430 5094000,1529530 5094000,1529530 5094100,1529430 5094100,1529430 5094000))"});
    const PolygonLayer layer = read_polygons(folder.file("scar.shp"), utm(), k_where);
    bool found = false;
    for (const Point& point : layer.features[0].shape.areas[0].outer) {
        found = found || std::hypot(point.x - 529401.483581, point.y - 5093978.921519) < 0.01;
    }
    EXPECT_TRUE(found) << "the corner does not lie where gdaltransform puts it";
    EXPECT_EQ(layer.transform.accuracy_m, 4);
}

TEST(ReadPolygons, LongEdgesAreCurvedByTheProjection) {
    const Folder folder;
    // The southern edge follows a parallel for a degree, which UTM curves: its middle is 121 m south of its ends.
    make_vector(folder.file("a.gpkg"), "GPKG", "EPSG:4326", {"POLYGON((8.5 46,9.5 46,9.5 46.1,8.5 46.1,8.5 46))"});
    const PolygonLayer layer = read_polygons(folder.file("a.gpkg"), utm(), k_where);
    EXPECT_NEAR(layer.bounds.south, 5094047.492, 0.001);  // 9 E 46 N by gdaltransform
    // Along the curve no vertex may deviate by more than a millimetre; that needs some hundred of them.
    EXPECT_GT(layer.features[0].shape.areas[0].outer.size(), 100U);
    // The ellipsoid's 860.24 km2 (77 393 m by 11 115.2 m at 46.05 N) times UTM's scale squared (0.9996, and
    // 6e-6 more on the average of half a degree either side), to the 1e-4 of these round values.
    EXPECT_NEAR(total_area(layer) / (77393.0 * 11115.2), 0.9996 * 0.9996 + 1.2e-5, 1e-4);
}

TEST(ReadPolygons, ReadsClosedLinesAndCollections) {
    const Folder folder;
    make_vector(folder.file("line.gpkg"), "GPKG", "EPSG:32632", {"LINESTRING(0 0,10 0,10 10,0 10,0 0)"});
    const PolygonLayer line = read_polygons(folder.file("line.gpkg"), utm(), k_where);
    EXPECT_EQ(total_area(line), 100);
    EXPECT_EQ(line.warnings.size(), 1U);
    make_vector(folder.file("mixed.gpkg"), "GPKG", "EPSG:32632",
                {"GEOMETRYCOLLECTION(POINT(1 1),POLYGON Z((0 0 5,10 0 5,10 10 5,0 10 5,0 0 5)))"});
    EXPECT_EQ(total_area(read_polygons(folder.file("mixed.gpkg"), utm(), k_where)), 100);
    make_vector(folder.file("curve.gpkg"), "GPKG", "EPSG:32632",
                {"CURVEPOLYGON(CIRCULARSTRING(10 0,0 10,-10 0,0 -10,10 0))"});
    // Straight segments of 4 degrees leave 0.2 percent of a circle out.
    EXPECT_NEAR(total_area(read_polygons(folder.file("curve.gpkg"), utm(), k_where)), 314.159, 0.7);
}

TEST(ReadPolygons, RefusesACrossingNamingThePlace) {
    const Folder folder;
    make_vector(folder.file("bow.gpkg"), "GPKG", "EPSG:32632",
                {"POLYGON((0 0,10 0,10 10,0 10,0 0))", "POLYGON((100 100,110 110,110 100,100 110,100 100))",
                 "POLYGON((200 200,220 220,220 200,200 220,200 200))"});
    const Error error = error_of([&] { (void)read_polygons(folder.file("bow.gpkg"), utm(), k_where); });
    EXPECT_EQ(error.kind(), ErrorKind::input);
    ASSERT_EQ(error.problems().size(), 2U) << "every feature's problem is reported";
    EXPECT_NE(error.problems()[0].what.find("feature 2"), std::string::npos);
    EXPECT_EQ(error.problems()[0].value, "at 105, 105");
    EXPECT_EQ(error.problems()[1].value, "at 210, 210");
    EXPECT_EQ(error.problems()[0].where.text.rfind(k_where, 0), 0U);
}

TEST(ReadPolygons, ListsTenProblemsAndCountsTheRest) {
    const Folder folder;
    const std::vector<std::string> bow_ties(13, "POLYGON((0 0,10 10,10 0,0 10,0 0))");
    make_vector(folder.file("many.gpkg"), "GPKG", "EPSG:32632", bow_ties);
    const Error error = error_of([&] { (void)read_polygons(folder.file("many.gpkg"), utm(), k_where); });
    ASSERT_EQ(error.problems().size(), 11U);
    EXPECT_EQ(error.problems().back().what.substr(0, 2), "3 ");
}

TEST(ReadPolygons, RepairsOutlinesThatOnlyTouchThemselves) {
    const Folder folder;
    // A ring that touches itself in a point: two squares corner to corner in one ring.
    make_vector(folder.file("pinch.gpkg"), "GPKG", "EPSG:32632",
                {"POLYGON((0 0,10 0,10 10,20 10,20 20,10 20,10 10,0 10,0 0))"});
    const PolygonLayer layer = read_polygons(folder.file("pinch.gpkg"), utm(), k_where);
    EXPECT_EQ(total_area(layer), 200);
    ASSERT_EQ(layer.warnings.size(), 1U);
    EXPECT_NE(layer.warnings[0].text().find("repaired"), std::string::npos);
}

// Before, 1200 m2 of the outline less its hole became 2000 m2 of both together.
TEST(ReadPolygons, RefusesAHoleOutsideItsOutline) {
    const Folder folder;
    make_vector(folder.file("hole.gpkg"), "GPKG", "EPSG:32632",
                {"POLYGON((0 0,40 0,40 40,0 40,0 0),(100 0,120 0,120 20,100 20,100 0))", "POLYGON((0 0,9 0,9 9,0 0))"});
    const Error error = error_of([&] { (void)read_polygons(folder.file("hole.gpkg"), utm(), k_where); });
    ASSERT_EQ(error.problems().size(), 1U);
    EXPECT_TRUE(has_problem(error.problems(), "hole.gpkg", "at 100, 0"));
    LayerChoice all;
    all.keep_unusable = true;
    const PolygonLayer layer = read_polygons(folder.file("hole.gpkg"), utm(), k_where, all);
    EXPECT_TRUE(layer.features[0].shape.areas.empty());
    EXPECT_NE(layer.unusable[0].find("hole"), std::string::npos) << layer.unusable[0];
}

TEST(ReadPolygons, OverlappingPartsCountOnce) {
    const Folder folder;
    make_vector(folder.file("overlap.gpkg"), "GPKG", "EPSG:32632",
                {"MULTIPOLYGON(((0 0,10 0,10 10,0 10,0 0)),((5 0,15 0,15 10,5 10,5 0)))"});
    const PolygonLayer layer = read_polygons(folder.file("overlap.gpkg"), utm(), k_where);
    EXPECT_EQ(total_area(layer), 150);
    EXPECT_EQ(layer.warnings.size(), 1U);
}

TEST(ReadPolygons, NoCrsIsRefusedUnlessLocal) {
    const Folder folder;
    make_vector(folder.file("a.shp"), "ESRI Shapefile", "", {"POLYGON((0 0,0 10,10 10,10 0,0 0))"});
    ASSERT_FALSE(std::filesystem::exists(folder.file("a.prj")));
    const Error error = error_of([&] { (void)read_polygons(folder.file("a.shp"), utm(), k_where); });
    EXPECT_NE(error.problems().front().remedy.find(".prj"), std::string::npos);
    EXPECT_EQ(total_area(read_polygons(folder.file("a.shp"), "", k_where)), 100);
}

TEST(ReadPolygons, MetresLabelledAsDegreesAreRefused) {
    const Folder folder;
    make_vector(folder.file("a.gpkg"), "GPKG", "EPSG:4326",
                {"POLYGON((529000 5094000,529100 5094000,529100 5094100,529000 5094000))"});
    const Error error = error_of([&] { (void)read_polygons(folder.file("a.gpkg"), utm(), k_where); });
    EXPECT_TRUE(has_problem(error.problems(), "a.gpkg", "529000, 5094000"));
}

TEST(ReadPolygons, RefusesLayersWithoutArea) {
    const Folder folder;
    make_vector(folder.file("open.gpkg"), "GPKG", "EPSG:32632", {"LINESTRING(0 0,10 0,10 10,3 4)"});
    make_vector(folder.file("empty.gpkg"), "GPKG", "EPSG:32632", {});
    make_vector(folder.file("point.geojson"), "GeoJSON", "EPSG:4326", {"POINT(9 46)"});
    make_vector(folder.file("flat.gpkg"), "GPKG", "EPSG:32632", {"POLYGON((0 0,10 10,20 20,0 0))"});
    test::write_text(folder.file("note.txt"), "not a vector");
    const auto refused = [&](const char* name, const std::string& value = "") {
        const Error error = error_of([&] { (void)read_polygons(folder.file(name), utm(), k_where); });
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_TRUE(has_problem(error.problems(), folder.file(name), value));
        return error.problems().front().remedy;
    };
    refused("open.gpkg", "a gap of 5 CRS units");
    refused("empty.gpkg", "shapes");  // the layer
    refused("point.geojson");
    refused("flat.gpkg");
    EXPECT_NE(refused("note.txt"), refused("missing.shp")) << "a file that does not exist needs another remedy";
}

TEST(ReadPolygons, ALayerIsNamedOrTheOnlyOne) {
    const Folder folder;
    const std::string path = folder.file("two.gpkg");
    make_vector(path, "GPKG", "EPSG:32632", {"POLYGON((0 0,10 0,10 10,0 10,0 0))"}, "first");
    make_vector(path, "GPKG", "EPSG:32632", {"POLYGON((0 0,20 0,20 20,0 20,0 0))"}, "second");
    EXPECT_EQ(total_area(read_polygons(path + "|layer=second", utm(), k_where)), 400);
    const Error several = error_of([&] { (void)read_polygons(path, utm(), k_where); });
    EXPECT_TRUE(has_problem(several.problems(), path, "first, second"));
    const Error unknown = error_of([&] { (void)read_polygons(path + "|layer=third", utm(), k_where); });
    EXPECT_TRUE(has_problem(unknown.problems(), path + "|layer=third", "third"));
    EXPECT_NE(unknown.problems().front().remedy.find("first, second"), std::string::npos);
}

}  // namespace
}  // namespace frana::gis
