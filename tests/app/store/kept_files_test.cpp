// SPDX-License-Identifier: Apache-2.0
// No picture and no table replaces an input or a file of a result, whichever path or name leads to it.
#include <csignal>
#include <fstream>

#include "app/store/manifest.h"
#include "started_program.h"
#include "support/checked_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

const std::string k_foreign = "exists already and was not written by frana",
                  k_changed = "was changed since frana wrote it, or is the user's";

class KeptFilesOf : public CheckedScene {
  protected:
    void SetUp() override {
        write_scene("frame-interval = 1\n[output]\nmaps = off\nanimation = off\nreport = off\n");
        ran("result", {"time.end=2"});
    }
    [[nodiscard]] std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const std::string& name : files())
            if (fs::is_regular_file(path(name)) && name.find(".started") == std::string::npos)
                all[name] = read_text(path(name));
        return all;
    }
    /// These words among the problems, and every file unchanged.
    void expect_refusal(const std::vector<std::string>& arguments, const std::vector<std::string>& words) const {
        const auto before = contents();
        std::string told;
        if (arguments.front() == "bench" || arguments.front() == "converge")  // which become, or load, other programs
            told = frana(arguments).err;
        else
            for (const Problem& problem : refusal(arguments)) told += describe(problem) + '\n';
        expect_words(told, words);
        EXPECT_TRUE(contents() == before);
    }
    void expect_refusal(const std::vector<std::string>& arguments, const std::string& words) const {
        expect_refusal(arguments, std::vector<std::string>{words});
    }
};

TEST_F(KeptFilesOf, ARasterThatIsDrawn) {
    fs::create_directory(path("maps"));
    fs::create_hard_link(path("result/max_depth.tif"), path("maps/max_depth.png"));
    expect_refusal({"render", "result/max_depth.tif", "--out", "maps", "--size", "640x480"},
                   "--out: would be overwritten: it is an input (value maps/max_depth.png)");
}

TEST_F(KeptFilesOf, AResult) {
    fs::create_symlink(path("result/max_depth.tif"), path("film.mp4"));
    expect_refusal({"render", "result", "--animation", "film.mp4", "--size", "640x480"}, k_foreign);
    fs::create_directory(path("pictures"));
    fs::create_symlink(path("dtm.asc"), path("pictures/max_depth.png"));
    expect_refusal({"render", "result", "--map", "max_depth", "--out", "pictures", "--size", "640x480"}, k_foreign);
    fs::create_directory(path("charts"));
    fs::create_hard_link(path("result/summary.json"), path("charts/timeseries.png"));
    expect_refusal({"render", "result", "--charts", "--out", "charts"}, k_foreign);
}

TEST_F(KeptFilesOf, AComparisonsInputs) {
    write_polygon("scar", {{20, 55}, {150, 55}, {150, 95}, {20, 95}});
    fs::create_directory(path("foreign"));
    fs::copy_file(path("result/max_depth.tif"), path("foreign/comparison.tif"));
    expect_refusal({"compare", "foreign/comparison.tif", "--scar", "scar.geojson", "--out", "foreign"},
                   "would be overwritten");
    fs::rename(path("scar.geojson"), path("result/comparison.json"));
    expect_refusal({"compare", "result", "--scar", "result/comparison.json"}, "would be overwritten");
}

TEST_F(KeptFilesOf, AConvergenceStudysInputs) {
    fs::create_directory(path("study"));
    fs::rename(path("dtm.asc"), path("study/convergence.csv"));
    fs::rename(path("dtm.prj"), path("study/convergence.prj"));
    expect_refusal({"converge", "scene.ini", "--set", "terrain.dtm=study/convergence.csv", "--out", "study", "--quiet"},
                   "would be overwritten");
}

class OwnFiles : public KeptFilesOf {};

