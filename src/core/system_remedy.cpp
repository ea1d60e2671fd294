// SPDX-License-Identifier: Apache-2.0
#include "core/system_remedy.h"

#include <cerrno>

namespace frana {

std::string system_remedy(int reason) {
    switch (reason) {
        case ENOMEM:
            return "Memory ran out: end other programs, allow more (ulimit -v), or choose larger cells "
                   "(terrain.cell-size) or smaller pictures (output.map-size)";
        case EAGAIN:
            return "The system gave no thread: allow more (ulimit -u, ulimit -v) or take fewer --threads";
        case EMFILE:
        case ENFILE:
            return "Too many files are open: allow more (ulimit -n)";
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return "Make room on the disk, then give the same command again";
        case EACCES:
        case EPERM:
        case EROFS:
            return "Check the rights of the file and its folder";
        case EINTR:
            return "Give the same command again";
        case EIO:
            return "The disk or the network could not be read or written: look at it, then give the same "
                   "command again";
        default:
            return "Check the place's rights and free space";
    }
}

}  // namespace frana
