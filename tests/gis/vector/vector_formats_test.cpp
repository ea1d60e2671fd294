// SPDX-License-Identifier: Apache-2.0
// Vector files of all common formats; layers, filters and CRSs specified by keys.
#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/vector/vector_in.h"
#include "gis/vector/vector_source.h"
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

struct VectorFile {
    const char* name;
    const char* driver;
    const char* file;
};
void PrintTo(const VectorFile& format, std::ostream* out) {
    *out << format.name;
}

class VectorFormat : public testing::TestWithParam<VectorFile> {};

TEST_P(VectorFormat, IsReadWhereItWasDrawn) {
    const Folder folder;
    const VectorFile& format = GetParam();
    // A square of a thousandth of a degree with heights; gdaltransform puts its southern corners at
    // 529424.272, 5094117.682 and 529501.704, 5094118.052.
    make_vector(folder.file(format.file), format.driver, "EPSG:4326",
                {"POLYGON Z((9.38 46.0 7,9.381 46.0 7,9.381 46.001 8,9.38 46.001 8,9.38 46.0 7))"});
    const PolygonLayer layer = read_polygons(folder.file(format.file), utm(), k_where);
    ASSERT_EQ(layer.features.size(), 1U);
    for (const Point corner : {Point{529424.272, 5094117.682}, Point{529501.704, 5094118.052}}) {
        double nearest = HUGE_VAL;
        for (const Point& p : layer.features[0].shape.areas[0].outer)
            nearest = std::min(nearest, std::hypot(p.x - corner.x, p.y - corner.y));
        EXPECT_LT(nearest, 0.01) << corner.x;
    }
    EXPECT_EQ(layer.features[0].numbers.at("thick"), 10);
    EXPECT_EQ(layer.features[0].texts.at("name"), "slope");
    EXPECT_NEAR(layer.own_bounds.west, 9.38, 1e-9);
}

/// Returns every file of a folder with its content.
std::map<std::string, std::string> contents(const Folder& folder) {
    std::map<std::string, std::string> all;
    for (const std::string& name : folder.names()) all[name] = test::text_in(folder.file(name));
    return all;
}

TEST_P(VectorFormat, NoFileIsCreatedBesideIt) {
    const Folder folder;
    const VectorFile& format = GetParam();
    make_vector(folder.file(format.file), format.driver, "EPSG:4326",
                {"POLYGON((9.38 46.0,9.381 46.0,9.381 46.001,9.38 46.001,9.38 46.0))"});
    // Without its schema, GDAL would write another beside the GML.
    std::filesystem::remove(folder.file("a.xsd"));
    const auto before = contents(folder);
    (void)read_polygons(folder.file(format.file), utm(), k_where);
    (void)read_polygons(folder.file(format.file), utm(), k_where, {"thick > 5", ""});
    EXPECT_EQ(contents(folder), before);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, VectorFormat,
    testing::Values(VectorFile{"shapefile", "ESRI Shapefile", "a.shp"}, VectorFile{"geopackage", "GPKG", "a.gpkg"},
                    VectorFile{"geojson", "GeoJSON", "a.geojson"}, VectorFile{"flatgeobuf", "FlatGeobuf", "a.fgb"},
                    VectorFile{"gml", "GML", "a.gml"}, VectorFile{"mapinfo", "MapInfo File", "a.tab"}),
    [](const auto& tested) { return tested.param.name; });

TEST(VectorFiles, KmlHasItsOwnColumns) {
    const Folder folder;
    make_vector(folder.file("a.kml"), "LIBKML", "EPSG:4326",
                {"POLYGON Z((9.38 46.0 7,9.381 46.0 7,9.381 46.001 8,9.38 46.001 8,9.38 46.0 7))"});
    const PolygonLayer layer = read_polygons(folder.file("a.kml"), utm(), k_where);
    EXPECT_NEAR(layer.bounds.south, 5094117.682, 0.01);
    EXPECT_EQ(layer.crs_label, "EPSG:4326 (WGS 84)");
}

