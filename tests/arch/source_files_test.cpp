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

// A law carries its row: its header names it, and everything else follows. A second file may name it for a reason of
// its own. Words that also name a quantity by place ("cohesion", "turbulence") are left out.
TEST(SourceFiles, ALawIsNamedInItsHeader) {
    const auto files = source_files({"src", "gis", "render"}, {".h", ".cpp"});
    for (const std::string word :
         {"chezy", "pouliquen-forterre", "mechanical", "coulomb", "ramms-yield", "bingham", "herschel-bulkley",
          "obrien-julien", "manning", "earth-pressure", "shear-stress", "growth"}) {
        std::vector<std::string> naming;
        for (const std::string& file : files) {
            const auto lines = lines_of(file);
            if (std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
                    const std::string code = line.substr(0, line.find("//"));
                    return code.find('"' + word + '"') != std::string::npos ||
                           code.find(" = " + word + '"') != std::string::npos;
                }))
                naming.push_back(file);
        }
        EXPECT_GE(naming.size(), 1U) << word;
        EXPECT_LE(naming.size(), 2U) << word << ": " << testing::PrintToString(naming);
    }
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
