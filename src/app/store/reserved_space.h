// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace frana::app {

/// Room on a disk, taken while there is some, for a file that must be written when there is none: a file of that size
/// whose blocks are there, which is written over under another name. Goes when this goes.
class ReservedSpace {
  public:
    explicit ReservedSpace(std::string path) : path_(std::move(path)) {}
    ~ReservedSpace() { release(); }
    ReservedSpace(const ReservedSpace&) = delete;
    ReservedSpace& operator=(const ReservedSpace&) = delete;

    [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }
    /// Makes it at least so large; where there is no room, or not as much again for the results, it stays as it is, and
    /// this is false, with errno.
    bool grow(std::uint64_t bytes);
    /// Makes it the file `path`, which is as large as it was and is to be written over; false: there is none.
    bool become(const std::string& path);
    void release();

  private:
    std::string path_;
    std::uint64_t bytes_ = 0;
};

}  // namespace frana::app