TEST(VectorFiles, TextWithWktNeedsACrsKey) {
    const Folder folder;
    test::write_text(folder.file("a.csv"),
                     "id,WKT\n1,\"POLYGON((1529430 5094000,1529530 5094000,1529530 5094100,"
                     "1529430 5094100,1529430 5094000))\"\n");
    const Error error = error_of([&] { (void)read_polygons(folder.file("a.csv"), utm(), k_where); });
    EXPECT_NE(error.problems().front().remedy.find("perimeter-crs"), std::string::npos);
    const LayerChoice choice{"", crs_from_user("EPSG:3003", "")};
    const PolygonLayer layer = read_polygons(folder.file("a.csv"), utm(), k_where, choice);
    // The corner 1529430, 5094000 by gdaltransform, as for the shapefile of the other test.
    EXPECT_NEAR(layer.bounds.south, 5093978.921519, 0.2);
    EXPECT_NEAR(layer.bounds.west, 529401.483581, 0.2);
    EXPECT_EQ(layer.crs_label.substr(0, 9), "EPSG:3003");
}

TEST(VectorFiles, ACrsKeyOverridesTheFile) {
    const Folder folder;
    // Latitude and longitude swapped in the label, not in the file: coordinates in metres, .prj in degrees.
    make_vector(folder.file("a.shp"), "ESRI Shapefile", "EPSG:4326",
                {"POLYGON((529400 5094000,529400 5094100,529500 5094100,529500 5094000,529400 5094000))"});
    EXPECT_EQ(error_of([&] { (void)read_polygons(folder.file("a.shp"), utm(), k_where); }).kind(), ErrorKind::input);
    const PolygonLayer layer = read_polygons(folder.file("a.shp"), utm(), k_where, {"", utm()});
    EXPECT_EQ(total_area(layer), 10000);
    EXPECT_TRUE(layer.transform.operation == "none");
}

std::string geojson(const std::string& top, const std::string& within) {
    return "{\"type\": \"FeatureCollection\"" + top + ", \"features\": [{\"type\": \"Feature\"" + within +
           ", \"geometry\": {\"type\": \"Polygon\", \"coordinates\": [[[9.38, 46], [9.38, 46.001], [9.381, "
           "46.001], "
           "[9.381, 46], [9.38, 46]]]}}]}";
}

std::string named(const std::string& name) {
    return R"(, "crs": {"type": "name", "properties": {"name": ")" + name + "\"}}";
}

// GDAL takes each of these for degrees of WGS 84; a datum is up to hundreds of metres.
TEST(VectorFiles, ACrsThatIsNotUnderstoodIsRefused) {
    const Folder folder;
    const auto read = [&](const std::string& top, const std::string& within = R"(, "properties": {"a": 1})") {
        test::write_text(folder.file("a.geojson"), geojson(top, within));
        return read_polygons(folder.file("a.geojson"), utm(), k_where);
    };
    const auto refused = [&](const std::string& name, const std::string& top, const std::string& within = {}) {
        const Problem problem = error_of([&] { (void)read(top, within); }).problems().front();
        EXPECT_NE(problem.where.text.find("a.geojson"), std::string::npos) << problem.where.text;
        EXPECT_NE(problem.value.find(name), std::string::npos) << problem.what << problem.value;
        EXPECT_NE(problem.remedy.find("perimeter-crs = EPSG:"), std::string::npos) << problem.remedy;
        EXPECT_EQ(problem.remedy.find(".prj"), std::string::npos) << problem.remedy;
    };
    refused("urn:ogc:def:crs:EPSG::999999", named("urn:ogc:def:crs:EPSG::999999"));
    refused("NAD27 / nonsense", named("NAD27 / nonsense"));
    refused("EPSG:999999", R"(, "crs": {"type": "EPSG", "properties": {"code": 999999}})");
    refused("EPSG:32632", R"(, "crs": "EPSG:32632")");
    refused("swisstopo", R"(, "crs": {"type": "swisstopo", "properties": {"name": "EPSG:4326"}})");
    refused("", R"(, "crs": null)");
    for (const std::string& top : {std::string(), named("urn:ogc:def:crs:OGC:1.3:CRS84"), named("EPSG:4326")}) {
        EXPECT_EQ(read(top).crs_label.substr(0, 9), "EPSG:4326");
        EXPECT_EQ(read(top, R"(, "properties": {"crs": "of an attribute", "b": {"crs": 3}})").crs_label.substr(0, 9),
                  "EPSG:4326");
    }
    EXPECT_EQ(read(named("EPSG:4267")).crs_label.substr(0, 9), "EPSG:4267");
    // A CRS given by a key is used.
    test::write_text(folder.file("a.geojson"), geojson(named("NAD27 / nonsense"), ""));
    EXPECT_EQ(read_polygons(folder.file("a.geojson"), utm(), k_where, {"", crs_from_user("EPSG:4267", "")})
                  .crs_label.substr(0, 9),
              "EPSG:4267");
    // A line for each feature: OGR's driver for these reads no crs at all.
    test::write_text(
        folder.file("a.geojsonl"),
        R"({"type": "Feature")" + named("EPSG:4267") +
            R"(, "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[[9.38, 46], [9.38, 46.001],)"
            R"( [9.381, 46.001], [9.38, 46]]]}})"
            "\n"
            R"({"type": "Feature", "properties": {}, "geometry": null})"
            "\n");
    const Error of_line = error_of([&] { (void)read_polygons(folder.file("a.geojsonl"), utm(), k_where); });
    EXPECT_NE(of_line.problems().front().value.find("EPSG:4267"), std::string::npos);
}

