// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using ManPage = TinyScene;

TEST_F(ManPage, EveryPageIsValidRoff) {
    ASSERT_EQ(frana({"man", "--out", "man"}).exit_code, 0);
    int pages = 0;
    const bool man = std::system("command -v man > /dev/null && man --version > /dev/null 2>&1") == 0,
               mandoc = std::system("command -v mandoc > /dev/null") == 0;
    for (const auto& entry : std::filesystem::directory_iterator(path("man"))) {
        ++pages;
        const std::string page = entry.path().string();
        EXPECT_EQ(read_text(page).rfind(".TH FRANA", 0), 0U);
        if (mandoc) {
            EXPECT_EQ(std::system(("mandoc -Tlint -Werror '" + page + "'").c_str()), 0);
        }
        if (!man) continue;
        EXPECT_EQ(std::system(("MANWIDTH=80 man --warnings -E UTF-8 -l '" + page + "' > '" + path("shown") + "' 2> '" +
                               path("warnings") + "'")
                                  .c_str()),
                  0);
        EXPECT_EQ(read_text(path("warnings")), "") << page;
    }
    EXPECT_GE(pages, 14);  // frana, its commands, the scene
}

TEST_F(ManPage, HasOptionsAndKeys) {
    const std::string run = frana({"man", "run"}).out, scene = frana({"man", "scene"}).out;
    EXPECT_NE(run.find("\\fB\\-\\-overwrite\\fR"), std::string::npos) << run;
    EXPECT_NE(run.find("\\fB\\-q\\fR, \\fB\\-\\-quiet\\fR"), std::string::npos) << run;
    EXPECT_NE(scene.find("\\fBdtm\\-contains\\-release\\fR"), std::string::npos);
    EXPECT_EQ(frana({"man", "rum"}).exit_code, 2);
    EXPECT_NE(frana({"man", "rum"}).err.find("Did you mean run?"), std::string::npos);
}

}  // namespace
}  // namespace frana::test
