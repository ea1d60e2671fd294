// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class Completion : public TinyScene {
  protected:
    /// What the shell's script offers for these words of a command line, of which the last is completed.
    std::vector<std::string> offered(const std::vector<std::string>& words, const std::string& shell = "bash") {
        std::string line = FRANA_PROGRAM;
        for (const std::string& word : words) line += " '" + word + "'";
        const std::string last = std::to_string(words.size());
        std::string& script = scripts_[shell];
        if (script.empty()) script = frana({"complete", shell}).out;
        write("script", script);
        // The builtins of zsh answer within an edited line only.
        write("ask",
              shell == "bash"
                  ? "source ./script\nCOMP_WORDS=(" + line + ")\nCOMP_CWORD=" + last +
                        "\n_frana 2> /dev/null\nprintf '%s\\n' \"${COMPREPLY[@]}\" > offered\n"
                  : "compadd() { print -rl -- $names }\n_files() { print -r -- files $* }\ncompset() { : }\nwords=(" +
                        line + ")\nCURRENT=$(( " + last + " + 1 ))\nsource ./script > offered\n");
        EXPECT_EQ(std::system(("cd '" + folder_.string() + "' && " + shell + " ask").c_str()), 0);
        std::vector<std::string> lines;
        std::istringstream text(read_text(path("offered")));
        for (std::string one; std::getline(text, one);)
            if (!one.empty()) lines.push_back(one);
        return lines;
    }
    static bool has(const std::vector<std::string>& list, const std::string& word) {
        return std::find(list.begin(), list.end(), word) != list.end();
    }

  private:
    std::map<std::string, std::string> scripts_;  ///< by shell
};

TEST_F(Completion, OfBashKnowsCommandsOptionsKeysAndValues) {
    write("other.txt", "");
    EXPECT_TRUE(has(offered({"ch"}), "check"));
    EXPECT_EQ(offered({"conv"}), std::vector<std::string>{"converge"});
    EXPECT_TRUE(has(offered({"run", "--over"}), "--overwrite"));
    EXPECT_TRUE(has(offered({"check", "--js"}), "--json"));
    EXPECT_EQ(offered({"run", "sc"}), std::vector<std::string>{"scene.ini"});
    EXPECT_EQ(offered({"run", "oth"}), std::vector<std::string>{});  // not a scene
    EXPECT_EQ(offered({"render", "--view", ""}), (std::vector<std::string>{"2d", "3d"}));
    EXPECT_TRUE(has(offered({"render", "--map", "max_"}), "max_depth"));
    EXPECT_EQ(offered({"run", "scene.ini", "--set", "material.model"}), std::vector<std::string>{"material.model="});
    // readline parts the words at "=".
    EXPECT_EQ(offered({"run", "--set", "material.model", "=", "vo"}), std::vector<std::string>{"voellmy-bingham"});
    EXPECT_TRUE(has(offered({"run", "--set", "material.preset", "="}), "debris-flow"));
    EXPECT_TRUE(has(offered({"run", "--set", "terrain.dtm", "=", "dt"}), "dtm.asc"));
    // Where "=" does not part words.
    EXPECT_EQ(offered({"run", "--set", "output.report=of"}), std::vector<std::string>{"output.report=off"});
    EXPECT_TRUE(has(offered({"bench", "acc"}), "accuracy"));
    EXPECT_TRUE(has(offered({"man", "conv"}), "converge"));
    EXPECT_EQ(offered({"run", "--set", "terrain.dtm=dtm.a"}), std::vector<std::string>{"terrain.dtm=dtm.asc"});
    EXPECT_EQ(offered({"render", "--view", "=", "2"}), std::vector<std::string>{"2d"});
    EXPECT_EQ(offered({"unknown", ""}), std::vector<std::string>{});
}

TEST_F(Completion, KnowsEveryCommandAndOptionOfTheHelp) {
    const std::vector<std::string> commands = offered({""});
    EXPECT_GE(commands.size(), 12U);
    for (const std::string& command : commands) {
        if (command.rfind("--", 0) == 0) continue;
        const std::vector<std::string> options = offered({command, "--"});
        std::istringstream help(frana({command, "--help"}).out);
        for (std::string line; std::getline(help, line);) {
            const auto at = line.find("--");
            if (line.rfind("  ", 0) != 0 || at == std::string::npos || at > 7) continue;
            const std::string option = line.substr(at, line.find_first_of(" \n", at) - at);
            EXPECT_TRUE(has(options, option)) << command << ' ' << option;
        }
    }
}

TEST_F(Completion, OfZshKnowsTheSame) {
    if (std::system("command -v zsh > /dev/null") != 0) GTEST_SKIP() << "no zsh";
    EXPECT_EQ(offered({"conv"}, "zsh"), std::vector<std::string>{"converge"});
    EXPECT_TRUE(has(offered({"run", "--over"}, "zsh"), "--overwrite"));
    EXPECT_EQ(offered({"run", ""}, "zsh"), std::vector<std::string>{"files -g *.ini"});
    EXPECT_EQ(offered({"run", "--out", ""}, "zsh"), std::vector<std::string>{"files -/"});
    EXPECT_EQ(offered({"run", "--set", "material.model"}, "zsh"), std::vector<std::string>{"material.model="});
    EXPECT_EQ(offered({"run", "--set", "output.report=of"}, "zsh"), std::vector<std::string>{"output.report=off"});
    EXPECT_EQ(offered({"run", "--set=output.report=of"}, "zsh"), std::vector<std::string>{"--set=output.report=off"});
    EXPECT_EQ(offered({"run", "--set", "terrain.dtm=dt"}, "zsh"), std::vector<std::string>{"files"});
}

TEST_F(Completion, OfAnotherShellIsRefused) {
    const Outcome outcome = frana({"complete", "fish"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(frana({"completion", "bash"}).out, frana({"complete", "bash"}).out);  // its older name
    EXPECT_NE(outcome.err.find("allowed bash, zsh"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace frana::test
