// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_in.h"

#include <gtest/gtest.h>

#include "gis/crs/crs.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::gis {
namespace {

using test::error_of;
using test::Folder;
using test::make_vector;
using test::write_text;

TEST(ReadMarks, PointsAndLinesWithTheirNames) {
    const Folder folder;
    make_vector(folder.file("a.gpkg"), "GPKG", "EPSG:32632",
                {"POINT (527000 5095000)", "POINT Z (527010 5095000 400)"});
    const Marks points = read_marks(folder.file("a.gpkg"), crs_from_user("EPSG:32632", ""), "output.gauges");
    ASSERT_EQ(points.points.size(), 2U);
    EXPECT_EQ(points.points[1].place.x, 527010);
    EXPECT_EQ(points.points[0].name, "slope");
    EXPECT_EQ(points.crs_label, "EPSG:32632 (WGS 84 / UTM zone 32N)");
    make_vector(folder.file("b.gpkg"), "GPKG", "EPSG:32632", {"LINESTRING (0 0, 3 4)"});
    const Marks lines = read_marks(folder.file("b.gpkg"), crs_from_user("EPSG:32632", ""), "k");
    ASSERT_EQ(lines.lines.size(), 1U);
    EXPECT_EQ(lines.lines[0].line.size(), 2U);
    make_vector(folder.file("c.gpkg"), "GPKG", "EPSG:32632", {"POLYGON ((0 0, 1 0, 1 1, 0 0))"});
    EXPECT_EQ(read_marks(folder.file("c.gpkg"), "", "k").polygons, 1);
}

TEST(ReadMarks, PlacesAreInTheTargetCrs) {
    // Monte Mario: 1500000 5000000 in EPSG:3003 is 499970.7 4999981 or so in UTM 32; the exact values depend
    // on the operation. Degrees do not: 9 E 45 N is 500000 4982950.400 in EPSG:32632 (on the central
    // meridian; the arc length of the ellipsoid times 0.9996).
    const Folder folder;
    write_text(folder.file("g.geojson"),
               R"({"type": "Feature", "properties": {"name": "bridge"}, "geometry": {"type": "Point",)"
               R"( "coordinates": [9, 45]}})");
    const Marks marks = read_marks(folder.file("g.geojson"), crs_from_user("EPSG:32632", ""), "k");
    ASSERT_EQ(marks.points.size(), 1U);
    EXPECT_EQ(marks.points[0].name, "bridge");
    EXPECT_NEAR(marks.points[0].place.x, 500000, 1e-3);
    EXPECT_NEAR(marks.points[0].place.y, 4982950.400, 1e-3);
}

TEST(ReadMarks, RefusesUnusableFiles) {
    const Folder folder;
    const auto refused = [&](const std::string& name, const std::string& crs = "") {
        const Error error = error_of([&] { read_marks(folder.file(name), crs, "output.gauges"); });
        EXPECT_TRUE(has_problem(error.problems(), "output.gauges: " + folder.file(name)));
        return error.problems().front().remedy;
    };
    write_text(folder.file("text.shp"), "no vector");
    EXPECT_NE(refused("none.shp"), refused("text.shp")) << "a file that does not exist needs another remedy";
    make_vector(folder.file("a.shp"), "ESRI Shapefile", "", {"POINT (1 2)"});
    EXPECT_NE(refused("a.shp", crs_from_user("EPSG:32632", "")).find(".prj"), std::string::npos);
    EXPECT_EQ(read_marks(folder.file("a.shp"), "", "k").points[0].place.y, 2);
}

}  // namespace
}  // namespace frana::gis
