// SPDX-License-Identifier: Apache-2.0
// Particles of the frames as files, of both models: they have the flow's mass, place and state.
#include <cmath>

#include "particle_points.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class ParticleFiles : public TinyScene {
  protected:
    [[nodiscard]] Points points(const std::string& file) const { return read_points(path(file)); }
    void write_structured(const std::string& phases) const {
        write("scene.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
              "model = structured\n[structured]\nphases = " +
                  phases +
                  "\n[time]\nend = 2\nframe-interval = 1\n"
                  "[output]\nmaps = off\nanimation = off\nreport = off\nformats = geotiff, particles-gpkg\n");
    }
};

const std::vector<std::string> k_common{"depth_m", "bed_m", "speed_ms", "velocity_x_ms", "velocity_y_ms", "volume_m3"};

// The slope falls eastward by 1 in 2 as far as 200 m, every cell's centre at its exact height.
void expect_on_the_slope(const Points& points) {
    const std::vector<double>&x = points.columns.at("x"), &bed = points.columns.at("bed_m");
    const std::vector<double>&u = points.columns.at("velocity_x_ms"), &v = points.columns.at("velocity_y_ms");
    for (std::size_t p = 0; p < x.size(); ++p) {
        ASSERT_LT(x[p], k_west + 190) << "the test looks at the slope alone";
        EXPECT_NEAR(bed[p], 300 - 0.5 * (x[p] - k_west), 1e-4);  // the file's elevations are 32-bit
        EXPECT_NEAR(points.columns.at("speed_ms")[p], std::hypot(u[p], v[p], 0.5 * u[p]), 1e-4 * (1 + std::abs(u[p])));
    }
}

TEST_F(ParticleFiles, OfTheFirstModel) {
    write_scene(
        "frame-interval = 1\n[output]\nmaps = off\nanimation = off\nreport = off\nformats = geotiff, particles-gpkg\n");
    ran("result", {"time.end=2"});
    const Points start = points("result/frames/particles_0000.gpkg"), end = points("result/frames/particles_0002.gpkg");
    EXPECT_EQ(start.names, k_common);
    EXPECT_NEAR(start.sum("volume_m3"), 4000, 1e-6);  // 50 m x 40 m x 2 m
    EXPECT_NEAR(end.sum("volume_m3"), 4000, 1e-6);
    EXPECT_EQ(start.sum("speed_ms"), 0);
    for (const double depth : start.columns.at("depth_m")) EXPECT_NEAR(depth, 2, 1e-9);
    expect_on_the_slope(start);
    expect_on_the_slope(end);
    // Its centre of mass gains less than g (sin - cos tan 15) t along the bed: friction of 15 degrees, and
    // turbulence.
    const double angle = std::atan(0.5), most = 2 * 9.81 * (std::sin(angle) - std::cos(angle) * std::tan(0.2618));
    double mean = 0;
    for (std::size_t p = 0; p < end.size(); ++p)
        mean += end.columns.at("velocity_x_ms")[p] * end.columns.at("volume_m3")[p] / (4000 * std::cos(angle));
    EXPECT_LT(mean, most);
    EXPECT_GT(mean, 0.8 * most);
    const Outcome wet =
        ran("wet", {"time.end=1", "material.pore-pressure-ratio=0.4", "material.pore-dissipation-time=2"});
    // As velocities, the ratio of a frame is up to half a step old.
    const Points later = points("wet/frames/particles_0001.gpkg");  // not in the loop's head: it must outlive the loop
    for (const double ratio : later.columns.at("pore_pressure_ratio")) {
        EXPECT_GE(ratio, 0.4 * std::exp(-0.5) * (1 - 1e-9));
        EXPECT_LT(ratio, 0.4 * std::exp(-0.4));
    }
}

TEST_F(ParticleFiles, OfStructuredSolidsInBothFormats) {
    write_structured(
        "solids-and-fluid\ncohesion = 1e6\ninternal-friction-angle = 28\nbed-friction-angle = 12\n"
        "young-modulus = 1e7\nbulk-modulus = 1e7\n[numerics]\nparticles-per-cell = 9");
    ran();
    const Points end = points("result/frames/particles_0002.gpkg");
    std::vector<std::string> names = k_common;
    for (const char* name :
         {"confined_fluid_m3", "stress_xx_kpa", "stress_yy_kpa", "stress_zz_kpa", "stress_xy_kpa", "mean_stress_kpa",
          "shear_stress_kpa", "strain", "strain_xx", "strain_yy", "strain_xy", "cohesion_ratio", "fractured_fraction"})
        names.emplace_back(name);
    EXPECT_EQ(end.names, names);
    // Nothing breaks: half of the volume remains confined, and all is one block.
    EXPECT_NEAR(end.sum("volume_m3"), 4000, 1e-6);
    EXPECT_NEAR(end.sum("confined_fluid_m3"), 2000, 1e-6);
    EXPECT_EQ(end.sum("fractured_fraction"), 0);
    expect_on_the_slope(end);
    for (std::size_t p = 0; p < end.columns.at("x").size(); ++p) {
        const auto value = [&](const char* name) { return end.columns.at(name)[p]; };
        const double mean = (value("stress_xx_kpa") + value("stress_yy_kpa") + value("stress_zz_kpa")) / 3;
        EXPECT_NEAR(value("mean_stress_kpa"), mean, 1e-9 * (1 + std::abs(mean)));
        EXPECT_LT(value("strain"), 0.01);
        // Plane strain of small magnitude: sigma_zz = (K - 2G/3) (e_xx + e_yy), G = 3 K E/(9 K - E).
        const double shear = 3 * 1e4 * 1e4 / (9e4 - 1e4);
        EXPECT_NEAR(value("stress_zz_kpa"), (1e4 - 2 * shear / 3) * (value("strain_xx") + value("strain_yy")),
                    1e-6 * (1 + std::abs(value("stress_zz_kpa"))));
    }
}

}  // namespace
}  // namespace frana::test
