// SPDX-License-Identifier: Apache-2.0
// Every law of bed friction as selected by a scene: a wide slab in a frame tilted along the bed must move as a block
// under that law. Only the slab's middle is compared: its edges collapse.
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/set_up/setup.h"
#include "params/keys/laws.h"
#include "params/keys/zone_keys.h"
#include "physics/laws.h"
#include "physics/yield_ratio.h"
#include "simulation/dispatch.h"
#include "simulation/terms.h"
#include "support/cases.h"

namespace frana::test {
namespace {

constexpr double k_along = 3, k_normal = 9, k_density = 2000;

Material material_of(std::vector<std::string> terms) {
    Material material = water();
    material.density = k_density;
    material.in_plane_stress = "none";
    material.bed_friction = std::move(terms);
    return material;
}

// Returns the mean speed of the material within 5 m of the slab's middle after `time`; the slab, 1 m thick, starts at
// 10 m < x < 70 m, and the pressure wave from its ends travels 3 m/s. Steps are short, since each law is applied to
// first order in time.
double slab_speed(const Material& material, double time, double travelled, const MaterialZones& zones = {},
                  double side = 0, std::int64_t rows = 4, double step = 0.005) {
    const GridSpec grid = bench::plain_grid(120 + static_cast<std::int64_t>(travelled), rows, 1);
    const ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{p.x > 10 && p.x < 70 ? 1.0 : 0.0}; });
    Flow flow(Raster(grid), seeds, material, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall), 1,
              TiltedGravity{k_along, 0, k_normal}, zones);
    while (flow.time() < time) flow.advance(std::min(step, time - flow.time()));
    flow.synchronise();
    double sum = 0;
    int n = 0;
    const ParticleSet& p = flow.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (std::abs(p[Field::x][i] - 40 - travelled) > 5) continue;
        if (side < 0 && p[Field::y][i] > 2) continue;
        if (side > 0 && p[Field::y][i] < static_cast<double>(rows) - 2) continue;
        sum += p[Field::u][i];
        ++n;
    }
    return sum / n;
}

// Speed and distance after `time` from rest under ds/dt = k_along - R(s, t), by the classical Runge-Kutta method.
struct BlockMotion {
    double speed = 0, way = 0;
};
BlockMotion block(const std::function<double(double, double)>& resistance, double time) {
    BlockMotion m;
    const int n = 20000;
    const double dt = time / n;
    const auto rate = [&](double s, double t) { return k_along - resistance(s, t); };
    for (int i = 0; i < n; ++i) {
        const double t = i * dt, s = m.speed;
        const double a = rate(s, t), b = rate(s + 0.5 * dt * a, t + 0.5 * dt);
        const double c = rate(s + 0.5 * dt * b, t + 0.5 * dt), d = rate(s + dt * c, t + dt);
        m.way += dt * (s + dt / 6 * (a + b + c));
        m.speed += dt / 6 * (a + 2 * b + 2 * c + d);
    }
    return m;
}

// A thousand steps of first order: an error of the order of 1e-3.
void expect_block(const Material& material, const std::function<double(double, double)>& resistance, double time = 5) {
    const BlockMotion exact = block(resistance, time);
    ASSERT_GT(exact.speed, 0.1);
    EXPECT_NEAR(slab_speed(material, time, exact.way), exact.speed, 1e-3 * exact.speed);
}

TEST(BedLaws, Cohesion) {
    Material m = material_of({"coulomb", "cohesion"});
    m.of<CoulombFriction>().friction_coefficient = 0.1;
    m.of<CohesiveFriction>().cohesion = 1000;
    expect_block(m, [](double, double) { return 0.1 * k_normal + 1000 / k_density; });
}

TEST(BedLaws, SurfacePressure) {
    Material m = material_of({"coulomb", "turbulence"});
    m.of<CoulombFriction>().friction_coefficient = 0.1;
    m.of<TurbulentFriction>().turbulence = 300;
    m.of<CoulombFriction>().surface_pressure = 6000;
    expect_block(m, [](double s, double) { return 0.1 * (k_normal + 6000 / k_density) + k_normal * s * s / 300; });
}

