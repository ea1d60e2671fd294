// SPDX-License-Identifier: Apache-2.0
// The structured model on large maps: memory follows the flows, and their numbers are those of a small map.
#include "large_map.h"

namespace frana::test {
namespace {

constexpr double k_end = 0.5;  // [s], blocks cost much
constexpr const char* k_blocks =
    "phases = solids-and-fluid\nsolid-fraction = 0.5\nconfined-fraction = 0.8\ncohesion = 5000\n"
    "internal-friction-angle = 34\nbed-friction-angle = 10\nyoung-modulus = 1e6\nbulk-modulus = 6.667e5\n"
    "manning = 0.05\n";

TEST_F(LargeMap, TwoStructuredFlowsFarApartTakeLessThanAGigabyte) {
    const std::vector<Place> hills{{4000, 4000}, {12485, 12485}};  // 12.0 km
    write_map("large.tif", 20'000, k_map_west, k_map_north, hills);
    write_releases(hills, 18);
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n"
          "[material]\nmodel = structured\n[structured]\n" +
              std::string(k_blocks) + "[numerics]\nparticles-per-cell = 9\n[output]\nanimation = off\n");
    const Outcome outcome = succeeded(run("large.tif", "result", "map", k_end));
    if (!k_sanitized) {
        EXPECT_LT(outcome.peak_memory_bytes, 1e9);
    }
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_NEAR(json_number(summary, "initial_m3"), 2 * 2 * 36 * 36, 0.001 * 2 * 2 * 36 * 36);
    EXPECT_EQ(Json::parse(summary)["flows"].size(), 2);
    const Raster depth = gis::read_result_raster(path("result/max_depth.tif"));
    std::int64_t reached[2] = {0, 0}, all = 0;
    depth.values.for_each_stored([&](std::size_t cell, double value) {
        if (!(value > 0)) return;
        ++all;
        const auto row = static_cast<std::int64_t>(cell) / 20'000, column = static_cast<std::int64_t>(cell) % 20'000;
        for (int k = 0; k < 2; ++k) reached[k] += std::hypot(row - hills[k].row, column - hills[k].column) < k_hill;
    });
    EXPECT_EQ(reached[0] + reached[1], all);
    EXPECT_GT(reached[0], 36 * 36);
    EXPECT_NEAR(static_cast<double>(reached[0]), static_cast<double>(reached[1]),
                0.01 * static_cast<double>(reached[0]));
}

class SameBitsStructured : public SameBits {};

TEST_F(SameBitsStructured, FluidThatFallsIntoAPond) {
    write_maps();
    write_round_top("pond.tif", [](double cells) { return cells > 22 && cells < 45 ? 0.3 : 0.0; });
    write_structured_scene("perimeter = perimeter.geojson\nthickness = 2",
                           "phases = fluid\nmanning = 0.05\ninitial-fluid-depth = raster:pond.tif");
    expect_same_flow();
    // 24 m east of the top, 6 m from the release, water was 0.3 m deep.
    const Raster depth = gis::read_result_raster(path("small/max_depth.tif"));
    EXPECT_GT(depth.at(k_top.row - k_row, k_top.column - k_column + 24), 0.4);
}

TEST_F(SameBitsStructured, BlocksWithValuesByPlace) {
    write_maps();
    write_round_top("cohesion.tif", [](double cells) { return 2000 + 100 * cells; });
    write_round_top("thickness.tif", dome);
    const std::string blocks = k_blocks;
    write_structured_scene("perimeter = perimeter.geojson\nthickness = raster:thickness.tif",
                           blocks.substr(0, blocks.find("cohesion")) + "cohesion = raster:cohesion.tif\n" +
                               blocks.substr(blocks.find("internal")));
    expect_same_flow(k_end);
    expect_same("cohesion_ratio");
    expect_same("solid_velocity");
}

TEST_F(SameBitsStructured, DepthsOfBothPhases) {
    write_maps();
    write_round_top("solids.tif", dome);
    write_round_top("fluid.tif", [](double cells) { return 0.5 * dome(cells); });
    const std::string blocks = k_blocks;
    write_structured_scene(
        "thickness = phases:solids.tif,fluid.tif",
        "phases = solids-and-fluid\nconfined-fraction = 0.8\n" + blocks.substr(blocks.find("cohesion")));
    expect_same_flow(k_end);
}

}  // namespace
}  // namespace frana::test
