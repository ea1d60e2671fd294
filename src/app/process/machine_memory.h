// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace frana::app {

/// The memory this program may use in total [bytes], and its source.
struct MemoryBound {
    double bytes = 0;
    std::string what;  ///< "the machine has free", for messages
};

/// Returns the least of the machine's free memory (including swap), the room in the control group of this process and
/// those above it (cgroup v1, v2), and the shell's limits on address space and data (ulimit -v, -d); each plus the
/// memory this process already uses. `root`: the folder that contains proc and sys.
MemoryBound machine_memory(const std::string& root = "/");

/// Returns the addresses that this process may still map, whether it touches them or not [bytes]: the shell's limits
/// (ulimit -v, -d), and the system's where it grants no more than it has (vm.overcommit_memory = 2). Infinity: any.
double address_room(const std::string& root = "/");

/// Returns the memory in use by this process [bytes].
std::int64_t resident_memory(const std::string& root = "/");

/// If the shell limits mapped memory (ulimit -v), makes the threads share their allocation arenas, for each would map
/// much more than it uses. Must be called before there are threads.
void map_sparingly();

}  // namespace frana::app
