// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "source_tree.h"

namespace frana::test {
namespace {

const std::vector<std::string> k_folders{"src", "gis", "render", "tests", "sample_data", "share"};

TEST(SourceFiles, EveryFileNamesItsLicenceFirst) {
    for (const std::string& file : source_files(k_folders, {".h", ".cpp", ".ini", ".txt", ".cmake", ".po", ".sh"})) {
        const auto lines = lines_of(file);
        ASSERT_FALSE(lines.empty()) << file << " is empty";
        const std::size_t first = lines.front().rfind("#!", 0) == 0 ? 1 : 0;
        ASSERT_GT(lines.size(), first) << file;
        EXPECT_NE(lines[first].find("SPDX-License-Identifier: Apache-2.0"), std::string::npos) << file;
    }
}

TEST(SourceFiles, NoFileIsTooLong) {
    constexpr std::size_t k_most_lines = 600;
    for (const std::string& file : source_files(k_folders, {".h", ".cpp"}))
        EXPECT_LE(lines_of(file).size(), k_most_lines) << file << " is to be split";
}

// A test is in the folder of the part of the product that it tests (ARCHITECTURE.md), except those of all libraries.
TEST(SourceFiles, TestsAreInFoldersOfTheProduct) {
    const std::vector<std::string> across{"arch", "fuzz", "hostile", "properties", "qgis", "support", "validation"};
    int mirrored = 0;
    for (const std::string& file : source_files({"tests"}, {".cpp"})) {
        if (!file.ends_with("_test.cpp")) continue;
        const std::string folder = file.substr(6, file.rfind('/') - 6);  // without "tests/"
        if (std::count(across.begin(), across.end(), folder.substr(0, folder.find('/'))) > 0) continue;
        ++mirrored;
        const std::filesystem::path root = FRANA_SOURCE_DIR;
        EXPECT_TRUE(std::filesystem::exists(root / "src" / folder) || std::filesystem::exists(root / folder)) << file;
    }
    EXPECT_GT(mirrored, 100);
}

}  // namespace
}  // namespace frana::test
