// SPDX-License-Identifier: Apache-2.0
// Raster files of all common formats, written by GDAL, read by frana: the same ground in the same place.
#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <functional>

#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_in.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::gis {
namespace {

using test::error_of;
using test::Folder;

constexpr double k_west = 527000, k_north = 5095000, k_cell = 5;
constexpr int k_columns = 40, k_rows = 30;

/// Whole numbers at the cells' centres, exact as integers.
double ground(double x, double y) {
    return 1000 + 0.4 * (x - k_west - k_cell / 2) - 0.2 * (y - k_north + k_cell / 2);
}

/// Some columns of the test ground, as a dataset in memory.
GDALDatasetUniquePtr part_of_ground(int first, int columns, GDALDataType type) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    GDALDatasetUniquePtr dataset(driver->Create("", columns, k_rows, 1, type, nullptr));
    double geo[6] = {k_west + first * k_cell, k_cell, 0, k_north, 0, -k_cell};
    dataset->SetGeoTransform(geo);
    OGRSpatialReference utm;
    utm.importFromEPSG(32632);
    dataset->SetSpatialRef(&utm);
    for (int row = 0; row < k_rows; ++row) {
        std::vector<double> line;
        for (int column = first; column < first + columns; ++column)
            line.push_back(ground(k_west + (column + 0.5) * k_cell, k_north - (row + 0.5) * k_cell));
        EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, row, columns, 1, line.data(), columns, 1,
                                                      GDT_Float64, 0, 0),
                  CE_None);
    }
    return dataset;
}

void write_as(const std::string& driver_name, const std::string& path, GDALDataset& from) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name.c_str());
    ASSERT_TRUE(driver) << driver_name;
    const GDALDatasetUniquePtr copy(driver->CreateCopy(path.c_str(), &from, FALSE, nullptr, nullptr, nullptr));
    ASSERT_TRUE(copy) << CPLGetLastErrorMsg();
}

void copy_bytes(const std::string& from, const std::string& to) {
    const std::string bytes = test::text_in(from);
    VSILFILE* file = VSIFOpenL(to.c_str(), "wb");
    ASSERT_TRUE(file) << to;
    EXPECT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), file), bytes.size());
    VSIFCloseL(file);
}

void expect_ground(const std::string& path, double tolerance = 0) {
    const GridSpec grid{k_west + 10, k_north - 10, k_cell, 20, 15, crs_from_user("EPSG:32632", "")};
    const RasterRead read = read_raster_on(path, grid, "", Resampling::automatic);
    EXPECT_EQ(read.resampling_used, "exact copy") << path;
    EXPECT_EQ(read.nodata_cells, 0) << path;
    for (int row = 0; row < 15; ++row) {
        for (int column = 0; column < 20; ++column) {
            const Point centre = grid.cell_centre(row, column);
            ASSERT_NEAR(read.raster.at(row, column), ground(centre.x, centre.y), tolerance) << path;
        }
    }
}

struct RasterFile {
    const char* name;
    const char* driver;
    const char* file;
    GDALDataType type;
};
void PrintTo(const RasterFile& format, std::ostream* out) {
    *out << format.name;
}

class RasterFormat : public testing::TestWithParam<RasterFile> {};

TEST_P(RasterFormat, IsReadAsTheSameGround) {
    const GdalSession session;
    const Folder folder;
    const RasterFile& format = GetParam();
    const std::string path = folder.file(format.file);
    write_as(format.driver, path, *part_of_ground(0, k_columns, format.type));
    expect_ground(path);
}

INSTANTIATE_TEST_SUITE_P(Formats, RasterFormat,
                         testing::Values(RasterFile{"geotiff_float", "GTiff", "a.tif", GDT_Float32},
                                         RasterFile{"geotiff_int16", "GTiff", "a.tif", GDT_Int16},
                                         RasterFile{"geotiff_uint16", "GTiff", "a.tif", GDT_UInt16},
                                         RasterFile{"geotiff_int32", "GTiff", "a.tif", GDT_Int32},
                                         RasterFile{"geotiff_uint32", "GTiff", "a.tif", GDT_UInt32},
                                         RasterFile{"geotiff_int64", "GTiff", "a.tif", GDT_Int64},
                                         RasterFile{"ascii_grid", "AAIGrid", "a.asc", GDT_Float32},
                                         RasterFile{"esri_binary", "EHdr", "a.flt", GDT_Float32},
                                         RasterFile{"esri_bil", "EHdr", "a.bil", GDT_Int16},
                                         RasterFile{"imagine", "HFA", "a.img", GDT_Float32},
                                         RasterFile{"netcdf", "netCDF", "a.nc", GDT_Float32},
                                         RasterFile{"envi", "ENVI", "a.dat", GDT_Float64}),
                         [](const auto& tested) { return tested.param.name; });

TEST(RasterFiles, AMosaicOfTilesIsOneRaster) {
    const GdalSession session;
    const Folder folder;
    write_as("GTiff", folder.file("west.tif"), *part_of_ground(0, 13, GDT_Float32));
    write_as("GTiff", folder.file("east.tif"), *part_of_ground(13, k_columns - 13, GDT_Float32));
    const std::string west = folder.file("west.tif"), east = folder.file("east.tif");
    const char* const tiles[] = {west.c_str(), east.c_str()};
    GDALClose(GDALBuildVRT(folder.file("all.vrt").c_str(), 2, nullptr, tiles, nullptr, nullptr));
    expect_ground(folder.file("all.vrt"));
    // A missing tile must not be read as flat ground.
    std::filesystem::remove(east);
    const GridSpec grid{k_west, k_north, k_cell, k_columns, k_rows, crs_from_user("EPSG:32632", "")};
    EXPECT_EQ(error_of([&] { (void)read_raster_on(folder.file("all.vrt"), grid, "", Resampling::automatic); }).kind(),
              ErrorKind::input);
}

