// SPDX-License-Identifier: Apache-2.0
// The scene.ini of a result gives the same result, whatever the scene: through the program, on random scenes.
#include <bit>
#include <iomanip>
#include <sstream>

#include "../properties/random_scene.h"
#include "gis/raster_in.h"
#include "tiny_scene.h"

namespace frana::test {
namespace {

using EchoedScene = TinyScene;

std::vector<std::uint64_t> bits_of(const std::string& file) {
    std::vector<std::uint64_t> list;
    for (const double value : gis::read_result_raster(file).values)
        list.push_back(std::bit_cast<std::uint64_t>(value));
    return list;
}

// A scene file over the tiny slope: numbers with all their digits, keys given or left out.
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
        text << "model = structured\n[structured]\nphases = fluid\nmanning = " << random.between(0.02, 0.12)
             << '\n';
    } else {
        text << "friction-angle = " << random.between(5, 30) << "\ndensity = " << random.between(1000, 2500)
             << '\n';
        if (random.once_in(2)) text << "turbulence = " << random.log_between(100, 3000) << '\n';
        if (random.once_in(3))
            text << "viscosity = " << random.log_between(10, 2000) << "\nyield-stress = 100\n";
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
        const Outcome first = frana({"run", "scene.ini", "--out", "first", "--overwrite", "--quiet"});
        ASSERT_EQ(first.exit_code, 0) << first.err << text;
        const Outcome second = frana({"run", "first/scene.ini", "--out", "second", "--overwrite", "--quiet"});
        ASSERT_EQ(second.exit_code, 0) << second.err << read_text(path("first/scene.ini"));
        for (const char* name :
             {"max_depth", "max_velocity", "final_depth", "arrival_time", "max_pressure"}) {
            const std::string file = std::string("/") + name + ".tif";
            EXPECT_EQ(bits_of(path("first" + file)), bits_of(path("second" + file))) << name << '\n' << text;
        }
        EXPECT_EQ(read_text(path("first/timeseries.csv")), read_text(path("second/timeseries.csv")));
    }
}

}  // namespace
}  // namespace frana::test
