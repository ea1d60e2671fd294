// SPDX-License-Identifier: Apache-2.0
#include "core/file_aside.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace frana {
namespace {

namespace fs = std::filesystem;

/// The number of a process that is no more.
std::string gone_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return std::to_string(child);
}

TEST(FileAside, RemovesWhatKilledProcessesLeftOfTheSameFileOnly) {
    const fs::path folder = fs::temp_directory_path() / ("frana_aside_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::string gone = gone_process(), running = std::to_string(::getppid());
    const auto make = [&](const std::string& name) { std::ofstream(folder / name) << "x"; };
    const auto there = [&](const std::string& name) { return fs::exists(folder / name); };
    for (const std::string& name :
         {"map.partial" + gone + ".png", "map.partial" + running + ".png", "other.partial" + gone + ".png",
          std::string("map.partial.png"), "map.partial" + gone + "a.png", "map.partial" + gone + ".csv"})
        make(name);
    {
        FileAside aside((folder / "map.png").string());
        std::ofstream(aside.partial_path()) << "whole";
        aside.rename_into_place();
    }
    EXPECT_TRUE(there("map.png"));
    EXPECT_FALSE(there("map.partial" + gone + ".png"));
    EXPECT_TRUE(there("map.partial" + running + ".png"));  // that one is being written
    EXPECT_TRUE(there("other.partial" + gone + ".png"));
    EXPECT_TRUE(there("map.partial.png"));
    EXPECT_TRUE(there("map.partial" + gone + "a.png"));
    EXPECT_TRUE(there("map.partial" + gone + ".csv"));
    { const FileAside aside((folder / "other.png").string()); }
    EXPECT_FALSE(there("other.partial" + gone + ".png"));
    fs::remove_all(folder);
}

}  // namespace
}  // namespace frana