TEST(BedLaws, RammsYield) {
    Material m = material_of({"coulomb", "ramms-yield"});
    m.of<CoulombFriction>().friction_coefficient = 0.1;
    m.of<RammsYield>().ramms_yield_stress = 1500;
    const double normal = k_density * k_normal;
    expect_block(
        m, [=](double, double) { return 0.1 * k_normal + 0.9 * 1500 * (1 - std::exp(-normal / 1500)) / k_density; });
}

TEST(BedLaws, Manning) {
    Material m = material_of({"manning"});
    m.of<ManningFriction>().manning = 0.1;
    expect_block(m, [](double s, double) { return k_normal * 0.01 * s * s; });
}

TEST(BedLaws, Chezy) {
    Material m = material_of({"chezy"});
    m.of<ChezyFriction>().chezy = 8;
    expect_block(m, [](double s, double) { return k_normal * s * s / 64; });
}

TEST(BedLaws, OBrienJulien) {
    Material m = material_of({"obrien-julien"});
    m.of<BinghamStress>().yield_stress = 1000;
    m.of<BinghamStress>().viscosity = 20;
    m.of<OBrienJulienFriction>().laminar_resistance = 400;
    m.of<ManningFriction>().manning = 0.06;
    expect_block(m, [](double s, double) {
        return 1000 / k_density + 400 * 20 * s / (8 * k_density) + k_normal * 0.0036 * s * s;
    });
}

TEST(BedLaws, Bingham) {
    Material m = material_of({"bingham"});
    m.of<BinghamStress>().yield_stress = 2000;
    m.of<BinghamStress>().viscosity = 400;
    const auto a = [](double s) { return 6 * 400 * s / 2000; };
    expect_block(m, [&](double s, double) { return 2000 / (k_density * ExactYieldRatio{}(a(s))); });
}

TEST(BedLaws, HerschelBulkley) {
    Material m = material_of({"herschel-bulkley"});
    m.of<BinghamStress>().yield_stress = 1000;
    m.of<HerschelBulkleyExcess>().consistency = 1500;
    m.of<HerschelBulkleyExcess>().flow_index = 0.5;
    // The bed stress at a speed, by bisection of the mean speed's closed form (index 1/2, 1 m thick).
    const auto speed = [](double x) {
        const double fraction = x / (1000 + x);
        return std::pow(x / 1500, 2) * fraction / 3 * (1 - fraction / 4);
    };
    expect_block(m, [&](double s, double) {
        double low = 0, high = 1e5;
        for (int i = 0; i < 60; ++i) (speed(0.5 * (low + high)) < s ? low : high) = 0.5 * (low + high);
        return (1000 + low) / k_density;
    });
}

TEST(BedLaws, PouliquenForterre) {
    Material m = material_of({"pouliquen-forterre"});
    m.of<CoulombFriction>().friction_coefficient = 0.2;
    m.of<PouliquenForterreExcess>().fast_friction_angle = std::atan(0.6) * 180 / M_PI;
    m.of<PouliquenForterreExcess>().friction_length = 0.5;
    expect_block(m, [](double s, double) {
        return k_normal * (s > 0 ? 0.2 + 0.4 / (1 + 0.136 * std::sqrt(k_normal) / (0.5 * s)) : 0.2);
    });
}

// 1 m thick: friction up to 1 m/s, from there on turbulence alone.
TEST(BedLaws, ModifiedVoellmy) {
    Material m = material_of({"modified-voellmy"});
    m.of<CoulombFriction>().friction_coefficient = 0.2;
    m.of<TurbulentFriction>().turbulence = 50;
    m.of<ModifiedVoellmyExcess>().crossover_speed = 1;
    expect_block(m, [](double s, double) { return s < 1 ? 0.2 * k_normal : k_normal * s * s / 50; });
}

