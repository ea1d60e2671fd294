// SPDX-License-Identifier: Apache-2.0
// Flow not shown on maps is refused at the start or reported at the end.
#include <cmath>
#include <filesystem>

#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using ThinFlow = TinyScene;

TEST_F(ThinFlow, ReleasedEverywhereIsRefused) {
    write_scene(k_numbers_only);
    for (const std::string command : {"run", "check"}) {
        refusal_of(frana({command, "scene.ini", "--set", "release.thickness=0.005"}),
                   {"release.thickness", "Set numerics.minimum-depth = 0.0005 or less"});
    }
    EXPECT_FALSE(std::filesystem::exists(path("results")));
    succeeded(
        frana({"run", "scene.ini", "--set", "release.thickness=0.005", "--set", "numerics.minimum-depth=0.0005"}));
}

TEST_F(ThinFlow, ReleasedInPartIsAWarningOfCheckAndRun) {
    write_scene(k_numbers_only);
    write_features("two", {{"Polygon", box(20, 55, 45, 95), R"("depth": 0.02)"},
                           {"Polygon", box(45, 55, 70, 95), R"("depth": 0.008)"}});
    const std::vector<std::string> more{"--set", "release.perimeter=two.geojson", "--set",
                                        "release.thickness=attribute:depth"};
    std::vector<std::string> check{"check", "scene.ini"}, run{"run", "scene.ini", "--out", "result"};
    for (auto* words : {&check, &run}) words->insert(words->end(), more.begin(), more.end());
    const std::string told = "% of flow thinner than numerics.minimum-depth = 0.01 m: lower it";
    for (const auto& words : {check, run}) {
        const Outcome outcome = succeeded(frana(words));
        EXPECT_NE(outcome.err.find(told), std::string::npos) << words.front() << ": " << outcome.err;
    }
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_TRUE(json_lists(summary, "warnings", told)) << summary;
}

TEST_F(ThinFlow, ThatOutlinesDoNotShowIsAWarningOfCheckAndRun) {
    write_scene(k_numbers_only);
    const std::string released = "100 % of flow thinner than output.trace-threshold = 0.1 m",
                      flowed = "flow nowhere deeper than output.trace-threshold = 0.1 m (0.0";
    const auto call = [&](std::vector<std::string> words, const std::string& threshold) {
        for (const std::string& set :
             {std::string("release.thickness=0.05"), std::string("numerics.minimum-depth=0.0005"), threshold})
            words.insert(words.end(), {"--set", set});
        const Outcome outcome = succeeded(frana(words));
        return outcome.err;
    };
    const std::string check = call({"check", "scene.ini"}, "output.trace-threshold=0.1");
    EXPECT_NE(check.find(released), std::string::npos) << check;
    const std::string run = call({"run", "scene.ini", "--out", "result"}, "output.trace-threshold=0.1");
    EXPECT_NE(run.find(released), std::string::npos) << run;
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_EQ(json_number(summary, "covered_area_m2"), 0);
    EXPECT_TRUE(json_lists(summary, "warnings", flowed)) << summary;
    // Following the remedy.
    const std::string heeded = call({"run", "scene.ini", "--out", "heeded"}, "output.trace-threshold=0.005");
    EXPECT_EQ(heeded.find("output.trace-threshold"), std::string::npos) << heeded;
    EXPECT_GT(json_number(read_text(path("heeded/summary.json")), "covered_area_m2"), 2000);
}

TEST_F(ThinFlow, DuringTheRunIsAWarning) {
    write_scene(k_numbers_only);
    const Outcome outcome = succeeded(
        frana({"run", "scene.ini", "--out", "result", "--set", "release.thickness=0.02", "--set", "time.end=30"}));
    EXPECT_NE(outcome.err.find("% of flow thinner than numerics.minimum-depth = 0.01 m"), std::string::npos)
        << outcome.err;
    EXPECT_GT(json_number(read_text(path("result/summary.json")), "greatest_thin_fraction"), 0.1);
    const Outcome usual = frana({"run", "scene.ini", "--out", "usual"});
    EXPECT_EQ(usual.err.find("thinner than"), std::string::npos) << usual.err;
}

// Pressure zones lost their thin and fast margins.
TEST_F(ThinFlow, ZonesOfPressureFollowThePressureRasterToTheCell) {
    write("own.ini", own_scheme("pressure > ", "3 kPa", "10 kPa"));
    write_scene(k_numbers_only + "trace-threshold = 0.5\n[hazard]\nscheme = own.ini\n");
    ran("result", {"material.density=2000"});
    const auto raster = [&](const std::string& name) { return gis::read_result_raster(path("result/" + name)); };
    const Raster classes = raster("hazard.tif"), pressure = raster("max_pressure.tif"), depth = raster("max_depth.tif");
    int shallow = 0;
    for (std::size_t i = 0; i < classes.values.size(); ++i) {
        const double kPa = pressure.values[i];
        ASSERT_EQ(std::isnan(classes.values[i]), std::isnan(kPa));
        if (std::isnan(kPa)) continue;
        ASSERT_EQ(classes.values[i], kPa > 10 ? 3 : kPa > 3 ? 2 : 1) << kPa;
        shallow += kPa > 3 && depth.values[i] <= 0.5 ? 1 : 0;
    }
    EXPECT_GT(shallow, 0) << "margins that a least depth would take away";
    EXPECT_EQ(gis::read_raster_text(path("result/max_pressure.tif")).metadata["DENSITY"], "2000 kg/m3");
    // The classes of a run that was cut say so wherever they go.
    ran("cut", {"material.density=2000", "time.end=1"});
    EXPECT_TRUE(gis::read_raster_text(path("cut/hazard.tif")).metadata.contains("LOWER_BOUND"));
}

}  // namespace
}  // namespace frana::test
