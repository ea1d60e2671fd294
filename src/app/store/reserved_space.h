// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace frana::app {

/// Space on a disk, reserved while available, for a file that must be written when there is none: a file of that size
/// with allocated blocks, which is overwritten under another name. Released by the destructor.
class ReservedSpace {
  public:
    explicit ReservedSpace(std::string path) : path_(std::move(path)) {}
    ~ReservedSpace() { release(); }
    ReservedSpace(const ReservedSpace&) = delete;
    ReservedSpace& operator=(const ReservedSpace&) = delete;

    [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }
    /// Enlarges it to at least this size; if there is no space, or not the same amount again for the results, it is
    /// unchanged and false is returned, with errno.
    bool grow(std::uint64_t bytes);
    /// Renames it to `path`, with its size, to be overwritten; false: there is none.
    bool become(const std::string& path);
    void release();

  private:
    std::string path_;
    std::uint64_t bytes_ = 0;
};

}  // namespace frana::app
