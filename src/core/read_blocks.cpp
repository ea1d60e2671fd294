// SPDX-License-Identifier: Apache-2.0
#include "core/read_blocks.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

namespace frana {

int read_blocks(const std::string& path, const std::function<void(std::string_view)>& consume) {
    int descriptor = -1;
    do descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a FIFO would wait for a writer
    while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0) return errno;
    struct stat found {};
    if (::fstat(descriptor, &found) != 0 || !S_ISREG(found.st_mode)) {
        ::close(descriptor);
        return EINVAL;
    }
    std::vector<char> block(1U << 20U);
    int reason = 0;
    for (;;) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) reason = errno;
        if (count <= 0) break;
        consume({block.data(), static_cast<std::size_t>(count)});
    }
    ::close(descriptor);
    return reason;
}

}  // namespace frana
