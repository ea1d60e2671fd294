// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace frana {

/// A file being written in the folder of its final path. It gets its name when it is complete and is removed otherwise,
/// so that no reader finds an incomplete file and a failed run keeps the old one. Where the file system supports it,
/// the file has no name until then and disappears with the process, however that ends; otherwise it is
/// NAME.partialPID.EXTENSION, and the next process that writes the same file removes the leftovers of killed processes.
class FileAside {
  public:
    enum class Kind {
        unnamed,  ///< if the file system supports it
        named,    ///< to be created at partial_path() by the caller
    };
    /// Does not throw: a problem is reported when the file is written.
    explicit FileAside(std::string path, Kind kind = Kind::unnamed);
    ~FileAside();
    FileAside(const FileAside&) = delete;
    FileAside& operator=(const FileAside&) = delete;

    [[nodiscard]] const std::string& path() const noexcept { return path_; }             ///< final
    [[nodiscard]] const std::string& partial_path() const noexcept { return partial_; }  ///< to be opened and written
    /// Waits until the bytes are on the disk. Throws Error(environment) if the disk cannot store them.
    void sync_to_disk() const;
    /// Throws Error(environment) if the file cannot be renamed.
    void rename_into_place();

  private:
    void open_without_name();
    [[noreturn]] void fail(const std::string& what, int reason) const;

    std::string path_, named_, partial_;
    int descriptor_ = -1;  ///< of the unnamed file
    bool done_ = false;
};

/// The parts of a name of the form NAME.partialPID.EXTENSION.
struct FileInMaking {
    std::string name;  ///< the final name
    bool is_beside;    ///< an auxiliary file of a library: NAME.partialPID.gpkg-journal
    bool abandoned;    ///< its process no longer runs
};
/// Returns nothing for a name not of that form.
std::optional<FileInMaking> file_in_making(const std::string& name);

/// A folder of a new name in the system's temporary folder, which only its owner may enter; it disappears with this.
/// Throws Error(environment).
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::string& path() const noexcept { return path_; }

  private:
    std::string path_;
};

enum class Sync { no, yes };

/// Writes a whole file aside, checks that every byte was written, syncs it to the disk if requested, and renames it.
/// Throws Error(environment).
void write_file(const std::string& path, std::string_view bytes, Sync sync = Sync::no);

/// Waits until an open file's bytes, or a folder's names, are on the disk and survive a power failure. Returns 0, or
/// the reason why the disk could not store them (errno); a file system that does not support syncing is not a problem.
int sync_descriptor(int descriptor);

/// The same for a file or folder given by path; one that cannot be opened is ignored.
int sync_path(const std::string& path);

/// Returns the entries of a folder, sorted by name; none if the folder does not exist. A read interrupted by a signal
/// is repeated. Throws Error(environment) if the folder cannot be read: that is not the same as empty.
std::vector<std::filesystem::directory_entry> folder_entries(const std::filesystem::path& folder);

/// Passes a file's bytes to `consume`, block by block from the beginning; a read interrupted by a signal is repeated.
/// Returns 0, or the reason why not everything could be read (errno; EINVAL: a FIFO, a device or another file that is
/// not regular).
int read_blocks(const std::string& path, const std::function<void(std::string_view)>& consume);

}  // namespace frana
