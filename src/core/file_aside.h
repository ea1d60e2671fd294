// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace frana {

/// A file in the making in the folder of its final place. It takes its name when complete and vanishes otherwise, so
/// that no reader meets half a file and a failed run leaves the old one. Where the file system can, it has no name
/// until then and vanishes with the program, however that ends; else it is NAME.partialPID.EXTENSION, and what killed
/// programs have left of the same file is removed by the next one that writes it.
class FileAside {
  public:
    enum class Kind {
        unnamed,  ///< if it can be
        named,    ///< to be made under partial_path() by whoever writes it
    };
    /// Never fails: what hinders shows when the file is written.
    explicit FileAside(std::string path, Kind kind = Kind::unnamed);
    ~FileAside();
    FileAside(const FileAside&) = delete;
    FileAside& operator=(const FileAside&) = delete;

    [[nodiscard]] const std::string& path() const noexcept { return path_; }             ///< final
    [[nodiscard]] const std::string& partial_path() const noexcept { return partial_; }  ///< to be opened and written
    /// Waits until the bytes are on the disk. Throws Error(environment) when the disk could not take them.
    void bring_to_disk() const;
    /// Throws Error(environment) when the file cannot take its name.
    void rename_into_place();

  private:
    void open_without_name();
    [[noreturn]] void fail(const std::string& what, int reason) const;

    std::string path_, named_, partial_;
    int descriptor_ = -1;  ///< of the file without a name
    bool done_ = false;
};

/// What a name of the form NAME.partialPID.EXTENSION says.
struct FileInMaking {
    std::string name;  ///< that the file was to get
    bool is_beside;    ///< a library's own file beside it: NAME.partialPID.gpkg-journal
    bool abandoned;    ///< its process runs no more
};
/// None where a name is not of that form.
std::optional<FileInMaking> file_in_making(const std::string& name);

enum class Sync { no, yes };

/// Writes a whole file aside, sees that every byte was taken, brings it to the disk if asked to, and gives it its name.
/// Throws Error(environment).
void write_file(const std::string& path, std::string_view bytes, Sync sync = Sync::no);

}  // namespace frana
