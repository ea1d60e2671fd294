// SPDX-License-Identifier: Apache-2.0
// Files get their name when they are complete, and leave nothing if they never are.
#include "core/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/error.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

// A name that is known before lets another user plant a link there.
TEST(TemporaryFolder, HasANewNameIsItsOwnersAloneAndDisappears) {
    std::string path;
    {
        const TemporaryFolder one, other;
        path = one.path();
        EXPECT_NE(path, other.path());
        EXPECT_EQ(path.find(std::to_string(::getpid())), std::string::npos);
        EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
        std::ofstream(path + "/file") << "x";
    }
    EXPECT_FALSE(fs::exists(path));
}

class FileAsideIn : public ::testing::Test {
  protected:
    FileAsideIn() : folder_(fs::temp_directory_path() / ("frana_unnamed_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~FileAsideIn() override { fs::remove_all(folder_); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder_)) all.insert(entry.path().filename().string());
        return all;
    }
    static std::string text(const std::string& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    fs::path folder_;
};

TEST_F(FileAsideIn, AnUnnamedFileAppearsWhenItIsComplete) {
    for (const char* content : {"first", "second"}) {  // a new name, and an existing one
        const auto before = names();
        FileAside file(path("a.txt"));
        if (file.partial_path().find("/proc/") == std::string::npos) GTEST_SKIP() << "no files without a name here";
        std::ofstream(file.partial_path()) << content;
        EXPECT_EQ(names(), before);
        file.sync_to_disk();
        file.rename_into_place();
        EXPECT_EQ(names(), std::set<std::string>{"a.txt"});
        EXPECT_EQ(text(path("a.txt")), content);
    }
    {
        const FileAside given_up(path("a.txt"));
        std::ofstream(given_up.partial_path()) << "third";
    }
    EXPECT_EQ(names(), std::set<std::string>{"a.txt"});
    EXPECT_EQ(text(path("a.txt")), "second");
}

TEST_F(FileAsideIn, EveryByteIsChecked) {
    write_file(path("a.txt"), "old");
    rlimit usual{};
    ::getrlimit(RLIMIT_FSIZE, &usual);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, usual.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(write_file(path("a.txt"), std::string(2000, 'x'), Sync::yes), Error);
    ::setrlimit(RLIMIT_FSIZE, &usual);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(text(path("a.txt")), "old");
    EXPECT_EQ(names(), std::set<std::string>{"a.txt"});
    EXPECT_THROW(write_file(path("no/folder/a.txt"), "x"), Error);
}

/// Returns the number of a process that has ended.
std::string ended_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return std::to_string(child);
}

TEST(FileAside, RemovesWhatKilledProcessesLeftOfTheSameFileOnly) {
    const fs::path folder = fs::temp_directory_path() / ("frana_aside_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::string gone = ended_process(), running = std::to_string(::getppid());
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
