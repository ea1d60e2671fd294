// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace frana::app {

/// What this program may hold in all [bytes], and who says so.
struct MemoryBound {
    double bytes = 0;
    std::string what;  ///< "the machine has free", for messages
};

/// The least of what the machine has free (with its swap), what a control group of this process or one above
/// it (cgroup v1, v2) leaves, and the shell's limits on address space and data (ulimit -v, -d); each with
/// what this process already holds. `root`: the folder that holds proc and sys.
MemoryBound machine_memory(const std::string& root = "/");

/// What this process holds now [bytes].
std::int64_t resident_memory(const std::string& root = "/");

/// Where the shell limits mapped memory (ulimit -v): the threads share what they allocate from, for each
/// would map much more than it uses. To be called before there are threads.
void map_sparingly();

}  // namespace frana::app
