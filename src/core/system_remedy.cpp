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
            return "The system refused a thread: allow more (ulimit -u, ulimit -v) or use fewer --threads";
        case EMFILE:
        case ENFILE:
            return "Too many files are open: allow more (ulimit -n)";
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return "Free some disk space, then repeat the command";
        case EACCES:
        case EPERM:
        case EROFS:
            return "Check the rights of the file and its folder";
        case EINTR:
            return "Repeat the command";
        case EIO:
            return "The disk or the network could not be read or written: check it, then repeat the command";
        default:
            return "Check the place's rights and free space";
    }
}

}  // namespace frana
