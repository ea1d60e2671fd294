// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_out.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/vector/vector_in.h"
#include "gis/vector/vector_style.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::gis {
namespace {

using test::error_of;
using test::Folder;

ShapeLayer release() {
    Feature feature;
    feature.shape.areas = {{{{527000, 5094000}, {527100, 5094000}, {527100, 5094100}, {527000, 5094100}},
                            {{{527020, 5094020}, {527040, 5094020}, {527040, 5094040}, {527020, 5094040}}}},
                           {{{527200, 5094000}, {527210, 5094000}, {527210, 5094010}}, {}}};
    feature.numbers["thickness_m"] = 2.5;
    feature.numbers["fid"] = 3;  // a name that GeoPackage reserves
    feature.texts["name"] = "upper part";
    return {"release", {feature}};
}

TEST(WriteOutlines, AreReadBackAsWritten) {
    const Folder folder;
    const std::string crs = crs_from_user("EPSG:32632", "");
    write_shapes(folder.file("extent.gpkg"), crs, {release(), {"trace", {}}});
    EXPECT_EQ(folder.names(), std::vector<std::string>{"extent.gpkg"});
    const PolygonLayer back = read_polygons(folder.file("extent.gpkg") + "|layer=release", crs, "");
    ASSERT_EQ(back.features.size(), 1U);
    EXPECT_EQ(back.features[0].shape.areas.size(), 2U);
    EXPECT_EQ(back.features[0].shape.areas[0].holes.size(), 1U);
    EXPECT_EQ(area(back.features[0].shape.areas), 10000 - 400 + 50);
    EXPECT_EQ(back.features[0].numbers.at("area_m2"), 9650);
    EXPECT_EQ(back.features[0].numbers.at("thickness_m"), 2.5);
    EXPECT_EQ(back.features[0].texts.at("name"), "upper part");
    EXPECT_EQ(back.crs_label, "EPSG:32632 (WGS 84 / UTM zone 32N)");
    EXPECT_EQ(error_of([&] { (void)read_polygons(folder.file("extent.gpkg") + "|layer=trace", crs, ""); }).kind(),
              ErrorKind::input)
        << "the empty layer is there, and empty";
}

// The table from which QGIS takes a layer's style without being asked.
TEST(WriteOutlines, EveryLayerHasAStyleThatIsItsDefault) {
    const Folder folder;
    const std::string file = folder.file("extent.gpkg");
    ShapeLayer named = release();
    named.style = titled(style_of("release", Shape::area, {{1, 2, 3}, 0.7, true, "name"}), "Anriss & Hang",
                         {{"volume_m3", "Volumen [m³]"}});
    write_shapes(file, "", {named, {"trace", {}}});
    const GdalSession session;
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(dataset);
    OGRLayer* const table = dataset->GetLayerByName("layer_styles");
    ASSERT_TRUE(table);
    ASSERT_EQ(table->GetFeatureCount(), 2);
    std::map<std::string, std::string> styles;
    for (const auto& row : *table) {
        EXPECT_EQ(row->GetFieldAsInteger("useAsDefault"), 1);
        EXPECT_EQ(row->GetFieldAsString("f_geometry_column"), std::string("geom"));
        EXPECT_NE(std::string(row->GetFieldAsString("styleSLD")).find("<Stroke>"), std::string::npos);
        styles[row->GetFieldAsString("f_table_name")] = row->GetFieldAsString("styleQML");
    }
    EXPECT_EQ(styles["release"], named.style.qml);
    EXPECT_NE(styles["release"].find("<alias field=\"volume_m3\" name=\"Volumen [m³]\"/>"), std::string::npos);
    EXPECT_NE(named.style.sld.find("<Title>Anriss &amp; Hang</Title>"), std::string::npos) << named.style.sld;
    for (const auto& [layer, qml] : styles)
        EXPECT_NE(qml.find("<prop k=\"style\" v=\"no\"/>"), std::string::npos) << layer << " is filled";
    const Error error = error_of([&] { (void)read_polygons(file + "|layer=other", "", ""); });
    EXPECT_TRUE(has_problem(error.problems(), "|layer=other", "other"));
    EXPECT_EQ(error.problems().front().remedy.find("layer_styles"), std::string::npos) << "it is no layer to choose";
}

TEST(WriteOutlines, LocalCoordinatesHaveNoCrs) {
    const Folder folder;
    write_shapes(folder.file("extent.gpkg"), "", {release()});
    EXPECT_EQ(read_polygons(folder.file("extent.gpkg"), "", "").crs_label, "none");
}

TEST(WriteOutlines, AFailureLeavesTheOldFile) {
    const Folder folder;
    test::write_text(folder.file("extent.gpkg"), "old");
    EXPECT_EQ(error_of([&] { write_shapes(folder.file("no/extent.gpkg"), "", {release()}); }).kind(),
              ErrorKind::environment);
    ShapeLayer unnamed = release();
    unnamed.name = "release";
    const Error error = error_of([&] {
        write_shapes(folder.file("extent.gpkg"), "", {release(), unnamed});
    });  // the name twice
    EXPECT_EQ(error.kind(), ErrorKind::environment);
    EXPECT_EQ(test::text_in(folder.file("extent.gpkg")), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"extent.gpkg"});
}

}  // namespace
}  // namespace frana::gis
