// SPDX-License-Identifier: Apache-2.0
// Runs and renders back to back in one process: memory does not grow, no file is left open or on the disk. Some seconds
// in the default tests; ctest -C long -R soak: half an hour of runs (FRANA_SOAK_SECONDS), a thousand renders
// (FRANA_SOAK_RENDERS).
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "app/commands/command_line.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

// Resident memory of this process [bytes].
std::int64_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::int64_t pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * ::sysconf(_SC_PAGESIZE);
}

std::ptrdiff_t entries_of(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

double asked(const char* variable, double otherwise) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? otherwise : std::atof(text);
}

// Returns frana's files in the folder for temporary ones.
std::vector<std::string> temporary_files() {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path())) {
        const std::string name = entry.path().filename().string();
        if (name.rfind("frana", 0) == 0 && name.rfind("frana_", 0) != 0) found.push_back(name);
    }
    return found;
}

class Soak : public TinyScene {
  protected:
    // Calls `once` until the time is over; memory may grow while caches fill, in the first fifth, and not afterwards.
    template <class Once>
    void repeat(const Once& once, double seconds, int at_least) {
        const auto begin = std::chrono::steady_clock::now();
        const auto passed = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        };
        int count = 0, warm = 0;
        std::int64_t after_warming = 0;
        std::ptrdiff_t open_files = 0;
        while (passed() < seconds || count < at_least) {
            once();
            ++count;
            if (after_warming == 0 && passed() > seconds / 5 && count >= at_least / 5 + 2) {
                after_warming = resident_bytes();
                open_files = entries_of("/proc/self/fd");
                warm = count;
            }
        }
        const std::int64_t grown = resident_bytes() - after_warming;
        std::printf("  %d times; memory grew by %.2f MB over the last %d, from %.1f MB\n", count,
                    static_cast<double>(grown) / 1e6, count - warm, static_cast<double>(after_warming) / 1e6);
        // Allocators keep pages in blocks of some megabytes; a leak grows with the number of calls.
        if (!k_sanitized) {
            EXPECT_LT(grown, 16'000'000 + 2'000 * static_cast<std::int64_t>(count));
        }
        EXPECT_EQ(entries_of("/proc/self/fd"), open_files);
    }
};

int command(const std::string& name, const app::Arguments& arguments) {
    for (const app::Command& one : app::commands())
        if (name == one.name) return app::run_command(one, arguments);
    return -1;
}

TEST_F(Soak, RunsInOneProcessLeaveNothingBehind) {
    write_scene(k_numbers_only);
    const auto before = temporary_files();
    repeat(
        [&] {
            ASSERT_EQ(command("run", {path("scene.ini"), "--out", path("result"), "--overwrite", "--quiet"}), 0);
        },
        asked("FRANA_SOAK_SECONDS", 3), 5);
    EXPECT_EQ(temporary_files(), before);
    for (const std::string& name : files()) EXPECT_EQ(name.find("partial"), std::string::npos) << name;
}

TEST_F(Soak, RendersInOneProcessLeaveNothingBehind) {
    write_scene(k_numbers_only);
    ASSERT_EQ(command("run", {path("scene.ini"), "--out", path("result"), "--quiet"}), 0);
    const auto before = temporary_files();
    int turn = 0;
    repeat(
        [&] {
            const char* const view = turn++ % 4 == 3 ? "3d" : "2d";
            ASSERT_EQ(command("render", {path("result"), "--map", "max_depth", "--view", view, "--size", "640x480"}),
                      0);
        },
        0, static_cast<int>(asked("FRANA_SOAK_RENDERS", 12)));
    EXPECT_EQ(temporary_files(), before);
}

}  // namespace
}  // namespace frana::test
