// SPDX-License-Identifier: Apache-2.0
#include "bench/speed/speed.h"

#include <gtest/gtest.h>

namespace frana::bench {
namespace {

TEST(Speed, MeasuresOneAndSeveralThreadsWithTheSameBits) {
    SpeedOptions options;
    options.quick = true;
    options.threads = 2;
    options.sizes = {400};
    options.steps = 20;
    const SpeedResult result = run_speed(options);
    ASSERT_EQ(result.rows.size(), 6u);  // slide, gullies and mud, 1 and 2 threads
    for (const SpeedRow& row : result.rows) {
        EXPECT_EQ(row.particles, 400);
        EXPECT_GT(row.particle_steps_per_second, 0);
        EXPECT_GT(row.bytes_per_particle, 0);
        EXPECT_GT(row.fraction_of_memory_bandwidth, 0);
        EXPECT_TRUE(row.same_bits);
    }
    EXPECT_GT(result.rows[4].bytes_per_particle, result.rows[0].bytes_per_particle)
        << "stress is carried only where there is some";
    EXPECT_TRUE(result.right());
    const std::string csv = speed_csv(result);
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "case,particles,threads,particle_steps_per_second,bytes_per_particle,fraction_of_memory_bandwidth");
}

// Other bits must not pass as a fast run.
TEST(Speed, OtherBitsAreNotRight) {
    SpeedResult result;
    result.rows.resize(2);
    EXPECT_TRUE(result.right());
    result.rows[1].same_bits = false;
    EXPECT_FALSE(result.right());
    EXPECT_NE(speed_table(result).find("NOT THE SAME BITS"), std::string::npos);
}

// What the three sweeps over particles read and write.
TEST(Speed, CountsTheBytesOfAStep) {
    // Position, velocity, volume, area, affine part; of the pressure five fields.
    EXPECT_EQ(bytes_moved(false), 80 + 40 + 56 + 104);
    EXPECT_EQ(bytes_moved(true), bytes_moved(false) + 24 + 24);
}

}  // namespace
}  // namespace frana::bench
