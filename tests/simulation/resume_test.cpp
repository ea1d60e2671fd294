// SPDX-License-Identifier: Apache-2.0
// A run that is saved and resumed elsewhere equals the run that never stopped: same result, same frames, and the same
// state at every later moment, bit for bit, for any number of threads before and after.
#include <gtest/gtest.h>

#include "core/error.h"
#include "played_runs.h"

namespace frana {
namespace {

struct ResumedCase {
    const char* name;
    Scene (*scene)();
    std::int64_t every;
};

class Resume : public testing::TestWithParam<ResumedCase> {};

TEST_P(Resume, EndsAsNeverInterrupted) {
    const Scene scene = GetParam().scene();
    const Played straight = play(scene, 1, GetParam().every);
    ASSERT_GE(straight.states.size(), 2U) << straight.result.steps;
    ASSERT_EQ(straight.result.hard_events.non_finite, 0);
    for (std::size_t i = 0; i < straight.states.size(); ++i) {
        constexpr int k_threads[] = {3, 1, 7, 2};
        const Played resumed = play(scene, k_threads[i % 4], GetParam().every, &straight.states[i]);
        SCOPED_TRACE("from step " + std::to_string(straight.steps[i]));
        expect_same(straight.result, resumed.result);
        ASSERT_EQ(resumed.states.size(), straight.states.size() - i - 1);
        for (std::size_t k = 0; k < resumed.states.size(); ++k)
            EXPECT_TRUE(same_state(straight.states[i + 1 + k], resumed.states[k])) << resumed.steps[k];
        ASSERT_LE(resumed.frames.size(), straight.frames.size());
        const std::size_t kept = straight.frames.size() - resumed.frames.size();
        for (std::size_t k = 0; k < resumed.frames.size(); ++k) {
            const Frame &a = straight.frames[kept + k], &b = resumed.frames[k];
            EXPECT_EQ(a.index, b.index);
            EXPECT_EQ(a.time, b.time);
            EXPECT_TRUE(same(a.depth, b.depth) && same(a.velocity, b.velocity)) << b.time;
        }
    }
}

// A stop writes the flow's state, which must not affect the later run.
TEST_P(Resume, ContinuesAfterAStopOnRequest) {
    const Scene scene = GetParam().scene();
    const std::int64_t never = 1'000'000'000, at = 2 * GetParam().every - 1;
    const Played straight = play(scene, 1, never), stopped = play(scene, 3, never, nullptr, at);
    EXPECT_EQ(stopped.result.stop_reason, StopReason::requested);
    ASSERT_EQ(stopped.steps, std::vector<std::int64_t>{at});
    expect_same(straight.result, play(scene, 1, never, &stopped.states.front()).result);
}

// Members of a study that time.end cuts go on so.
TEST_P(Resume, GoesOnFromBeforeItsEndAsARunWithALaterOne) {
    const Scene whole = GetParam().scene();
    const RunResult straight = run(whole, {});
    Scene early = whole;
    early.time.end = 0.6 * straight.simulated_seconds;
    std::string state;
    RunOptions options;
    options.before_end = [&](const SaveState& save) {
        EXPECT_TRUE(state.empty()) << "once";
        StateWriter writer(state);
        save(writer);
    };
    ASSERT_EQ(run(early, options).stop_reason, StopReason::end_time);
    StateReader reader(state);
    options = {};
    options.saved = &reader;
    expect_same(straight, run(whole, options));
}

INSTANTIATE_TEST_SUITE_P(, Resume,
                         testing::Values(ResumedCase{"hillside", hillside, 30}, ResumedCase{"eventful", eventful, 45},
                                         ResumedCase{"resting", resting, 80}, ResumedCase{"settling", settling, 140},
                                         ResumedCase{"paper", paper, 50}, ResumedCase{"flying", flying, 25},
                                         ResumedCase{"earth_pressure", earth_pressure, 40},
                                         ResumedCase{"fluid", fluid, 40}, ResumedCase{"raining", raining, 40},
                                         ResumedCase{"finite_volumes", finite_volumes, 20},
                                         ResumedCase{"eventful_volumes", eventful_volumes, 20},
                                         ResumedCase{"resting_volumes", resting_volumes, 37},
                                         ResumedCase{"breaking", breaking, 15},
                                         ResumedCase{"breaking_later", breaking_later, 10},
                                         ResumedCase{"breaking_under_pressure", breaking_under_pressure, 15},
                                         ResumedCase{"loose_and_dry", loose_and_dry, 15}),
                         [](const auto& instance) { return std::string(instance.param.name); });

// Of another grid, of another model, truncated, with an impossible count.
TEST(ResumeRefuses, AStateThatDoesNotFit) {
    const Scene scene = hillside();
    const Bytes whole = play(scene, 1, 60).states.front();
    EXPECT_THROW(play(fluid(), 1, 60, &whole), Error);
    EXPECT_THROW(play(paper(), 1, 60, &whole), Error);
    Scene smaller = hillside();
    smaller.grid = {0, 120, 2, 100, 60, ""};
    smaller.terrain = Raster(smaller.grid, 1);
    EXPECT_THROW(play(smaller, 1, 60, &whole), Error);
    for (const std::size_t size : {std::size_t{0}, std::size_t{9}, whole.size() / 2, whole.size() - 1}) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_THROW(play(scene, 1, 60, &cut), Error) << size;
    }
    Bytes broken = whole;
    std::fill(broken.begin() + 16, broken.begin() + 24, std::byte{0xff});  // the number of particles
    EXPECT_THROW(play(scene, 1, 60, &broken), Error);
}

}  // namespace
}  // namespace frana
