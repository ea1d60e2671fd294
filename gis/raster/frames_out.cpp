// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/frames_out.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "core/json.h"
#include "gis/access/gdal_session.h"
#include "gis/access/table_in.h"
#include "gis/raster/raster_out.h"

namespace frana::gis {
namespace {

[[noreturn]] void refuse_metadata(const std::string& file) {
    throw Error(ErrorKind::environment, Problem{"the frames' metadata cannot be written", file, "", "",
                                                "Check that the folder exists, may be written and has free space"});
}

void write(const std::string& file, const Json& content) {
    constexpr bool k_only_ascii = true;
    std::ofstream out(file, std::ios::binary);
    out << content.dump(2, ' ', k_only_ascii, Json::error_handler_t::replace) << '\n';
    out.close();
    if (!out) refuse_metadata(file);
}

/// Converts the metadata that GDAL wrote into a Zarr (version 2) folder to the form that zarr and xarray read: every
/// array lists its dimensions, also one without any (_ARRAY_DIMENSIONS), and the files contain only ASCII, as zarr
/// decodes them.
void finish_zarr_metadata(const std::string& folder) {
    const std::string all = folder + "/.zmetadata", attributes = "/.zattrs", array = "/.zarray";
    std::ifstream file(all, std::ios::binary);
    Json root = Json::parse(file, nullptr, false);
    if (!root.contains("metadata")) refuse_metadata(all);
    Json& parts = root["metadata"];
    for (const auto& [name, part] : parts.items()) {
        if (!name.ends_with(array) || !part.contains("shape") || !part["shape"].empty()) continue;
        const std::string beside = name.substr(0, name.size() - array.size()) + attributes;
        if (parts.contains(beside)) parts[beside]["_ARRAY_DIMENSIONS"] = Json::array();
    }
    for (const auto& [name, part] : parts.items()) write(folder + "/" + name, part);
    write(all, root);
}

using Array = std::shared_ptr<GDALMDArray>;

constexpr std::int64_t k_frame_block = 256;
constexpr const char* k_mapping = "spatial_ref";

void set_text(GDALIHasAttribute& holder, const std::string& name, const std::string& value) {
    const auto attribute = holder.CreateAttribute(name, {}, GDALExtendedDataType::CreateString());
    if (attribute) attribute->Write(value.c_str());
}

}  // namespace

struct FrameStack::Parts {
    std::string path;
    bool netcdf = false;
    GdalSession session;
    std::unique_ptr<GDALDataset> dataset;
    std::shared_ptr<GDALGroup> root;
    Array depth, velocity;

