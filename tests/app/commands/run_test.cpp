// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "gis/raster/raster_in.h"
#include "same_result.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> k_rasters{"max_depth", "max_velocity", "final_depth", "arrival_time", "max_pressure"};

/// Bits of all values, so that NaN compares equal to itself.
std::vector<std::uint64_t> bits(const std::string& file) {
    const Raster raster = gis::read_result_raster(file);
    std::vector<std::uint64_t> list(raster.values.size());
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = std::bit_cast<std::uint64_t>(raster.values[i]);
    return list;
}

using RunCommand = TinyScene;

TEST_F(RunCommand, WritesEveryFileOfTheContract) {
    write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
    write_scene("frame-interval = 1\n[output]\nmap-size = 640x480\n[scar]\nperimeter = scar.geojson\n");
    const Outcome outcome = ran();
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
    std::vector<std::string> expected{"scene.ini",
                                      "summary.json",
                                      "extent.gpkg",
                                      "timeseries.csv",
                                      "log.txt",
                                      "comparison.json",
                                      "comparison.tif",
                                      "comparison.png",
                                      "dtm.tif",
                                      "release.tif",
                                      "animation.mp4",
                                      "frames/depth_0000.tif",
                                      "frames/velocity_0004.tif",
                                      "maps/max_depth.png",
                                      "maps/max_velocity.png"};
    for (const std::string& name : k_rasters)
        for (const char* ending : {".tif", ".qml", ".sld"}) expected.push_back(name + ending);
    for (const std::string& name : expected) {
        EXPECT_TRUE(fs::exists(path("result/" + name))) << name;
        EXPECT_GT(fs::file_size(path("result/" + name)), 0U) << name;
    }
    for (const std::string& name : files()) EXPECT_EQ(name.find("partial"), std::string::npos) << name;

    const std::string summary = read_text(path("result/summary.json"));
    for (const std::string key : {"program",
                                  "version",
                                  "scene",
                                  "model",
                                  "scheme",
                                  "crs",
                                  "threads",
                                  "steps",
                                  "simulated_seconds",
                                  "stop_reason",
                                  "grid",
                                  "columns",
                                  "rows",
                                  "cell_size",
                                  "particles",
                                  "initial",
                                  "final",
                                  "peak",
                                  "terms",
                                  "wall_seconds",
                                  "total",
                                  "input",
                                  "engine",
                                  "output",
                                  "render",
                                  "particle_steps",
                                  "particle_steps_per_second",
                                  "peak_memory_bytes",
                                  "volume",
                                  "initial_m3",
                                  "final_m3",
                                  "left_domain_m3",
                                  "relative_error",
                                  "max_depth_m",
                                  "max_velocity_ms",
                                  "covered_area_m2",
                                  "runout",
                                  "horizontal_m",
                                  "drop_m",
                                  "reach_angle_deg",
                                  "hard_events"})
        EXPECT_TRUE(json_has(summary, key)) << key;
    EXPECT_EQ(json_number(summary, "columns"), 60);
    EXPECT_EQ(json_number(summary, "cell_size"), 5);
    // 50 m x 40 m x 2 m; the outline's corners are on cell edges, so the lattice fills it exactly except for rounding
    EXPECT_NEAR(json_number(summary, "initial_m3"), 4000, 1e-6);
    EXPECT_LE(json_number(summary, "relative_error"), 1e-12);  // the measure
    EXPECT_EQ(json_number(summary, "non_finite"), 0);
    EXPECT_GT(json_number(summary, "max_velocity_ms"), 1);

    const std::string comparison = read_text(path("result/comparison.json"));
    for (const std::string key : {"threshold_m", "observed_area_m2", "simulated_area_m2", "area_difference_percent",
                                  "hit_m2", "false_alarm_m2", "miss_m2", "jaccard", "dice", "csi", "true_positive_rate",
                                  "false_positive_rate", "d2pc", "auroc", "runout_difference_m"})
        EXPECT_TRUE(json_has(comparison, key)) << key;
    EXPECT_EQ(json_number(comparison, "observed_area_m2"), 165 * 50);
}

