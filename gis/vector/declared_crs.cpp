// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/declared_crs.h"

#include <cpl_vsi.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "gis/access/json_members.h"
#include "gis/crs/crs.h"

namespace frana::gis {
namespace {

/// Returns the "crs" members outside attributes in those files of a data set that are text in braces.
std::vector<JsonMember> crs_members(GDALDataset& dataset) {
    std::vector<JsonMember> all;
    char** const files = dataset.GetFileList();
    for (int i = 0; files != nullptr && files[i] != nullptr; ++i) {
        const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> file(VSIFOpenL(files[i], "rb"), &VSIFCloseL);
        if (!file) continue;
        JsonMembers members("crs", "properties");
        std::vector<char> block(std::size_t{1} << 16);
        bool is_json = true;
        for (bool first = true; is_json; first = false) {
            const std::size_t count = VSIFReadL(block.data(), 1, block.size(), file.get());
            if (count == 0) break;
            // Marks that may come first: of UTF-8, and of records in a sequence.
            const std::string begin(block.data(), std::min<std::size_t>(count, 64));
            const auto start = begin.find_first_not_of(" \t\r\n\xEF\xBB\xBF\x1E");
            if (first) is_json = start == std::string::npos || begin[start] == '{';
            if (is_json) members.read(block.data(), count);
        }
        all.insert(all.end(), members.found().begin(), members.found().end());
    }
    CSLDestroy(files);
    return all;
}

/// Returns the CRS name that the member contains; none if its kind is unknown.
std::optional<std::string> name_in(const std::string& member) {
    const auto json = nlohmann::json::parse(member, nullptr, false);
    const auto at = [&](const char* pointer) -> std::optional<std::string> {
        const nlohmann::json::json_pointer place(pointer);
        if (!json.contains(place)) return std::nullopt;
        return json[place].is_string() ? json[place].get<std::string>() : json[place].dump();
    };
    const auto of = [&](const char* key) { return at((std::string("/properties/") + key).c_str()); };
    const std::string type = at("/type").value_or("");
    if (EQUAL(type.c_str(), "name")) return of("name");
    if (EQUAL(type.c_str(), "OGC")) return of("urn");
    if (EQUAL(type.c_str(), "EPSG")) {
        const auto code = of("code");
        return code ? std::optional<std::string>("EPSG:" + *code) : std::nullopt;
    }
    return std::nullopt;
}

bool is_link(const std::string& member) {
    return member.find("\"link\"") != std::string::npos || member.find("\"URL\"") != std::string::npos;
}

/// Whether a name is known and, if it is not at the top, whether it is that of the layer.
bool is_understood(const std::string& name, const OGRSpatialReference* layers, bool at_top) {
    const GdalSession session;
    OGRSpatialReference crs;
    const char* const access[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
    if (name.empty() || crs.SetFromUserInput(name.c_str(), access) != OGRERR_NONE) return false;
    const char* const alike[] = {"CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
                                 "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
    return at_top || (layers != nullptr && crs.IsSame(layers, alike) != 0);
}

}  // namespace

std::string declared_crs(GDALDataset& dataset, OGRLayer& layer, const VectorSource& source, const std::string& key) {
    const OGRSpatialReference* const crs = layer.GetSpatialRef();
    const std::string driver = dataset.GetDriverName();
    if (driver != "GeoJSON" && driver != "GeoJSONSeq" && driver != "OGR_VRT") return layer_crs(crs);
    for (const JsonMember& member : crs_members(dataset)) {
        if (member.text == "null") return {};  // GeoJSON's value for "unknown"
        const bool at_top = member.at_top && driver != "GeoJSONSeq";
        if (at_top && is_link(member.text)) continue;  // GDAL follows it, or it was refused
        const auto name = name_in(member.text);
        if (name && is_understood(*name, crs, at_top)) continue;
        constexpr std::size_t k_printed = 200;
        throw vector_error(source,
                           at_top ? "the file's coordinate reference system is unknown"
                                  : "a coordinate reference system within the file differs from the layer's",
                           name.value_or(member.text.substr(0, k_printed)), crs_remedy(source, key));
    }
    return layer_crs(crs);
}

std::string crs_remedy(const VectorSource& source, const std::string& key) {
    const std::string ending = source.file.substr(source.file.find_last_of('.') + 1);
    const bool is_shapefile = EQUAL(ending.c_str(), "shp") || EQUAL(ending.c_str(), "shz");
    return (is_shapefile ? "Correct or add its .prj file" : "Write the file again with the right one") +
           std::string(" (ogr2ogr -a_srs EPSG:...)") +
           (key.empty() ? "" : ", or state it in the scene (" + key + " = EPSG:...)");
}

}  // namespace frana::gis
