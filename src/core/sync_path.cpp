// SPDX-License-Identifier: Apache-2.0
#include "core/sync_path.h"

#include <fcntl.h>
#include <unistd.h>

namespace frana {

void sync_path(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace frana
