// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace frana::test {

/// Which system calls are watched before they are made.
struct Watch {
    bool changes = true;  ///< everything that changes the disk: write, rename, fsync, unlink, mkdir and similar
    bool reads = false;   ///< openat, read, pread64, getdents64
    bool memory = false;  ///< mmap of 128 KiB and more that belong to no file
};

/// From now on every watched call of this process and its children waits for an answer at the returned descriptor
/// (seccomp_unotify(2); nothing is injected into the program itself, so that its own calls and those of its libraries
/// are both watched). Returns -1, with errno, if the system does not allow it.
int watch_own_calls(const Watch& watch);

/// Returns a call's name; "" for one that is never watched.
std::string call_name(int number);

/// Where a call has its file.
struct CallPlace {
    enum class Kind { path, descriptor, memory } kind = Kind::path;
    int argument = 0;  ///< of the path, or of the descriptor
    int folder = -1;   ///< argument of the descriptor to which a relative path refers; -1: the current folder
};
CallPlace call_place(int number);

}  // namespace frana::test
