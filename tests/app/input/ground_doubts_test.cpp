// SPDX-License-Identifier: Apache-2.0
// Terrain models that are read without error and do not look like ground: each is told of, and no good one is.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "gis/raster/raster_out.h"
#include "support/checked_scene.h"
#include "support/files.h"

namespace frana::test {
namespace {

using Elevation = std::function<double(double x, double y)>;

// A slope of 30 degrees, 600 m long, that runs out to a plain; with `k_waves` it is uneven as real ones are.
const double k_slope = std::tan(30 * std::numbers::pi / 180);
double bed(double x, double) {
    return k_slope * std::max(600 - x, 0.0) + 50;
}
double waves(double x, double y) {
    return bed(x, y) + 4 * std::sin(x / 90 + 1) * std::cos(y / 70) + 0.02 * y;
}

double channel(double x, double y) {
    return bed(x, y) + 0.3 * std::abs(y - 450) + 0.1 * (2100 - x);
}

class GroundDoubts : public CheckedScene {
  protected:
    static constexpr double k_wide = 2100, k_high = 900;
    /// Writes NAME.asc of cells of `cell` metres, and its CRS.
    void write_grid(const std::string& name, double cell, const Elevation& elevation) const {
        std::filesystem::copy(path("dtm.prj"), path(name + ".prj"), std::filesystem::copy_options::overwrite_existing);
        std::ofstream file(path(name + ".asc"));
        file.precision(9);
        const auto columns = std::lround(k_wide / cell), rows = std::lround(k_high / cell);
        file << "ncols " << columns << "\nnrows " << rows << "\nxllcorner " << k_west << "\nyllcorner " << k_south
             << "\ncellsize " << cell << "\n";
        for (long row = 0; row < rows; ++row)
            for (long column = 0; column < columns; ++column)
                file << elevation((double(column) + 0.5) * cell, (double(rows - row) - 0.5) * cell)
                     << (column + 1 < columns ? ' ' : '\n');
    }
    void SetUp() override {
        write_polygon("mass", {{100, 390}, {220, 390}, {220, 510}, {100, 510}});
        write("bed.ini",
              "[terrain]\ndtm = bed.asc\n[release]\nperimeter = mass.geojson\nthickness = 2\n[material]\n"
              "friction-angle = 20\nturbulence = 500\n[time]\nend = 90\n" +
                  k_numbers_only);
    }
    /// The warnings about the DTM, a line each.
    [[nodiscard]] std::string doubts(const Sets& more = {}) const {
        const Checked checked = check(more, "bed.ini");
        EXPECT_FALSE(checked.is_refused()) << checked.told();
        std::string found;
        for (const std::string& warning : texts_of(checked.warnings))
            if (warning.starts_with("DTM")) found += warning + '\n';
        return found;
    }
    [[nodiscard]] double number(const std::string& result, const std::string& key) const {
        return json_number(read_text(path(result + "/summary.json")), key);
    }
};

// A slope of 17 degrees, its elevations in feet: read as metres, it is one of 45. A steep one is none of the kind.
TEST_F(GroundDoubts, FeetAreToldOnAGentleSlopeWhereNoUnitIsStated) {
    const auto ramp = [](double degrees, double unit) -> Elevation {
        return [=](double x, double y) {
            return (std::tan(degrees * std::numbers::pi / 180) * std::max(600 - x, 0.0) + 50 + 0.02 * y) / unit;
        };
    };
    write_grid("bed", 10, ramp(17, 0.3048));
    expect_words(doubts(), {"DTM bed.asc: slopes of 45° (17° if feet)"});
    EXPECT_EQ(doubts({"terrain.vertical-unit=foot"}), "");
    EXPECT_EQ(doubts({"terrain.vertical-unit=metre"}), "") << "the user's word";
    write_grid("bed", 10, ramp(38, 1));
    EXPECT_EQ(doubts(), "");
}

/// A model of cells of `coarse` metres, each copied into the finer ones.
Elevation copied(double coarse, const Elevation& ground) {
    return [=](double x, double y) {
        const auto centre = [&](double v) { return (std::floor(v / coarse) + 0.5) * coarse; };
        return ground(centre(x), centre(y));
    };
}

// The slope's own answer, on 10 m: that of 30 m brought to 10 m by frana; copied cells lose most of the run-out.
TEST_F(GroundDoubts, CopiedCellsAreToldWithTheirFactorAndFranasOwnResamplingIsRight) {
    write_grid("bed", 10, bed);
    EXPECT_EQ(doubts(), "");
    write_grid("coarse", 30, bed);
    const auto run = [&](const std::string& name, const std::vector<std::string>& more) {
        succeeded(frana(with_sets({"run", "bed.ini", "--out", name, "--quiet"}, more)));
    };
    run("right", {});
    const std::vector<std::string> finer{"terrain.dtm=coarse.asc", "terrain.cell-size=10"};
    EXPECT_EQ(doubts(finer), "");
    run("bilinear", finer);
    // The bend at the foot of the slope is rounded over 30 m: 3 % of the run-out.
    EXPECT_NEAR(number("bilinear", "runout.horizontal_m") / number("right", "runout.horizontal_m"), 1, 0.03);
    EXPECT_NEAR(number("bilinear", "covered_area_m2") / number("right", "covered_area_m2"), 1, 0.05);
    write_grid("bed", 10, copied(30, bed));
    const std::string told = doubts();
    expect_words(told, {"copied cells (3 x 3)", "bilinear"});
    run("copied", {"output.report=on"});
    EXPECT_LT(number("copied", "runout.horizontal_m"), 0.5 * number("right", "runout.horizontal_m"));
    expect_words(read_text(path("copied/report.html")), {"copied cells (3 x 3)"});
    // What passes on without the log carries it, too; those of a study as well.
    write("study.ini", "[study]\nscene = bed.ini\nsamples = 2\n[vary]\nmaterial.friction-angle = uniform(19, 21)\n");
    const Outcome study = succeeded(frana({"ensemble", "study.ini", "--out", "study", "--quiet"}));
    for (const std::string raster : {"copied/max_depth.tif", "study/probability_depth_0.5.tif"})
        expect_words(gis::read_raster_text(path(raster)).metadata["DOUBTS"], {"% copied cells"});
    for (const std::string result : {"copied", "study"}) {
        const Json summary = parse_json(read_text(path(result + "/summary.json")));
        expect_words(summary["warning_values"].dump(), {"% copied cells"});
        expect_words(summary["warnings"].dump(), {"copied cells (3 x 3)"});
    }
    EXPECT_FALSE(gis::read_raster_text(path("right/max_depth.tif")).metadata.contains("DOUBTS"));
    expect_words(read_text(path("copied/log.txt")), {"WARNING: DTM bed.asc: ", "copied cells (3 x 3)"});
    // Cells as large as the blocks are the original again.
    EXPECT_EQ(doubts({"terrain.cell-size=30"}), "");
}

TEST_F(GroundDoubts, CopiedCellsOfOtherFactorsAreTold) {
    for (const auto& [coarse, words] : {std::pair{20.0, "cells (2 x 2)"},
                                        {12.5, "copied cells"},
                                        {15.0, "cells (1.5 x 1.5)"},
                                        {33.0, "cells (3.3 x 3.3)"},
                                        {90.0, "cells (9 x 9)"}}) {
        write_grid("bed", 10, copied(coarse, waves));
        expect_words(doubts(), {words});
    }
}

// Brought to another coordinate system: the blocks lie askew.
TEST_F(GroundDoubts, CopiedCellsAreToldThoughTheyLieAskew) {
    const auto turned = [](const Elevation& ground, bool interpolated) -> Elevation {
        return [=](double x, double y) {
            const double angle = 2.5 * std::numbers::pi / 180, u = x * std::cos(angle) - y * std::sin(angle),
                         v = x * std::sin(angle) + y * std::cos(angle), west = std::floor(u / 10 - 0.5) * 10 + 5,
                         south = std::floor(v / 10 - 0.5) * 10 + 5, a = (u - west) / 10, b = (v - south) / 10;
            if (!interpolated) return ground(std::round(a) * 10 + west, std::round(b) * 10 + south);
            return (1 - b) * ((1 - a) * ground(west, south) + a * ground(west + 10, south)) +
                   b * ((1 - a) * ground(west, south + 10) + a * ground(west + 10, south + 10));
        };
    };
    for (const bool interpolated : {false, true}) {
        write_grid("bed", 10, turned(copied(30, waves), interpolated));
        expect_words(doubts(), {"% copied cells"});
    }
    write_grid("bed", 10, turned(waves, true));
    EXPECT_EQ(doubts(), "");
    write_grid("bed", 10, turned(waves, false));  // by nearest: its rows are shifted by a cell here and there
    EXPECT_NE(doubts(), "");
}

TEST_F(GroundDoubts, WhatIsNotGroundIsToldWithItsPlace) {
    const auto gentle = [](double x, double y) { return 0.15 * waves(x, y); };
    struct Case {
        Elevation ground;
        std::vector<std::string> words;
    };
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> chance(0, 1);
    const std::vector<Case> cases{
        {[&](double x, double y) { return std::round(gentle(x, y)); }, {"% in steps of 1 m", "use decimals"}},
        {[](double x, double y) { return 10 * std::round(waves(x, y) / 10); }, {"in steps of 10 m"}},
        {[](double x, double y) { return waves(x, y) + (x > 400 ? 4 : 0); }, {"step of 4", "E 527405", "fit tiles"}},
        {[](double x, double y) { return waves(x, y) + (x + y > 1e4 || y > 450 ? 48 : 0); },
         {"step of 48 m", "N 5094445"}},
        // Of tiles in another coordinate system, turned by 5 and by 30 degrees; the second was interpolated.
        {[](double x, double y) { return waves(x, y) + (x - 0.0875 * y > 400 ? 20 : 0); }, {"step of"}},
        {[](double x, double y) { return waves(x, y) + 20 * std::clamp((x - 0.577 * y - 150) / 12, 0.0, 1.0); },
         {"step of"}},
        {[](double x, double y) { return x > 300 && x < 340 && y > 430 && y < 470 ? -1 : waves(x, y); },
         {"16 pits at -1 m", "E 527305", "terrain.nodata-value"}},
        {[](double x, double y) { return x > 300 && x < 340 && y > 430 && y < 470 ? 0 : waves(x, y); },
         {"16 cells of 0 stand out", "16 pits at 0 m"}},
        {[](double x, double y) { return x > 100 && x < 140 && y > 530 && y < 570 ? 255 : waves(x, y); },
         {"16 pits at 255 m"}},
        {[&](double x, double y) { return waves(x, y) + (chance(generator) < 0.4 ? 5 + 15 * chance(generator) : 0); },
         {"% stands out", "bare ground"}},
    };
    for (const Case& one : cases) {
        write_grid("bed", 10, one.ground);
        const std::string told = doubts();
        expect_words(told, one.words);
        const bool is_zero = one.words.size() == 2 && one.words.front().find("of 0 stand") != std::string::npos;
        EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), is_zero ? 2 : 1) << told;
    }
}

