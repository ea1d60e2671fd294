// SPDX-License-Identifier: Apache-2.0
// Pore pressure of solids: the first model's law, and what its excess does to friction, strength and thrust.
#include <gtest/gtest.h>

#include "models/structured/solid/pore_stage.h"
#include "physics/friction_coulomb.h"
#include "simulation/scene.h"
#include "simulation/structured_flow.h"
#include "solid_cases.h"
#include "support/cases.h"

namespace frana::structured::test {
namespace {

constexpr double k_rock = 2000;  // [kg/m3]

/// Solids without water; of the strength given they are blocks, which nothing breaks, or loose.
StructuredMaterial debris(double cohesion, double ratio) {
    StructuredMaterial m;
    m.solids = true;
    m.solid_fraction = 1;
    m.grain_density = k_rock;
    m.cohesion = cohesion;
    m.friction = m.bed_friction = std::tan(20 * k_degree);
    m.young_modulus = 1e8;
    m.bulk_modulus = 1e8 / 1.5;
    m.pores.initial.ratio = ratio;
    return m;
}
constexpr double k_whole = 1e9;  // cohesion of blocks [Pa]

Numerics walled() {
    Numerics n = frana::test::numerics(Scheme::standard, SlopeCorrection::normal, Boundary::wall);
    n.particles_per_cell = 9;
    return n;
}

StructuredFlow flow_of(const Raster& bed, const StructuredMaterial& m, const std::function<bench::Seed(Point)>& seed) {
    return {bed, std::nullopt, m, walled(), bench::fill_lattice(bed.grid, 3, 0, seed), 1};
}

void advance(StructuredFlow& flow, double time, double step = 1e9) {
    while (time - flow.time() > 1e-9) flow.step(std::min(step, time - flow.time()));
}

double mean(const ParticleSet& p, Field field) {
    double sum = 0, volume = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        sum += p[Field::volume][i] * p[field][i];
        volume += p[Field::volume][i];
    }
    return sum / volume;
}

// Terzaghi's first mode, exact for any steps: some hundred of them round 1e-16 each. Water in the pores of a block
// presses on the bed as far as its B says, and the excess decreases to that.
TEST(PorePressureOfSolids, ConsolidatesWithTheSquareOfTheThickness) {
    struct Layer {
        double solid_fraction, reaches, hydrostatic;
    };
    // rho_f / rho with rho = 0.5 * 2000 + 0.5 * 1000 kg/m3
    for (const Layer& layer : {Layer{1, 0, 0}, Layer{0.5, 0, 0}, Layer{0.5, 1, 2.0 / 3}}) {
        for (const double depth : {0.5, 2.0}) {
            StructuredMaterial m = debris(k_whole, 0.9);
            m.solid_fraction = layer.solid_fraction;
            m.pore_pressure_fraction = layer.reaches;
            m.pores.diffusivity = 0.05;
            StructuredFlow flow = flow_of(flat(12, 12, 2), m, [&](Point p) {
                return bench::Seed{std::abs(p.x - 12) < 6 && std::abs(p.y - 12) < 6 ? depth : 0};
            });
            advance(flow, 7.3);
            const double exact = layer.hydrostatic +
                                 (0.9 - layer.hydrostatic) * std::exp(-M_PI * M_PI * 0.05 * 7.3 / (4 * depth * depth));
            const ParticleSet& p = *flow.particle_set();
            ASSERT_GT(p.size(), 100U);
            for (std::size_t i = 0; i < p.size(); ++i) {
                ASSERT_NEAR(p[Field::pore_pressure][i], exact, 1e-12) << depth << " " << layer.hydrostatic;
                ASSERT_EQ(p[Field::u][i], 0);
            }
        }
    }
}

// A block slides down a plane while its pressure leaves it, T = 4 d^2 / (pi^2 D) with d normal to the bed:
//     v = g (sin - mu cos) t + g mu cos r_0 T (1 - exp(-t / T))
// The pressure of a step is that in its middle: of second order.
TEST(PorePressureOfSolids, FrictionOfASlidingBlockRecovers) {
    constexpr double slope = 15, depth = 4, diffusivity = 3, start = 0.8, end = 3.2;
    const double cosine = std::cos(slope * k_degree), d = depth * cosine, mu = std::tan(20 * k_degree);
    const double t = 4 * d * d / (M_PI * M_PI * diffusivity);
    const double exact =
        9.81 * ((std::sin(slope * k_degree) - mu * cosine) * end + mu * cosine * start * t * (1 - std::exp(-end / t)));
    const auto error = [&](double step) {
        StructuredMaterial m = debris(k_whole, start);
        m.pores.diffusivity = diffusivity;
        StructuredFlow flow = flow_of(incline(slope, 30, 12, 10), m, [&](Point p) {
            return bench::Seed{std::abs(p.x - 90) < 30 && std::abs(p.y - 60) < 20 ? depth : 0};
        });
        advance(flow, end, step);
        EXPECT_EQ(flow.steps(), std::llround(end / step));
        return std::abs(mean(*flow.particle_set(), Field::u) / cosine - exact) / exact;
    };
    const double coarse = error(0.2), fine = error(0.1);
    EXPECT_LT(coarse, 2e-3);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
}

// Nothing dissipates: whatever the pressure breaks of a block full of water, the pressure at its bed stays, and the
// block slides with the friction that it leaves.
TEST(PorePressureOfSolids, StaysWhereAPartOfTheStructureBreaks) {
    constexpr double slope = 10, ratio = 0.8, end = 2;
    const double exact =
        9.81 * end * (std::sin(slope * k_degree) - std::tan(25 * k_degree) * std::cos(slope * k_degree) * (1 - ratio));
    for (const double cohesion : {3e3, 15e3, 1e6}) {
        StructuredMaterial m = debris(cohesion, ratio);
        m.solid_fraction = 0.5;
        m.grain_density = 2700;
        m.friction = std::tan(28 * k_degree);
        m.bed_friction = std::tan(25 * k_degree);
        StructuredFlow flow = flow_of(incline(slope, 60, 12, 5), m,
                                      [](Point p) { return bench::Seed{std::abs(p.x - 150) < 100 ? 4.0 : 0}; });
        advance(flow, end);
        const ParticleSet& p = *flow.particle_set();
        double speed = 0, mass = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (std::abs(p[Field::x][i] - 150) > 50) continue;
            EXPECT_NEAR(p[Field::pore_pressure][i], ratio, 1e-12) << cohesion;
            speed += p[Field::volume][i] * p[Field::u][i];
            mass += p[Field::volume][i];
        }
        speed /= mass * std::cos(slope * k_degree);
        std::printf("%g Pa: %.3f m/s of %.3f\n", cohesion, speed, exact);
        // What is released moves on its own, with the grid's step: the solids are up to 5.4 % off.
        EXPECT_NEAR(speed, exact, 0.08 * exact) << cohesion;
    }
}

