// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/zarr_metadata.h"

#include <cpl_json.h>

#include <cstdint>
#include <cstdio>
#include <fstream>

#include "core/error.h"
#include "gis/access/gdal_session.h"

namespace frana::gis {
namespace {

constexpr const char* k_dimensions = "_ARRAY_DIMENSIONS";

void append_unit(std::string& text, std::uint32_t unit) {
    char escaped[8];
    std::snprintf(escaped, sizeof escaped, "\\u%04x", unit & 0xffffU);
    text += escaped;
}

[[noreturn]] void refuse(const std::string& file) {
    throw Error(ErrorKind::environment, Problem{"the frames' metadata cannot be written", file, "", "",
                                                "Check that the folder exists, may be written and has room"});
}

void write(const std::string& file, const CPLJSONObject& content) {
    std::ofstream out(file, std::ios::binary);
    out << ascii_json(content.Format(CPLJSONObject::PrettyFormat::Pretty)) << '\n';
    out.close();
    if (!out) refuse(file);
}

}  // namespace

std::string ascii_json(const std::string& json) {
    std::string text;
    for (std::size_t i = 0; i < json.size();) {
        const auto first = static_cast<unsigned char>(json[i++]);
        if (first < 0x80) {
            text += static_cast<char>(first);
            continue;
        }
        const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
        std::uint32_t code = first & (0x3fU >> more);
        for (int k = 0; k < more && i < json.size(); ++k)
            code = code << 6U | (static_cast<unsigned char>(json[i++]) & 0x3fU);
        if (code > 0xffff) {
            code -= 0x10000;
            append_unit(text, 0xd800 + (code >> 10U));
            append_unit(text, 0xdc00 + (code & 0x3ffU));
        } else {
            append_unit(text, code);
        }
    }
    return text;
}

void finish_zarr_metadata(const std::string& folder) {
    const GdalSession session;
    const std::string all = folder + "/.zmetadata", attributes = "/.zattrs", array = "/.zarray";
    CPLJSONDocument document;
    if (!document.Load(all)) refuse(all);
    const CPLJSONObject root = document.GetRoot();
    const std::vector<CPLJSONObject> parts = root.GetObj("metadata").GetChildren();
    for (const CPLJSONObject& shape : parts) {
        const std::string name = shape.GetName();
        if (!name.ends_with(array) || shape.GetArray("shape").Size() > 0) continue;
        for (CPLJSONObject part : parts)
            if (part.GetName() == name.substr(0, name.size() - array.size()) + attributes)
                part.Add(k_dimensions, CPLJSONArray());
    }
    for (const CPLJSONObject& part : parts) write(folder + "/" + part.GetName(), part);
    write(all, root);
}

}  // namespace frana::gis
