// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// A file in the making beside its final place. It takes its name when complete and vanishes otherwise, so
/// that no reader meets half a file and a failed run leaves the old one. The extension stays last, as some
/// formats insist. What a process that was killed left of the same file goes before.
class FileAside {
  public:
    explicit FileAside(std::string path);
    ~FileAside();
    FileAside(const FileAside&) = delete;
    FileAside& operator=(const FileAside&) = delete;

    [[nodiscard]] const std::string& path() const noexcept { return path_; }             ///< final
    [[nodiscard]] const std::string& partial_path() const noexcept { return partial_; }  ///< while written
    /// Throws Error(environment) when the file cannot take its name.
    void rename_into_place();

  private:
    std::string path_, partial_;
    bool done_ = false;
};

}  // namespace frana
