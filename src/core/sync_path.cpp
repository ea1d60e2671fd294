// SPDX-License-Identifier: Apache-2.0
#include "core/sync_path.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace frana {
namespace {

// Descriptors opened for reading only, and file systems that do not support syncing, are not disk problems.
bool is_disk_problem(int reason) {
    return reason == EIO || reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
}

}  // namespace

int sync_descriptor(int descriptor) {
    int reason = 0;
    do reason = ::fsync(descriptor) == 0 ? 0 : errno;
    while (reason == EINTR);
    return is_disk_problem(reason) ? reason : 0;
}

int sync_path(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return 0;
    const int reason = sync_descriptor(descriptor);
    ::close(descriptor);
    return reason;
}

}  // namespace frana
