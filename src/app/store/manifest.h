// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace frana::app {

/// Identifies the content of a file.
struct FileMark {
    std::uint64_t bytes = 0;
    std::string checksum;  ///< XXH3, 128 bits, as `xxh128sum` prints it

    bool operator==(const FileMark&) const = default;
};

/// The content of manifest.json of a result: the program that wrote it, the scene, and every file written by the
/// program. A folder with a manifest is a result; files not listed, or different from the list, belong to the user.
struct Manifest {
    std::string scene_hash;  ///< as in the rasters' metadata
    double simulated_seconds = 0;
    /// Complete; checkpoints that still exist only have to be removed; none: of an older frana without this field.
    std::optional<bool> finished;
    std::map<std::string, FileMark> files;  ///< by path inside the result, with '/' between folders
    std::set<std::string> in_making{};      ///< names that frana is writing, or was when it was killed
};

/// Escapes a name as in URLs: file names are bytes, and JSON supports only Unicode.
std::string escaped_name(const std::string& name);
/// Returns the unescaped name. Throws std::exception for an invalid text.
std::string unescaped_name(const std::string& text);

/// Returns the mark of a file's content. Throws Error(environment) if it cannot be read.
FileMark mark_of(const std::string& path);

/// Whether a file is as it was listed. Of a GeoPackage also if a GIS only showed it: SQLite then changes the journal
/// mode in the header and counts there. Throws Error(environment) if it cannot be read.
bool is_as_listed(const std::string& path, const FileMark& listed);

/// Returns the mark of a file's content after its bytes are synced to the disk: listed files survive a power failure.
FileMark mark_on_disk(const std::string& path);

/// Returns a folder's manifest; none if there is none, it is not readable, not frana's, or of an unknown format. Throws
/// Error(environment) for a read error of the disk.
std::optional<Manifest> read_manifest(const std::string& folder);

/// Writes it atomically and syncs it to the disk. Throws Error(environment).
void write_manifest(const std::string& folder, const Manifest& manifest);

/// Returns whether a folder is a complete result with a list of files.
bool is_listed_result(const std::string& folder);

/// Notes that files will be written, so that those of a killed program are known as frana's; record_files ends it. The
/// same files and results as there.
void note_in_making(const std::vector<std::string>& paths);

/// Adds files just written to the manifest of the result that contains them, with their marks; those outside results,
/// or in results without a manifest, are ignored. Several programs may do so at once. Throws Error(environment).
void record_files(const std::vector<std::string>& paths);

/// Returns those files that are in a result with a manifest, exist, and differ from it.
std::vector<std::string> changed_files(const std::vector<std::string>& paths);

/// Removes files that no longer exist from a result's manifest. Throws Error(environment).
void remove_from_manifest(const std::string& folder, const std::vector<std::string>& names);

/// Marks a result as complete in its manifest. Throws Error(environment).
void record_finished(const std::string& folder);

}  // namespace frana::app
