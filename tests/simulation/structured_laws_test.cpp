// SPDX-License-Identifier: Apache-2.0
// What a scene's choices become in the structured model, and what its run counts.
#include "simulation/structured_laws.h"

#include <gtest/gtest.h>

#include "played_runs.h"
#include "simulation/structured_flow.h"

namespace frana {
namespace {

TEST(StructuredLaws, EveryChoiceArrives) {
    Scene scene = breaking();
    StructuredMaterial& m = *scene.structured;
    const auto laws = [&] { return structured_laws(m, scene.numerics, scene.grid); };
    const structured::Laws usual = laws();
    const double cell = scene.grid.cell_size;
    EXPECT_EQ(structured_laws(m, scene.numerics, scene.grid, 2.4 * cell).solid.damage_length, 0.6 * cell);
    EXPECT_EQ(usual.solid.damage_length, 0.5 * cell);  // however thin
    m.damage_length = 1.5 * cell;
    EXPECT_EQ(laws().solid.damage_length, 1.5 * cell);
    EXPECT_GT(laws().solid.side, usual.solid.side);  // it follows the damage length
    m.damage_length.reset();
    m.young_modulus /= 4;
    m.bulk_modulus /= 4;
    const structured::Laws chosen = laws();
    EXPECT_DOUBLE_EQ(chosen.solid.elastic.shear, usual.solid.elastic.shear / 4);
}

// Loose material on a plain, too low for its friction to let it spread: nothing moves, and a step ends with the second
// substep that shows it.
TEST(StructuredRun, TwoSubstepsShowThatAllRests) {
    Scene scene = loose_and_dry();
    for (double& z : scene.terrain.values) z = 0;
    scene.release[0].thickness = 0.2;
    scene.structured->bed_friction = 0.6;
    const Release release = make_release(scene);
    StructuredFlow flow(release.bed_at_start, scene.walls, *scene.structured, scene.numerics, release.particles, 1);
    for (int i = 0; i < 5; ++i) flow.step(0.1);
    EXPECT_GT(flow.particle_count(), 100);
    EXPECT_EQ(flow.steps(), 5);
    EXPECT_LE(flow.particle_steps(), 2 * 5 * flow.particle_count());
    EXPECT_EQ(flow.state().solid->last.speed2, 0);
}

}  // namespace
}  // namespace frana
