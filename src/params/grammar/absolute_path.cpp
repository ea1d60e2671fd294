// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/absolute_path.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>

#include "params/grammar/value_text.h"

namespace frana {
namespace {

std::string counted_from(const std::string& path, const std::string& directory) {
    if (path.rfind('/', 0) == 0) return path;
    return (std::filesystem::path(directory) / trimmed(path)).lexically_normal().string();
}

/// Returns the length of a leading "/vsizip/", "/vsigzip/" or similar, which precedes a path of its own.
std::size_t archive_prefix(const std::string& path) {
    std::size_t length = 0;
    for (bool more = true; more;) {
        more = false;
        for (const std::string prefix : {"/vsizip/", "/vsigzip/", "/vsitar/", "/vsi7z/", "/vsirar/"}) {
            if (path.compare(length, prefix.size(), prefix) != 0) continue;
            length += prefix.size();
            more = true;
        }
    }
    return length;
}

/// Returns where the file name begins and ends in DRIVER:"file":part or DRIVER:file:part; {0, 0}: not of this form.
std::pair<std::size_t, std::size_t> named_file(const std::string& path, std::size_t colon) {
    const std::size_t quote = path.find('"');
    if (quote != std::string::npos && path.find('"', quote + 1) != std::string::npos)
        return {quote + 1, path.find('"', quote + 1)};
    const std::string driver = path.substr(0, colon);
    std::size_t begin = colon + 1;
    if (driver == "GTIFF_DIR") {
        begin = path.find(':', begin) + 1;
    } else if (driver != "NETCDF" && driver != "HDF5" && driver != "GPKG") {
        return {0, 0};
    }
    if (begin == 0) return {0, 0};
    const std::size_t end = path.find(':', begin);
    return {begin, end == std::string::npos ? path.size() : end};
}

}  // namespace

namespace {

/// Replaces the path within GDAL's syntax.
std::string replaced(const std::string& path, const std::function<std::string(const std::string&)>& place) {
    if (const std::size_t prefix = archive_prefix(path); prefix > 0)
        return path.substr(0, prefix) + place(path.substr(prefix));
    const std::size_t colon = path.find(':');
    const bool driver = colon != std::string::npos && colon >= 2 &&
                        std::all_of(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(colon),
                                    [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    if (driver) {
        const auto [begin, end] = named_file(path, colon);
        if (end <= begin) return path;
        return path.substr(0, begin) + place(path.substr(begin, end - begin)) + path.substr(end);
    }
    const std::size_t bar = path.find('|');
    const std::string suffix = bar == std::string::npos ? "" : path.substr(bar);
    return place(path.substr(0, bar)) + suffix;
}

}  // namespace

std::string absolute_path(const std::string& path, const std::string& directory) {
    return replaced(path, [&](const std::string& part) { return counted_from(part, directory); });
}

std::string relative_path(const std::string& path, const std::string& directory) {
    return replaced(path, [&](const std::string& part) {
        if (part.rfind('/', 0) != 0 || part.rfind("/vsi", 0) == 0) return part;
        namespace fs = std::filesystem;
        std::error_code error;
        const fs::path base = fs::absolute(directory).lexically_normal();
        const fs::path relative = fs::path(part).lexically_relative(base);
        const fs::path there = fs::weakly_canonical(base / relative, error), here = fs::weakly_canonical(part, error);
        return relative.empty() || error || there != here ? part : relative.string();
    });
}

std::string plain_file(const std::string& path) {
    if (archive_prefix(path) > 0) return "";
    std::string file;
    replaced(path, [&](const std::string& part) { return file = part; });
    return file.rfind("/vsi", 0) == 0 ? "" : file;
}

}  // namespace frana
