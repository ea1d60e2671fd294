// SPDX-License-Identifier: Apache-2.0
// Terrain that is read only where the flow comes gives the result of terrain that is read whole, bit for bit: along
// the way, after a resume, for any number of threads. What cannot be read ends the run after its state was saved.
#include <gtest/gtest.h>

#include <memory>

#include "core/error.h"
#include "physics/laws.h"
#include "played_runs.h"
#include "simulation/release.h"
#include "support/problems.h"

namespace frana {
namespace {

constexpr std::int64_t k_west_cells = 400, k_north_cells = 450, k_side = 1000;

// A raster in the middle of a map a hundred times larger; its rim goes on.
Raster in_wide_map(const Raster& raster) {
    GridSpec grid = raster.grid;
    grid.west -= static_cast<double>(k_west_cells) * grid.cell_size;
    grid.north += static_cast<double>(k_north_cells) * grid.cell_size;
    grid.columns = grid.rows = k_side;
    Raster wide(grid);
    for (std::int64_t row = 0; row < k_side; ++row)
        for (std::int64_t column = 0; column < k_side; ++column)
            wide.at(row, column) =
                raster.at(std::clamp<std::int64_t>(row - k_north_cells, 0, raster.grid.rows - 1),
                          std::clamp<std::int64_t>(column - k_west_cells, 0, raster.grid.columns - 1));
    return wide;
}

Scene wide(Scene scene) {
    scene.terrain = in_wide_map(scene.terrain);
    scene.terrain.at(k_north_cells + 2, k_west_cells + 60) = k_no_data;  // a hole beside the flow
    if (scene.walls) scene.walls = in_wide_map(*scene.walls);
    if (scene.zones.friction_coefficient)
        scene.zones.friction_coefficient = in_wide_map(*scene.zones.friction_coefficient);
    if (scene.zones.erodible_depth) scene.zones.erodible_depth = in_wide_map(*scene.zones.erodible_depth);
    if (scene.structured && scene.structured->initial_fluid) {
        Raster pond(scene.terrain.grid, k_no_data);
        const Raster& depth = *scene.structured->initial_fluid;
        depth.values.for_each_stored([&](std::size_t cell, double h) {
            const auto n = static_cast<std::int64_t>(cell);
            pond.at(k_north_cells + n / depth.grid.columns, k_west_cells + n % depth.grid.columns) = h;
        });
        scene.structured->initial_fluid = pond;
    }
    scene.grid = scene.terrain.grid;
    scene.time.frame_interval *= 3;  // frames have a million cells
    return scene;
}

// Reads windows of a terrain; throws from the `last` window on.
struct Reader {
    Raster whole;
    int windows = 0, last = 1'000'000;
};

Scene on_demand(Scene scene, const std::shared_ptr<Reader>& reader) {
    reader->whole = scene.terrain;
    scene.terrain.values = CellValues::tiled(
        scene.grid.rows, scene.grid.columns, k_no_data, [reader](const CellWindow& window, double* values) {
            if (++reader->windows > reader->last)
                throw Error(ErrorKind::environment, Problem{"the disk is gone", "dtm.tif", "", "", ""});
            for (std::int64_t row = 0; row < window.rows; ++row)
                for (std::int64_t column = 0; column < window.columns; ++column)
                    *values++ = reader->whole.at(window.row + row, window.column + column);
        });
    return scene;
}

// Values by place that are read in windows too.
Scene on_demand(const Scene& scene) {
    Scene part = on_demand(scene, std::make_shared<Reader>());
    for (const ZoneRaster& zone : k_zone_rasters) {
        std::optional<Raster>& raster = part.zones.*zone.raster;
        if (!raster) continue;
        const auto whole = std::make_shared<const Raster>(*raster);
        raster->values = CellValues::tiled(raster->grid.rows, raster->grid.columns, k_no_data,
                                           [whole](const CellWindow& window, double* values) {
                                               for (std::int64_t row = 0; row < window.rows; ++row)
                                                   for (std::int64_t column = 0; column < window.columns; ++column)
                                                       *values++ = whole->at(window.row + row, window.column + column);
                                           });
    }
    return part;
}

// Friction and the erodible bed differ from place to place.
Scene eroding_by_place() {
    Scene scene = eventful();
    scene.entrainment.erosion = "growth";
    scene.entrainment.of<GrowthErosion>().growth_rate = 0.002;
    scene.entrainment.erodible_depth = 0.2;
    scene.zones.erodible_depth = scene.terrain;
    scene.zones.erodible_depth->values.change_each_stored([](std::size_t cell, double& value) {
        value = cell % 3 == 0 ? k_no_data : 0.1 * static_cast<double>(cell % 7);
    });
    return scene;
}

// On ground that nothing else reaches.
Scene inflow_elsewhere() {
    Scene scene = hillside();
    scene.inflows = {{{{300, -500}, {300, -480}}, {{2, 20, 3}, {9, 20, 4}}, 1.5}};
    return scene;
}

// In the wide map's corner and at its edge, which are walls, on ground that nothing of the narrow one reaches.
Scene between_walls() {
    Scene scene = hillside();
    scene.numerics.boundary = Boundary::wall;
    scene.release.push_back({{box(-800, 990, -770, 1020)}, 4});
    scene.release.push_back({{box(-800, -300, -770, -270)}, 4});
    return scene;
}

Scene fluid_between_walls() {
    Scene scene = between_walls();
    scene.structured.emplace();
    return scene;
}

// A pond in the way of breaking blocks, and another flow, of which nothing is known here, far off.
Scene into_a_pond() {
    Scene scene = breaking();
    scene.structured->more_fluid = true;
    Raster& depth = scene.structured->initial_fluid.emplace(scene.grid, k_no_data);
    for (std::int64_t row = 20; row < 40; ++row)
        for (std::int64_t column = 55; column < 62; ++column) depth.at(row, column) = 0.8;
    scene.release.push_back({{box(900, -900, 920, -880)}, 3});
    return scene;
}

struct GroundCase {
    const char* name;
    Scene (*scene)();
    std::int64_t every;
};

class GroundOnDemand : public testing::TestWithParam<GroundCase> {};

TEST_P(GroundOnDemand, GivesTheResultOfTheWholeGround) {
    const Scene whole = wide(GetParam().scene()), part = on_demand(whole);
    const Played straight = play(whole, 1, GetParam().every), read = play(part, 3, GetParam().every);
    EXPECT_LT(part.terrain.values.stored_cells(), k_side * k_side / 2);
    expect_same(straight.result, read.result);
    ASSERT_EQ(straight.frames.size(), read.frames.size());
    for (std::size_t k = 0; k < read.frames.size(); ++k)
        EXPECT_TRUE(same(straight.frames[k].depth, read.frames[k].depth) &&
                    same(straight.frames[k].velocity, read.frames[k].velocity));
    ASSERT_FALSE(read.states.empty());
    expect_same(straight.result,
                play(on_demand(whole), 1, GetParam().every, &read.states[read.states.size() / 2]).result);
}

INSTANTIATE_TEST_SUITE_P(
    , GroundOnDemand,
    testing::Values(GroundCase{"resting", resting, 300}, GroundCase{"flying", flying, 100},
                    GroundCase{"inflow_elsewhere", inflow_elsewhere, 45},
                    GroundCase{"earth_pressure", earth_pressure, 60}, GroundCase{"fluid", fluid, 30},
                    GroundCase{"breaking_later", breaking_later, 10}, GroundCase{"between_walls", between_walls, 45},
                    GroundCase{"fluid_between_walls", fluid_between_walls, 45},
                    GroundCase{"into_a_pond", into_a_pond, 10}, GroundCase{"eroding_by_place", eroding_by_place, 200}),
    [](const auto& instance) { return std::string(instance.param.name); });

// Not before anything is computed: on the way. The state of the last whole step goes on when the ground can be read.
TEST(GroundThatCannotBeRead, EndsTheRunAfterItsStateWasSaved) {
    const Scene whole = wide(hillside());
    const Played straight = play(whole, 1, 1'000'000);
    const auto reader = std::make_shared<Reader>();
    Scene part = on_demand(whole, reader);
    (void)make_release(part);  // what lies under the release is read
    reader->last = reader->windows + 3;
    Bytes saved;
    RunOptions options;
    options.after_step = [&](const Progress& now, const SaveState& save) {
        if (!now.last) return;
        StateWriter writer([&](const void* data, std::size_t count) {
            const auto* const begin = static_cast<const std::byte*>(data);
            saved.insert(saved.end(), begin, begin + count);
        });
        save(writer);
    };
    try {
        (void)run(part, options);
        FAIL() << "read " << reader->windows << " windows, " << reader->last << " of them";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::environment);
        EXPECT_TRUE(has_problem(error.problems(), "dtm.tif")) << "the reader's own";
    }
    ASSERT_FALSE(saved.empty());
    expect_same(straight.result, play(on_demand(whole), 2, 1'000'000, &saved).result);
}

TEST(GroundThatHasChanged, IsNotGoneOnWith) {
    const Scene whole = wide(hillside());
    const Bytes state = play(on_demand(whole), 1, 45).states.front();
    Scene other = whole;
    other.terrain.at(k_north_cells + 30, k_west_cells + 20) += 0.1;  // under the release
    EXPECT_THROW(play(on_demand(other), 1, 45, &state), Error);
}

}  // namespace
}  // namespace frana
