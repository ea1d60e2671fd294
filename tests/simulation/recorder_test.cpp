// SPDX-License-Identifier: Apache-2.0
#include "simulation/recorder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/exact/solutions.h"
#include "physics/laws.h"
#include "simulation/simulation.h"
#include "support/cases.h"

namespace frana::test {
namespace {

// Ritter's dam break, 10 m over dry ground: at the dam the depth is 4/9 of 10 m, the speed 2/3 sqrt(g 10 m) and the
// discharge 8/27 10 m sqrt(g 10 m) per metre of width, from the first moment and for ever.
class AtTheDam : public ::testing::Test {
  protected:
    static constexpr double k_end = 20;
    static constexpr std::int64_t k_columns = 400, k_rows = 4;
    GridSpec grid_ = bench::plain_grid(k_columns, k_rows, 1000.0 / k_columns);
    RunResult result_;
    double beyond_ = 0;  // volume beyond the dam when the last step began, from the particles

    void record(const Recording& recording) {
        const ParticleSet seeds =
            bench::fill_lattice(grid_, 2, 0, [](Point p) { return bench::Seed{p.x < 500 ? 10.0 : 0}; });
        const Numerics n = numerics(Scheme::standard, SlopeCorrection::none, Boundary::wall);
        Flow flow(bench::sample_raster(grid_, [](Point) { return 0.0; }), seeds, water(), n, 1);
        flow.record_gathered_velocities();
        Recorder recorder(recording, grid_, n);
        while (flow.time() < k_end) {
            const double began = flow.time();
            const ParticleSet& p = flow.particles();
            beyond_ = 0;
            for (std::size_t i = 0; i < p.size(); ++i)
                if (p[Field::x][i] > 500) beyond_ += p[Field::volume][i];
            const double dt = flow.advance(k_end - began).dt;
            recorder.record(flow, began, dt);
        }
        flow.record_present();
        result_.add("max_depth", flow.to_raster(flow.maxima().depth));
        recorder.move_to(flow, result_);
    }
    [[nodiscard]] Point dam(double offset_y) const { return {grid_.west + 500, grid_.south() + offset_y}; }
    [[nodiscard]] double width() const { return grid_.cell_size * k_rows; }
};

TEST_F(AtTheDam, DischargeAndVolumeAreRitters) {
    Recording recording;
    // From the south to the north the flow passes to the right; in the other direction to the left.
    recording.sections = {{"north", {dam(0), dam(width())}}, {"south", {dam(width()), dam(0)}}};
    recording.gauges = {{"dam", dam(width() / 2)}};
    record(recording);
    const double exact = 8.0 / 27 * 10 * std::sqrt(9.81 * 10) * width();
    ASSERT_FALSE(result_.sections.empty());
    for (const SectionRow& row : result_.sections) {
        if (row.time < 5) continue;  // the wave must span enough cells
        // Mean error of depth of this case on this grid: 0.011 m (dam_break_test) of 4.4 m; a fraction of a
        // percent. Speed likewise. The section at a cell's edge averages two cells, of 2.5 m in a wave of
        // 150 m and more: nothing. 2 % leaves room for the particles' arrangement in single steps.
        EXPECT_NEAR(std::abs(row.discharge), exact, 0.02 * exact) << row.time;
        EXPECT_EQ(row.discharge > 0, row.section == 0);
        EXPECT_NEAR(row.wetted_width, width(), 1e-9);
    }
    // The volume passed by the nodes against that by the particles, which cross column by column: a column of 1.25 m
    // contains 125 m3, so their sum is accurate to half of that.
    const SectionRow& last = result_.sections[result_.sections.size() - 2];
    EXPECT_NEAR(last.volume, beyond_, 0.5 * 10 * 1.25 * width());
    EXPECT_NEAR(result_.sections.back().volume, -last.volume, 1e-9 * beyond_);
    EXPECT_NEAR(last.volume, exact * last.time, 0.01 * exact * last.time);
    const GaugeRow& gauge = result_.gauges.back();
    EXPECT_NEAR(gauge.depth, 40.0 / 9, 0.02 * 40 / 9);
    EXPECT_NEAR(gauge.speed, 2.0 / 3 * std::sqrt(98.1), 0.02 * 6.6);
}

TEST_F(AtTheDam, GreatestFluxIsThatOfTheDamAndRowsKeepTheInterval) {
    Recording recording;
    recording.intensity = true;
    recording.interval = 5;
    recording.gauges = {{"dam", dam(width() / 2)}, {"dry", {grid_.west + 990, grid_.south() + 1}}};
    record(recording);
    ASSERT_EQ(result_.gauges.size(), 4U * 2);  // 0, 5, 10 and 15 s
    for (std::size_t i = 0; i < result_.gauges.size(); ++i) {
        EXPECT_EQ(result_.gauges[i].gauge, i % 2);
        // The first step at or after the time; a step is shorter than 0.2 s.
        EXPECT_NEAR(result_.gauges[i].time, 5.0 * static_cast<double>(i / 2) + 0.1, 0.1);
    }
    EXPECT_EQ(result_.gauges.back().depth, 0);
    // At a place x downstream of the dam the flux grows towards that at the dam and never exceeds it:
    // q(x, t) has its maximum 8/27 h c at x = 0.
    const double exact = 8.0 / 27 * 10 * std::sqrt(98.1);
    const Point place{grid_.west + 520, grid_.south() + width() / 2};
    const double there =
        result_.raster("max_flux").at(1, static_cast<std::int64_t>((place.x - grid_.west) / grid_.cell_size));
    // After 20 s: xi = x / (c t) = 0.105, q = h u = (2 - xi)^2 (1 + xi) 2/27 h c = 0.992 of the greatest.
    EXPECT_NEAR(there, 0.992 * exact, 0.02 * exact);
}

TEST(Recorder, FluxAndHeadAreWithinTheBoundsOfTheMaxima) {
    Scene scene;
    scene.grid = {600000, 5000120, 2, 120, 60, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < 60; ++r)
        for (std::int64_t c = 0; c < 120; ++c)
            scene.terrain.at(r, c) = 100 + std::max(0.0, 0.5 * (120 - 2.0 * static_cast<double>(c)));
    scene.release = {
        {{{{{600030, 5000040}, {600060, 5000040}, {600060, 5000080}, {600030, 5000080}}, {}}}, 2, {}, {}, false}};
    scene.material.of<CoulombFriction>().friction_coefficient = 0.3;
    scene.time.end = 8;
    scene.recording.intensity = true;
    scene.recording.sections = {{"toe", {{600100, 5000000}, {600100, 5000120}}}};
    const RunResult result = run(scene, {});
    EXPECT_EQ(static_cast<std::int64_t>(result.sections.size()), result.steps);
    for (std::size_t i = 0; i < result.raster("max_depth").values.size(); ++i) {
        const double depth = result.raster("max_depth").values[i], speed = result.raster("max_velocity").values[i];
        EXPECT_EQ(std::isnan(depth), std::isnan(result.raster("max_flux").values[i]));
        EXPECT_EQ(std::isnan(depth), std::isnan(result.raster("max_head").values[i]));
        if (std::isnan(depth)) continue;
        EXPECT_LE(result.raster("max_flux").values[i], depth * speed * (1 + 1e-12));
        EXPECT_GE(result.raster("max_head").values[i], depth);
        EXPECT_LE(result.raster("max_head").values[i], (depth + speed * speed / (2 * 9.81)) * (1 + 1e-12));
    }
}

}  // namespace
}  // namespace frana::test
