// SPDX-License-Identifier: Apache-2.0
// Completion and manual pages as share/package/documents.sh makes them for an installation.
#include <cstdlib>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class GeneratedDocs : public TinyScene {
  protected:
    GeneratedDocs() {
        EXPECT_EQ(system("sh '" FRANA_SOURCE_DIR "/share/package/documents.sh' '" FRANA_PROGRAM "' generated"), 0);
    }
    [[nodiscard]] int system(const std::string& command) const {
        return std::system(("cd '" + folder_.string() + "' && " + command).c_str());
    }
    [[nodiscard]] bool has(const std::string& command) const {
        return system("command -v " + command + " > /dev/null") == 0;
    }
    /// What bash offers for the last of some words.
    [[nodiscard]] std::string offered(const std::string& words, int last) const {
        write("ask", "source generated/completion/frana\ncompopt() { :; }\nCOMP_WORDS=(frana " + words +
                         ")\nCOMP_CWORD=" + std::to_string(last) +
                         "\n_frana\nprintf '%s ' \"${COMPREPLY[@]}\" > offered\n");
        EXPECT_EQ(system("bash ask"), 0);
        return read_text(path("offered"));
    }
};

TEST_F(GeneratedDocs, CompleteInShellsAndAreValidRoff) {
    EXPECT_EQ(offered("conv", 1), "converge ");
    EXPECT_EQ(offered("run --over", 2), "--overwrite ");
    EXPECT_EQ(offered("run scene.ini --set material.model", 4), "material.model= ");
    EXPECT_EQ(offered("unknown --", 2), " ");
    EXPECT_EQ(offered("run sc", 2), " ") << "files, which bash lists";
    if (has("zsh")) {
        EXPECT_EQ(system("zsh -n generated/completion/_frana"), 0);
    }
    EXPECT_NE(read_text(path("generated/completion/_frana")).find("run) compadd -- --out --set "), std::string::npos);
    int pages = 0;
    for (const auto& entry : std::filesystem::directory_iterator(path("generated/man"))) {
        ++pages;
        EXPECT_EQ(read_text(entry.path().string()).rfind(".TH FRANA", 0), 0U) << entry.path();
    }
    EXPECT_GE(pages, 14);  // frana, its commands, the scene
    if (has("mandoc")) {
        EXPECT_EQ(system("mandoc -Tlint -Werror generated/man/*"), 0);
    }
    if (has("man")) {
        EXPECT_EQ(system("MANWIDTH=80 man --warnings -E UTF-8 -l generated/man/* > shown 2> warnings"), 0);
        EXPECT_EQ(read_text(path("warnings")), "");
    }
    EXPECT_NE(read_text(path("generated/man/frana-run.1")).find("\\-\\-overwrite"), std::string::npos);
    EXPECT_NE(read_text(path("generated/man/frana-scene.5")).find("dtm\\-contains\\-release"), std::string::npos);
    // The commands of before.
    for (const std::string gone : {"complete", "completion", "man"}) {
        refusal_of(frana({gone, "bash"}), {"are installed with frana"});
    }
}

}  // namespace
}  // namespace frana::test
