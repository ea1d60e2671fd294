// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

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

// As clang-format lays them out: from the first line of what ends with the brace to the next that is no further in.
TEST(SourceFiles, NoFunctionIsTooLong) {
    constexpr std::size_t k_most_lines = 80;
    const std::regex other(R"((if|for|while|switch|else|do|try|namespace|struct|class|enum|union|return)\b.*)");
    std::size_t functions = 0;
    for (const std::string& file : source_files({"src", "gis", "render"}, {".h", ".cpp"})) {
        const auto lines = lines_of(file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (!lines[i].ends_with('{') || lines[i].find(')') == std::string::npos) continue;
            std::size_t begin = i;
            const auto open = [&](std::size_t line) {
                return std::count(lines[line].begin(), lines[line].end(), ')') -
                       std::count(lines[line].begin(), lines[line].end(), '(');
            };
            for (auto missing = open(i); missing > 0 && begin > 0; missing += open(begin)) --begin;
            const auto indent = [&](std::size_t line) { return lines[line].find_first_not_of(' '); };
            const std::string code = lines[begin].substr(indent(begin));
            if (code.starts_with("}") || std::regex_match(code, other)) continue;
            std::size_t end = i + 1;
            while (end < lines.size() && (lines[end].empty() || lines[end][0] == '#' || indent(end) > indent(begin)))
                ++end;
            ++functions;
            EXPECT_LE(end - begin + 1, k_most_lines) << file << ':' << begin + 1 << " is to be split: " << code;
        }
    }
    EXPECT_GT(functions, 3000U) << "the search has found them";
}

std::size_t lines_in(const std::string& folder) {
    std::size_t lines = 0;
    for (const std::string& file : source_files({folder}, {".h", ".cpp"})) lines += lines_of(file).size();
    return lines;
}

// The sum is above the ceiling: it is only ever lowered, when the product has shrunk; what comes in makes its room
// elsewhere. Once below, the ceiling alone holds.
TEST(SourceFiles, TheProductKeepsBelowItsCeiling) {
    constexpr std::size_t k_lines = 89785;
    const std::size_t lines = lines_in("src") + lines_in("gis") + lines_in("render");
    EXPECT_LE(lines, k_lines);
    std::size_t ceiling = 0;
    if (!(std::ifstream(FRANA_SHARED_DIR "/CEILING") >> ceiling)) GTEST_SKIP() << "no ceiling at " FRANA_SHARED_DIR;
    EXPECT_EQ(lines > ceiling, k_lines > ceiling) << "the product is below its ceiling: k_lines is the ceiling now";
}

// Many small files cost a reader more than their lines.
TEST(SourceFiles, HalfOfTheFilesAreNotShort) {
    constexpr std::size_t k_median = 95;
    std::vector<std::size_t> lengths;
    for (const std::string& file : source_files({"src", "gis", "render"}, {".h", ".cpp"}))
        lengths.push_back(lines_of(file).size());
    std::sort(lengths.begin(), lengths.end());
    EXPECT_GE(lengths[lengths.size() / 2], k_median) << lengths.size() << " files";
}

/// Files of the product whose code has one of these texts.
std::vector<std::string> files_with(const std::vector<std::string>& texts) {
    std::vector<std::string> naming;
    for (const std::string& file : source_files({"src", "gis", "render"}, {".h", ".cpp"})) {
        const auto lines = lines_of(file);
        if (std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
                const std::string code = line.substr(0, line.find("//"));
                return std::any_of(texts.begin(), texts.end(),
                                   [&](const std::string& text) { return code.find(text) != std::string::npos; });
            }))
            naming.push_back(file);
    }
    return naming;
}

// A law carries its row: its header names it, and everything else follows. A second file may name it for a reason of
// its own. Words that also name a quantity by place ("cohesion", "turbulence") are left out.
TEST(SourceFiles, ALawIsNamedInItsHeader) {
    for (const std::string word :
         {"chezy", "pouliquen-forterre", "modified-voellmy", "mechanical", "coulomb", "ramms-yield", "bingham",
          "herschel-bulkley", "obrien-julien", "manning", "earth-pressure", "shear-stress", "growth"}) {
        const auto naming = files_with({'"' + word + '"', " = " + word + '"'});
        EXPECT_GE(naming.size(), 1U) << word;
        EXPECT_LE(naming.size(), 2U) << word << ": " << testing::PrintToString(naming);
    }
}

// A raster of the result costs its row and the code that computes it; what else asks for it does so by RasterName.
TEST(SourceFiles, ARasterIsNamedInItsRowAndWhereItIsComputed) {
    // Words that name a section, a palette or a field of particles as well.
    const std::set<std::string> words{"cohesion_ratio", "comparison", "depth", "hazard", "release", "velocity"};
    std::string table;
    for (const std::string& line : lines_of("src/params/keys/result_rasters.cpp")) table += line;
    const std::regex row(
        R"re((?:\.flow|\.add|phase|probability|for_values|of_all|of_scenario)\( *(?:"|RasterName::)([a-z_]+))re");
    std::size_t rows = 0;
    for (std::sregex_iterator at(table.begin(), table.end(), row), end; at != end; ++at, ++rows) {
        const std::string name = (*at)[1];
        const auto naming = files_with({'"' + name + '"'});
        EXPECT_EQ(naming.size() > 2, words.count(name) > 0) << name << ": " << testing::PrintToString(naming);
    }
    EXPECT_GT(rows, 40U);
}

// A way to give the release's thickness is named in its row; a second file may name it in a remedy. ("attribute" and
// "raster" are words of other keys as well.)
TEST(SourceFiles, AKindOfThicknessIsNamedInItsRow) {
    for (const std::string kind : {"difference", "slip-surface", "phases"}) {
        const auto naming = files_with({".word = \"" + kind + '"', '"' + kind + ':', " = " + kind + '"'});
        EXPECT_GE(naming.size(), 1U) << kind;
        EXPECT_LE(naming.size(), 2U) << kind << ": " << testing::PrintToString(naming);
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
