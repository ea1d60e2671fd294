// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/raster_out.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "core/error.h"
#include "core/text.h"
#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
#include "gis/raster/raster_source.h"

namespace frana::gis {
namespace {

std::string label_of(GDALRasterBandH band, int value) {
    const char* named = GDALGetMetadataItem(band, ("CLASS_" + std::to_string(value)).c_str(), nullptr);
    if (named != nullptr) return named;
    char** names = GDALGetRasterCategoryNames(band);
    if (value < CSLCount(names) && *names[value] != '\0') return names[value];
    return std::to_string(value);
}

std::vector<NamedClass> classes_of(GDALRasterBandH band) {
    std::vector<NamedClass> classes;
    GDALColorTableH colours = GDALGetRasterColorTable(band);
    if (colours == nullptr) return classes;
    const bool labelled = GDALGetMetadata(band, nullptr) != nullptr || GDALGetRasterCategoryNames(band) != nullptr;
    for (int value = 0; value < GDALGetColorEntryCount(colours); ++value) {
        GDALColorEntry entry{};
        GDALGetColorEntryAsRGB(colours, value, &entry);
        const std::string label = label_of(band, value);
        // A table has an entry for every byte; if any classes are named, unnamed entries are not classes.
        if (entry.c4 == 0 || (labelled && label == std::to_string(value))) continue;
        const auto byte = [](short c) { return static_cast<std::uint8_t>(c); };
        classes.push_back({value, label, {byte(entry.c1), byte(entry.c2), byte(entry.c3)}});
    }
    return classes;
}

}  // namespace

std::string depth_direction_in(const std::map<std::string, std::string>& metadata) {
    const auto item = metadata.find(k_depth_item);
    return item == metadata.end() ? "vertical" : item->second;
}

RasterText read_raster_text(const std::string& path) {
    const GdalSession session;
    const GdalDataset dataset(GDALOpen(path.c_str(), GA_ReadOnly));
    if (!dataset || GDALGetRasterCount(dataset.get()) < 1) {
        throw Error(ErrorKind::input, Problem{"the raster cannot be read", path, session.last_message(), "", ""});
    }
    GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
    RasterText text;
    text.description = GDALGetDescription(band);
    text.unit = GDALGetRasterUnitType(band);
    for (int next = 2; next <= GDALGetRasterCount(dataset.get()); ++next)
        text.further.emplace_back(GDALGetDescription(GDALGetRasterBand(dataset.get(), next)));
    char** items = GDALGetMetadata(dataset.get(), nullptr);
    for (int i = 0; i < CSLCount(items); ++i) {
        const std::string pair = items[i];
        const auto equals = pair.find('=');
        if (equals != std::string::npos) text.metadata[pair.substr(0, equals)] = pair.substr(equals + 1);
    }
    text.classes = classes_of(band);
    return text;
}

namespace {

constexpr int k_block = 256;          // cells; a landslide's raster is small, so that 512 would give no overviews
constexpr int k_small = 4 * k_block;  // cells
constexpr std::uint8_t k_no_class = 0;

void place(GDALDatasetH dataset, const GridSpec& grid, std::optional<double> nodata) {
    std::array<double, 6> geo{grid.west, grid.cell_size, 0, grid.north, 0, -grid.cell_size};
    GDALSetGeoTransform(dataset, geo.data());
    if (!grid.crs_wkt.empty()) {
        OGRSpatialReferenceH crs = OSRNewSpatialReference(grid.crs_wkt.c_str());
        // A GeoTIFF of a known CRS has its code alone. From WKT 2 GDAL takes 5 ms longer to find it than from WKT 1.
        if (OSRGetAuthorityCode(crs, nullptr) != nullptr) {
            char* plain = nullptr;
            OSRExportToWkt(crs, &plain);
            OSRSetFromUserInput(crs, plain);
            CPLFree(plain);
        }
        OSRSetAxisMappingStrategy(crs, OAMS_TRADITIONAL_GIS_ORDER);
        GDALSetSpatialRef(dataset, crs);
        OSRDestroySpatialReference(crs);
    }
    for (int band = 1; nodata && band <= GDALGetRasterCount(dataset); ++band)
        GDALSetRasterNoDataValue(GDALGetRasterBand(dataset, band), *nodata);
}

GdalDataset in_memory(const GridSpec& grid, GDALDataType type, double nodata, int bands = 1) {
    GdalDataset dataset(GDALCreate(GDALGetDriverByName("MEM"), "", static_cast<int>(grid.columns),
                                   static_cast<int>(grid.rows), bands, type, nullptr));
    place(dataset.get(), grid, nodata);
    return dataset;
}

void set_texts(GDALDatasetH dataset, const BandText& text, int number = 1) {
    GDALRasterBandH band = GDALGetRasterBand(dataset, number);
    const std::string unit = text.unit.empty() ? "" : " [" + text.unit + "]";
    GDALSetDescription(band, (text.name + ": " + text.description + unit).c_str());
    GDALSetRasterUnitType(band, text.unit.c_str());
    for (const auto& [key, value] : text.metadata)
        GDALSetMetadataItem(dataset, key.c_str(), valid_utf8(value).c_str(), nullptr);
}

/// Statistics of the values in the file, not of those before rounding. `zeros`: further cells, of value 0.
void set_statistics(GDALDatasetH dataset, const std::vector<float>& values, std::size_t cells, int number = 1,
                    std::size_t zeros = 0) {
    double least = HUGE_VAL, greatest = -HUGE_VAL, sum = 0, squares = 0;
    std::size_t count = 0;
    for (const float value : values) {
        if (value == static_cast<float>(k_file_nodata)) continue;
        least = std::min(least, static_cast<double>(value));
        greatest = std::max(greatest, static_cast<double>(value));
        sum += value;
        ++count;
    }
    if (zeros > 0) {
        least = std::min(least, 0.0);
        greatest = std::max(greatest, 0.0);
        count += zeros;
    }
    if (count == 0) return;
    const double mean = sum / static_cast<double>(count);
    for (const float value : values) {
        if (value != static_cast<float>(k_file_nodata)) squares += (value - mean) * (value - mean);
    }
    squares += static_cast<double>(zeros) * mean * mean;
    GDALRasterBandH band = GDALGetRasterBand(dataset, number);
    const auto set = [&](const char* key, double value) {
        GDALSetMetadataItem(band, key, shortest_text(value).c_str(), nullptr);
    };
    set("STATISTICS_MINIMUM", least);
    set("STATISTICS_MAXIMUM", greatest);
    set("STATISTICS_MEAN", mean);
    set("STATISTICS_STDDEV", std::sqrt(squares / static_cast<double>(count)));
    set("STATISTICS_VALID_PERCENT", 100.0 * static_cast<double>(count) / static_cast<double>(cells));
}

/// Halved until one block contains all cells. Made in memory, they need no temporary file.
void build_overviews(GDALDatasetH dataset, const char* resampling, const std::string& path,
                     const GdalSession& session) {
    std::vector<int> factors;
    const int longest = std::max(GDALGetRasterXSize(dataset), GDALGetRasterYSize(dataset));
    for (int factor = 2; longest > k_block * factor / 2; factor *= 2) factors.push_back(factor);
    if (factors.empty()) return;
    if (GDALBuildOverviews(dataset, resampling, static_cast<int>(factors.size()), factors.data(), 0, nullptr, nullptr,
                           nullptr) != CE_None) {
        session.refuse_written("the raster", path);
    }
}

void write_cog(const std::string& path, GDALDatasetH dataset, const char* resampling, const char* predictor,
               RasterUse use = RasterUse::result) {
    const GdalSession session;
    const bool small = std::max(GDALGetRasterXSize(dataset), GDALGetRasterYSize(dataset)) <= k_small;
    const bool overviews = use == RasterUse::result || !small;
    if (overviews) build_overviews(dataset, resampling, path, session);
    const NoSideFiles quiet;
    const MemoryFolder memory;
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", predictor);
    options.SetNameValue("BLOCKSIZE", std::to_string(k_block).c_str());
    options.SetNameValue("OVERVIEWS", overviews ? "AUTO" : "NONE");
    options.SetNameValue("OVERVIEW_RESAMPLING", resampling);
    if (use == RasterUse::result) {
        options.SetNameValue("NUM_THREADS", "ALL_CPUS");  // the file is the same for any number
    } else {
        options.SetNameValue("SPARSE_OK", "TRUE");
    }
    {
        const GdalDataset written(GDALCreateCopy(GDALGetDriverByName("COG"), memory.place_of(path).c_str(), dataset,
                                                 TRUE, options.List(), nullptr, nullptr));
        if (!written) session.refuse_written("the raster", path);
        GDALFlushCache(written.get());
    }
    // Closing writes the last bytes and reports errors only through the error handler.
    if (session.failed()) session.refuse_written("the raster", path);
    memory.write_to_disk(path);
}

/// Of cells that are not stored `elsewhere`.
std::vector<float> file_values(const Raster& raster, double elsewhere = k_file_nodata) {
    std::vector<float> values(raster.values.size(), static_cast<float>(elsewhere));
    raster.values.for_each_run([&](std::size_t first, const double* from, std::size_t count) {
        std::transform(from, from + count, values.begin() + static_cast<std::ptrdiff_t>(first), [](double value) {
            return std::isfinite(value) ? static_cast<float>(value) : static_cast<float>(k_file_nodata);
        });
    });
    return values;
}

/// Whether the blocks that nothing reached are left out of a file.
bool is_sparse(const Raster& raster) {
    return raster.values.is_tiled() && static_cast<std::int64_t>(raster.values.size()) > CellValues::k_most_dense;
}

void write_band(const std::string& path, GDALDatasetH dataset, int number, const std::vector<float>& values) {
    const GdalSession session;
    const int columns = GDALGetRasterXSize(dataset), rows = GDALGetRasterYSize(dataset);
    if (GDALRasterIO(GDALGetRasterBand(dataset, number), GF_Write, 0, 0, columns, rows,
                     const_cast<float*>(values.data()), columns, rows, GDT_Float32, 0, 0) != CE_None) {
        session.refuse_written("the raster", path);
    }
}

GdalDataset in_memory(const std::string& path, const GridSpec& grid, const std::vector<float>& values) {
    GdalDataset dataset = in_memory(grid, GDT_Float32, k_file_nodata);
    write_band(path, dataset.get(), 1, values);
    return dataset;
}

/// Calls visit(window) for the blocks of a file.
void for_each_block(const GridSpec& grid, const std::function<void(const CellWindow& window)>& visit) {
    for (std::int64_t row = 0; row < grid.rows; row += k_block)
        for (std::int64_t column = 0; column < grid.columns; column += k_block)
            visit({row, column, std::min<std::int64_t>(k_block, grid.rows - row),
                   std::min<std::int64_t>(k_block, grid.columns - column)});
}

void write_block(const std::string& path, GDALDatasetH dataset, int number, const Raster& raster,
                 const CellWindow& window, double nodata, const GdalSession& session) {
    if (!raster.values.stores_any(window)) return;
    Raster block = part_of(raster, window);
    bool empty = true;
    for (double& value : block.values.dense()) {
        empty = empty && !std::isfinite(value);
        if (!std::isfinite(value)) value = nodata;
    }
    if (empty) return;
    const int columns = static_cast<int>(window.columns), rows = static_cast<int>(window.rows);
    if (GDALRasterIO(GDALGetRasterBand(dataset, number), GF_Write, static_cast<int>(window.column),
                     static_cast<int>(window.row), columns, rows, block.values.data(), columns, rows, GDT_Float64, 0,
                     0) != CE_None) {
        session.refuse_written("the raster", path);
    }
}

/// Writes rasters of a large map as the bands of a file: only the blocks that contain data, and no overviews. Blocks
/// that are not there read as `nodata`, or as 0 where there is none.
void write_sparse(const std::string& path, const std::vector<const Raster*>& bands, GDALDataType type,
                  std::optional<double> nodata, const char* predictor,
                  const std::function<void(GDALDatasetH)>& describe) {
    const GdalSession session;
    const NoSideFiles quiet;
    const MemoryFolder memory;
    const GridSpec& grid = bands.front()->grid;
    CPLStringList options;
    options.SetNameValue("TILED", "YES");
    options.SetNameValue("INTERLEAVE", "BAND");
    options.SetNameValue("BLOCKXSIZE", std::to_string(k_block).c_str());
    options.SetNameValue("BLOCKYSIZE", std::to_string(k_block).c_str());
    options.SetNameValue("SPARSE_OK", "TRUE");
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", predictor);
    {
        GDALDriverH const driver = GDALGetDriverByName("GTiff");
        const GdalDataset written(GDALCreate(driver, memory.place_of(path).c_str(), static_cast<int>(grid.columns),
                                             static_cast<int>(grid.rows), static_cast<int>(bands.size()), type,
                                             options.List()));
        if (!written) session.refuse_written("the raster", path);
        place(written.get(), grid, nodata);
        describe(written.get());
        for_each_block(grid, [&](const CellWindow& window) {
            int number = 0;
            for (const Raster* band : bands)
                write_block(path, written.get(), ++number, *band, window, nodata.value_or(k_no_data), session);
        });
        GDALFlushCache(written.get());
    }
    if (session.failed()) session.refuse_written("the raster", path);
    memory.write_to_disk(path);
}

void set_classes(GDALRasterBandH band, const std::vector<ClassEntry>& classes) {
    GDALColorTableH colours = GDALCreateColorTable(GPI_RGB);
    const GDALColorEntry clear{0, 0, 0, 0};
    GDALSetColorEntry(colours, k_no_class, &clear);
    for (const ClassEntry& entry : classes) {
        const GDALColorEntry colour{entry.colour.r, entry.colour.g, entry.colour.b, 255};
        GDALSetColorEntry(colours, entry.value, &colour);
        const std::string key = "CLASS_" + std::to_string(entry.value);
        GDALSetMetadataItem(band, key.c_str(), entry.label.c_str(), nullptr);
    }
    GDALSetRasterColorTable(band, colours);
    GDALDestroyColorTable(colours);
}

/// Values stored in a sparse file, for its statistics.
std::vector<float> stored_values(const Raster& raster) {
    std::vector<float> values;
    raster.values.for_each_stored([&](std::size_t, double value) {
        if (std::isfinite(value)) values.push_back(static_cast<float>(value));
    });
    return values;
}

}  // namespace

void write_geotiff(const std::string& path, const Raster& raster, const BandText& text, RasterUse use) {
    const GdalSession session;
    if (is_sparse(raster)) {
        write_sparse(path, {&raster}, GDT_Float32, k_file_nodata, "3", [&](GDALDatasetH dataset) {
            set_texts(dataset, text);
            set_statistics(dataset, stored_values(raster), raster.values.size());
        });
        return;
    }
    const std::vector<float> values = file_values(raster);
    const GdalDataset dataset = in_memory(path, raster.grid, values);
    set_texts(dataset.get(), text);
    set_statistics(dataset.get(), values, values.size());
    write_cog(path, dataset.get(), "AVERAGE", "FLOATING_POINT", use);
}

void write_geotiff(const std::string& path, const std::vector<RasterBand>& bands) {
    const GdalSession session;
    if (is_sparse(bands.front().raster)) {
        std::vector<const Raster*> rasters;
        for (const RasterBand& band : bands) rasters.push_back(&band.raster);
        const bool zeros = bands.front().zero_elsewhere;
        write_sparse(path, rasters, GDT_Float32, zeros ? std::nullopt : std::optional<double>(k_file_nodata), "3",
                     [&](GDALDatasetH dataset) {
                         int number = 0;
                         for (const RasterBand& band : bands) {
                             const std::vector<float> values = stored_values(band.raster);
                             const std::size_t cells = band.raster.values.size();
                             set_texts(dataset, band.text, ++number);
                             set_statistics(dataset, values, cells, number, zeros ? cells - values.size() : 0);
                         }
                     });
        return;
    }
    const GdalDataset dataset =
        in_memory(bands.front().raster.grid, GDT_Float32, k_file_nodata, static_cast<int>(bands.size()));
    int number = 0;
    for (const RasterBand& band : bands) {
        const std::vector<float> values = file_values(band.raster, band.zero_elsewhere ? 0 : k_file_nodata);
        write_band(path, dataset.get(), ++number, values);
        set_texts(dataset.get(), band.text, number);
        set_statistics(dataset.get(), values, values.size(), number);
    }
    write_cog(path, dataset.get(), "AVERAGE", "FLOATING_POINT");
}

void write_class_geotiff(const std::string& path, const Raster& raster, const std::vector<ClassEntry>& classes,
                         const BandText& text) {
    const GdalSession session;
    const bool sparse = is_sparse(raster);
    std::vector<std::uint8_t> values(sparse ? 0 : raster.values.size(), k_no_class);
    raster.values.for_each_stored([&](std::size_t cell, double value) {
        if (std::isnan(value) || value == k_no_class) return;
        const auto entry =
            std::find_if(classes.begin(), classes.end(), [value](const ClassEntry& one) { return value == one.value; });
        if (entry == classes.end()) {
            throw Error(ErrorKind::input, Problem{"a cell has a value that is not a class", path, shortest_text(value),
                                                  std::to_string(classes.size()) + " named classes", ""});
        }
        if (!sparse) values[cell] = entry->value;
    });
    const auto describe = [&](GDALDatasetH dataset) {
        set_classes(GDALGetRasterBand(dataset, 1), classes);
        set_texts(dataset, text);
    };
    if (sparse) return write_sparse(path, {&raster}, GDT_Byte, k_no_class, "1", describe);
    const GdalDataset dataset = in_memory(raster.grid, GDT_Byte, k_no_class);
    GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
    const int columns = static_cast<int>(raster.grid.columns), rows = static_cast<int>(raster.grid.rows);
    if (GDALRasterIO(band, GF_Write, 0, 0, columns, rows, values.data(), columns, rows, GDT_Byte, 0, 0) != CE_None) {
        session.refuse_written("the raster", path);
    }
    describe(dataset.get());
    write_cog(path, dataset.get(), "NEAREST", "NO");
}

}  // namespace frana::gis
