// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "source_tree.h"

namespace frana::test {
namespace {

const std::vector<std::string> k_folders{"src", "gis", "render", "tests", "sample_data", "share"};

TEST(SourceFiles, EveryFileNamesItsLicenceFirst) {
    for (const std::string& file : source_files(k_folders, {".h", ".cpp", ".ini", ".txt", ".sh"})) {
        const auto lines = lines_of(file);
        ASSERT_FALSE(lines.empty()) << file << " is empty";
        const std::size_t first = lines.front().rfind("#!", 0) == 0 ? 1 : 0;
        ASSERT_GT(lines.size(), first) << file;
        EXPECT_NE(lines[first].find("SPDX-License-Identifier: Apache-2.0"), std::string::npos) << file;
    }
}

TEST(SourceFiles, NoFileIsTooLong) {
    constexpr std::size_t k_most_lines = 400;
    for (const std::string& file : source_files(k_folders, {".h", ".cpp"}))
        EXPECT_LE(lines_of(file).size(), k_most_lines) << file << " is to be split";
}

}  // namespace
}  // namespace frana::test