TEST(VectorFiles, ALayerAndAFilterChoose) {
    const Folder folder;
    const std::string path = folder.file("two.gpkg");
    make_vector(path, "GPKG", "EPSG:32632", {"POLYGON((0 0,10 0,10 10,0 10,0 0))"}, "first");
    make_vector(path, "GPKG", "EPSG:32632",
                {"POLYGON((0 0,20 0,20 20,0 20,0 0))", "POLYGON((50 0,80 0,80 30,50 30,50 0))"}, "second");
    const std::string second = path + "|layer=second";
    EXPECT_EQ(total_area(read_polygons(second, utm(), k_where, {"", ""})), 1300);
    EXPECT_EQ(total_area(read_polygons(second, utm(), k_where, {"thick > 15", ""})), 900);
    EXPECT_EQ(total_area(read_polygons(second, utm(), k_where, {"name = 'slope' AND thick = 10", ""})), 400);
    const Error none = error_of([&] { (void)read_polygons(second, utm(), k_where, {"thick > 99", ""}); });
    EXPECT_TRUE(has_problem(none.problems(), second, "thick > 99"));
    EXPECT_NE(none.problems().front().remedy.find("thick, name"), std::string::npos);
    const Error wrong = error_of([&] { (void)read_polygons(second, utm(), k_where, {"depth > 1", ""}); });
    EXPECT_TRUE(has_problem(wrong.problems(), second, "depth > 1"));
    EXPECT_NE(wrong.problems().front().remedy, none.problems().front().remedy) << "it is not understood";
}

TEST(VectorFiles, ArchivesAreReadInPlace) {
    const Folder folder;
    make_vector(folder.file("a.geojson"), "GeoJSON", "EPSG:4326",
                {"POLYGON((9.38 46.0,9.381 46.0,9.381 46.001,9.38 46.001,9.38 46.0))"});
    const std::string bytes = test::text_in(folder.file("a.geojson"));
    const GdalSession session;
    VSILFILE* file = VSIFOpenL(("/vsizip/" + folder.file("a.zip") + "/a.geojson").c_str(), "wb");
    VSIFWriteL(bytes.data(), 1, bytes.size(), file);
    VSIFCloseL(file);
    const PolygonLayer layer = read_polygons("/vsizip/" + folder.file("a.zip") + "/a.geojson", utm(), k_where);
    EXPECT_NEAR(layer.bounds.south, 5094117.682, 0.01);
}

