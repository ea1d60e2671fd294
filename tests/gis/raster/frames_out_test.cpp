// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/frames_out.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::Folder;

std::string text_of(const GDALIHasAttribute& holder, const std::string& name) {
    const auto attribute = holder.GetAttribute(name);
    const char* text = attribute ? attribute->ReadAsString() : nullptr;
    return text ? text : "(none)";
}

/// Two frames of 5 x 3 cells, one cell without flow.
class Stack : public ::testing::TestWithParam<StackFormat> {
  protected:
    Stack() {
        GridSpec grid{527000, 5095000, 2, 5, 3, crs_from_user("EPSG:32632", "")};
        path_ = folder_.file(GetParam() == StackFormat::netcdf ? "frames.nc" : "frames.zarr");
        FrameStack stack(path_, GetParam(), grid, {0, 2.5}, {{"PROGRAM", "frana"}});
        for (std::size_t frame = 0; frame < 2; ++frame) {
            Raster depth(grid), velocity(grid);
            for (std::size_t i = 0; i < depth.values.size(); ++i) {
                depth.values[i] = 100.0 * static_cast<double>(frame) + static_cast<double>(i);
                velocity.values[i] = -depth.values[i];
            }
            depth.values[7] = k_no_data;
            stack.add(frame, depth, velocity);
        }
        stack.close();
    }
    Folder folder_;
    std::string path_;
};

TEST_P(Stack, HasCfCoordinatesUnitsAndCrs) {
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path_.c_str(), GDAL_OF_MULTIDIM_RASTER));
    ASSERT_TRUE(file) << session.last_message();
    const auto root = file->GetRootGroup();
    EXPECT_EQ(text_of(*root, "Conventions"), "CF-1.8");
    EXPECT_EQ(text_of(*root, "PROGRAM"), "frana");
    EXPECT_EQ(root->OpenMDArray("time")->GetUnit(), "seconds since 2000-01-01 00:00:00");
    const auto depth = root->OpenMDArray("depth");
    ASSERT_TRUE(depth);
    ASSERT_EQ(depth->GetDimensionCount(), 3U);
    EXPECT_EQ(depth->GetDimensions()[0]->GetName(), "time");
    EXPECT_EQ(depth->GetUnit(), "m");
    EXPECT_EQ(root->OpenMDArray("velocity")->GetUnit(), "m s-1");
    const auto crs = depth->GetSpatialRef();
    ASSERT_TRUE(crs);
    OGRSpatialReference utm;
    utm.importFromEPSG(32632);
    EXPECT_TRUE(crs->IsSame(
        &utm, std::array<const char*, 3>{"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT", nullptr}
                  .data()));
    EXPECT_TRUE(root->OpenMDArray(text_of(*depth, "grid_mapping"))) << "the variable that the attribute names";
    const auto read = [&](const char* name, std::size_t count) {
        std::vector<double> values(count);
        const GUInt64 start = 0;
        const auto array = root->OpenMDArray(name);
        EXPECT_TRUE(
            array->Read(&start, &count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data()));
        return values;
    };
    EXPECT_EQ(read("time", 2), (std::vector<double>{0, 2.5}));
    EXPECT_EQ(read("x", 5), (std::vector<double>{527001, 527003, 527005, 527007, 527009}));
    EXPECT_EQ(read("y", 3), (std::vector<double>{5094999, 5094997, 5094995}));
    if (GetParam() == StackFormat::netcdf) {
        EXPECT_EQ(text_of(*root->OpenMDArray("x"), "standard_name"), "projection_x_coordinate");
    } else {
        // GDAL hides this attribute when it reads; other readers do not.
        const auto attributes = nlohmann::json::parse(test::text_in(path_ + "/x/.zattrs"));
        EXPECT_EQ(attributes["standard_name"], "projection_x_coordinate");
    }
    if (GetParam() == StackFormat::netcdf) {
        EXPECT_EQ(text_of(*root->OpenMDArray("time"), "axis"), "T");
    }
}