TEST_F(RunCommand, RastersHavePlaceNodataAndTexts) {
    write_scene(k_numbers_only);
    ran();
    GDALAllRegister();
    for (const std::string& name : k_rasters) {
        const GDALDatasetUniquePtr file(GDALDataset::Open(path("result/" + name + ".tif").c_str()));
        ASSERT_TRUE(file) << name;
        EXPECT_STREQ(file->GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG") << name;
        GDALRasterBand* band = file->GetRasterBand(1);
        EXPECT_EQ(band->GetNoDataValue(), -9999) << name;
        EXPECT_EQ(band->GetRasterDataType(), GDT_Float32) << name;
        EXPECT_NE(std::string(band->GetDescription()), "") << name;
        EXPECT_NE(band->GetMetadataItem("STATISTICS_MAXIMUM"), nullptr) << name;
        double transform[6];
        ASSERT_EQ(file->GetGeoTransform(transform), CE_None);
        EXPECT_EQ(transform[0], k_west);
        EXPECT_EQ(transform[3], k_south + k_rows * k_cell);
        ASSERT_NE(file->GetSpatialRef(), nullptr) << name;
        EXPECT_STREQ(file->GetSpatialRef()->GetAuthorityCode(nullptr), "32632") << name;
    }
}

TEST_F(RunCommand, TheResolvedSceneReproducesTheRunWhateverTheThreads) {
    write_scene("stop-when-still = off\nstop-change = 0\n[numerics]\nparticles-per-cell = 9\n" + k_numbers_only);
    succeeded(frana({"run", "scene.ini", "--out", "a", "--quiet", "--threads", "1", "--set", "time.end=3"}));
    fs::create_directory(folder_ / "elsewhere");
    fs::copy_file(path("a/scene.ini"), path("elsewhere/again.ini"));
    succeeded(frana({"run", "elsewhere/again.ini", "--out", "b", "--quiet", "--threads", "3"}));
    for (const std::string& name : k_rasters)
        EXPECT_EQ(bits(path("a/" + name + ".tif")), bits(path("b/" + name + ".tif"))) << name;
    EXPECT_EQ(read_text(path("a/timeseries.csv")), read_text(path("b/timeseries.csv")));
    EXPECT_EQ(json_number(read_text(path("b/summary.json")), "simulated_seconds"), 3);
}

// Bytes of every file, pictures and animation too; except those that contain the time of day or a duration.
TEST_F(RunCommand, EveryOutputIsTheSameForAnyNumberOfThreadsAndASecondTime) {
    write_scene("frame-interval = 1\n[output]\nmap-size = 640x480\n" + k_one_day);
    const std::vector<std::string> runs{"1", "2", "3", "7", "1"};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::string result = "result" + std::to_string(i);
        succeeded(frana({"run", "scene.ini", "--out", result, "--quiet", "--threads", runs[i]}));
    }
    for (std::size_t i = 1; i < runs.size(); ++i) {
        SCOPED_TRACE(runs[i] + " threads");
        EXPECT_GT(expect_same_files(path("result0"), path("result" + std::to_string(i))), 25U);
    }
}

TEST_F(RunCommand, AnExistingResultIsKeptWithoutOverwrite) {
    write_scene(k_numbers_only);
    ran();
    write("result/notes.txt", "mine");
    const std::string before = read_text(path("result/summary.json"));
    refusal_of(frana({"run", "scene.ini", "--out", "result"}), {"--overwrite"});
    EXPECT_EQ(read_text(path("result/summary.json")), before);

    const std::vector<std::string> overwrite{"run",         "scene.ini", "--out", "result",
                                             "--overwrite", "--quiet",   "--set", "time.end=2"};
    refusal_of(frana(overwrite));
    EXPECT_EQ(read_text(path("result/notes.txt")), "mine");
    EXPECT_EQ(read_text(path("result/summary.json")), before);
    fs::remove(path("result/notes.txt"));
    succeeded(frana(overwrite));
    EXPECT_EQ(json_number(read_text(path("result/summary.json")), "simulated_seconds"), 2);
    // An invalid scene does not remove the older result either.
    refusal_of(frana({"run", "scene.ini", "--out", "result", "--overwrite", "--set", "numerics.cfl=9"}));
    EXPECT_EQ(json_number(read_text(path("result/summary.json")), "simulated_seconds"), 2);
}