TEST(VectorFiles, ADatabaseInUseIsNotChanged) {
    // QGIS opens GeoPackages with a log beside them, which may contain the latest state.
    const Folder folder;
    const std::string path = folder.file("a.gpkg");
    make_vector(path, "GPKG", "EPSG:32632", {"POLYGON((0 0,10 0,10 10,0 10,0 0))"});
    const GdalSession session;
    const GDALDatasetUniquePtr in_use(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    const auto execute = [&](const char* statement) {
        in_use->ReleaseResultSet(in_use->ExecuteSQL(statement, nullptr, nullptr));
    };
    execute("PRAGMA journal_mode = WAL");
    execute("UPDATE shapes SET thick = 7");
    const auto names = folder.names();
    EXPECT_EQ(read_polygons(path, utm(), k_where).features[0].numbers.at("thick"), 7);
    EXPECT_EQ(folder.names(), names);
}

TEST(VectorFiles, NoFileIsCreatedBesideAnArchive) {
    const Folder folder;
    make_vector(folder.file("a.geojson"), "GeoJSON", "EPSG:32632", {"POLYGON((0 0,10 0,10 10,0 10,0 0))"});
    const std::string bytes = test::text_in(folder.file("a.geojson"));
    const std::string name = "/vsigzip/" + folder.file("a.geojson.gz");
    {
        const GdalSession session;
        VSILFILE* file = VSIFOpenL(name.c_str(), "wb");
        VSIFWriteL(bytes.data(), 1, bytes.size(), file);
        VSIFCloseL(file);
    }
    const auto names = folder.names();
    (void)read_polygons(name, utm(), k_where);
    EXPECT_EQ(folder.names(), names);
}

TEST(VectorFiles, HolesThatTouchTheOutlineAndMeasuresDoNotMatter) {
    const Folder folder;
    // A hole that touches the outline in a point is sound; M values are dropped like heights.
    make_vector(folder.file("a.gpkg"), "GPKG", "EPSG:32632",
                {"POLYGON ZM((0 0 1 1,10 0 1 2,10 10 1 3,0 10 1 4,0 0 1 5),(0 5 1 1,4 3 1 1,4 7 1 1,0 5 1 1))",
                 "MULTISURFACE(CURVEPOLYGON(COMPOUNDCURVE((100 0,110 0),CIRCULARSTRING(110 0,115 5,110 10),(110 10,"
                 "100 10,100 0))))"});
    const PolygonLayer layer = read_polygons(folder.file("a.gpkg"), utm(), k_where);
    ASSERT_EQ(layer.features.size(), 2U);
    EXPECT_EQ(area(layer.features[0].shape.areas), 100 - 8);
    // A square and a half disc of radius 5, its arc in pieces of 4 degrees: 0.1 % of the disc is missing.
    EXPECT_NEAR(area(layer.features[1].shape.areas), 100 + 39.27, 0.1);
}

TEST(VectorFiles, AnEdgeAroundTheWholeEarthIsRefused) {
    const Folder folder;
    // A square of 0.2 degrees at Taveuni, Fiji, not split at the antimeridian: as drawn it encloses the rest of the
    // Earth.
    make_vector(folder.file("long.gpkg"), "GPKG", "EPSG:4326",
                {"POLYGON((179.9 -16.5,-179.9 -16.5,-179.9 -16.4,179.9 -16.4,179.9 -16.5))"});
    const std::string fiji = crs_from_user("EPSG:32760", "");
    const Error error = error_of([&] { (void)read_polygons(folder.file("long.gpkg"), fiji, k_where); });
    EXPECT_TRUE(has_problem(error.problems(), "long.gpkg", "from 179.9, -16.5 to -179.9, -16.5"));
    // Split there, or with longitudes beyond 180, it is one area of 21.4 km by 11.1 km.
    make_vector(folder.file("split.gpkg"), "GPKG", "EPSG:4326",
                {"MULTIPOLYGON(((179.9 -16.5,180 -16.5,180 -16.4,179.9 -16.4,179.9 -16.5)),"
                 "((-180 -16.5,-179.9 -16.5,-179.9 -16.4,-180 -16.4,-180 -16.5)))"});
    make_vector(folder.file("beyond.gpkg"), "GPKG", "EPSG:4326",
                {"POLYGON((179.9 -16.5,180.1 -16.5,180.1 -16.4,179.9 -16.4,179.9 -16.5))"});
    const PolygonLayer split = read_polygons(folder.file("split.gpkg"), fiji, k_where);
    const PolygonLayer beyond = read_polygons(folder.file("beyond.gpkg"), fiji, k_where);
    // Edges follow the projection to a millimetre; over 65 km of outline that is at most 65 m2.
    EXPECT_NEAR(total_area(split), total_area(beyond), 65);
    EXPECT_NEAR(split.bounds.east, beyond.bounds.east, 0.01);
    // 0.2 degrees of the parallel and 0.1 of the meridian at 16.45 S on the ellipsoid; three degrees off the
    // central meridian UTM's scale is 0.9996 (1 + (0.05236 cos 16.45)^2 / 2) = 1.00086, squared for an area.
    EXPECT_NEAR(total_area(beyond) / (21358.2 * 11066.3), 1.00172, 2e-4);
}

}  // namespace
}  // namespace frana::gis