TEST_F(OwnFiles, OfAComparisonAreReplacedAndNoOthers) {
    write_polygon("scar", {{20, 55}, {150, 55}, {150, 95}, {20, 95}});
    const std::vector<std::string> compare{
        "compare", "result/max_depth.tif", "--scar", "scar.geojson", "--out", "compared", "--size", "640x480"};
    fs::create_directory(path("compared"));
    write("compared/comparison.png", "the user's");
    expect_refusal(compare, k_foreign);
    fs::remove(path("compared/comparison.png"));
    for (int i = 0; i < 2; ++i) succeeded(frana(compare));
    write("compared/comparison.json", "edited");
    expect_refusal(compare, k_changed);
    fs::remove_all(path("compared"));
    fs::create_directory(path("compared"));
    write("compared/manifest.json", "{\"name\": \"of a web page\"}");
    expect_refusal(compare, "is not frana's list of files");
    // In a result they belong to it.
    for (int i = 0; i < 2; ++i) succeeded(frana({"compare", "result", "--scar", "scar.geojson", "--size", "640x480"}));
    EXPECT_TRUE(app::read_manifest(path("result")).value().files.contains("comparison.png"));
}

TEST_F(OwnFiles, OfAStudyAreReplacedAndNoOthers) {
    fs::create_directory(path("study"));
    write("study/uncertainty.tif", "the user's");
    const std::vector<std::string> study{"converge", "scene.ini", "--out", "study", "--quiet", "--set", "time.end=1"};
    expect_refusal(study, k_foreign);
    fs::remove(path("study/uncertainty.tif"));
    succeeded(frana(study));
    expect_refusal(study, "contains a convergence study already");
    std::vector<std::string> again = study;
    again.emplace_back("--overwrite");
    succeeded(frana(again));
    write("study/convergence.csv", "edited");
    expect_refusal(again, k_changed);
}

TEST_F(OwnFiles, OfABenchAreReplacedAndNoOthers) {
    const std::vector<std::string> bench{"bench", "accuracy", "--quick", "--case", "lake-z1", "--out", "bench"};
    fs::create_directory(path("bench"));
    write("bench/accuracy.csv", "the user's");
    expect_refusal(bench, k_foreign);
    fs::remove(path("bench/accuracy.csv"));
    for (int i = 0; i < 2; ++i) succeeded(frana(bench));
}

// Redrawn pictures belong to the result: a run that replaces it removes them.
TEST_F(OwnFiles, OfARedrawnResultAreReplacedWithIt) {
    succeeded(frana({"render", "result", "--map", "max_depth", "--map", "release", "--size", "640x480"}));
    succeeded(frana({"run", "scene.ini", "--out", "result", "--overwrite", "--quiet", "--set", "time.end=1"}));
    EXPECT_FALSE(fs::exists(path("result/maps/release.png")));
}

// Each of two runs keeps its own files, whatever command writes, and however the place is written.
class AnotherResult : public KeptFilesOf {
  protected:
    void SetUp() override {
        KeptFilesOf::SetUp();
        fs::copy(path("result"), path("other"), fs::copy_options::recursive);
        write_polygon("scar", {{20, 55}, {150, 55}, {150, 95}, {20, 95}});
    }
    void expect_both_named(const std::vector<std::string>& arguments, const std::string& reads) const {
        std::vector<std::string> words{"is in another result, " + fs::canonical(path("other")).string()};
        if (!reads.empty()) words.insert(words.end(), {"the input is " + reads, "Choose a place outside it"});
        expect_refusal(arguments, words);
    }
};

TEST_F(AnotherResult, IsNotComparedInto) {
    expect_both_named({"compare", "result", "--scar", "scar.geojson", "--out", "other"}, "result");
    expect_both_named({"compare", "result", "--scar", "scar.geojson", "--out", "other/new/folder"}, "result");
    expect_both_named({"compare", "result/max_depth.tif", "--scar", "scar.geojson", "--out", "other"},
                      "result/max_depth.tif");
    for (const std::string own : {"result", "result/more"})
        succeeded(frana({"compare", "result", "--scar", "scar.geojson", "--out", own, "--size", "640x480"}));
}