TEST_F(RunCommand, ASignalWritesTheResultSoFar) {
    write_scene("stop-when-still = off\nstop-change = 0\n[numerics]\nparticles-per-cell = 16\n" + k_numbers_only);
    const Outcome outcome = frana(
        {"run", "scene.ini", "--out", "result", "--set", "time.end=100000", "--set", "terrain.cell-size=1"}, 2000);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_EQ(json_text(summary, "stop_reason"), "requested");
    EXPECT_TRUE(fs::exists(path("result/max_depth.tif")));
}

TEST_F(RunCommand, FlowThatLeavesOrStillMovesIsReported) {
    write_scene(k_numbers_only);
    const Outcome outcome = succeeded(
        frana({"run", "scene.ini", "--out", "result", "--set", "terrain.bounds=527000 5094000 527090 5094150"}));
    EXPECT_NE(outcome.err.find("left the computed ground"), std::string::npos) << outcome.err;
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_GT(json_number(summary, "left_domain_m3"), 0);
    EXPECT_LE(json_number(summary, "relative_error"), 1e-12);
}

TEST_F(RunCommand, GroundWithoutElevationStopsWallsOrIsFilled) {
    // A strip without data across the slope, 40 m below the release.
    write_dtm([](int, int column) { return column == 22 ? -9999.0 : 300 - 2.5 * column; });
    write_scene(k_numbers_only);
    const Outcome stopped = frana({"run", "scene.ini", "--out", "stop", "--set", "time.end=60"});
    EXPECT_EQ(stopped.exit_code, 3) << stopped.err;
    EXPECT_NE(stopped.err.find("ground without elevation"), std::string::npos) << stopped.err;
    EXPECT_EQ(json_text(read_text(path("stop/summary.json")), "stop_reason"), "reached-no-data");

    ran("wall", {"terrain.nodata-policy=wall"});
    const Outcome fill = succeeded(frana({"run", "scene.ini", "--out", "fill", "--set", "terrain.nodata-policy=fill"}));
    EXPECT_NE(fill.err.find("30 interpolated"), std::string::npos) << fill.err;
}

TEST_F(RunCommand, PlainMetresWithoutACrs) {
    write_dtm({}, false);
    write_scene();
    ran("result", {"terrain.crs=local"});
    EXPECT_EQ(json_text(read_text(path("result/summary.json")), "crs"), "local");
    EXPECT_EQ(gis::read_result_raster(path("result/max_depth.tif")).grid.crs_wkt, "");
    succeeded(frana({"render", "result", "--map", "max_depth", "--size", "640x480"}));
}

TEST_F(RunCommand, ADtmInDegreesIsComputedInItsUtmZone) {
    // 0.00005 degrees are 3.9 m east and 5.6 m north at 46 N; the slope falls east as the other one does.
    std::string grid = "ncols 80\nnrows 60\nxllcorner 9.348\nyllcorner 45.9995\ncellsize 0.00005\nNODATA_value -9999\n";
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 80; ++column)
            grid += std::to_string(300 - 2 * column) + (column < 79 ? ' ' : '\n');
    write("degrees.asc", grid);
    write_polygon("perimeter", {{20, 55}, {70, 55}, {70, 95}, {20, 95}});
    write_scene(k_numbers_only);
    ran("result", {"terrain.dtm=degrees.asc", "terrain.dtm-crs=EPSG:4326"});
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_NE(json_text(summary, "crs").find("EPSG:32632"), std::string::npos);
    // 2000 m2 of 2 m; the outline does not follow the cells, so the lattice is clipped by it: a lattice square is
    // (cell/2)^2 and the 180 m of outline can miscount half of one all along
    EXPECT_NEAR(json_number(summary, "initial_m3"), 4000, 180 * 2 * json_number(summary, "cell_size") / 4);
}

TEST_F(RunCommand, AFullDiskLeavesTheOlderResultAndNothingElse) {
#if defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "ThreadSanitizer writes a larger file of its own before the program begins";
#endif
    write_scene(k_numbers_only);
    ran();
    const std::vector<std::string> before = files();
    // The limit of the shell's ulimit (blocks of 512 or 1024 bytes) simulates a full disk.
    const int status = std::system(("cd '" + folder_.string() +
                                    "' && ulimit -f 4 && '" FRANA_PROGRAM
                                    "' run scene.ini --out result --overwrite --quiet 2> /dev/null")
                                       .c_str());
    EXPECT_EQ(WEXITSTATUS(status), 4);
    EXPECT_EQ(files(), before);
}

