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
    ASSERT_EQ(result.rows.size(), 8u);  // slide, gullies, mud and solids, 1 and 2 threads
    for (const SpeedRow& row : result.rows) {
        EXPECT_EQ(row.particles, 400);
        EXPECT_GT(row.particle_steps_per_second, 0);
        EXPECT_GT(row.bytes_per_particle, 0);
        EXPECT_TRUE(row.case_name == "solids" || row.fraction_of_memory_bandwidth > 0);
        EXPECT_TRUE(row.same_bits);
    }
    EXPECT_GT(result.rows[4].bytes_per_particle, result.rows[0].bytes_per_particle)
        << "stress is carried only where there is some";
    EXPECT_LT(result.difference_from_plain, 1e-10) << "the fast kernels compute something else";
    EXPECT_TRUE(result.right());
    const std::string csv = speed_csv(result);
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "case,particles,threads,particle_steps_per_second,bytes_per_particle,fraction_of_memory_bandwidth");
}

// A wrong result or other bits must not pass as a fast run.
TEST(Speed, AWrongAnswerIsNotRight) {
    SpeedResult result;
    result.rows.resize(2);
    EXPECT_TRUE(result.right());
    result.rows[1].same_bits = false;
    EXPECT_FALSE(result.right());
    result.rows[1].same_bits = true;
    result.difference_from_plain = 1e-6;
    EXPECT_FALSE(result.right());
    EXPECT_NE(speed_table(result).find("NOT THE SAME ANSWER"), std::string::npos);
}

// The stages' bytes add up to those a step must move: 13 fields and the stress, each read or written where needed.
TEST(Speed, CountsTheBytesOfAStage) {
    using voellmy_bingham::Stage;
    EXPECT_EQ(bytes_moved(Stage::particles_to_nodes, false), 80);  // position, velocity, volume, area, affine part
    EXPECT_EQ(bytes_moved(Stage::pressure, false), 40);
    EXPECT_EQ(bytes_moved(Stage::nodes_to_particles, false), 56 + 104);
    EXPECT_EQ(bytes_moved(Stage::nodes_to_particles, true), 56 + 104 + 24);
    EXPECT_EQ(bytes_moved(Stage::levels, true), 0);
}

}  // namespace
}  // namespace frana::bench
