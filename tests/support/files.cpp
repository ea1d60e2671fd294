// SPDX-License-Identifier: Apache-2.0
#include "support/files.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "gis/access/gdal_session.h"

namespace frana::gis::test {
namespace {

OGRSpatialReference crs_from(const std::string& text) {
    OGRSpatialReference crs;
    crs.SetFromUserInput(text.c_str());
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
}

}  // namespace

Folder::Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "frana_gis_XXXXXX").string();
    path_ = mkdtemp(name.data());
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> Folder::names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) found.push_back(entry.path().filename());
    std::sort(found.begin(), found.end());
    return found;
}

void make_raster(const std::string& path, const TestRaster& raster) {
    const GdalSession session;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    const GDALDatasetUniquePtr dataset(
        driver->Create(path.c_str(), raster.columns, raster.rows, 1, raster.bytes ? GDT_Byte : GDT_Float64, nullptr));
    ASSERT_TRUE(dataset);
    double geo[6] = {raster.west, raster.cell_x, raster.rotation, raster.north, raster.rotation, -raster.cell_y};
    dataset->SetGeoTransform(geo);
    if (!raster.crs.empty()) {
        const OGRSpatialReference crs = crs_from(raster.crs);
        dataset->SetSpatialRef(&crs);
    }
    GDALRasterBand& band = *dataset->GetRasterBand(1);
    if (raster.nodata) band.SetNoDataValue(*raster.nodata);
    if (!raster.unit.empty()) band.SetUnitType(raster.unit.c_str());
    if (raster.scale != 1) band.SetScale(raster.scale);
    if (raster.offset != 0) band.SetOffset(raster.offset);
    std::vector<double> values = raster.values;
    ASSERT_EQ(values.size(), static_cast<std::size_t>(raster.columns * raster.rows));
    ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, raster.columns, raster.rows, values.data(), raster.columns, raster.rows,
                            GDT_Float64, 0, 0),
              CE_None);
}

void copy_as(const std::string& from, const std::string& to, const std::string& driver) {
    const GdalSession session;
    const NoSideFiles no_side_files;
    const GDALDatasetUniquePtr source(GDALDataset::Open(from.c_str(), GDAL_OF_RASTER));
    ASSERT_TRUE(source);
    const GDALDatasetUniquePtr copy(GetGDALDriverManager()
                                        ->GetDriverByName(driver.c_str())
                                        ->CreateCopy(to.c_str(), source.get(), FALSE, nullptr, nullptr, nullptr));
    ASSERT_TRUE(copy) << to;
}

void make_vector(const std::string& path, const std::string& driver_name, const std::string& crs_text,
                 const std::vector<std::string>& wkt, const std::string& layer_name) {
    const GdalSession session;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name.c_str());
    const bool exists = std::filesystem::exists(path);
    const GDALDatasetUniquePtr dataset(exists ? GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE)
                                              : driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    ASSERT_TRUE(dataset);
    OGRSpatialReference crs = crs_from(crs_text.empty() ? "EPSG:4326" : crs_text);
    OGRGeometry* first = nullptr;
    if (!wkt.empty()) OGRGeometryFactory::createFromWkt(wkt.front().c_str(), nullptr, &first);
    const OGRwkbGeometryType type = driver_name == "ESRI Shapefile" && first ? first->getGeometryType() : wkbUnknown;
    OGRGeometryFactory::destroyGeometry(first);
    OGRLayer* layer = dataset->CreateLayer(layer_name.c_str(), crs_text.empty() ? nullptr : &crs, type, nullptr);
    ASSERT_TRUE(layer);
    OGRFieldDefn thick("thick", OFTReal), name("name", OFTString);
    layer->CreateField(&thick);
    layer->CreateField(&name);
    double thickness = 0;
    for (const std::string& text : wkt) {
        OGRFeature feature(layer->GetLayerDefn());
        OGRGeometry* geometry = nullptr;
        ASSERT_EQ(OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &geometry), OGRERR_NONE) << text;
        feature.SetGeometryDirectly(geometry);
        feature.SetField("thick", thickness += 10);
        feature.SetField("name", "slope");
        ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    }
}

std::string text_in(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

Error error_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "no Error was thrown";
    return Error(ErrorKind::numerical, Problem{});
}

}  // namespace frana::gis::test