    [[noreturn]] void refuse() const {
        throw Error(ErrorKind::environment,
                    Problem{"the frames cannot be written: " + session.last_message(), path, "", "",
                            "Check that the folder exists, may be written and has free space"});
    }
    template <class T>
    const T& must(const T& made) const {
        if (!made) refuse();
        return made;
    }
    /// A coordinate along one dimension.
    std::shared_ptr<GDALDimension> axis(const std::string& name, const std::string& type, const std::string& direction,
                                        const std::vector<double>& values,
                                        const std::map<std::string, std::string>& texts, const std::string& unit) {
        auto dimension = must(root->CreateDimension(name, type, direction, values.size()));
        const Array array =
            must(root->CreateMDArray(name, {dimension}, GDALExtendedDataType::Create(GDT_Float64), nullptr));
        const GUInt64 start = 0;
        const size_t count = values.size();
        if (!array->Write(&start, &count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data()))
            refuse();
        array->SetUnit(unit);
        for (const auto& [key, text] : texts) set_text(*array, key, text);
        // In NetCDF a variable of a dimension's name is its coordinate.
        if (!netcdf) dimension->SetIndexingVariable(array);
        return dimension;
    }
};

FrameStack::FrameStack(std::string path, StackFormat format, const GridSpec& grid, const std::vector<double>& times,
                       const std::map<std::string, std::string>& metadata)
    : parts_(std::make_unique<Parts>()) {
    Parts& p = *parts_;
    p.path = std::move(path);
    const bool netcdf = p.netcdf = format == StackFormat::netcdf;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(netcdf ? "netCDF" : "Zarr");
    CPLStringList creation;
    creation.SetNameValue("FORMAT", netcdf ? "NC4" : "ZARR_V2");
    if (driver) p.dataset.reset(driver->CreateMultiDimensional(p.path.c_str(), nullptr, creation.List()));
    if (!p.dataset) p.refuse();
    p.root = p.must(p.dataset->GetRootGroup());
    set_text(*p.root, "Conventions", "CF-1.8");
    for (const auto& [key, value] : metadata) set_text(*p.root, key, value);

    std::vector<double> x, y;
    for (std::int64_t i = 0; i < grid.columns; ++i) x.push_back(grid.cell_centre(0, i).x);
    for (std::int64_t j = 0; j < grid.rows; ++j) y.push_back(grid.cell_centre(j, 0).y);
    const auto time = p.axis("time", GDAL_DIM_TYPE_TEMPORAL, "", times,
                             {{"long_name", "time since the release, as seconds from an arbitrary date"},
                              {"standard_name", "time"},
                              {"calendar", "proleptic_gregorian"},
                              {"axis", "T"}},
                             "seconds since " + date_text(0).substr(0, 10) + " 00:00:00");
    const auto north = p.axis("y", GDAL_DIM_TYPE_HORIZONTAL_Y, "NORTH", y,
                              {{"standard_name", "projection_y_coordinate"}, {"axis", "Y"}}, "m");
    const auto east = p.axis("x", GDAL_DIM_TYPE_HORIZONTAL_X, "EAST", x,
                             {{"standard_name", "projection_x_coordinate"}, {"axis", "X"}}, "m");
    OGRSpatialReference crs;
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (!grid.crs_wkt.empty()) crs.importFromWkt(grid.crs_wkt.c_str());
    if (!netcdf && !grid.crs_wkt.empty()) {
        // GDAL stores the CRS of a Zarr array in its own attribute; CF readers look for a grid mapping, by one of two
        // names for its text.
        const Array mapping =
            p.must(p.root->CreateMDArray(k_mapping, {}, GDALExtendedDataType::Create(GDT_Int32), nullptr));
        for (const char* name : {"crs_wkt", "spatial_ref"}) set_text(*mapping, name, grid.crs_wkt);
        const std::int32_t any = 1;  // required by readers, value without meaning
        if (!mapping->Write(nullptr, nullptr, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Int32), &any))
            p.refuse();
    }
    CPLStringList options;
    options.SetNameValue("COMPRESS", netcdf ? "DEFLATE" : "ZLIB");
    options.SetNameValue("BLOCKSIZE", ("1," + std::to_string(std::min(k_frame_block, grid.rows)) + "," +
                                       std::to_string(std::min(k_frame_block, grid.columns)))
                                          .c_str());
    const auto field = [&](const std::string& name, const std::string& long_name, const std::string& unit) {
        Array array = p.must(p.root->CreateMDArray(name, {time, north, east}, GDALExtendedDataType::Create(GDT_Float32),
                                                   options.List()));
        if (!array->SetNoDataValue(k_file_nodata)) p.refuse();
        array->SetUnit(unit);
        set_text(*array, "long_name", long_name);
        if (!grid.crs_wkt.empty()) {
            array->SetSpatialRef(&crs);
            if (!netcdf) set_text(*array, "grid_mapping", k_mapping);
        }
        return array;
    };
    p.depth = field("depth", "flow depth, " + depth_direction_in(metadata), "m");
    p.velocity = field("velocity", "flow speed along the bed", "m s-1");
}

FrameStack::~FrameStack() = default;

void FrameStack::add(std::size_t index, const Raster& depth, const Raster& velocity) {
    Parts& p = *parts_;
    // Parts not written have no data.
    const auto write_part = [&](const Array& array, const Raster& raster, const CellWindow& window) {
        std::vector<float> values(raster.values.size());
        std::transform(raster.values.begin(), raster.values.end(), values.begin(), [](double value) {
            return std::isfinite(value) ? static_cast<float>(value) : static_cast<float>(k_file_nodata);
        });
        const GUInt64 start[3] = {index, static_cast<GUInt64>(window.row), static_cast<GUInt64>(window.column)};
        const size_t count[3] = {1, static_cast<size_t>(raster.grid.rows), static_cast<size_t>(raster.grid.columns)};
        if (!array->Write(start, count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float32), values.data()))
            p.refuse();
    };
    const auto write = [&](const Array& array, const Raster& raster) {
        if (!raster.values.is_tiled()) return write_part(array, raster, {0, 0, raster.grid.rows, raster.grid.columns});
        for (const CellWindow& window : raster.values.stored_windows(raster.grid.columns))
            write_part(array, part_of(raster, window), window);
    };
    write(p.depth, depth);
    write(p.velocity, velocity);
}

void FrameStack::close() {
    Parts& p = *parts_;
    p.depth.reset();
    p.velocity.reset();
    p.root.reset();
    p.dataset.reset();
    if (p.session.failed()) p.refuse();
    if (!p.netcdf) finish_zarr_metadata(p.path);
}

}  // namespace frana::gis
