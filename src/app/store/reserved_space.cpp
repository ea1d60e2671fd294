// SPDX-License-Identifier: Apache-2.0
#include "app/store/reserved_space.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

namespace frana::app {

bool ReservedSpace::grow(std::uint64_t bytes) {
    if (bytes <= bytes_) return true;
    // Without this the results would lack the reserved space, and a run with enough for them would end.
    std::error_code error;
    const std::uint64_t free = std::filesystem::space(std::filesystem::path(path_).parent_path(), error).available;
    if (!error && free < 2 * bytes - bytes_) {
        errno = ENOSPC;
        return false;
    }
    const int file = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) return false;
    const int refusal = ::posix_fallocate(file, 0, static_cast<off_t>(bytes));
    // Some file systems keep the part that was allocated.
    const bool as_before = refusal != 0 && ::ftruncate(file, static_cast<off_t>(bytes_)) == 0;
    ::close(file);
    if (refusal == 0) {
        bytes_ = bytes;
    } else if (!as_before || bytes_ == 0) {
        release();
    }
    errno = refusal;
    return refusal == 0;
}

bool ReservedSpace::become(const std::string& path) {
    if (bytes_ == 0 || std::rename(path_.c_str(), path.c_str()) != 0) return false;
    bytes_ = 0;
    return true;
}

void ReservedSpace::release() {
    ::unlink(path_.c_str());
    bytes_ = 0;
}

}  // namespace frana::app
