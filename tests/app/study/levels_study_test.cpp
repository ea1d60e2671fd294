// SPDX-License-Identifier: Apache-2.0
// Multilevel studies, as a user sees them.
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class LevelsStudy : public Ensemble {
  protected:
    /// Cells of 20, 10 and 5 m.
    void write_levels(const std::string& more = "") const {
        write_study("samples = 24\nsampling = random\nlevels = 3\n" + more, k_local_keys);
    }
    /// Without a CRS a run is prepared in a moment.
    const std::string k_local_keys = "[set]\nterrain.crs = local\n" + k_two_keys;
    [[nodiscard]] double of_level(const std::string& summary, int level, const std::string& key) const {
        return json_value(summary, "levels").at(static_cast<std::size_t>(level)).at(key).get<double>();
    }
    [[nodiscard]] Raster probability_of(const std::string& result) const {
        return gis::read_result_raster(path(result + "/probability_depth_0.1.tif"));
    }
    /// The second band.
    [[nodiscard]] Raster error_of(const std::string& result) const {
        Raster error = probability_of(result);
        const GDALDatasetUniquePtr file(
            GDALDataset::Open(path(result + "/probability_depth_0.1.tif").c_str(), GDAL_OF_RASTER));
        std::vector<double> values(error.values.size());
        const int columns = file->GetRasterXSize(), rows = file->GetRasterYSize();
        EXPECT_EQ(file->GetRasterBand(2)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows,
                                                   GDT_Float64, 0, 0),
                  CE_None);
        error.values = std::move(values);
        return error;
    }
};

TEST_F(LevelsStudy, RunsAreSharedOutWithinTheBudget) {
    write_levels();
    const Outcome outcome = run();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    std::map<std::string, double> counts, weights;
    const Rows rows = members();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& row = rows[i];
        counts[row.at("level") + " " + row.at("terrain.cell-size")] += 1;
        weights[row.at("level") + " " + row.at("terrain.cell-size")] += std::stod(row.at("weight"));
        if (row.at("level") == "0" || std::stod(row.at("weight")) > 0) continue;
        // The coarser run of a pair follows the finer one, with the same values.
        EXPECT_EQ(rows[i - 1].at("material.turbulence"), row.at("material.turbulence"));
        EXPECT_EQ(std::stod(rows[i - 1].at("terrain.cell-size")) * 2, std::stod(row.at("terrain.cell-size")));
    }
    EXPECT_EQ(counts.size(), 5U);
    EXPECT_EQ(counts["1 10"], counts["1 20"]);
    EXPECT_EQ(counts["2 5"], counts["2 10"]);
    EXPECT_GT(counts["0 20"], counts["1 10"]);
    EXPECT_GT(counts["1 10"], counts["2 5"]);
    constexpr double k_rounding = 1e-12;
    EXPECT_NEAR(weights["0 20"], 1, k_rounding);
    EXPECT_NEAR(weights["1 10"], 1, k_rounding);
    EXPECT_NEAR(weights["1 20"], -1, k_rounding);
    EXPECT_NEAR(weights["2 5"] + weights["2 10"], 0, k_rounding);
    // As much work as 24 runs on the scene's own cells, of which a pair on level 2 is the most expensive.
    const std::string summary = read_text(path("out/summary.json"));
    double cost = 0;
    for (int l = 0; l < 3; ++l)
        cost += of_level(summary, l, "members") * of_level(summary, l, "particle_steps_per_member");
    const double dearest = of_level(summary, 2, "particle_steps_per_member");
    EXPECT_LE(cost, 24 * dearest);
    EXPECT_GT(cost, 15 * dearest);
}

