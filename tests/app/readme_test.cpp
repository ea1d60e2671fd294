// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iomanip>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

std::string document(const std::string& name) {
    return read_text(std::string(FRANA_SOURCE_DIR) + "/" + name);
}

/// Returns the first block of a document marked as this language.
std::string first_block(const std::string& text, const std::string& language) {
    const std::string opening = "```" + language + "\n";
    const std::size_t begin = text.find(opening), end = text.find("\n```", begin + opening.size());
    if (begin == std::string::npos || end == std::string::npos) return {};
    return text.substr(begin + opening.size(), end - begin - opening.size()) + "\n";
}

using Readme = TinyScene;

TEST_F(Readme, ItsFirstSceneRunsUnchanged) {
    const std::string scene = first_block(document("README.md"), "ini");
    ASSERT_FALSE(scene.empty()) << "the README has lost its first scene";
    fs::create_directory_symlink(FRANA_SOURCE_DIR "/sample_data", folder_ / "sample_data");
    fs::create_directory(folder_ / "my-slope");
    write("my-slope/scene.ini", scene);
    const Outcome checked = frana({"check", "my-slope/scene.ini"});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    // A second of the flow is enough to show that it runs.
    const Outcome run = frana({"run", "my-slope/scene.ini", "--quiet", "--set", "time.end=1", "--set",
                               "output.maps=off", "--set", "output.animation=off"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(fs::exists(folder_ / "my-slope/results/my-slope/max_depth.tif"));
}

using Tutorial = TinyScene;

// In their order, with the files that the page writes ("```ini FILE"). Five seconds of the flow and sixteen runs are
// enough to show that each command takes what the one before it left.
TEST_F(Tutorial, EachOfItsCommandsRuns) {
    fs::create_directory_symlink(FRANA_SOURCE_DIR "/sample_data", folder_ / "sample_data");
    const std::string opening = "```ini ", command = "    frana ";
    std::istringstream page(document("share/doc/tutorial.md"));
    int commands = 0, shortened = 0;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with(opening)) {
            const std::string file = line.substr(opening.size());
            std::string text;
            while (std::getline(page, line) && line != "```") {
                const std::string whole = line;
                if (line == "end = 900") line = "end = 5";
                if (line == "samples = 64") line = "samples = 16";
                shortened += line != whole ? 1 : 0;
                text += line + "\n";
            }
            write(file, text);
        }
        if (!line.starts_with(command)) continue;
        std::istringstream rest(line.substr(command.size()));
        std::vector<std::string> words;
        for (std::string word; rest >> std::quoted(word);) words.push_back(word);
        const Outcome outcome = frana(words);
        ASSERT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.err;
        ++commands;
    }
    EXPECT_EQ(shortened, 2);
    EXPECT_GE(commands, 8);
    for (const char* made :
         {"slope/results/slope/report.html", "slope/results/range/report.html", "slope/results/slope/comparison.json",
          "slope/sheets/max_depth.pdf", "slope/range-sheets/probability_depth_0.5.pdf"})
        EXPECT_TRUE(fs::exists(folder_ / made)) << made;
}

TEST(Documents, LinkOnlyToExistingFiles) {
    std::vector<fs::path> pages{fs::path(FRANA_SOURCE_DIR) / "README.md"};
    for (const fs::directory_entry& entry : fs::directory_iterator(FRANA_SOURCE_DIR "/share/doc"))
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    ASSERT_GT(pages.size(), 5U);
    const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
    for (const fs::path& page : pages) {
        const std::string text = read_text(page.string());
        for (std::sregex_iterator found(text.begin(), text.end(), link), none; found != none; ++found)
            EXPECT_TRUE(fs::exists(page.parent_path() / (*found)[1].str()))
                << page << " links to " << (*found)[1].str();
    }
}

}  // namespace
}  // namespace frana::test