TEST_F(AnotherResult, IsNotDrawnInto) {
    fs::create_directory_symlink(path("other"), path("alias"));
    expect_both_named({"render", "result", "--map", "max_depth", "--out", "other/maps"}, "result");
    expect_both_named({"render", "result", "--map", "max_depth", "--out", "alias/maps"}, "result");
    expect_both_named({"render", "result", "--animation", "other/animation.mp4"}, "result");
    expect_both_named({"render", "result", "--charts", "--out", "other/charts"}, "result");
    expect_both_named({"render", "dtm.asc", "--out", "other/maps"}, "dtm.asc");
    for (const std::string own : {"result/maps", "result/more"})
        succeeded(frana({"render", "result", "--map", "max_depth", "--out", own, "--size", "640x480"}));
}

TEST_F(AnotherResult, RefusesAStudy) {
    expect_both_named({"bench", "accuracy", "--quick", "--case", "lake-z1", "--out", "other"}, "");
    expect_both_named({"converge", "scene.ini", "--quiet", "--set", "time.end=1", "--out", "other/study"}, "");
}

class OwnPictures : public KeptFilesOf {
  protected:
    static std::vector<std::string> animation(const std::string& name) {
        return {"render", "result", "--animation", name, "--size", "640x480"};
    }
};

TEST_F(OwnPictures, AreReplacedAndNoOthers) {
    const std::vector<std::string> draw{"render", "result",   "--map",  "max_depth",
                                        "--out",  "pictures", "--size", "640x480"};
    fs::create_directory(path("pictures"));
    write("pictures/max_depth.png", "the user's");
    expect_refusal(draw, k_foreign);
    fs::remove(path("pictures/max_depth.png"));
    for (int i = 0; i < 2; ++i) succeeded(frana(draw));
    write("pictures/max_depth.png", "edited");
    expect_refusal(draw, k_changed);
    fs::create_directory(path("charts"));
    write("charts/timeseries.png", "the user's");
    expect_refusal({"render", "result", "--charts", "--out", "charts"}, k_foreign);
    write("max_depth.png", "the user's");
    expect_refusal({"render", "result/max_depth.tif", "--size", "640x480"}, k_foreign);
}

// The program that drew them was killed before it listed them.
TEST_F(OwnPictures, OfAKilledProgramAreReplaced) {
    const std::vector<std::string> draw{"render", "result",       "--map",  "max_depth",
                                        "--map",  "max_velocity", "--size", "640x480"};
    {
        StartedProgram program(folder_.string(), draw);
        ASSERT_TRUE(program.wait_until([&] { return fs::exists(path("result/maps/max_depth.png")); }));
        program.send(SIGKILL);
        program.wait();
    }
    succeeded(frana(draw));
    write("result/maps/max_depth.png", "edited");
    expect_refusal(draw, k_changed);
}

TEST_F(OwnPictures, AreNotDrawnThroughALink) {
    fs::remove_all(path("result/maps"));
    fs::create_directory(path("elsewhere"));
    fs::create_directory_symlink(path("elsewhere"), path("result/maps"));
    const Outcome outcome = frana({"render", "result", "--map", "max_depth", "--size", "640x480"});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find("is a symbolic link: pictures would be written elsewhere"), std::string::npos);
    EXPECT_TRUE(fs::is_empty(path("elsewhere")));
}

TEST_F(OwnPictures, OfAnimationsAreReplacedAndNoOthers) {
    write("film.gif", "the user's");
    expect_refusal(animation("film.gif"), k_foreign);
    fs::remove(path("film.gif"));
    for (int i = 0; i < 2; ++i) succeeded(frana(animation("film.gif")));
}

}  // namespace
}  // namespace frana::test