/// A loose pile on a slope, seen from its start: how far its middle is, and how fast.
struct Slide {
    double way, speed;
};
constexpr double k_seconds = 4;
const std::function<bench::Seed(Point)> k_pile = [](Point p) {
    return bench::Seed{4 - 0.1 * std::hypot(p.x - 80, p.y - 60)};
};

Slide slide_of_solids(const StructuredMaterial& m) {
    StructuredFlow flow = flow_of(incline(15, 60, 24, 5), m, k_pile);
    const double start = mean(*flow.particle_set(), Field::x);
    advance(flow, k_seconds);
    return {mean(*flow.particle_set(), Field::x) - start, mean(*flow.particle_set(), Field::u)};
}

// A constant ratio lowers friction by it: for solids exactly (the two round differently), and as in the first model:
// the schemes differ by half a per cent in how a pile spreads.
TEST(PorePressureOfSolids, LowersFrictionAsInTheFirstModel) {
    const Slide dry = slide_of_solids(debris(0, 0)), with = slide_of_solids(debris(0, 0.4));
    StructuredMaterial smooth = debris(0, 0);
    smooth.bed_friction *= 0.6;
    const Slide smoother = slide_of_solids(smooth);
    EXPECT_NEAR(with.way, smoother.way, 1e-9 * smoother.way);
    EXPECT_NEAR(with.speed, smoother.speed, 1e-9 * smoother.speed);
    EXPECT_GT(with.way, 2 * dry.way);

    Material m = frana::test::dry_friction(20);
    m.density = k_rock;
    m.of<CoulombFriction>().pore_pressure_ratio = 0.4;
    const Raster bed = incline(15, 60, 24, 5);
    Flow flow(bed, bench::fill_lattice(bed.grid, 3, 0, k_pile), m, walled(), 1);
    const double start = flow.centroid().x;
    flow.advance_to(k_seconds);
    EXPECT_NEAR(with.way, flow.centroid().x - start, 0.01 * with.way);
}

