// SPDX-License-Identifier: Apache-2.0
// Observation changes nothing: with frames or without, at any interval, with gauges, saved often or never, by any
// number of threads, a run has the same rasters, series and values, bit for bit.
#include "played_runs.h"

namespace frana {
namespace {

constexpr double k_by_motion = std::numeric_limits<double>::infinity();

struct ObservedCase {
    const char* name;
    Scene (*scene)();
};

// The scene unchanged, without frames, saved once.
Played unobserved(Scene scene) {
    scene.time.frame_interval = 0;
    return play(scene, 1, 1'000'000'000);
}

class Observed : public testing::TestWithParam<ObservedCase> {};

TEST_P(Observed, FramesChangeNothing) {
    Scene scene = GetParam().scene();
    const Played alone = unobserved(scene);
    EXPECT_TRUE(alone.frames.empty());
    for (const double interval : {1e-3, 0.37, k_by_motion}) {
        SCOPED_TRACE(interval);
        scene.time.frame_interval = interval;
        const Played seen = play(scene, 3, 7);
        expect_same(alone.result, seen.result);
        ASSERT_GE(seen.states.size(), 3U);
        if (interval < 0.1) continue;
        const Played resumed = play(scene, 2, 1'000'000'000, &seen.states[seen.states.size() / 2]);
        expect_same(alone.result, resumed.result);
        ASSERT_LE(resumed.frames.size(), seen.frames.size());
        for (std::size_t k = 1; k <= resumed.frames.size(); ++k)
            EXPECT_EQ(resumed.frames[resumed.frames.size() - k].time, seen.frames[seen.frames.size() - k].time);
    }
}

// The first state at or after each requested time, at the end of a step in the series; none twice. None exceeds the
// greatest values over time.
TEST_P(Observed, FramesAreTheFirstStatesThatReachTheirTimes) {
    Scene scene = GetParam().scene();
    for (const double interval : {1e-3, 0.37}) {
        SCOPED_TRACE(interval);
        scene.time.frame_interval = interval;
        const Played seen = play(scene, 1, 1'000'000'000);
        std::vector<double> expected{0};
        double due = interval;
        for (const SeriesRow& row : seen.result.series) {
            if (row.time < due) continue;
            expected.push_back(row.time);
            while (due <= row.time) due += interval;
        }
        const double last = seen.result.series.back().time;
        if (expected.back() != last) expected.push_back(last);
        ASSERT_EQ(seen.frames.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_EQ(seen.frames[i].time, expected[i]);
            EXPECT_EQ(seen.frames[i].index, static_cast<int>(i));
            std::size_t over = 0;
            for (std::size_t c = 0; c < seen.result.raster("max_depth").values.size(); ++c) {
                over += seen.frames[i].depth.values[c] > seen.result.raster("max_depth").values[c];
                over += seen.frames[i].velocity.values[c] > seen.result.raster("max_velocity").values[c] + 1e-9;
            }
            EXPECT_EQ(over, 0U) << expected[i];
        }
    }
}

// A rest has no frames, whatever its length; the mean distance between frames is a cell, and grows as the root of the
// distance so far.
TEST(ObservedMotion, HasFramesAtStepsOfTheDistanceCovered) {
    Scene scene = resting();
    scene.time.stop_when_still = false;
    scene.time.frame_interval = k_by_motion;
    const Played seen = play(scene, 1, 1'000'000'000);
    const double cell = scene.grid.cell_size;
    double moved = 0, due = cell;
    std::size_t frame = 0;
    for (const SeriesRow& row : seen.result.series) {
        moved += std::sqrt(2 * row.kinetic_energy / (scene.material.density * row.volume)) * row.dt;
        if (moved < due || frame + 2 >= seen.frames.size()) continue;
        ++frame;
        EXPECT_EQ(seen.frames[frame].time, row.time) << frame;
        due = moved + std::max(cell, std::sqrt(cell * moved) / 2);
    }
    EXPECT_EQ(frame + 2, seen.frames.size()) << "but for the first and the last";
    EXPECT_GT(frame, 5U);
    EXPECT_LT(frame, 60U);
    double longest = 0, shortest = scene.time.end;  // before the second area fails little moves
    for (std::size_t k = 1; k + 1 < seen.frames.size(); ++k) {
        longest = std::max(longest, seen.frames[k].time - seen.frames[k - 1].time);
        shortest = std::min(shortest, seen.frames[k].time - seen.frames[k - 1].time);
    }
    EXPECT_GT(longest, 4 * shortest) << "of " << seen.frames.size() << " frames";
}

TEST_P(Observed, GaugesIntensitiesAndStressesChangeNothing) {
    Scene scene = GetParam().scene();
    scene.recording = {};
    const Played alone = unobserved(scene);
    scene.recording.gauges = {{"a", {90, 60}}, {"b", {150, 60}}};
    scene.recording.sections = {{"s", {{100, 10}, {100, 110}}}};
    scene.recording.interval = 0.31;
    scene.recording.intensity = scene.recording.plane_stress = true;
    Played seen = unobserved(scene);
    EXPECT_FALSE(seen.result.gauges.empty() || seen.result.sections.empty());
    seen.result.gauges.clear();
    seen.result.sections.clear();
    std::erase_if(seen.result.rasters, [](const NamedRaster& raster) {
        return raster.name == "max_flux" || raster.name == "max_head" || raster.name == "max_momentum_flux" ||
               raster.name.starts_with("plane_stress");
    });
    expect_same(alone.result, seen.result);
}

INSTANTIATE_TEST_SUITE_P(, Observed,
                         testing::Values(ObservedCase{"eventful", eventful}, ObservedCase{"resting", resting},
                                         ObservedCase{"paper", paper}, ObservedCase{"fluid", fluid},
                                         ObservedCase{"finite_volumes", finite_volumes},
                                         ObservedCase{"breaking_later", breaking_later}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace frana
