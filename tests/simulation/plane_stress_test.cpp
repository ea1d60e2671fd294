// SPDX-License-Identifier: Apache-2.0
// The normal stresses in the plane, against closed forms.
#include "simulation/plane_stress.h"

#include <gtest/gtest.h>

#include "params/keys/result_rasters.h"
#include "simulation/finite_volume_flow.h"
#include "simulation/played_runs.h"
#include "support/cases.h"

namespace frana::test {
namespace {

constexpr double k_rate = 0.1, k_depth = 2;                              // [1/s], [m]
constexpr std::int64_t k_middle = 20;                                    // the cell in which the sheet does not move
constexpr double k_half_weight = 1e-3 * 1300 * k_gravity * k_depth / 2;  // [kPa]

// A sheet of uniform depth that extends along x about the middle of a cell.
ParticleSet extending_sheet(const GridSpec& grid) {
    return bench::fill_lattice(grid, 2, 0, [](Point p) {
        return bench::Seed{k_depth, k_rate * (p.x - (k_middle + 0.5)), 0};
    });
}

Material sheet_material() {
    Material material = water();
    material.density = 1300;
    return material;
}

struct Stresses {
    double xx, yy;  ///< in the middle [kPa]
};

Stresses in_the_middle(const std::vector<NamedRaster>& rasters) {
    EXPECT_EQ(rasters.size(), 2U);
    EXPECT_EQ(rasters[0].name, RasterName::plane_stress_xx);
    EXPECT_EQ(rasters[1].name, RasterName::plane_stress_yy);
    return {rasters[0].values.at(k_middle, k_middle), rasters[1].values.at(k_middle, k_middle)};
}

Stresses by_volumes(const Material& material, PointTable& particles) {
    const GridSpec grid = bench::plain_grid(41, 41, 1);
    FiniteVolumeFlow flow(Raster(grid), std::nullopt, extending_sheet(grid), material,
                          numerics(Scheme::finite_volume, SlopeCorrection::normal, Boundary::open), 1);
    return in_the_middle(flow.plane_stress(flow.snapshot().depth, particles));
}

// sigma_xx = (2 mu + tau_Y / sqrt(I2 + r^2)) e, sigma_yy = 0; where nothing moves I2 = e^2.
class BinghamSheet : public testing::Test {
  protected:
    BinghamSheet() {
        material_.of<BinghamStress>().viscosity = 2e5;
        material_.of<BinghamStress>().yield_stress = 5e4;
    }
    Material material_ = sheet_material();
    const double sigma_ =
        1e-3 * (2 * 2e5 + 5e4 / std::sqrt(k_rate * k_rate + std::pow(k_yield_regularisation, 2))) * k_rate;  // [kPa]
};

TEST_F(BinghamSheet, InUniformExtensionByFiniteVolumes) {
    PointTable none;
    const Stresses is = by_volumes(material_, none);
    EXPECT_NEAR(is.xx, k_half_weight - sigma_, 1e-9 * sigma_);
    EXPECT_NEAR(is.yy, k_half_weight, 1e-9 * sigma_);
    EXPECT_TRUE(none.columns.empty());
}

// The particles' own stress is that of their last step, a quarter of a cell from where nothing moves.
TEST_F(BinghamSheet, InUniformExtensionByParticles) {
    const GridSpec grid = bench::plain_grid(41, 41, 1);
    for (const Scheme scheme : {Scheme::standard, Scheme::paper}) {
        Flow flow(Raster(grid), extending_sheet(grid), material_,
                  numerics(scheme, SlopeCorrection::normal, Boundary::open), 1);
        flow.advance_to(1e-4);
        PointTable particles = flow.particle_table();
        const Stresses is = in_the_middle(flow.plane_stress(flow.snapshot().depth, particles));
        EXPECT_NEAR(is.xx, k_half_weight - sigma_, 1e-3 * sigma_);
        EXPECT_NEAR(is.yy, k_half_weight, 1e-3 * sigma_);
        const std::vector<double>*const xx = particles.find("plane_stress_xx_kpa"), *const yy = particles.find(
                                                                                        "plane_stress_yy_kpa");
        ASSERT_TRUE(xx != nullptr && yy != nullptr);
        const Point middle = grid.map_from_local({k_middle + 0.5, k_middle + 0.5});
        int beside = 0;
        for (std::size_t p = 0; p < particles.places.size(); ++p) {
            const Point place = particles.places[p];
            if (std::max(std::abs(place.x - middle.x), std::abs(place.y - middle.y)) > 0.3) continue;
            ++beside;
            EXPECT_NEAR((*xx)[p], k_half_weight - sigma_, 5e-3 * sigma_);
            EXPECT_NEAR((*yy)[p], k_half_weight, 5e-3 * sigma_);
        }
        EXPECT_EQ(beside, 4);
    }
}

// Earth pressure of a mass that spreads is K_act of the weight's, alike in both directions.
TEST(PlaneStress, OfEarthPressure) {
    Material material = sheet_material();
    material.in_plane_stress = "earth-pressure";
    material.of<EarthPressureStress>().internal_friction_angle = 35;
    PointTable none;
    const double active = EarthPressureStress::of(tangent_of(35), 0, k_gravity).spreading;
    EXPECT_NEAR(active, std::pow(std::tan((45 - 35.0 / 2) * M_PI / 180), 2), 1e-12) << "Rankine's, of a smooth bed";
    const Stresses is = by_volumes(material, none);
    EXPECT_NEAR(is.xx, active * k_half_weight, 1e-9);
    EXPECT_NEAR(is.yy, active * k_half_weight, 1e-9);
}

// Frames and the end of a run have it if asked for; without a law of stress it is the weight's.
TEST(PlaneStress, IsInFramesAndAtTheEndOnlyOnRequest) {
    for (const bool asked : {true, false})
        for (const Scheme scheme : {Scheme::standard, Scheme::finite_volume}) {
            Scene scene = hillside();
            scene.numerics.scheme = scheme;
            scene.recording.plane_stress = asked;
            scene.time.end = 3;
            int frames = 0;
            const auto expect_weight = [&](const Raster& stress, const Raster& depth) {
                for (std::size_t cell = 0; cell < depth.values.size(); ++cell) {
                    const double h = depth.values[cell];
                    ASSERT_EQ(std::isnan(stress.values[cell]), std::isnan(h));
                    if (std::isnan(h)) continue;
                    ASSERT_NEAR(stress.values[cell], 1e-3 * scene.material.density * k_gravity * h / 2, 1e-9);
                }
            };
            RunOptions options;
            options.particles_in_frames = true;
            options.on_frame = [&](Frame frame) {
                ++frames;
                ASSERT_EQ(frame.more.size(), asked ? 2U : 0U);
                for (const NamedRaster& raster : frame.more) expect_weight(raster.values, frame.depth);
                EXPECT_EQ(frame.particles.find("plane_stress_xx_kpa") != nullptr, asked && scheme == Scheme::standard);
            };
            const RunResult result = run(scene, options);
            EXPECT_GT(frames, 1);
            EXPECT_EQ(result.find_raster(RasterName::plane_stress_yy) != nullptr, asked);
            EXPECT_EQ(result.find_raster(RasterName::max_flux), nullptr);
            if (asked)
                expect_weight(result.raster(RasterName::plane_stress_xx), result.raster(RasterName::final_depth));
        }
}

}  // namespace
}  // namespace frana::test
