// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace frana::app {

/// What a file is known again by.
struct FileMark {
    std::uint64_t bytes = 0;
    std::string checksum;  ///< XXH3, 128 bits, as `xxh128sum` prints it

    bool operator==(const FileMark&) const = default;
};

/// What a result says of itself in manifest.json: which program wrote it, of which scene, and every file that
/// is the program's. Who has it has a finished result; what is not in it, or not as it says any more, is the
/// user's.
struct Manifest {
    std::string scene_hash;  ///< as in the rasters' metadata
    double simulated_seconds = 0;
    /// All is there, and checkpoints that still are have only to be removed; none: an older frana's, which
    /// did not say.
    std::optional<bool> finished;
    std::map<std::string, FileMark> files;  ///< by path inside the result, with '/' between folders
};

/// A name as URLs write it: names are bytes to the system, and JSON knows only Unicode.
std::string escaped_name(const std::string& name);
/// The name again. Throws std::exception where the text is not of that kind.
std::string unescaped_name(const std::string& text);

/// The mark of a file's content. Throws Error(environment) where it cannot be read.
FileMark mark_of(const std::string& path);

/// The same, after the file's bytes are on the disk: what is listed outlasts a power cut.
FileMark mark_on_disk(const std::string& path);

/// A folder's manifest; none where there is none that this program may read, or not frana's, or of a format
/// that this frana does not know. Throws Error(environment) where there is one and the disk does not give it.
std::optional<Manifest> read_manifest(const std::string& folder);

/// Writes it in one go, to the disk. Throws Error(environment).
void write_manifest(const std::string& folder, const Manifest& manifest);

/// Whether a folder is a finished result that tells its files.
bool is_listed_result(const std::string& folder);
/// Whether a folder is the result of a frana that did not list files yet: its summary.json names the program.
bool is_unlisted_result(const std::string& folder);

/// Adds files that were just written to the manifest of the result that they lie in, with their marks; those
/// outside results, or in results without a manifest, are left out. Several programs may do so at once.
/// Throws Error(environment).
void record_files(const std::vector<std::string>& paths);

/// Of these files those that lie in a result with a manifest, are there, and are not as it says.
std::vector<std::string> changed_files(const std::vector<std::string>& paths);

/// Takes files out of a result's manifest: they are no more. Throws Error(environment).
void remove_from_manifest(const std::string& folder, const std::vector<std::string>& names);

/// Says in a result's manifest that all is there. Throws Error(environment).
void record_finished(const std::string& folder);

}  // namespace frana::app