// Trees in the path alone, on a tenth of what can be reached; beside it they change nothing.
TEST_F(GroundDoubts, TreesAreSoughtWhereTheFlowComes) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> chance(0, 1);
    const auto trees = [&](bool in_path) -> Elevation {
        return [&, in_path](double x, double y) {
            const bool here = std::abs(y - 450) < 90;
            return channel(x, y) + (here == in_path && chance(generator) < 0.4 ? 5 + 15 * chance(generator) : 0);
        };
    };
    write_grid("bed", 10, trees(true));
    expect_words(doubts(), {"% stands out", "bare ground"});
    write_grid("bed", 10, trees(false));
    EXPECT_EQ(doubts(), "");
}

// A road on a fill, whose culvert the model does not have: the flow stops behind it. A hump of the ground is none.
TEST_F(GroundDoubts, ADamAcrossTheChannelIsTold) {
    write_grid("bed", 10, [&](double x, double y) { return channel(x, y) + (std::abs(x - 500) < 10 ? 12 : 0); });
    expect_words(doubts(), {"DTM bed.asc: dam of", "E 5274", "open culverts"});
    write_grid("bed", 10, [&](double x, double y) {
        return std::max(channel(x, y), std::abs(x - 800) < 10 ? channel(800, 450) + 15 : 0);
    });
    expect_words(doubts(), {"DTM bed.asc: dam of 12 m", "E 527805"});
    write_grid("bed", 10, channel);
    EXPECT_EQ(doubts(), "");
    write_grid("bed", 10,
               [&](double x, double y) { return channel(x, y) + 20 * std::exp(-std::pow((x - 700) / 120, 2)); });
    EXPECT_EQ(doubts(), "");
}

