// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace frana::app {

/// The content of manifest.json of a result: the program that wrote it, the scene, and every file written by the
/// program. A folder with a manifest is a result; files not listed, or of another size than listed, belong to the user.
struct Manifest {
    std::string scene_hash;  ///< as in the rasters' metadata
    double simulated_seconds = 0;
    bool finished = false;  ///< complete: checkpoints that still exist only have to be removed
    /// Sizes [bytes] by path inside the result, with '/' between folders; none: frana is writing it, or was when it was
    /// killed.
    std::map<std::string, std::optional<std::uint64_t>> files;
};

/// Escapes a name as in URLs: file names are bytes, and JSON supports only Unicode.
std::string escaped_name(const std::string& name);
/// Returns the unescaped name. Throws std::exception for an invalid text.
std::string unescaped_name(const std::string& text);

/// Whether a file is as it was listed.
bool is_as_listed(const std::string& path, const std::optional<std::uint64_t>& bytes);

/// Returns the size of a file after its bytes are synced to the disk: listed files survive a power failure. Throws
/// Error(environment).
std::uint64_t size_on_disk(const std::string& path);

/// Returns a folder's manifest; none if there is none, it is not readable, not frana's, or of an unknown format. Throws
/// Error(environment) for a read error of the disk.
std::optional<Manifest> read_manifest(const std::string& folder);

/// Writes it atomically and syncs it to the disk. Throws Error(environment).
void write_manifest(const std::string& folder, const Manifest& manifest);

/// Notes that files will be written, so that those of a killed program are known as frana's; record_files ends it. The
/// same files and results as there.
void note_in_making(const std::vector<std::string>& paths);

/// Adds files just written to the manifest of the result that contains them, with their sizes; those outside results,
/// or in results without a manifest, are ignored. Several programs may do so at once. Throws Error(environment).
void record_files(const std::vector<std::string>& paths);

/// Returns those files that are in a result with a manifest, exist, and differ from it.
std::vector<std::string> changed_files(const std::vector<std::string>& paths);

/// Removes files that no longer exist from a result's manifest. Throws Error(environment).
void remove_from_manifest(const std::string& folder, const std::vector<std::string>& names);

}  // namespace frana::app
