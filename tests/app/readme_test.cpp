// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iomanip>
#include <map>
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
    succeeded(frana({"check", "my-slope/scene.ini"}));
    // A second of the flow is enough to show that it runs.
    succeeded(frana({"run", "my-slope/scene.ini", "--quiet", "--set", "time.end=1", "--set", "output.maps=off", "--set",
                     "output.animation=off"}));
    EXPECT_TRUE(fs::exists(folder_ / "my-slope/results/my-slope/max_depth.tif"));
}

using Tutorial = TinyScene;

// In their order, with the files that the page writes ("```ini FILE"). Two seconds of the flow on larger cells, few
// runs and pictures of half the size are enough to show that each command takes what the one before it left.
TEST_F(Tutorial, EachOfItsCommandsRuns) {
    const std::map<std::string, std::string> shorter{
        {"end = 900", "end = 2"},
        {"cell-size = 5", "cell-size = 20"},
        {"samples = 64", "samples = 16"},
        {"title = Bindo, scenario 1", "maps = off\nanimation = off\ncharts = off\nframes = off"}};
    // The samples' scenes, shorter too, beside the files that they name.
    fs::create_directories(folder_ / "sample_data/fan");
    fs::create_directory_symlink(FRANA_SOURCE_DIR "/sample_data/bindo", folder_ / "sample_data/bindo");
    for (const fs::directory_entry& entry : fs::directory_iterator(FRANA_SOURCE_DIR "/sample_data/fan")) {
        const std::string name = entry.path().filename().string();
        std::string text = read_text(entry.path().string());
        if (entry.path().extension() == ".ini")
            for (const auto& [whole, part] : {std::pair{"end = 1800", "end = 60"},
                                              {"dtm = dtm.tif", "dtm = dtm.tif\ncell-size = 30"},
                                              {"cell-size = 10", "cell-size = 30"},
                                              {"samples = 64", "samples = 16"},
                                              {"title = ", "maps = off\ntitle = "}})
                text = std::regex_replace(text, std::regex(whole), part);
        write("sample_data/fan/" + name, text);
    }
    const std::string opening = "```ini ", command = "    frana ";
    std::istringstream page(document("share/doc/tutorial.md"));
    std::size_t commands = 0, shortened = 0;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with(opening)) {
            const std::string file = line.substr(opening.size());
            std::string text;
            while (std::getline(page, line) && line != "```") {
                const auto found = shorter.find(line);
                shortened += found == shorter.end() ? 0 : 1;
                text += (found == shorter.end() ? line : found->second) + "\n";
            }
            write(file, text);
        }
        if (!line.starts_with(command)) continue;
        std::istringstream rest(std::regex_replace(line.substr(command.size()), std::regex("@300"), "@150"));
        std::vector<std::string> words;
        for (std::string word; rest >> std::quoted(word);) words.push_back(word);
        succeeded(frana(words));
        ++commands;
    }
    EXPECT_EQ(shortened, shorter.size());
    EXPECT_GE(commands, 13U);
    for (const char* made : {"scenarios/hazard_degree.tif", "frequency/hazard_curves.csv", "sheets/max_depth_T100.pdf"})
        EXPECT_TRUE(fs::exists(folder_ / "fan" / made)) << made;
    for (const char* made : {"results/slope/report.html", "results/range/report.html", "results/slope/comparison.json",
                             "sheets/max_depth.pdf", "sheets/hazard.pdf", "range-sheets/probability_depth_0.5.pdf"})
        EXPECT_TRUE(fs::exists(folder_ / "slope" / made)) << made;
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
