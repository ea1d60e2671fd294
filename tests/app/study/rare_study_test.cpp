// SPDX-License-Identifier: Apache-2.0
// Importance sampling of a place that is seldom reached, as a user sees it.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class RareStudy : public Ensemble {
  protected:
    RareStudy() {
        write_scene("stop-when-still = off\n" + k_numbers_only + "charts = off\ngauges = gauges.geojson\n");
        write_gauges(222);
    }
    /// A gauge on the axis of the flow, so far east of the DTM's western edge [m].
    void write_gauges(double east) const { write_features("gauges", {{"Point", {{east, 72.5}}, named("house")}}); }
    void write_rare(const std::string& head) const { write_study(head, k_keys); }
    const std::string k_keys = "[set]\ntime.end = 1.2\n" + k_two_keys;  // they run on to 12 s
    const std::string k_importance = "sampling = importance\nrare-place = house\n";

    [[nodiscard]] nlohmann::json rare_place() const {
        return json_value(read_text(path("out/summary.json")), "rare_place");
    }
};

// The truth is that of 512 members of an even design, whose own error counts too.
TEST_F(RareStudy, TheHouseIsReachedAsOftenAsManyPlainRunsSay) {
    write_rare("samples = 512\n");
    succeeded(run());
    const int row = 15, column = 44;
    const double plain = probability("probability_depth_0.1", row, column);
    fs::remove_all(path("out"));
    write_rare("samples = 64\n" + k_importance);
    succeeded(run());
    const nlohmann::json rare = rare_place();
    const double p = rare.at("probability"), error = rare.at("standard_error");
    std::printf("512 even members: %g; 64 members: %g +- %g, %g of them came\n", plain, p, error,
                rare.at("members_that_came").get<double>());
    EXPECT_NEAR(p, probability("probability_depth_0.1", row, column), 1e-6) << "Float32 in the map";
    EXPECT_GT(plain, 0);
    EXPECT_LT(plain, 0.05);
    EXPECT_LT(std::abs(p - plain), 3 * std::hypot(error, std::sqrt(plain / 512)));
    EXPECT_LT(error, std::sqrt(plain / 64) / 2) << "of plain members";
    EXPECT_GT(rare.at("members_that_came").get<double>(), 64 * 4 * plain);
    double weights = 0, near = 0;
    for (const auto& member : members()) {
        weights += std::stod(member.at("weight"));
        near += std::stoi(member.at("member")) >= 32 ? std::stod(member.at("weight")) : 0;
    }
    EXPECT_NEAR(weights, 64, 12);
    EXPECT_LT(near, weights / 4);
}

TEST_F(RareStudy, SameBitsForAnyNumberOfThreadsAndAfterAKill) {
    write_rare("samples = 64\n" + k_importance);
    for (const std::string threads : {"1", "3"})
        succeeded(frana({"ensemble", "study.ini", "--out", "out" + threads, "--threads", threads, "--quiet"}));
    expect_same("out1", "out3");
    ASSERT_EQ(stop_after(40, SIGKILL).exit_code, -SIGKILL);  // within the second round
    succeeded(run({"--resume"}));
    expect_same("out1", "out");
}

// With every run cut nobody knows: from nothing to one, as the map has it.
TEST_F(RareStudy, RunsThatWereCutMayHaveComeThere) {
    write_study("samples = 64\n" + k_importance, "[set]\ntime.end = 0.6\n" + k_two_keys);
    succeeded(run());
    EXPECT_EQ(parse_json(read_text(path("out/summary.json")))["run_troubles"]["cut"], 64);
    EXPECT_EQ(rare_place().at("interval_95").at(1), 1);
}

TEST_F(RareStudy, WhatDoesNotGoTogetherIsRefused) {
    const auto expect_refused = [&](const std::string& words) {
        expect_run_refused({words});
        EXPECT_FALSE(fs::exists(path("out")));
    };
    write_rare("samples = 64\nsampling = importance\nrare-place = hose\n");
    expect_refused("is no gauge of the scene");
    write_scene(k_numbers_only);
    write_rare("samples = 64\n" + k_importance);
    expect_refused("output.gauges");
}

}  // namespace
}  // namespace frana::test
