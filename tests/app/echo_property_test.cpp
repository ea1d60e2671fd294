// SPDX-License-Identifier: Apache-2.0
// Changes that affect no bit of a result, through the program: running the scene.ini of a result, on random scenes;
// more terrain.
#include <bit>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "gis/raster/raster_in.h"
#include "properties/random_scene.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using EchoedScene = TinyScene;

std::vector<std::uint64_t> bits_of(const std::string& file) {
    std::vector<std::uint64_t> list;
    for (const double value : gis::read_result_raster(file).values) list.push_back(std::bit_cast<std::uint64_t>(value));
    return list;
}

// A scene file on the tiny slope: numbers with all their digits, keys given or left out.
std::string random_text(RandomNumbers& random) {
    std::ostringstream text;
    text << std::setprecision(17);
    const auto one_of = [&](std::initializer_list<const char*> words) {
        return words.begin()[random.below(words.size())];
    };
    text << "[terrain]\ndtm = dtm.asc\n";
    if (random.once_in(2)) text << "cell-size = " << random.between(4, 8) << '\n';
    text << "[release]\nperimeter = perimeter.geojson\nthickness = " << random.between(0.5, 4) << '\n';
    if (random.once_in(2)) text << "thickness-direction = normal\n";
    if (random.once_in(3)) text << "velocity = " << random.between(0, 10) << '\n';
    text << "[material]\n";
    if (random.once_in(4)) {
        text << "model = structured\n[structured]\nphases = fluid\nmanning = " << random.between(0.02, 0.12) << '\n';
    } else {
        text << "friction-angle = " << random.between(5, 30) << "\ndensity = " << random.between(1000, 2500) << '\n';
        if (random.once_in(2)) text << "turbulence = " << random.log_between(100, 3000) << '\n';
        if (random.once_in(3)) text << "viscosity = " << random.log_between(10, 2000) << "\nyield-stress = 100\n";
    }
    text << "[numerics]\ncfl = " << random.between(0.3, 0.5) << '\n';
    if (random.once_in(3)) text << "boundary = " << one_of({"open", "wall"}) << '\n';
    text << "[time]\nend = " << random.between(1, 3) << '\n' << k_numbers_only;
    return text.str();
}

TEST_F(EchoedScene, ReproducesTheRunBitForBit) {
    for (int i = 0; i < scene_count(6); ++i) {
        SCOPED_TRACE(scene_label(i));
        RandomNumbers random(scene_seed(), 9000000 + static_cast<std::uint64_t>(i));
        const std::string text = random_text(random);
        write("scene.ini", text);
        const Outcome first = succeeded(frana({"run", "scene.ini", "--out", "first", "--overwrite", "--quiet"}));
        const Outcome second =
            succeeded(frana({"run", "first/scene.ini", "--out", "second", "--overwrite", "--quiet"}));
        for (const char* name : {"max_depth", "max_velocity", "final_depth", "arrival_time", "max_pressure"}) {
            const std::string file = std::string("/") + name + ".tif";
            EXPECT_EQ(bits_of(path("first" + file)), bits_of(path("second" + file))) << name << '\n' << text;
        }
        EXPECT_EQ(read_text(path("first/timeseries.csv")), read_text(path("second/timeseries.csv")));
    }
}

// The whole DTM and the part of it that the flow needs: the cells in common have the same bits.
TEST_F(EchoedScene, MoreTerrainChangesNoBit) {
    write_scene(k_numbers_only);
    const auto run_to = [&](const std::string& result, const std::vector<std::string>& more) {
        succeeded(frana(with_more({"run", "scene.ini", "--out", result, "--quiet", "--set", "time.end=2"}, more)));
    };
    run_to("whole", {});
    run_to("part", {"--set", "terrain.bounds=527005 5094020 527200 5094135"});
    for (const char* name : {"max_depth", "max_velocity", "final_depth", "arrival_time"}) {
        const Raster whole = gis::read_result_raster(path(std::string("whole/") + name + ".tif"));
        const Raster part = gis::read_result_raster(path(std::string("part/") + name + ".tif"));
        ASSERT_LT(part.grid.cell_count(), whole.grid.cell_count());
        std::int64_t flooded = 0;
        for (std::int64_t row = 0; row < part.grid.rows; ++row) {
            for (std::int64_t column = 0; column < part.grid.columns; ++column) {
                const Point here = part.grid.cell_centre(row, column);
                const auto r = static_cast<std::int64_t>((whole.grid.north - here.y) / whole.grid.cell_size);
                const auto c = static_cast<std::int64_t>((here.x - whole.grid.west) / whole.grid.cell_size);
                const double value = part.at(row, column);
                EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(whole.at(r, c))) << name;
                flooded += std::isnan(value) ? 0 : 1;
            }
        }
        EXPECT_GT(flooded, 50) << name;
    }
}

}  // namespace
}  // namespace frana::test