/// Saturated solids of half water; one column of 10 m with 1 m2.
struct ColumnUnder {
    ColumnUnder(double cohesion, double ratio) : laws(2), p(k_fields) {
        laws.basal.fluid_density = 1000;
        ParticleSet placed(k_basic_fields | FieldMask{Field::confined});
        ParticleRow row = ParticleSet::initial_row();
        get(row, Field::volume) = 5;
        get(row, Field::area) = 1;
        get(row, Field::confined) = cohesion > 0 ? 5 : 0;
        placed.push_back(row);
        SolidMaterial m;
        m.solid_fraction = 0.5;
        m.grain_density = 2400;
        m.cohesion = cohesion;
        m.friction = tangent;
        m.pore_pressure = ratio;
        p = assign_material(placed, k_fields, [&](Point) { return m; });
        update();
    }
    void update() { advance_pore_pressure<Kind>({0, 1}, 0, laws, NodeGrid(flat(2, 2, 2)), p); }
    [[nodiscard]] ParticleLoad load() const { return particle_load<Kind>(laws, p, 0); }
    void break_and_release() {
        p[Field::cohesion_ratio][0] = 0;
        p[Field::confined][0] = 0;
        p[Field::submergence][0] = 1;  // what it held stays in its pores
        update();
    }

    using Kind = SolidKind<true, true, true>;
    static constexpr double tangent = 0.6, weight = k_standard_gravity * 10 * 1700;
    inline static const FieldMask k_fields = solid_fields(true, true) | k_pore_fields;
    SolidLaws laws;
    ParticleSet p;
};

// Hydrostatic pressure counts once: it is a part of the ratio at the start, and where a block breaks it takes the place
// of excess pressure. Tolerances of rounding.
TEST(PorePressureOfSolids, CountsHydrostaticPressureOnce) {
    constexpr double buoyant = k_standard_gravity * 5 * (2400 - 1000), w = ColumnUnder::weight;
    // ratio, load on the bed of an intact block, and after it broke; the second never exceeds the buoyant weight.
    for (const auto& [ratio, whole, broken] :
         {std::tuple{0.0, w, buoyant}, {0.3, 0.7 * w, buoyant}, {0.8, 0.2 * w, 0.2 * w}}) {
        ColumnUnder block(1e9, ratio);
        EXPECT_NEAR(block.load().bearing, whole, 1e-12 * w);
        block.break_and_release();
        EXPECT_NEAR(block.load().bearing, broken, 1e-12 * w);
        ColumnUnder loose(0, ratio);
        loose.p[Field::submergence][0] = 1;
        EXPECT_NEAR(loose.load().bearing, broken, 1e-12 * w);
        // Free water that leaves the pores takes its buoyancy with it, but no excess.
        const double excess = buoyant - broken;
        loose.p[Field::submergence][0] = 0;
        loose.update();
        EXPECT_NEAR(loose.load().bearing, k_standard_gravity * 5 * 2400 - excess, 1e-12 * w);
    }
}

// Mohr and Coulomb with effective stress: friction that the pressure takes off is lost to the strength, and what has no
// strength pushes with the whole pressure.
TEST(PorePressureOfSolids, TakesStrengthAndPushes) {
    constexpr double cohesion = 80e3, excess = 0.3 * ColumnUnder::weight;
    ColumnUnder block(cohesion, 0.3);
    EXPECT_NEAR(block.load().cohesion, cohesion - 0.5 * excess * ColumnUnder::tangent, 1e-9 * cohesion);
    EXPECT_EQ(block.load().lost, 0);
    ColumnUnder loose(0, 0.8);
    loose.p[Field::submergence][0] = 1;
    const double whole = k_standard_gravity * 5 * (2400 - 1000);
    EXPECT_NEAR(loose.load().thrust, 0.5 * whole * loose.load().depth, 1e-12 * whole);
}

// Loose solids under water liquefy when they slide, dense ones of the same friction hold themselves back (Iverson and
// others 2000, Science 290, 513).
TEST(PorePressureOfSolids, LooseOnesLiquefyAndDenseOnesStop) {
    const auto run = [](double fraction) {
        StructuredMaterial m = debris(0, 0);
        m.solid_fraction = fraction;
        m.grain_density = 2600;
        m.pores.diffusivity = 1e-3;
        m.pores.critical_fraction = 0.56;
        m.pores.compressibility = 1e-5;
        StructuredFlow flow =
            flow_of(incline(14, 80, 20, 1), m, [](Point p) { return bench::Seed{p.x > 20 && p.x < 50 ? 1.0 : 0}; });
        const double start = mean(*flow.particle_set(), Field::x);
        advance(flow, 3);
        return std::pair{mean(*flow.particle_set(), Field::x) - start,
                         mean(*flow.particle_set(), Field::pore_pressure)};
    };
    const auto [loose, loose_ratio] = run(0.5);
    const auto [dense, dense_ratio] = run(0.6);
    EXPECT_GT(loose_ratio, 0.9);
    EXPECT_LT(dense_ratio, 0.4);
    EXPECT_GT(loose, 5 * dense);
}

}  // namespace
}  // namespace frana::structured::test
