// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace frana::test {

/// Which calls to the system somebody wants to see before they happen.
struct Watch {
    bool changes = true;  ///< whatever changes what is on disk: write, rename, fsync, unlink, mkdir and their like
    bool reads = false;   ///< openat, read, pread64, getdents64
    bool memory = false;  ///< mmap of 128 KiB and more that belong to no file
};

/// From now on every watched call of this process and its children waits for an answer at the descriptor that
/// is returned (seccomp_unotify(2); nothing is injected into the program itself, so that its own and its
/// libraries' calls are seen alike). -1, with errno, where the system does not let us.
int watch_own_calls(const Watch& watch);

/// A call's name; "" for one that is never watched.
std::string call_name(int number);

/// Where a call has the file it is about.
struct CallPlace {
    enum class Kind { path, descriptor, memory } kind = Kind::path;
    int argument = 0;  ///< of the path, or of the descriptor
    int folder = -1;   ///< argument of the descriptor that a relative path counts from; -1: the current folder
};
CallPlace call_place(int number);

}  // namespace frana::test
