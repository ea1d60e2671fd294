// SPDX-License-Identifier: Apache-2.0
// The scenes after van den Bout et al. (2021) in sample_data, on coarser cells: what holds of them whatever the
// resolution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/input/prepare.h"
#include "sample_data/structured_samples.h"
#include "simulation/particle_table.h"
#include "simulation/release.h"
#include "simulation/structured_flow.h"

namespace frana::test {
namespace {

struct Outcome {
    double lost = 0;             // mean loss of cohesion, by volume
    double damaged = 0;          // share of the particles that lost any
    double whole_strain = 0;     // greatest of particles that lost none
    bool whole_unless_damaged = true;
    double ahead = 0;            // mean easting of the marked particles less that of the others [m]
    double length = 0;           // from the hindmost to the foremost particle, eastward [m]
    double events = 0;
};

// Marks the particles that start north of a line, by a diameter that differs by a thousandth: grains settle in free
// fluid a little faster or slower for it, which moves nothing that is looked at here.
Outcome slide(const std::string& file, const std::string& cell_size, double end, double north_of = 0) {
    const SceneReading reading = read_scene(FRANA_SOURCE_DIR "/sample_data/" + file,
                                            {"terrain.cell-size=" + cell_size}, FRANA_SOURCE_DIR "/share/materials");
    app::RunLog log(true);
    Scene scene = std::move(app::prepare(reading, log).scene);
    StructuredMaterial& material = *scene.structured;
    Raster& mark = material.zones.grain_diameter.emplace(scene.grid, material.grain_diameter);
    for (std::int64_t row = 0; row < scene.grid.rows; ++row)
        for (std::int64_t column = 0; column < scene.grid.columns; ++column)
            if (scene.grid.cell_centre(row, column).y > north_of) mark.at(row, column) *= 1.001;
    const Release release = make_release(scene);
    StructuredFlow flow(release.bed_at_start, scene.walls, material, scene.numerics, release.particles, 1);
    Outcome outcome;
    while (flow.time() < end) {
        const StepFigures step = flow.advance(end - flow.time());
        outcome.events += static_cast<double>(step.non_finite + step.clamped);
    }
    const ParticleSet& p = flow.state().solid->particles;
    double volume = 0, x[2] = {0, 0}, count[2] = {0, 0};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double ratio = p[Field::cohesion_ratio][i];
        volume += p[Field::volume][i];
        outcome.lost += (1 - ratio) * p[Field::volume][i];
        outcome.damaged += (ratio < 1) / static_cast<double>(p.size());
        const bool marked = p[Field::grain_diameter][i] > material.grain_diameter;
        x[marked] += p[Field::x][i];
        count[marked] += 1;
        if (p[Field::damage][i] > 0) continue;
        outcome.whole_unless_damaged = outcome.whole_unless_damaged && ratio == 1;
        outcome.whole_strain = std::max(outcome.whole_strain, greatest_strain(p, i));
    }
    outcome.lost /= volume;
    outcome.ahead = x[1] / count[1] - x[0] / count[0];
    const auto [back, front] = std::minmax_element(p[Field::x], p[Field::x] + p.size());
    outcome.length = *front - *back;
    return outcome;
}

void moves_as_one_where_whole(const Outcome& outcome) {
    EXPECT_TRUE(outcome.whole_unless_damaged);
    EXPECT_LT(outcome.whole_strain, 0.01);
    EXPECT_EQ(outcome.events, 0);
}

// A quarter of a second after the impact.
TEST(FlumeSample, TheWeakerTheMoreBreaksAndTheFreeSideIsAhead) {
    const auto run = [](const char* file) { return slide(file, "0.05", 0.9, sample::k_obstacle_north); };
    const Outcome strong = run("flume/strong.ini"), first = run("flume/material_1.ini"),
                  second = run("flume/material_2.ini");
    EXPECT_EQ(strong.lost, 0);
    EXPECT_GT(first.lost, 0.01);
    EXPECT_GT(second.lost, first.lost);
    for (const Outcome& outcome : {strong, first, second}) {
        moves_as_one_where_whole(outcome);
        EXPECT_GT(outcome.ahead, 0.005);  // of a block 0.25 m wide
    }
}

TEST(FractureSample, OverABreakOfSlope) {
    const Outcome a = slide("fracture/2a.ini", "20", 25), b = slide("fracture/2b.ini", "20", 25),
                  c = slide("fracture/2c.ini", "20", 25);
    for (const Outcome& outcome : {a, b, c}) moves_as_one_where_whole(outcome);
    EXPECT_EQ(a.lost, 0);
    EXPECT_GT(b.lost, 0.01);
    EXPECT_GT(c.lost, 2 * b.lost);
    EXPECT_NEAR(a.length, 29 * 20 / 3.0, 0.01 * 200);  // it keeps its shape
    EXPECT_GT(b.length, 1.1 * a.length);               // its parts come away from each other
    EXPECT_GT(c.length, 2 * a.length);
}

TEST(FractureSample, IntoAValley) {
    const Outcome a = slide("fracture/3a.ini", "20", 25), b = slide("fracture/3b.ini", "20", 25),
                  c = slide("fracture/3c.ini", "20", 25);
    for (const Outcome& outcome : {a, b, c}) moves_as_one_where_whole(outcome);
    EXPECT_EQ(a.lost, 0);
    EXPECT_GT(b.lost, 0.01);
    EXPECT_GT(c.lost, 2 * b.lost);
    // Weak material begins to break on the even slope, by its own thrust; 3B hardly before the valley.
    EXPECT_GT(slide("fracture/3c.ini", "20", 10).lost, 2 * slide("fracture/3b.ini", "20", 10).lost);
}

}  // namespace
}  // namespace frana::test
