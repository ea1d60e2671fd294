// SPDX-License-Identifier: Apache-2.0
#include "app/process/machine_memory.h"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr double k_none = std::numeric_limits<double>::infinity();

// Returns the number after a word at the beginning of a line [bytes]; the unit kB is 1024 bytes.
std::optional<double> number_after(const fs::path& file, const std::string& word) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name, unit;
        double value = 0;
        if (!(words >> name >> value) || name != word) continue;
        words >> unit;
        return unit == "kB" ? 1024 * value : value;
    }
    return std::nullopt;
}

// "max" and values beyond any machine are no limit.
double limit_in(const fs::path& file) {
    std::ifstream in(file);
    double value = 0;
    return in >> value && value < 0x1p60 ? value : k_none;
}

// Returns the memory that a group may still allocate: its limit minus its usage, without the files cached in memory,
// which are released.
double room_in(const fs::path& group, const char* limit_file, const char* usage_file, const char* prefix) {
    const double limit = limit_in(group / limit_file);
    if (limit == k_none) return k_none;
    const double usage = limit_in(group / usage_file);
    if (usage == k_none) return limit;
    double files = 0;
    for (const char* kind : {"inactive_file", "active_file"})
        files += number_after(group / "memory.stat", std::string(prefix) + kind).value_or(0);
    return std::max(0.0, limit - std::max(0.0, usage - files));
}

// Returns the least over a group and those above it. A container may not have access to its own group's folder, only to
// the root.
double room_above(const fs::path& tree, const std::string& path, const char* limit, const char* usage,
                  const char* prefix) {
    double room = room_in(tree, limit, usage, prefix);
    fs::path group = tree;
    for (const fs::path& part : fs::path(path).relative_path()) {
        group /= part;
        room = std::min(room, room_in(group, limit, usage, prefix));
    }
    return room;
}

double group_room(const fs::path& root) {
    double room = k_none;
    std::ifstream in(root / "proc/self/cgroup");
    for (std::string line; std::getline(in, line);) {
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string kinds = line.substr(first + 1, second - first - 1), path = line.substr(second + 1);
        if (kinds.empty())
            room = std::min(room, room_above(root / "sys/fs/cgroup", path, "memory.max", "memory.current", ""));
        else if (kinds.find("memory") != std::string::npos)
            room = std::min(room, room_above(root / "sys/fs/cgroup/memory", path, "memory.limit_in_bytes",
                                             "memory.usage_in_bytes", "total_"));
    }
    return room;
}

// Returns the part of the shell's limit on mapped memory available for pages in use: libraries and stacks map more than
// they use.
double shell_room(const fs::path& root, int resource, const std::string& mapped) {
    rlimit shell{};
    if (::getrlimit(static_cast<__rlimit_resource>(resource), &shell) != 0 || shell.rlim_cur == RLIM_INFINITY)
        return k_none;
    return std::max(0.0,
                    static_cast<double>(shell.rlim_cur) - number_after(root / "proc/self/status", mapped).value_or(0));
}

}  // namespace

std::int64_t resident_memory(const std::string& root) {
    return static_cast<std::int64_t>(number_after(fs::path(root) / "proc/self/status", "VmRSS:").value_or(0));
}

void map_sparingly() {
    if (shell_room("/", RLIMIT_AS, "VmSize:") != k_none) ::mallopt(M_ARENA_MAX, 1);
}

double address_room(const std::string& root) {
    const fs::path system(root), info = system / "proc/meminfo";
    double room = std::min(shell_room(system, RLIMIT_AS, "VmSize:"), shell_room(system, RLIMIT_DATA, "VmData:"));
    constexpr double k_strictly = 2;
    if (limit_in(system / "proc/sys/vm/overcommit_memory") == k_strictly) {
        const auto most = number_after(info, "CommitLimit:"), given = number_after(info, "Committed_AS:");
        if (most && given) room = std::min(room, std::max(0.0, *most - *given));
    }
    return room;
}

MemoryBound machine_memory(const std::string& root) {
    const fs::path system(root), info = system / "proc/meminfo";
    const double all = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE)),
                 in_use = static_cast<double>(resident_memory(root));
    const auto free = number_after(info, "MemAvailable:");
    MemoryBound bound{free ? *free + number_after(info, "SwapFree:").value_or(0) + in_use : all,
                      "the machine has free"};
    const auto lower = [&](double room, const char* what) {
        if (room + in_use < bound.bytes) bound = {room + in_use, what};
    };
    lower(group_room(system), "the control group of this process leaves");
    lower(shell_room(system, RLIMIT_AS, "VmSize:"), "the shell allows (ulimit -v)");
    lower(shell_room(system, RLIMIT_DATA, "VmData:"), "the shell allows (ulimit -d)");
    return bound;
}

}  // namespace frana::app
