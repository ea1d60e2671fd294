// SPDX-License-Identifier: Apache-2.0
// Every key of a scene with absurd values: non-finite or far out of bounds, devices, folders and pipes instead of
// files, texts of ten thousand letters or of no encoding. `check` and `run` must agree, and end.
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "params/keys/scene_parameters.h"
#include "trial_ground.h"
#include "trials.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> k_values{"",
                                        " ",
                                        "nan",
                                        "inf",
                                        "-inf",
                                        "-1",
                                        "0",
                                        "-0",
                                        "1e308",
                                        "-1e308",
                                        "1e-308",
                                        "1e400",
                                        "4e-3x",
                                        "1,5",
                                        "1 2",
                                        "0x10",
                                        "99999999999999999999",
                                        "-99999999999999999999",
                                        "2147483648",
                                        "on",
                                        "off",
                                        "all",
                                        ",",
                                        ",,,,",
                                        "0, 1, 2, 3, 4, 5",
                                        std::string(10000, 'a'),
                                        std::string(5000, '9'),
                                        std::string("1,").append(std::string(4000, '1')),
                                        "\x01\x1b[31m\x7f",
                                        "\xff\xfe\xc3\x28",
                                        "\"",
                                        "'",
                                        "%s%n%d",
                                        "${HOME}",
                                        "=1+1",
                                        "..",
                                        "../..",
                                        ".",
                                        "/",
                                        "/dev/zero",
                                        "/dev/null",
                                        "/dev/full",
                                        "/proc/self/mem",
                                        "/proc/self/environ",
                                        "fifo",
                                        "folder",
                                        "loop",
                                        "nothing.tif",
                                        "dtm.asc",
                                        "dtm.prj",
                                        "perimeter.geojson",
                                        "scene.ini",
                                        "dtm.asc/dtm.asc",
                                        "attribute:",
                                        "attribute:nothing",
                                        "attribute:\xff",
                                        "raster:",
                                        "raster:/dev/zero",
                                        "raster:fifo",
                                        "raster:perimeter.geojson",
                                        "raster:dtm.asc",
                                        "difference:",
                                        "difference:dtm.asc",
                                        "difference:dtm.asc,fifo",
                                        "slip-surface",
                                        "/vsizip//dev/zero",
                                        "/vsicurl/http://127.0.0.1:9/x",
                                        "EPSG:4326",
                                        "EPSG:99999",
                                        "EPSG:-1",
                                        "+proj=nothing",
                                        "+proj=merc +a=1e-300",
                                        "local",
                                        "depth = 2 OR",
                                        "1=1; DROP TABLE x"};

class AbsurdValue : public TrialGround {
  protected:
    void SetUp() override {
        write_scene("[output]\nmaps = off\nanimation = off\nframes = off\ncharts = off\n");
        fs::rename(path("scene.ini"), at("in/scene.ini"));
        fs::create_directory(at("in/folder"));
        fs::create_symlink("loop", at("in/loop"));
        ASSERT_EQ(::mkfifo(at("in/fifo").c_str(), 0644), 0);
        inputs_ = state_of(at("in"));
    }

    void attempt(const std::string& key, const std::string& value, Trials& trials) const {
        std::vector<std::string> check{"check", "in/scene.ini", "--set", "time.end=1"};
        if (key.rfind("structured.", 0) == 0) check.insert(check.end(), {"--set", "material.model=structured"});
        check.insert(check.end(), {"--set", key + "=" + value});
        std::vector<std::string> run_it = check;
        run_it.front() = "run";
        run_it.insert(run_it.end(), {"--memory-limit", "1GB"});
        const bool own_place = key == "output.directory";
        if (!own_place) run_it.insert(run_it.end(), {"--out", "out/r"});

        const Ending checked = run(Launch{check});
        expect_decent_end(checked);
        EXPECT_TRUE(checked.exit_code == 0 || checked.exit_code == 2 || checked.exit_code == 4) << checked.err;
        EXPECT_EQ(in_lines(differences(inputs_, state_of(at("in")))), "") << "check writes";
        Launch launch{run_it};
        launch.stop_after_seconds = 20;
        const Ending ended = run(launch);
        expect_decent_end(ended);
        trials.ended(ended.exit_code);
        const bool for_memory = ended.err.find("--memory-limit") != std::string::npos;
        EXPECT_TRUE(for_memory || (checked.exit_code == 2) == (ended.exit_code == 2))
            << "check says " << checked.exit_code << ": " << checked.err << "run says " << ended.exit_code << ": "
            << ended.err;
        EXPECT_EQ(in_lines(broken_rasters(at("out"))), "");
        const FolderState now =
            part_of(state_of(at("in")), [&](const auto& name) { return inputs_.contains(name) || !own_place; });
        EXPECT_EQ(in_lines(differences(inputs_, now)), "") << "run changes inputs";
        EXPECT_TRUE(ended.exit_code != 2 || !fs::exists(at("out/r"))) << "refused, and yet there is a result";
        clear();
    }

  private:
    void clear() const {
        fs::remove_all(at("out"));
        fs::create_directory(at("out"));
        for (const auto& entry : fs::directory_iterator(at("in")))
            if (!inputs_.contains(entry.path().filename().string()) &&
                !inputs_.contains(entry.path().filename().string() + "/"))
                fs::remove_all(entry.path());
        // An empty folder is a valid place for a result.
        fs::remove_all(at("in/folder"));
        fs::create_directory(at("in/folder"));
    }

    FolderState inputs_;
};

TEST_F(AbsurdValue, OfAnyKeyIsRefusedOrComputed) {
    std::vector<std::pair<std::string, std::string>> all;
    for (const Parameter& parameter : scene_parameters())
        for (const std::string& value : k_values) all.emplace_back(parameter.name(), value);
    RandomNumbers random(trial_seed(), 3);
    for (std::size_t k = all.size(); k > 1; --k) std::swap(all[k - 1], all[random.below(k)]);
    Trials trials;
    for (std::size_t k = 0; k < std::min(all.size(), static_cast<std::size_t>(trial_count(8))); ++k) {
        trials.begin("absurd values");
        SCOPED_TRACE("seed " + std::to_string(trial_seed()) + ", trial " + std::to_string(k) + ": " + all[k].first +
                     " = " + ::testing::PrintToString(all[k].second.substr(0, 60)));
        attempt(all[k].first, all[k].second, trials);
    }
}

}  // namespace
}  // namespace frana::test