TEST(RasterFiles, ArchivesAreReadInPlace) {
    const GdalSession session;
    const Folder folder;
    write_as("GTiff", folder.file("a.tif"), *part_of_ground(0, k_columns, GDT_Float32));
    copy_bytes(folder.file("a.tif"), "/vsizip/" + folder.file("a.zip") + "/dtm/a.tif");
    copy_bytes(folder.file("a.tif"), "/vsigzip/" + folder.file("a.tif.gz"));
    expect_ground("/vsizip/" + folder.file("a.zip") + "/dtm/a.tif");
    expect_ground("/vsigzip/" + folder.file("a.tif.gz"));
}

TEST(RasterFiles, SeveralRastersInOneFileAreNamed) {
    const GdalSession session;
    const Folder folder;
    for (const char* name : {"before", "after"}) {
        const auto from = part_of_ground(0, k_columns, GDT_Float32);
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
        const std::string table = std::string("RASTER_TABLE=") + name;
        const char* options[] = {table.c_str(), "APPEND_SUBDATASET=YES", nullptr};
        const GDALDatasetUniquePtr copy(driver->CreateCopy(folder.file("two.gpkg").c_str(), from.get(), FALSE,
                                                           const_cast<char**>(options), nullptr, nullptr));
        ASSERT_TRUE(copy) << CPLGetLastErrorMsg();
    }
    const Error error = error_of([&] { (void)inspect_raster(folder.file("two.gpkg"), "scene.ini: terrain.dtm"); });
    EXPECT_TRUE(has_problem(error.problems(), "scene.ini: terrain.dtm", folder.file("two.gpkg")));
    for (const char* name : {":before", ":after"})
        EXPECT_NE(error.problems().front().remedy.find("GPKG:" + folder.file("two.gpkg") + name), std::string::npos);
    expect_ground("GPKG:" + folder.file("two.gpkg") + ":after");
}

TEST(RasterFiles, PixelIsPointMeansTheCentre) {
    const GdalSession session;
    const Folder folder;
    // As written, the tie point is the first cell's centre.
    CPLSetThreadLocalConfigOption("GTIFF_POINT_GEO_IGNORE", "YES");
    {
        const auto from = part_of_ground(0, k_columns, GDT_Float32);
        from->SetMetadataItem("AREA_OR_POINT", "Point");
        write_as("GTiff", folder.file("point.tif"), *from);
    }
    CPLSetThreadLocalConfigOption("GTIFF_POINT_GEO_IGNORE", nullptr);
    const RasterInfo info = inspect_raster(folder.file("point.tif"), "");
    EXPECT_EQ(info.bounds.west, k_west - k_cell / 2);
    EXPECT_EQ(info.bounds.north, k_north + k_cell / 2);
}

/// Tiles of a degree with their values at whole steps: HGT and DTED.
void expect_tile(const std::string& driver, const std::string& name) {
    const GdalSession session;
    const Folder folder;
    const auto height = [](double longitude, double latitude) {
        return 1000 + 20000 * (longitude - 9) + 8000 * (latitude - 46);
    };
    constexpr int n = 1201;
    constexpr double step = 1.0 / (n - 1);
    {
        GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
        const GDALDatasetUniquePtr from(memory->Create("", n, n, 1, GDT_Int16, nullptr));
        double geo[6] = {9 - step / 2, step, 0, 47 + step / 2, 0, -step};
        from->SetGeoTransform(geo);
        OGRSpatialReference wgs84;
        wgs84.importFromEPSG(4326);
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        from->SetSpatialRef(&wgs84);
        for (int row = 0; row < n; ++row) {
            std::vector<double> line;
            for (int column = 0; column < n; ++column)
                line.push_back(std::round(height(9 + column * step, 47 - row * step)));
            ASSERT_EQ(from->GetRasterBand(1)->RasterIO(GF_Write, 0, row, n, 1, line.data(), n, 1, GDT_Float64, 0, 0),
                      CE_None);
        }
        write_as(driver, folder.file(name), *from);
    }
    const RasterInfo info = inspect_raster(folder.file(name), "");
    EXPECT_NEAR(info.bounds.west, 9 - step / 2, 1e-9);
    const GridSpec grid{529000, 5100000, 50, 40, 40, crs_from_user("EPSG:32632", "")};
    const RasterRead read = read_raster_on(folder.file(name), grid, "", Resampling::automatic);
    const CrsTransform to_degrees(grid.crs_wkt, crs_from_user("EPSG:4326", ""), grid.bounds());
    for (int i = 0; i < 40; ++i) {
        const Point place = to_degrees(grid.cell_centre(i, 39 - i));
        // Half a metre was rounded away; a shift of half a cell would be 8 m and 3 m.
        ASSERT_NEAR(read.raster.at(i, 39 - i), height(place.x, place.y), 0.7) << driver;
    }
}

TEST(RasterFiles, ShuttleTiles) {
    expect_tile("SRTMHGT", "N46E009.hgt");
}

TEST(RasterFiles, DtedTiles) {
    expect_tile("DTED", "n46.dt1");
}

}  // namespace
}  // namespace frana::gis
