// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "app/text/text_table.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class Terminal : public TinyScene {
  protected:
    /// The lines that a command prints to a terminal of this width.
    std::vector<std::string> lines_on(int columns, const std::string& words) {
        const std::string inside = "stty cols " + std::to_string(columns) + "; \"" FRANA_PROGRAM "\" " + words;
        const std::string command =
            "cd '" + folder_.string() + "' && script -qec '" + inside + "' typescript < /dev/null > shown 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << read_text(path("shown"));
        std::vector<std::string> lines;
        std::istringstream text(read_text(path("shown")));
        for (std::string line; std::getline(text, line);) {
            line.erase(std::remove(line.begin(), line.end(), '\r'), line.end());
            lines.push_back(line);
        }
        return lines;
    }
};

TEST_F(Terminal, TablesFitItsWidth) {
    if (std::system("command -v script > /dev/null && command -v stty > /dev/null") != 0) GTEST_SKIP() << "no script";
    write_scene(k_numbers_only);
    for (const int columns : {100, 64}) {
        bool table = false;
        for (const std::string& line : lines_on(columns, "check scene.ini")) {
            if (line.rfind("frana: ", 0) == 0 || line.rfind("Scene ", 0) == 0) continue;  // sentences; a long path
            table = table || line.rfind("Input", 0) == 0 || line.rfind("Working grid", 0) == 0;
            EXPECT_LE(app::display_width(line), static_cast<std::size_t>(columns)) << line;
        }
        EXPECT_TRUE(table);
    }
    // Where columns would tear words, each input is a list.
    const auto narrow = lines_on(60, "check scene.ini");
    EXPECT_NE(std::find(narrow.begin(), narrow.end(), "CRS: EPSG:32632 (WGS 84 / UTM zone 32N)"), narrow.end());
    for (const std::string words : {"--help", "check --help", "bench --help", "compare --help", "materials"})
        for (const std::string& line : lines_on(60, words)) EXPECT_LE(app::display_width(line), 60U) << words << line;
    // A pipe is no terminal: nothing depends on a window.
    EXPECT_NE(frana({"check", "scene.ini"}).out.find("Extent (west south,"), std::string::npos);
}

}  // namespace
}  // namespace frana::test
