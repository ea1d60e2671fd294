// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace frana {

/// The source of a quantity: one number, a column of its vector layer, a raster, or a table over time.
struct SourceSpec {
    enum class Kind { number, attribute, raster, table };
    Kind kind = Kind::number;
    double number = 0;  ///< number, in the key's unit
    std::string name;   ///< attribute: the column; raster, table: the file
};

/// Reads "12.5", "attribute:NAME", "raster:FILE" or "table:FILE"; none: invalid.
std::optional<SourceSpec> source_from_text(const std::string& text);
std::string text_of(const SourceSpec& source);

/// Makes a path given in a scene absolute, relative to `directory`. GDAL's syntax around a path is kept: a layer after
/// '|', archives ("/vsizip/tiles.zip/dtm.tif", the archive's path made absolute), rasters inside a file
/// (NETCDF:"file.nc":band). Database connections are unchanged.
std::string absolute_path(const std::string& path, const std::string& directory);

/// Returns an absolute path relative to a directory, by which a file in that directory names it; GDAL's syntax is kept
/// as above. Unchanged if the relative path would not lead to the same file (through a symbolic link).
std::string relative_path(const std::string& path, const std::string& directory);

/// Returns the file of the file system that such a path names: "/data/tiles.zip" of "/vsizip//data/tiles.zip/dtm.tif"
/// is not found, but "/data/release.gpkg" of "/data/release.gpkg|layer=a" is. Empty: a database or a service.
std::string plain_file(const std::string& path);

/// One "key = value" of an INI file, with the section in the name.
struct IniEntry {
    std::string name;   ///< "section.key"; only the key before the first section
    std::string value;  ///< trimmed; may be empty
};

/// Returns the entries of an INI file in their order, duplicates included, uninterpreted. '#' starts a comment. Throws
/// Error(input) if the file cannot be read or a line is neither a section, an entry nor a comment.
std::vector<IniEntry> read_ini(const std::string& path);

}  // namespace frana
