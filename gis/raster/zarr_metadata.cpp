// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/zarr_metadata.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/json.h"

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

}  // namespace

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

}  // namespace frana::gis
