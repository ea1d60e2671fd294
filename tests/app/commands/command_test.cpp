// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/command_line.h"
#include "core/words/words.h"
#include "support/checked_scene.h"
#include "support/problems.h"

namespace frana::test {
namespace {

using Command = CheckedScene;

TEST_F(Command, HelpAndVersion) {
    EXPECT_EQ(frana({"--version"}).out.rfind("frana ", 0), 0U);
    std::string told = read_text(FRANA_SOURCE_DIR "/README.md");
    for (const auto& entry : std::filesystem::directory_iterator(FRANA_SOURCE_DIR "/share/doc"))
        if (entry.path().extension() == ".md") told += read_text(entry.path().string());
    for (const app::Command& row : app::commands()) {
        const std::string command = row.name;
        const Outcome outcome = succeeded(frana({command, "--help"}));
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(outcome.out.rfind("Usage: frana " + command, 0), 0U) << outcome.out;
        EXPECT_NE(frana({"--help"}).out.find("  " + command), std::string::npos);
        EXPECT_NE(told.find("frana " + command), std::string::npos) << command << " is in no document";
    }
}

TEST_F(Command, ErrorsOnTheCommandLine) {
    refusal_of(frana({}));
    EXPECT_NE(frana({"chek"}).err.find("Did you mean check?"), std::string::npos);
    refusal_of(frana({"chek"}));
    EXPECT_TRUE(has_problem(refusal({"run"}), "command line"));
    EXPECT_TRUE(has_problem(refusal({"run", "scene.ini", "--overwrit"}), "command line"));  // no abbreviations
    EXPECT_TRUE(has_problem(refusal({"run", "scene.ini", "--threads", "0"}), "--threads", "0", "1 to 1024"));
    EXPECT_TRUE(has_problem(refusal({"run", "scene.ini", "other.ini"}), "command line"));
    EXPECT_TRUE(has_problem(refusal({"run", "scene.ini", "--out", ""}), "--out"));
    EXPECT_TRUE(has_problem(refusal({"render", "nowhere"}), "RESULT_DIR", "nowhere"));
    EXPECT_TRUE(has_problem(refusal({"compare", "dtm.asc"}), "command line"));
    EXPECT_TRUE(has_problem(refusal({"params", "--json", "--ini"}), "command line"));
    EXPECT_TRUE(
        has_problem(refusal({"params", "--json", "--language", "xx"}), "--language", "xx", language_codes().c_str()));
    const std::vector<Problem> gone = refusal({"render", "result", "--beside", "other"});
    ASSERT_TRUE(has_problem(gone, "--beside"));
    EXPECT_EQ(gone.front().remedy, "Use --difference");
    refusal_of(frana({"bench", "acuracy"}));
    succeeded(frana({"params", "--json", "--language", "de_AT.UTF-8"}));
    for (const char* command : {"run", "check", "render", "compare", "converge"}) {
        for (const char* word : {"", "--threads"}) EXPECT_EQ(refusal({command, word}).size(), 1U) << command << word;
        const Outcome outcome = refusal_of(frana({command, std::string(5000, 'a')}));
        EXPECT_LT(outcome.err.size(), 6000U) << command;
    }
    for (const std::string threshold : {"1e-320", "0", "-1", "nan", "1e308"})
        EXPECT_TRUE(
            has_problem(refusal({"compare", "dtm.asc", "--scar", "perimeter.geojson", "--threshold", threshold}),
                        "--threshold", threshold, "1e-06 to 100 m"));
    EXPECT_EQ(files().size(), 4U);  // dtm.asc, dtm.prj, perimeter.geojson, scene.ini
}

TEST_F(Command, HelpOfACommandByItsName) {
    EXPECT_EQ(frana({"help", "run"}).out, frana({"run", "--help"}).out);
    refusal_of(frana({"help", "rum"}));
}

TEST_F(Command, NeitherResultNorRaster) {
    write_scene(k_numbers_only);
    EXPECT_TRUE(
        has_problem(refusal({"compare", "nowhere", "--scar", "perimeter.geojson"}), "RESULT_DIR|RASTER", "nowhere"));
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"render", "scene.ini"}, {"compare", "scene.ini", "--scar", "perimeter.geojson"}}) {
        const std::vector<Problem> problems = refusal(words);
        ASSERT_EQ(problems.size(), 1U);
        EXPECT_EQ(problems.front().what, "is a scene, not its result");
    }
}

// `frana params | head` is not an error; a disk that is full is.
TEST_F(Command, AReaderThatHasWhatItWanted) {
    const auto run = [&](const std::string& command) {
        return WEXITSTATUS(std::system(("cd '" + folder_.string() + "' && bash -c '" + command + "'").c_str()));
    };
    const std::string params = std::string("\"") + FRANA_PROGRAM + "\" params";
    EXPECT_EQ(run("{ " + params + "; echo $? > code; } 2> err | head -n 1 > /dev/null"), 0);
    EXPECT_EQ(read_text(path("code")), "0\n");
    EXPECT_EQ(read_text(path("err")), "");
    EXPECT_EQ(run(params + " > /dev/full 2> /dev/null"), 4);
}