TEST_P(Stack, ContainsEveryFrameWithNodataWhereThereIsNoFlow) {
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path_.c_str(), GDAL_OF_MULTIDIM_RASTER));
    ASSERT_TRUE(file);
    for (const std::string name : {"depth", "velocity"}) {
        const auto array = file->GetRootGroup()->OpenMDArray(name);
        bool has_nodata = false;
        EXPECT_EQ(array->GetNoDataValueAsDouble(&has_nodata), -9999);
        EXPECT_TRUE(has_nodata);
        std::vector<float> values(15);
        const GUInt64 start[3] = {1, 0, 0};
        const size_t count[3] = {1, 3, 5};
        ASSERT_TRUE(
            array->Read(start, count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float32), values.data()));
        for (std::size_t i = 0; i < 15; ++i) {
            const float expected = 100 + static_cast<float>(i);
            if (name == "depth")
                EXPECT_EQ(values[i], i == 7 ? -9999 : expected);
            else
                EXPECT_EQ(values[i], -expected);
        }
    }
}

TEST_P(Stack, OpensAsAnOrdinaryRasterInItsPlace) {
    const GdalSession session;
    const std::string name =
        GetParam() == StackFormat::netcdf ? "NETCDF:\"" + path_ + "\":depth" : "ZARR:\"" + path_ + "\":/depth:1";
    const GDALDatasetUniquePtr file(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER));
    ASSERT_TRUE(file) << session.last_message();
    double geo[6];
    ASSERT_EQ(file->GetGeoTransform(geo), CE_None);
    EXPECT_EQ(geo[0], 527000);
    EXPECT_EQ(geo[1], 2);
    EXPECT_EQ(geo[3], 5095000);
    EXPECT_EQ(geo[5], -2);
    ASSERT_TRUE(file->GetSpatialRef());
    EXPECT_TRUE(file->GetSpatialRef()->IsProjected());
}

// zarr decodes metadata as ASCII, xarray reads the dimensions of every array.
TEST(ZarrMetadata, IsAsciiAndNamesTheDimensionsOfEveryArray) {
    const Folder folder;
    const std::string path = folder.file("frames.zarr");
    const GridSpec grid{527000, 5095000, 2, 5, 3, crs_from_user("EPSG:32632", "")};
    FrameStack stack(path, StackFormat::zarr, grid, {0}, {{"SCENE", "Dürrenbühl \xf0\x9f\x8f\x94"}});
    stack.add(0, Raster(grid, 1), Raster(grid, 2));
    stack.close();
    std::size_t attributes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(".z")) continue;
        const std::string text = test::text_in(entry.path().string());
        EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return static_cast<signed char>(c) >= 0; }))
            << entry.path();
        const bool of_an_array = name == ".zattrs" && entry.path().parent_path() != path;
        if (!of_an_array) continue;
        ++attributes;
        EXPECT_TRUE(nlohmann::json::parse(text).contains("_ARRAY_DIMENSIONS")) << entry.path();
    }
    EXPECT_EQ(attributes, 6U);  // depth, velocity, time, y, x, spatial_ref
    const std::string all = test::text_in(path + "/.zmetadata");
    EXPECT_NE(all.find("D\\u00fcrrenb\\u00fchl \\ud83c\\udfd4"), std::string::npos);
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER));
    ASSERT_TRUE(file);
    EXPECT_EQ(text_of(*file->GetRootGroup(), "SCENE"), "Dürrenbühl \xf0\x9f\x8f\x94");
}

INSTANTIATE_TEST_SUITE_P(Formats, Stack, ::testing::Values(StackFormat::netcdf, StackFormat::zarr),
                         [](const auto& tested) {
                             return std::string(tested.param == StackFormat::netcdf ? "netcdf" : "zarr");
                         });

}  // namespace
}  // namespace frana::gis
