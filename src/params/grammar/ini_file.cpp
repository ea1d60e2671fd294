// SPDX-License-Identifier: Apache-2.0
#include "params/grammar/ini_file.h"

#include <algorithm>
#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"

namespace frana {

std::optional<SourceSpec> source_from_text(const std::string& text) {
    using Kind = SourceSpec::Kind;
    if (const auto number = number_from_text(text)) return SourceSpec{Kind::number, *number, ""};
    const auto colon = text.find(':');
    if (colon == std::string::npos) return std::nullopt;
    const std::string word = text.substr(0, colon), rest = trimmed(text.substr(colon + 1));
    if (rest.empty()) return std::nullopt;
    if (word == "attribute") return SourceSpec{Kind::attribute, 0, rest};
    if (word == "raster") return SourceSpec{Kind::raster, 0, rest};
    if (word == "table") return SourceSpec{Kind::table, 0, rest};
    return std::nullopt;
}

std::string text_of(const SourceSpec& source) {
    switch (source.kind) {
        case SourceSpec::Kind::attribute:
            return "attribute:" + source.name;
        case SourceSpec::Kind::raster:
            return "raster:" + source.name;
        case SourceSpec::Kind::table:
            return "table:" + source.name;
        case SourceSpec::Kind::number:
            break;
    }
    return shortest_text(source.number);
}

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

namespace {

constexpr std::uintmax_t k_most_bytes = 10'000'000;

// The library cuts a line at any '#'. No UTF-8 text contains these bytes.
const std::string k_number_sign = "\xFF\xFE\xFF";

/// A '#' within a word belongs to it, as in the name of a folder; at the start of a line or after a space it starts a
/// comment.
std::string with_signs_in_words_kept(const std::string& text) {
    std::string kept;
    bool comment = false, space = true;
    for (const char c : text) {
        const bool sign = c == '#', end = c == '\n';
        comment = !end && (comment || (sign && space));
        space = end || c == ' ' || c == '\t' || c == '\r';
        kept += sign && !comment ? k_number_sign : std::string(1, c);
    }
    return kept;
}

std::string with_signs_back(std::string value) {
    for (auto at = value.find(k_number_sign); at != std::string::npos; at = value.find(k_number_sign, at))
        value.replace(at, k_number_sign.size(), "#");
    return value;
}

}  // namespace

std::vector<IniEntry> read_ini(const std::string& path) {
    namespace options = boost::program_options;
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw Error(ErrorKind::input, Problem{"is a folder, not a file", path, "", "", "Name the .ini file in it"});
    if (std::filesystem::is_other(path, ignored))
        throw Error(ErrorKind::input, Problem{"is not a regular file", path, "", "",
                                              "Copy the content of the FIFO, device or socket into a file"});
    if (const auto bytes = std::filesystem::file_size(path, ignored); !ignored && bytes > k_most_bytes)
        throw Error(ErrorKind::input, Problem{"is too long for a scene", path, std::to_string(bytes) + " bytes",
                                              "up to " + std::to_string(k_most_bytes), "A scene is an INI file"});
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw Error(ErrorKind::input,
                    Problem{"cannot be opened", path, "", "", "Check that the file exists and may be read"});
    std::stringstream content;
    content << file.rdbuf();
    std::string text = content.str();
    if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);  // byte order mark of Windows editors
    if (text.find('\0') != std::string::npos)
        throw Error(ErrorKind::input, Problem{"is not a text file", path, "", "", "A scene is an INI file"});

    std::vector<IniEntry> entries;
    try {
        std::istringstream stream(with_signs_in_words_kept(text));
        // No option is registered: the caller matches the keys and can suggest the nearest one.
        const auto parsed = options::parse_config_file(stream, options::options_description{}, true);
        for (const auto& option : parsed.options)
            entries.push_back({with_signs_back(option.string_key),
                               option.value.empty() ? "" : with_signs_back(trimmed(option.value.front()))});
    } catch (const options::error& error) {
        throw Error(ErrorKind::input, Problem{with_signs_back(error.what()), path, "",
                                              "[section], key = value or # comment", "Correct the line"});
    }
    return entries;
}

}  // namespace frana
