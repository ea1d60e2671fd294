// SPDX-License-Identifier: Apache-2.0
#include "core/thread_pool.h"

#include <gtest/gtest.h>

#include <chrono>

namespace frana {
namespace {

using namespace std::chrono_literals;

// The clock is the test's: between two calls the calling thread uses next to no processor time.
struct TeamWatchTest : testing::Test {
    TeamWatch watch;
    TeamWatch::Clock::time_point now{};

    TeamWatchTest() { watch.start(now); }
    bool alone_after(TeamWatch::Clock::duration time) { return watch.alone(now += time); }
};

TEST_F(TeamWatchTest, WorksTogetherWhileTheOthersWork) {
    for (int window = 0; window < 10; ++window) {
        watch.add_wait(0.021, 0.021);  // uneven tasks, not a lost processor
        EXPECT_FALSE(alone_after(21ms));
    }
}

TEST_F(TeamWatchTest, WorksAloneWhenASuspendedThreadIsWaitedFor) {
    watch.add_wait(0.021, 0);
    EXPECT_TRUE(alone_after(21ms));
    EXPECT_TRUE(alone_after(90ms));
    EXPECT_FALSE(alone_after(11ms)) << "tries the team again";
}

TEST_F(TeamWatchTest, PausesTwiceAsLongWhenItHappensAgain) {
    watch.add_wait(0.021, 0);
    ASSERT_TRUE(alone_after(21ms));
    ASSERT_FALSE(alone_after(101ms));
    watch.add_wait(0.021, 0);
    ASSERT_TRUE(alone_after(21ms));
    EXPECT_TRUE(alone_after(190ms));
    EXPECT_FALSE(alone_after(11ms));
}

TEST_F(TeamWatchTest, ALongPauseBetweenLoopsIsNoLoss) {
    EXPECT_FALSE(alone_after(10s));
}

}  // namespace
}  // namespace frana