// Against plain Monte Carlo with 300 members on the scene's own cells: the difference of two estimates over the sum of
// the squares of their standard errors has a mean of 1; cells of one map depend on each other, hence the wide bounds.
// On the coarsest cells alone the same map is farther off than it says.
TEST_F(LevelsStudy, TheMapsAreThoseOfTheFinestCells) {
    const std::string longer = "[set]\nterrain.crs = local\ntime.end = 10\n";
    write_study("samples = 300\nsampling = random\nseed = 7\n", longer + k_two_keys);
    ASSERT_EQ(run().exit_code, 0);
    fs::rename(path("out"), path("plain"));
    write_study("samples = 100\nsampling = random\nlevels = 3\n", longer + k_two_keys);
    ASSERT_EQ(run().exit_code, 0);
    fs::rename(path("out"), path("levels"));
    write_study("samples = 300\nsampling = random\nseed = 9\n", longer + "terrain.cell-size = 20\n" + k_two_keys);
    ASSERT_EQ(run().exit_code, 0);
    const Raster exact = probability_of("plain"), exact_error = error_of("plain"), p = probability_of("levels"),
                 error = error_of("levels"), coarse = probability_of("out");
    ASSERT_TRUE(exact.grid.same_cells(p.grid));
    double squares = 0, cells = 0, far = 0, coarse_far = 0;
    for (int row = 0; row < k_rows; ++row) {
        for (int column = 0; column < k_columns; ++column) {
            if (!(exact.at(row, column) > 0.05 && exact.at(row, column) < 0.95)) continue;
            const double difference = p.at(row, column) - exact.at(row, column);
            squares += difference * difference /
                       (std::pow(error.at(row, column), 2) + std::pow(exact_error.at(row, column), 2));
            cells += 1;
            far += std::abs(difference);
            const Point centre = exact.grid.cell_centre(row, column);
            const auto r = static_cast<std::int64_t>((coarse.grid.north - centre.y) / coarse.grid.cell_size),
                       c = static_cast<std::int64_t>((centre.x - coarse.grid.west) / coarse.grid.cell_size);
            const bool inside = centre.y < coarse.grid.north && r < coarse.grid.rows && c < coarse.grid.columns;
            coarse_far += std::abs((inside ? coarse.at(r, c) : 0) - exact.at(row, column));
        }
    }
    ASSERT_GT(cells, 50);
    EXPECT_LT(squares / cells, 3);
    EXPECT_GT(squares / cells, 0.1);
    EXPECT_LT(far, coarse_far);
}

TEST_F(LevelsStudy, SameBitsForAnyNumberOfThreadsAndAfterAKill) {
    write_levels();
    for (const std::string threads : {"1", "2", "7"})
        ASSERT_EQ(frana({"ensemble", "study.ini", "--out", "out" + threads, "--threads", threads, "--quiet"}).exit_code,
                  0);
    expect_same("out1", "out2");
    expect_same("out1", "out7");
    ASSERT_EQ(stop_after(30, SIGKILL).exit_code, -SIGKILL);  // beyond the pilot of 16 + 16 + 8 runs or within it
    const Outcome resumed = run({"--resume"});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    expect_same("out1", "out");
    EXPECT_EQ(run({"--resume"}).exit_code, 0);  // complete
    write_study("samples = 25\nsampling = random\nlevels = 3\n", k_local_keys);
    EXPECT_EQ(run({"--resume"}).exit_code, 2);  // another budget, although the pilot is the same
}

TEST_F(LevelsStudy, AnyRunCanBeRepeatedAlone) {
    write_levels();
    ASSERT_EQ(run().exit_code, 0);
    const Rows rows = members();
    for (const std::string size : {"5", "10", "20"}) {
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&](const auto& one) { return one.at("terrain.cell-size") == size; });
        ASSERT_NE(row, rows.end());
        std::vector<std::string> arguments{"run",         "scene.ini", "--out", "alone",
                                           "--overwrite", "--quiet",   "--set", "terrain.crs=local"};
        for (const auto& [key, value] : *row)
            if (key.find('.') != std::string::npos) arguments.insert(arguments.end(), {"--set", key + "=" + value});
        ASSERT_EQ(frana(arguments).exit_code, 0);
        EXPECT_EQ(std::stod(row->at("covered_area_m2")),
                  json_number(read_text(path("alone/summary.json")), "covered_area_m2"))
            << size;
    }
}

