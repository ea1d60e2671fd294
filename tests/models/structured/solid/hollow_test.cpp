// SPDX-License-Identifier: Apache-2.0
// Walls of the ground take the velocity of solids normal to them (mpm/ground_walls.h): what a basin keeps of a flow.
#include <gtest/gtest.h>

#include "solid_cases.h"
#include "support/hollows.h"

namespace frana::structured::test {
namespace {

double kept(const frana::test::Hollow& hollow, double cell) {
    ThreadPool pool(1);
    Case c(cell);
    c.material.cohesion = 0;
    c.material.bed_friction = std::tan(10 * k_degree);
    c.laws.fluid.wall = true;
    c.fill(0, 0, 3 * hollow.grid.columns, 3 * hollow.grid.rows, hollow.flow);
    State state = c.start(hollow.bed, pool);
    advance_to(state, c.laws, 20, pool);
    return frana::test::fraction_inside(hollow, state.solid->particles);
}

// Without walls they passed as over level ground: 0 and 0.2 %. It keeps all of them on cells of 5 and 2.5 m.
TEST(Solids, TheWallOfABasinStopsThem) {
    for (const double cell : {5.0, 2.5}) EXPECT_GT(kept(frana::test::basin(cell), cell), 0.95) << cell;
}

}  // namespace
}  // namespace frana::structured::test
