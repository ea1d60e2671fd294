// SPDX-License-Identifier: Apache-2.0
// numerics.accuracy as a user meets it.
#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/input/share_directory.h"
#include "params/scene/read_scene.h"
#include "resuming.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

// Cells of 2 m on a DTM of 5 m: the release of 50 m x 40 m has levels of 12, 8, 6 and 4 m.
class AccuracyRun : public TinyScene {
  protected:
    AccuracyRun() { write_scene(k_numbers_only); }

    [[nodiscard]] Outcome run(const std::string& result, const std::vector<std::string>& more) const {
        return frana(with_more({"run", "scene.ini", "--out", result, "--quiet", "--set", "terrain.cell-size=2"}, more));
    }
    [[nodiscard]] Json summary(const std::string& result) const {
        return parse_json(read_text(path(result + "/summary.json")));
    }
    [[nodiscard]] std::string bytes(const std::string& file) const { return read_text(path(file)); }
};

TEST_F(AccuracyRun, TellsLevelsCostEstimatesAndVerdict) {
    succeeded(run("result", {"--accuracy", "2%", "--set", "output.report=on"}));
    const Json all = summary("result"), accuracy = all.at("accuracy");
    EXPECT_EQ(accuracy.at("asked"), 0.02);
    EXPECT_EQ(accuracy.at("finest_cell_size_m"), 2.0);
    EXPECT_EQ(accuracy.at("dtm_cell_size_m"), 5.0);
    EXPECT_EQ(accuracy.at("cell_size_m"), all.at("grid").at("cell_size"));
    std::vector<double> sizes;
    for (const Json& level : accuracy.at("levels")) {
        sizes.push_back(level.at("cell_size_m"));
        // The coarser levels are finite volumes, without particles; what is claimed is the scene's own scheme.
        EXPECT_EQ(level.at("particles").get<int>() > 0, level == accuracy.at("levels").back());
        EXPECT_GT(level.at("engine_seconds").get<double>(), 0);
    }
    ASSERT_GE(sizes.size(), 4U);
    EXPECT_EQ((std::vector<double>(sizes.begin(), sizes.begin() + 4)), (std::vector<double>{12, 8, 6, 4}));
    // The values are those of the result, in the same words and to the last digit.
    std::size_t within = 0;
    for (const Json& value : accuracy.at("values")) {
        const std::string key = value.at("key");
        const Json& own = key == "runout_m" ? all.at("runout").at("horizontal_m") : all.at(key);
        EXPECT_EQ(value.at("value"), own) << key;
        const Json& error = value.at("estimated_error");
        EXPECT_EQ(error.is_null(), value.at("trend") == "diverging") << key;
        EXPECT_TRUE(error.is_null() || error.get<double>() > 0) << key;
        within += value.at("within").get<bool>() ? 1 : 0;
    }
    EXPECT_EQ(accuracy.at("values").size(), 6U);
    EXPECT_EQ(accuracy.at("reached").get<bool>(), within == 6);
    // Nothing is left unclaimed before the scene's own cells are computed.
    EXPECT_TRUE(within == 6 || accuracy.at("cell_size_m") == 2.0) << accuracy.at("cell_size_m");
    // The run-out is not known better than to a cell.
    if (const Json& error = accuracy.at("values").back().at("estimated_error"); !error.is_null()) {
        EXPECT_GE(error.get<double>(), accuracy.at("cell_size_m").get<double>());
    }
    const std::string verdict = accuracy.at("verdict");
    expect_words(verdict, {"numerics.accuracy = 2 %", "finer than the DTM's 5 m"});
    for (const char* file : {"result/log.txt", "result/report.html"}) {
        expect_words(bytes(file), {"stimated error", "12"});
    }
    // What is not claimed is a warning.
    EXPECT_EQ(json_lists(bytes("result/summary.json"), "warnings", "not met by"), within != 6);
}

TEST_F(AccuracyRun, IsThePlainRunOnTheCellsThatItChose) {
    succeeded(run("result", {"--accuracy", "0.02", "--threads", "2"}));
    const double chosen = summary("result").at("grid").at("cell_size");
    succeeded(frana({"run", "scene.ini", "--out", "plain", "--quiet", "--threads", "1", "--set",
                     "terrain.cell-size=" + std::to_string(chosen)}));
    for (const char* key : {"max_depth_m", "max_velocity_ms", "covered_area_m2", "steps", "particle_steps", "volume"})
        EXPECT_EQ(summary("result").at(key), summary("plain").at(key)) << key;
    EXPECT_FALSE(summary("plain").contains("accuracy"));
    // Its own scene gives it again, one thread or two.
    const Outcome again = succeeded(frana({"run", "result/scene.ini", "--out", "again", "--quiet", "--threads", "1"}));
    Json one = summary("result").at("accuracy"), other = summary("again").at("accuracy");
    for (Json* accuracy : {&one, &other})
        for (Json& level : accuracy->at("levels")) level.erase("engine_seconds");
    EXPECT_EQ(one, other);
    EXPECT_EQ(summary("result").at("max_depth_m"), summary("again").at("max_depth_m"));
}

TEST_F(AccuracyRun, StopsAtTheCoarsestCellsThatAreGoodEnough) {
    ran("loose", {"numerics.accuracy=100 %", "terrain.cell-size=1"});
    const Json accuracy = summary("loose").at("accuracy");
    ASSERT_TRUE(accuracy.at("reached").get<bool>()) << accuracy.dump(1);
    for (const Json& value : accuracy.at("values"))
        EXPECT_LE(value.at("estimated_error"), value.at("allowed_error")) << value.dump();
    // Nothing finer was computed.
    EXPECT_EQ(accuracy.at("levels").back().at("cell_size_m"), accuracy.at("cell_size_m"));
    EXPECT_GT(accuracy.at("cell_size_m").get<double>(), 1);
    EXPECT_NE(accuracy.at("verdict").get<std::string>().find("met by 6 of 6 values"), std::string::npos);
}