TEST_F(LevelsStudy, UntilStopsAfterARound) {
    write_levels("until = 0.49\n");
    ASSERT_EQ(run().exit_code, 0);
    const auto pilot = members().size();
    EXPECT_EQ(pilot, 16U + 2 * 8 + 2 * 4);  // samples / 16, at least 4 pairs on the finest level
    EXPECT_LE(json_number(read_text(path("out/summary.json")), "largest_standard_error"), 0.49);
    write_levels("until = 0.02\n");
    const Outcome outcome = run({"--overwrite"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_GT(members().size(), pilot);
    EXPECT_FALSE(json_value(read_text(path("out/summary.json")), "until.reached").get<bool>());
}

// Where the bed is slippery the flow reaches cells without terrain.
TEST_F(LevelsStudy, APairWithAFailedRunIsLeftOut) {
    write_dtm(
        [](int, int column) { return column > 50 ? -9999 : 300 - 0.5 * std::min((column + 0.5) * k_cell, 200.0); });
    write_scene(
        "stop-when-still = off\n[output]\nreport = on\nmaps = on\nmap-formats = svg\nanimation = off\nframes = off\n");
    write_study("samples = 24\nsampling = random\nlevels = 2\n",
                "[set]\ntime.end = 40\nterrain.crs = local\n[vary]\nmaterial.friction-angle = uniform(1, 40)\n");
    const Outcome outcome = run();
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    const Rows rows = members();
    std::map<std::string, double> weights;
    std::size_t failed = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        failed += rows[i].at("status") == "failed" ? 1 : 0;
        weights[rows[i].at("terrain.cell-size") + rows[i].at("level")] += std::stod(rows[i].at("weight"));
        if (rows[i].at("status") == "failed") {
            EXPECT_EQ(rows[i].at("weight"), "0");
        }
    }
    EXPECT_GT(failed, 0U);
    EXPECT_NEAR(weights["100"], 1, 1e-12);
    EXPECT_NEAR(weights["51"], 1, 1e-12);
    EXPECT_NEAR(weights["101"], -1, 1e-12);
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("out/probability_depth_0.5.tif").c_str(), GDAL_OF_RASTER));
    ASSERT_EQ(file->GetRasterCount(), 4);
    const int width = file->GetRasterXSize(), height = file->GetRasterYSize();
    std::vector<std::vector<float>> bands(5);  // from 1: value, error, upper and lower bound
    for (int band = 1; band <= 4; ++band) {
        std::vector<float>& values = bands[static_cast<std::size_t>(band)];
        values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        ASSERT_EQ(file->GetRasterBand(band)->RasterIO(GF_Read, 0, 0, width, height, values.data(), width, height,
                                                      GDT_Float32, 0, 0),
                  CE_None);
    }
    double widest = 0;
    for (std::size_t i = 0; i < bands[1].size(); ++i) {
        EXPECT_LE(0, bands[4][i]);
        EXPECT_LE(bands[4][i], bands[1][i]);
        EXPECT_LE(bands[1][i], bands[3][i]);
        EXPECT_LE(bands[3][i], 1);
        widest = std::max(widest, static_cast<double>(bands[3][i] - bands[4][i]));
    }
    EXPECT_GT(widest, 0);
    const Json run_out = json_value(read_text(path("out/summary.json")), "figures.runout_m");
    EXPECT_LE(run_out["lower_bound"]["q05"].get<double>(), run_out["q05"].get<double>());
    EXPECT_TRUE(run_out["upper_bound"].contains("q95"));
    // The values themselves are no bounds, as the first line says.
    const std::string first = parse_json(read_text(path("out/summary.json")))["warnings"][0];
    EXPECT_NE(first.find("too small or too large"), std::string::npos) << first;
    EXPECT_NE(first.find(std::to_string(failed) + " of "), std::string::npos) << first;
    const std::string report = read_text(path("out/report.html")),
                      map = read_text(path("out/maps/probability_depth_0.5.svg"));
    EXPECT_LT(report.find("too small or too large"), report.find("id=\"answer\""));
    EXPECT_EQ(report.find("In at least half of the runs"), std::string::npos);
    EXPECT_EQ(report.find("lower bounds"), std::string::npos);
    EXPECT_NE(map.find("too small or"), std::string::npos);
}

TEST_F(LevelsStudy, WhatCannotBeOnLevelsIsRefused) {
    write_study("samples = 24\nsampling = latin-hypercube\nlevels = 9\n", k_two_keys);
    const Outcome outcome = run();
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("study.levels"), std::string::npos) << outcome.err;
    write_study("samples = 24\nsampling = latin-hypercube\nlevels = 2\n", k_two_keys);
    EXPECT_NE(run().err.find("study.sampling"), std::string::npos);
    // Cells of 320 m: the slope of 300 m x 150 m has none.
    write_study("samples = 24\nlevels = 6\n", "[set]\nterrain.cell-size = 10\n" + k_two_keys);
    const Outcome coarse = run();
    EXPECT_EQ(coarse.exit_code, 2);
    EXPECT_NE(coarse.err.find("study.levels, cells of 320 m"), std::string::npos) << coarse.err;
    EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(LevelsStudy, CheckTellsLevelsAndCost) {
    write_levels();
    const auto before = files();
    const Outcome outcome = frana({"check", "study.ini"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const std::string words :
         {"as much work as 24", "level 0", "cells of 20 m: 16 members first",
          "cells of 5 m with those of 10 m: 4 members first", "of a run on the scene's own cells"})
        EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
    EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace frana::test
