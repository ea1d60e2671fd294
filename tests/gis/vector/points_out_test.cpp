// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_out.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "gis/crs/crs.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::error_of;
using test::Folder;

PointTable two_points() {
    PointTable table;
    table.places = {{527000.125, 5094000}, {527001, 5094002.5}};
    table.add("depth_m") = {2.5, std::nan("")};
    table.add("speed_ms") = {0.1, 30};
    return table;
}

TEST(WritePoints, AreReadBackAsWritten) {
    const Folder folder;
    write_points(folder.file("particles.gpkg"), crs_from_user("EPSG:32632", ""), "particles", two_points());
    EXPECT_EQ(folder.names(), std::vector<std::string>{"particles.gpkg"});
    GDALAllRegister();
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(folder.file("particles.gpkg").c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
    ASSERT_TRUE(dataset);
    OGRLayer* layer = dataset->GetLayerByName("particles");
    ASSERT_TRUE(layer);
    EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "32632");
    const PointTable wanted = two_points();
    std::size_t p = 0;
    for (const auto& row : *layer) {
        ASSERT_LT(p, wanted.places.size());
        EXPECT_EQ(row->GetGeometryRef()->toPoint()->getX(), wanted.places[p].x);
        EXPECT_EQ(row->GetGeometryRef()->toPoint()->getY(), wanted.places[p].y);
        EXPECT_EQ(row->GetFieldAsDouble("speed_ms"), wanted.columns[1].values[p]);
        EXPECT_EQ(row->IsFieldSetAndNotNull(row->GetFieldIndex("depth_m")), p == 0);
        ++p;
    }
    EXPECT_EQ(p, 2U);
}

TEST(WritePoints, AnEmptyTableIsAnEmptyLayer) {
    const Folder folder;
    PointTable table;
    table.add("depth_m");
    write_points(folder.file("particles.gpkg"), "", "particles", table);
    GDALAllRegister();
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(folder.file("particles.gpkg").c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
    ASSERT_TRUE(dataset);
    EXPECT_EQ(dataset->GetLayerByName("particles")->GetFeatureCount(), 0);
}

TEST(WritePoints, AFailureLeavesNothing) {
    const Folder folder;
    EXPECT_EQ(error_of([&] { write_points(folder.file("no/particles.gpkg"), "", "particles", two_points()); }).kind(),
              ErrorKind::environment);
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace frana::gis