TEST_F(AccuracyRun, WithoutCoarserLevelsClaimsNothing) {
    // 50 m x 40 m are two cells of 30 m.
    succeeded(
        frana({"run", "scene.ini", "--out", "result", "--quiet", "--accuracy", "5%", "--set", "terrain.cell-size=10"}));
    const Json accuracy = summary("result").at("accuracy");
    EXPECT_FALSE(accuracy.at("reached").get<bool>());
    EXPECT_EQ(accuracy.at("cell_size_m"), 10.0);
    EXPECT_TRUE(accuracy.at("values").empty());
    EXPECT_NE(accuracy.at("verdict").get<std::string>().find("too few coarser levels"), std::string::npos);
}

TEST_F(AccuracyRun, EstimatesGaugesAndSections) {
    write_features("gauges", {{"Point", {{80, 70}}, named("near")}, {"Point", {{285, 70}}, named("far")}});
    succeeded(run("result", {"--accuracy", "20%", "--set", "output.gauges=gauges.geojson"}));
    std::vector<std::string> keys;
    const Json accuracy = summary("result").at("accuracy");
    for (const Json& value : accuracy.at("values")) {
        keys.push_back(value.at("key"));
        // Never reached: nothing is known of its error.
        const bool is_far = keys.back().starts_with("gauge far");
        EXPECT_EQ(value.at("zero_on_all_levels").get<bool>(), is_far) << value.dump();
        EXPECT_TRUE(!is_far || !value.at("within").get<bool>()) << value.dump();
    }
    for (const char* key : {"gauge near: max_depth_m", "gauge near: max_speed_ms", "gauge far: max_depth_m"})
        EXPECT_NE(std::find(keys.begin(), keys.end(), key), keys.end()) << key;
}

TEST_F(AccuracyRun, IsAPercentageOrAFraction) {
    const Outcome outcome =
        succeeded(frana({"check", "scene.ini", "--set", "numerics.accuracy=2%", "--set", "terrain.cell-size=2"}));
    EXPECT_NE(outcome.out.find("2 %: cells of 12, 8, 6, 4, then at most 2 m"), std::string::npos) << outcome.out;
    for (const char* value : {"2 %", "2%", "0.02"})
        EXPECT_EQ(read_scene(path("scene.ini"), {std::string("numerics.accuracy=") + value}, app::share_directory())
                      .scene.numerics.accuracy,
                  0.02)
            << value;
}

// Flight is what finite volumes lack: all levels are then particles.
TEST_F(AccuracyRun, UsesParticlesWhereFiniteVolumesAreRefused) {
    succeeded(run("result", {"--accuracy", "100%", "--set", "numerics.flight=on"}));
    const Json levels = summary("result").at("accuracy").at("levels");
    EXPECT_GE(levels.size(), 3U);
    for (const Json& level : levels) EXPECT_GT(level.at("particles"), 0) << level.dump();
}

// A scene of a second on cells of 1 m, which are twice its own.
class AccuracyResume : public Resuming {
  protected:
    [[nodiscard]] Json summary(const std::string& result) const {
        return parse_json(read_text(path(result + "/summary.json")));
    }
};

TEST_F(AccuracyResume, ContinuesOnTheCellsThatItHadChosen) {
    const std::vector<std::string> fine{"--accuracy", "2%", "--set", "terrain.cell-size=0.5"};
    succeeded(frana(run("whole", fine)));
    interrupt("result", fine);
    std::vector<std::string> again = run("result", fine);
    again.emplace_back("--resume");
    std::vector<std::string> other = again;
    std::replace(other.begin(), other.end(), std::string("2%"), std::string("3%"));
    refusal_of(frana(other), {"numerics.accuracy is 0.03 here and was 0.02"});
    const Outcome outcome = succeeded(frana(again));
    EXPECT_NE(outcome.err.find("resuming from"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("coarser levels first"), std::string::npos) << outcome.err;
    for (const char* key : {"grid", "max_depth_m", "max_velocity_ms", "steps", "volume"})
        EXPECT_EQ(summary("result").at(key), summary("whole").at(key)) << key;
    EXPECT_EQ(summary("result").at("accuracy").at("values"), summary("whole").at("accuracy").at("values"));
    expect_tidy("result");
    // Finished: there is nothing to compute.
    const Outcome complete = succeeded(frana(again));
    EXPECT_NE(complete.err.find("the result is complete"), std::string::npos) << complete.err;
}

TEST_F(AccuracyRun, ASignalDuringTheCoarserLevelsLeavesNothing) {
    StartedProgram program(folder_.string(), {"run", "scene.ini", "--out", "result", "--accuracy", "2%", "--set",
                                              "terrain.cell-size=0.25", "--set", "time.end=30"});
    ASSERT_TRUE(program.wait_until([&] {
        return read_text(path(".started_stderr")).find("coarser levels first") != std::string::npos;
    })) << program.wait().err;
    program.send(SIGTERM);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, 143) << outcome.err;
    EXPECT_NE(outcome.err.find("nothing was written"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(path("result")));
    for (const std::string& name : files()) EXPECT_EQ(name.find("result"), std::string::npos) << name;
}

}  // namespace
}  // namespace frana::test