TEST(BedLaws, PorePressureThatDissipates) {
    Material m = material_of({"coulomb"});
    m.of<CoulombFriction>().friction_coefficient = 0.3;
    m.of<CoulombFriction>().pore_pressure_ratio = 0.8;
    m.of<CoulombFriction>().pore_dissipation_time = 4;
    expect_block(m, [](double, double t) { return 0.3 * k_normal * (1 - 0.8 * std::exp(-t / 4)); });
}

// A block whose friction recovers as the layer, 1 m thick, consolidates: closed form.
TEST(BedLaws, PorePressureOfALayerThatConsolidatesIsOfSecondOrderInTime) {
    Material m = material_of({"coulomb"});
    m.of<CoulombFriction>().friction_coefficient = 0.3;
    m.of<CoulombFriction>().pore_pressure_ratio = 0.9;
    m.of<CoulombFriction>().pore_fluid_density = 800;
    m.of<CoulombFriction>().hydraulic_diffusivity = 0.2;
    const double T = 4 / (M_PI * M_PI * 0.2), time = 4, yield = 0.3 * k_normal;
    const auto motion = [&](double t) {  // speed, way
        const double e = std::exp(-t / T), push = k_along - yield * (1 - 0.4);
        return std::pair{push * t + yield * 0.5 * T * (1 - e), push * t * t / 2 + yield * 0.5 * T * (t - T * (1 - e))};
    };
    const auto [speed, way] = motion(time);
    const auto error = [&, speed = speed, way = way](double step) {
        return std::abs(slab_speed(m, time, way, {}, 0, 4, step) - speed);
    };
    const double coarse = error(0.1), fine = error(0.05);
    EXPECT_LT(coarse, 1e-4 * speed);
    EXPECT_NEAR(coarse / fine, 4, 0.4);
}

TEST(BedLaws, SumOfThree) {
    Material m = material_of({"coulomb", "turbulence", "bingham"});
    m.of<CoulombFriction>().friction_coefficient = 0.05;
    m.of<TurbulentFriction>().turbulence = 300;
    m.of<BinghamStress>().yield_stress = 500;
    m.of<BinghamStress>().viscosity = 100;
    expect_block(m, [](double s, double) {
        return 0.05 * k_normal + k_normal * s * s / 300 + 500 / (k_density * ExactYieldRatio{}(6 * 100 * s / 500));
    });
}

// The compared strips are 6 m from the zones' border, and in 1 s a pressure wave travels 3 m; steps are long, since
// each one smooths the shear between the zones slightly.
TEST(BedLaws, ZonesGiveEachPlaceItsOwnFriction) {
    Material m = material_of({"coulomb", "turbulence"});
    m.of<CoulombFriction>().friction_coefficient = 0.1;
    MaterialZones zones;
    zones.friction_coefficient = Raster(bench::plain_grid(121, 16, 1), k_no_data);
    for (std::int64_t c = 0; c < 121; ++c) {
        for (std::int64_t r = 0; r < 8; ++r) zones.friction_coefficient->at(r, c) = 0.3;  // north
    }
    const double slow = (k_along - 0.3 * k_normal), fast = k_along - 0.1 * k_normal;
    EXPECT_NEAR(slab_speed(m, 1, 1, zones, -1, 16, 0.1), fast, 1e-3 * fast);
    EXPECT_NEAR(slab_speed(m, 1, 1, zones, 1, 16, 0.1), slow, 1e-3 * fast);
}

// Gives each key that a law of a list needs and the material lacks a value within its limits, so that every law can be
// built.
template <class List>
void give_needed_keys(LawValues& of_laws) {
    List::for_each([&]<class Law>() {
        if constexpr (requires { typename Law::Values; }) {
            typename Law::Values& values = of_laws.of<Law>();
            for_each_key<Law>([&](const auto& key) {
                if constexpr (requires { values.*key.member = key.range.highest; }) {
                    if (key.needed() && !(values.*key.member))
                        values.*key.member = std::sqrt(key.range.highest * std::fmax(key.range.lowest, 1e-3));
                }
            });
        }
    });
}