TEST_F(RunCommand, ThicknessInItsFourFormsReleasesTheSameVolume) {
    write_dtm([](int, int) { return 2.0; }, true, "two.asc");
    write_dtm([](int, int) { return 302.0; }, true, "before.asc");
    write_dtm([](int, int) { return 300.0; }, true, "after.asc");
    write_scene(k_numbers_only);
    int number = 0;
    for (const std::string thickness : {"2", "attribute:depth", "raster:two.asc", "difference:before.asc,after.asc"}) {
        std::string out = std::to_string(number++);
        ran(out, {"release.thickness=" + thickness, "time.end=0.1"});
        // 50 m x 40 m x 2 m, filled except for rounding
        EXPECT_NEAR(json_number(read_text(path(out + "/summary.json")), "initial_m3"), 4000, 1e-6) << thickness;
    }
}

// A scene with laws of every kind: rasters, budget, terms, and an echo that gives the same result.
TEST_F(RunCommand, ErosionAndOtherLawsAreReportedAndRepeatable) {
    write_scene(k_numbers_only +
                "[material]\nbed-friction = voellmy, cohesion\ncohesion = 100\npore-pressure-ratio = 0.2\n"
                "pore-dissipation-time = 30\n[numerics]\ncurvature = on\n"
                "[entrainment]\nerosion = growth\ngrowth-rate = 0.005\nerodible-depth = 0.5\n"
                "deposition = on\ndeposition-rate = 0.01\ndeposition-shear-stress = 2000\n");
    ran();
    const std::string summary = read_text(path("result/summary.json"));
    for (const std::string key : {"eroded_m3", "deposited_m3", "unsupported_node_steps"})
        EXPECT_TRUE(json_has(summary, key)) << key;
    for (const std::string words :
         {"cohesion at the bed", "pore pressure that dissipates", "curvature of the bed", "exponential growth"})
        EXPECT_TRUE(json_lists(summary, "terms", words)) << words;
    EXPECT_NE(read_text(path("result/log.txt")).find("the flow eroded"), std::string::npos);
    const Outcome again = succeeded(frana({"run", "result/scene.ini", "--out", "again", "--quiet"}));
    for (const std::string name : {"eroded_depth.tif", "deposited_depth.tif"})
        EXPECT_GT(fs::file_size(path("result/" + name)), 0U) << name;
    EXPECT_EQ(json_value(summary, "volume"), json_value(read_text(path("again/summary.json")), "volume"));
    // What failed or was eroded lies elsewhere, but for films under the least depth of maps.
    const auto volume = [&](const std::string& name) {
        const Raster raster = gis::read_result_raster(path("result/" + name + ".tif"));
        double sum = 0;
        for (const double d : raster.values) sum += std::isnan(d) ? 0 : d * raster.grid.cell_area();
        return sum;
    };
    const double released = volume("release"), films = volume("final_depth") - json_number(summary, "volume.final_m3");
    EXPECT_GT(volume("eroded_depth"), 0.01 * released);
    EXPECT_NEAR(volume("elevation_change"), films, 0.002 * released);
}

// By finite volumes friction stops at the edge of a deposit within the step what comes to it: it came at some speed. Of
// these cells 25 had none, up to 1 m deep, and so no pressure.
TEST_F(RunCommand, WhateverIsCoveredWasReachedAtSomeSpeed) {
    succeeded(frana({"run", FRANA_SOURCE_DIR "/sample_data/fan/scene.ini", "--out", "result", "--quiet", "--set",
                     "numerics.scheme=finite-volume", "--set", "terrain.cell-size=10", "--set", "output.maps=off",
                     "--set", "output.report=off", "--set", "release.perimeter-filter=SCENARIO = 'T300'", "--set",
                     "release.volume=20000"}));
    const Raster depth = gis::read_result_raster(path("result/max_depth.tif")),
                 speed = gis::read_result_raster(path("result/max_velocity.tif"));
    int covered = 0;
    for (std::size_t cell = 0; cell < depth.values.size(); ++cell) {
        if (!(depth.values[cell] > 0.1)) continue;
        ++covered;
        EXPECT_GT(speed.values[cell], 0) << depth.values[cell] << " m";
    }
    EXPECT_GT(covered, 500);
}

}  // namespace
}  // namespace frana::test