TEST_F(Command, AnAmountOfMemoryAsShellsWriteIt) {
    write_scene(k_numbers_only);
    succeeded(frana({"run", "scene.ini", "--out", "r", "--quiet", "--memory-limit", "2G"}));
    for (const char* wrong : {"2X", "", "much", "-1GB", "0", "nan", "4 parsecs"}) {
        const std::vector<Problem> problems = refusal({"run", "scene.ini", "--out", "r2", "--memory-limit", wrong});
        EXPECT_TRUE(has_problem(problems, "--memory-limit", wrong)) << wrong;
    }
}

TEST_F(Command, ParamsAndMaterials) {
    EXPECT_NE(frana({"params"}).out.find("# friction-angle = "), std::string::npos);
    const Json keys = parse_json(frana({"params", "--json"}).out);
    EXPECT_TRUE(std::any_of(keys.begin(), keys.end(),
                            [](const Json& key) { return key["name"] == "material.friction-angle"; }));
    EXPECT_NE(frana({"params", "--markdown"}).out.find("| `friction-angle` |"), std::string::npos);
    const Outcome version = succeeded(frana({"--version"}));
    expect_words(version.out, {"frana ", "\nGDAL ", "\nGEOS ", "\nPROJ ", "\nVTK ", "\nFFmpeg ", "\nBoost "});
    const Outcome materials = succeeded(frana({"materials"}));
    expect_words(materials.out, {"bindo\n", "material.density = 1291"});
    for (const std::string preset :
         {"bindo", "debris-flow", "earthflow", "lahar", "mudflow", "rock-avalanche", "snow-avalanche", "snow-slab"})
        EXPECT_NE(materials.out.find(preset + "\n  A starting point"), std::string::npos) << preset;
    const Outcome schemes = succeeded(frana({"schemes"}));
    expect_words(schemes.out, {"\nswiss-flood\n  Switzerland, floods; intensities of scenarios of 30, 100, 300 years",
                               "\n  Customary limits, source not read\n", "\n  2  Red zone: pressure > 10 kPa\n"});
    EXPECT_NE(schemes.out.find("\n  Degree of hazard: all, channel-debris-flow\n"), std::string::npos) << schemes.out;
}

TEST_F(Command, SchemesListsFrictionTablesAndChecksAFileOfOnesOwn) {
    const Outcome listed = succeeded(frana({"schemes", "--friction"}));
    expect_words(listed.out, {"ngi-avalanche\n  NGI, Voellmy friction", "events of 10, 30, 100, 300 years",
                              "\n  Limits of altitude: 1 000, 1 500 m\n", "\n  4  Gully: curvature 0.05 1/m\n"});
    write("own.ini", own_friction_table(0.2));
    const std::string own = frana({"schemes", "own.ini", "--friction"}).out;
    expect_words(own, {"own\n  ", "\n  Source not read\n", "\n  Has values for forest\n"});
    write("bad.ini", own_friction_table(7));
    refusal_of(frana({"schemes", "bad.ini", "--friction"}), {"bad.ini: class-1.30-years-from-0-m3"});
}

TEST_F(Command, CheckPrintsWhatWouldRunAndWritesNothing) {
    const std::vector<std::string> before = files();
    const Outcome outcome = succeeded(frana({"check", "scene.ini", "--threads", "1"}));
    expect_words(outcome.out, {"ready to run", "EPSG:32632", "527000.00 5094000.00", "60 x 30", "4 000 m3", "2 000 m2",
                               "-9999", "particles", "memory", "terms", "estimated time"});
    EXPECT_EQ(files(), before);
}

TEST_F(Command, FullDeviceForStandardOutputIsAnError) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    ran("result", {"output.maps=off", "output.animation=off"});
    // All commands that print to stdout; the shell is needed for the redirection only.
    for (const std::string words :
         {"params", "params --json", "materials", "schemes", "--help", "--version", "run --help", "check scene.ini",
          "render result --map max_depth --size 800x600", "render result --charts --size 800x600",
          "compare result --scar perimeter.geojson --size 800x600", "bench stability --case single-cell --threads 1"}) {
        const int status = std::system(
            ("cd " + folder_.string() + " && " FRANA_PROGRAM " " + words + " > /dev/full 2> stderr").c_str());
        EXPECT_EQ(WEXITSTATUS(status), 4) << words << "\n" << read_text(path("stderr"));
        EXPECT_NE(read_text(path("stderr")).find("stdout"), std::string::npos) << words;
    }
}

}  // namespace
}  // namespace frana::test