// The table of laws agrees with the laws built from it.
TEST(BedLaws, OfTheTableAreBuiltAndReadTheirZones) {
    const GridSpec grid = bench::plain_grid(4, 4, 1);
    const Raster ground(grid), values(grid, 0.5);
    NodeGrid nodes(ground);
    for (const Law& law : laws()) {
        if (law.kind != LawKind::bed_friction) continue;
        SCOPED_TRACE(law.word);
        Scene scene;
        scene.material = material_of({law.word});
        Material& m = scene.material;
        m.of<CoulombFriction>().friction_coefficient = 0.3;
        m.of<TurbulentFriction>().turbulence = 500;
        give_needed_keys<BedLaws>(m);
        const std::vector<std::string> terms = list_terms(scene);
        EXPECT_TRUE(std::any_of(terms.begin(), terms.end(),
                                [&](const std::string& term) { return term.rfind(law.sentence, 0) == 0; }));
        for (const ZoneRaster& zone : k_zone_rasters) {
            if (!zone.of_bed_friction) continue;
            MaterialZones zones;
            zones.*zone.raster = values;
            const auto friction = make_friction(scene.material, zones, {}, nodes, k_normal);
            EXPECT_EQ(friction.sweeps.size(), 1u);
            const bool is_listed = std::any_of(zone_keys().begin(), zone_keys().end(), [&](const ZoneKey& key) {
                return key.what == zone.what && law.reads_zone(key.name);
            });
            EXPECT_EQ(!friction.node_values.empty(), is_listed) << zone.what;
        }
    }
}

// A law with yield holds material exactly at rest, by its own bound: a cone on a slope, whose driving stress is at most
// rho g h times the slope of its surface, 0.1 + 0.2: 9 kPa at its middle, less everywhere else.
class StaysAtRest : public testing::TestWithParam<std::string> {};

TEST_P(StaysAtRest, NotOneBitMoves) {
    Material m = material_of({GetParam()});
    m.of<CoulombFriction>().friction_coefficient = 0.4;
    m.of<PouliquenForterreExcess>().fast_friction_angle = std::atan(0.6) * 180 / M_PI;
    m.of<PouliquenForterreExcess>().friction_length = 1;
    m.of<CohesiveFriction>().cohesion = m.of<BinghamStress>().yield_stress = 30000;
    m.of<RammsYield>().ramms_yield_stress = 60000;  // reaches 14 kPa there
    m.of<HerschelBulkleyExcess>().consistency = m.of<BinghamStress>().viscosity = 100;
    m.of<HerschelBulkleyExcess>().flow_index = 0.5;
    m.of<TurbulentFriction>().turbulence = 500;
    m.of<ModifiedVoellmyExcess>().crossover_speed = 4;
    const GridSpec grid = bench::plain_grid(40, 40, 1);
    const Raster bed = bench::sample_raster(grid, [](Point p) { return (40 - p.x) * 0.2; });
    const ParticleSet seeds = bench::fill_lattice(
        grid, 2, 0, [](Point p) { return bench::Seed{1.5 - 0.1 * std::hypot(p.x - 20, p.y - 20)}; });
    Flow flow(bed, seeds, m, numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), 1);
    const std::vector<double> x(flow.particles()[Field::x], flow.particles()[Field::x] + flow.particles().size());
    flow.advance_to(10);
    ASSERT_EQ(flow.particles().size(), x.size());
    EXPECT_EQ(greatest_speed(flow), 0);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_EQ(flow.particles()[Field::x][i], x[i]);
}

INSTANTIATE_TEST_SUITE_P(Laws, StaysAtRest,
                         testing::Values("cohesion", "ramms-yield", "bingham", "herschel-bulkley", "obrien-julien",
                                         "pouliquen-forterre", "modified-voellmy"));

}  // namespace
}  // namespace frana::test
