// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_in.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "core/error.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::gis {
namespace {

/// Two particles as in a result's frame.
void write_particles(const std::string& path) {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    ASSERT_NE(driver, nullptr);
    const GDALDatasetUniquePtr dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    ASSERT_NE(dataset, nullptr);
    OGRSpatialReference crs;
    crs.importFromEPSG(32632);
    OGRLayer* layer = dataset->CreateLayer("particles", &crs, wkbPoint);
    for (const char* name : {"depth_m", "speed_ms"}) {
        OGRFieldDefn field(name, OFTReal);
        layer->CreateField(&field);
    }
    for (const double k : {1.0, 2.0}) {
        const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
        OGRPoint point(527000 + k, 5094000 + k);
        feature->SetGeometry(&point);
        feature->SetField("depth_m", k / 2);
        feature->SetField("speed_ms", 10 * k);
        ASSERT_EQ(layer->CreateFeature(feature.get()), OGRERR_NONE);
    }
}

TEST(ValuedPoints, PlacesAndNumbersAreReadInTheRequestedOrder) {
    const test::Folder folder;
    write_particles(folder.file("a.gpkg"));
    const ValuedPoints points = read_valued_points(folder.file("a.gpkg"), {"speed_ms", "depth_m"}, "particles");
    ASSERT_EQ(points.places.size(), 2U);
    EXPECT_EQ(points.places[1].x, 527002);
    EXPECT_EQ(points.places[1].y, 5094002);
    ASSERT_EQ(points.columns.size(), 2U);
    EXPECT_EQ(points.columns[0][1], 20);
    EXPECT_EQ(points.columns[1][0], 0.5);
}

TEST(ValuedPoints, MissingAttributesAndFilesAreNamed) {
    const test::Folder folder;
    write_particles(folder.file("a.gpkg"));
    const Error error = test::error_of([&] { read_valued_points(folder.file("a.gpkg"), {"volume_m3"}, "particles"); });
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_TRUE(has_problem(error.problems(), "a.gpkg", "volume_m3"));
    EXPECT_THROW(read_valued_points(folder.file("b.gpkg"), {"depth_m"}, "particles"), Error);
}

}  // namespace
}  // namespace frana::gis