TEST_F(GroundDoubts, AHillshadeIsTold) {
    write_grid("bed", 10, [](double x, double y) { return std::clamp(std::round(waves(x, y) / 2), 0.0, 255.0); });
    write("bytes.vrt", "<VRTDataset rasterXSize=\"210\" rasterYSize=\"90\"><SRS>EPSG:32632</SRS><GeoTransform>" +
                           std::to_string(k_west) + ", 10, 0, " + std::to_string(k_south + k_high) +
                           ", 0, -10</GeoTransform><VRTRasterBand dataType=\"Byte\" band=\"1\"><SimpleSource>"
                           "<SourceFilename relativeToVRT=\"1\">bed.asc</SourceFilename></SimpleSource>"
                           "</VRTRasterBand></VRTDataset>");
    expect_words(doubts({"terrain.dtm=bytes.vrt"}), {"DTM bytes.vrt has values 0 to 255", "hillshade"});
}

// A warning that comes without a fault is none.
TEST_F(GroundDoubts, GoodGroundIsNotDoubted) {
    const auto lakes = [](double x, double y) {
        return std::hypot(x - 900, y - 450) < 150 ? 50 : std::max(waves(x, y), 50.0);
    };
    const std::vector<Elevation> grounds{
        bed,
        waves,
        lakes,
        [](double x, double) { return 400 - 0.4 * x + (x > 750 ? 0.4 * (x - 750) : 0); },
        [](double x, double y) { return 1000 - 0.3 * x - 0.1 * y; },
        [](double x, double y) { return std::round(100 * waves(x, y)) / 100; },
        [](double x, double y) { return std::round(10 * waves(x, y)) / 10; },
        // A channel between steep banks, a cliff askew that is neither straight nor of one height, a terrace.
        [](double x, double y) { return waves(x, y) + (std::abs(y - 450) > 120 ? 30 : 0.002 * (y - 450) * (y - 450)); },
        [](double x, double y) {
            return waves(x, y) + (x + 0.4 * y + 30 * std::sin(y / 50) > 560 ? -40 - 15 * std::sin(y / 35) : 0);
        },
        [](double x, double y) { return x > 340 && x < 380 && std::abs(y - 450) < 60 ? waves(340, y) : waves(x, y); },
    };
    for (std::size_t i = 0; i < grounds.size(); ++i) {
        write_grid("bed", 10, grounds[i]);
        EXPECT_EQ(doubts(), "") << i;
    }
    write_grid("bed", 30, waves);
    for (const std::string size : {"10", "12.5", "45", "100"})
        EXPECT_EQ(doubts({"terrain.cell-size=" + size}), "") << size;
}

}  // namespace
}  // namespace frana::test
