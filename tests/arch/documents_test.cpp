// SPDX-License-Identifier: Apache-2.0
// ARCHITECTURE.md and the comments refer to existing files and sections.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "source_tree.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

bool exists(const std::string& path) {
    return fs::exists(fs::path(FRANA_SOURCE_DIR) / path);
}

/// Returns every match's group in the lines of a file.
std::vector<std::smatch> matches(const std::string& text, const std::regex& pattern) {
    return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

/// Returns titles of the headings and of the paragraphs that begin in bold ("**Walls.**").
std::set<std::string> sections_of(const std::string& document) {
    static const std::regex k_heading("^#+ (.*)$"), k_paragraph(R"(^(?:<a id="[^"]*"></a>)?\*\*([^*.]*))");
    std::set<std::string> titles;
    for (const std::string& line : lines_of(document)) {
        std::smatch found;
        if (std::regex_match(line, found, k_heading) || std::regex_search(line, found, k_paragraph))
            titles.insert(found[1]);
    }
    return titles;
}

TEST(Documents, EveryPathOfTheArchitectureExists) {
    static const std::regex k_path("(?:src|gis|render|tests|share)/[A-Za-z0-9_./]*[A-Za-z0-9_]");
    int paths = 0;
    for (const std::string& line : lines_of("ARCHITECTURE.md")) {
        for (const std::smatch& found : matches(line, k_path)) {
            const std::string path = found.str();
            if (path.find("NAME") != std::string::npos) continue;  // a placeholder
            ++paths;
            EXPECT_TRUE(exists(path)) << "ARCHITECTURE.md names " << path << ": " << line;
        }
    }
    EXPECT_GT(paths, 50);
}

// The events of share/doc/validation.md are those that share/catalogue/run repeats, each from a scene that exists.
TEST(Documents, TheCatalogueRepeatsEveryEventAndScene) {
    std::set<std::string> repeated, scenes, shown, files;
    for (const std::string& line : lines_of("share/catalogue/events")) {
        static const std::regex k_run("^([a-z0-9_]+) *\\| [a-z0-9_.]+ *\\| ([a-z0-9_]+) *\\|.*");
        std::smatch found;
        if (line.starts_with("#")) continue;
        ASSERT_TRUE(std::regex_match(line, found, k_run)) << line;
        repeated.insert(found[1]);
        scenes.insert(found[2]);
    }
    bool in_table = false;
    for (const std::string& line : lines_of("share/doc/validation.md")) {
        static const std::regex k_last("\\| `([a-z0-9_]+)`[^|]*\\|$");
        in_table = in_table ? line.starts_with("|") : line.find("`share/catalogue/run` |") != std::string::npos;
        std::smatch found;
        if (in_table && std::regex_search(line, found, k_last)) shown.insert(found[1]);
    }
    for (const auto& entry : fs::directory_iterator(fs::path(FRANA_SOURCE_DIR) / "share/scenes"))
        if (entry.path().extension() == ".ini") files.insert(entry.path().stem().string());
    EXPECT_EQ(shown, repeated);
    EXPECT_EQ(files, scenes);
    EXPECT_GT(repeated.size(), 4U);
}

// Comments of the form share/doc/NAME.md, "Section".
TEST(Documents, CommentsCiteSectionsThatExist) {
    static const std::regex k_citation("share/doc/[a-z_]+\\.md(?:, \"([^\"]+)\")?");
    static const std::regex k_other("\\bspecification\\b|shared spec|\\b(?:of|\\()section [0-9]");
    int sections = 0;
    for (const std::string& file : source_files({"src", "gis", "render", "tests", "sample_data"}, {".h", ".cpp"})) {
        if (file.find("documents_test") != std::string::npos) continue;
        for (const std::string& line : lines_of(file)) {
            EXPECT_FALSE(std::regex_search(line, k_other)) << file << " cites a section missing in share/doc: " << line;
            for (const std::smatch& found : matches(line, k_citation)) {
                const std::string cited = found.str(), document = cited.substr(0, cited.find(".md") + 3);
                ASSERT_TRUE(exists(document)) << file << ": " << line;
                if (!found[1].matched) continue;
                ++sections;
                EXPECT_EQ(sections_of(document).count(found[1]), 1U) << file << ": " << line;
            }
        }
    }
    EXPECT_GT(sections, 10);
}

}  // namespace
}  // namespace frana::test
