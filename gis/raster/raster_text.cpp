// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/raster_text.h"

#include <cpl_string.h>
#include <gdal.h>

#include "core/error.h"
#include "gis/access/gdal_session.h"
#include "gis/access/memory_dataset.h"

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
    char** items = GDALGetMetadata(dataset.get(), nullptr);
    for (int i = 0; i < CSLCount(items); ++i) {
        const std::string pair = items[i];
        const auto equals = pair.find('=');
        if (equals != std::string::npos) text.metadata[pair.substr(0, equals)] = pair.substr(equals + 1);
    }
    text.classes = classes_of(band);
    return text;
}

}  // namespace frana::gis
