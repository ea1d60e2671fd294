// SPDX-License-Identifier: Apache-2.0
// Manning's resistance (U25), by own and by total depth, and viscous stress against exact solutions.
#include <gtest/gtest.h>

#include "basin.h"

namespace frana::structured::test {
namespace {

using bench::plain_grid;
using bench::sample_raster;

// A plane that falls towards +x, long enough that nothing from its ends reaches the middle in time.
Basin plane(double slope, double depth, FluidLaws laws, double dx = 10, std::int64_t cells = 300) {
    Basin basin(sample_raster(plain_grid(cells, 3, dx), [&](Point p) { return -slope * p.x; }), laws);
    basin.fill([&](Point) { return Water{depth}; });
    return basin;
}

// U25. After five time constants u/(2 g S) the transient is below 1e-4; the mark is 1 %.
TEST(FluidResistance, UniformFlowHasManningsVelocity) {
    FluidLaws laws = still_laws();
    laws.manning = 0.03;
    Basin basin = plane(0.01, 1, laws);
    basin.advance(100);
    const double exact = std::sqrt(0.01) / 0.03;
    EXPECT_NEAR(basin.u(150, 1), exact, 0.01 * exact);
    EXPECT_NEAR(basin.depth(150, 1), 1, 1e-9);
}

// On steep ground Manning holds along the bed, with the thickness normal to it: V = d^(2/3) sqrt(sin) / n with
// d = h cos, and u = V cos in map view.
TEST(FluidResistance, SteepUniformFlowHasManningsVelocityAlongTheBed) {
    FluidLaws laws = still_laws();
    laws.steep = true;
    laws.manning = 0.05;
    const double angle = 30 * M_PI / 180;
    Basin basin = plane(std::tan(angle), 0.5, laws);
    basin.advance(40);
    const double exact = std::pow(0.5 * std::cos(angle), 2.0 / 3) * std::sqrt(std::sin(angle)) / 0.05 * std::cos(angle);
    EXPECT_NEAR(basin.u(150, 1), exact, 1e-3 * exact);
}

TEST(FluidResistance, StopsAndNeverReverses) {
    FluidLaws laws = still_laws();
    laws.manning = 0.1;
    laws.viscosity = 1000;  // far beyond what an explicit step would bear
    Basin basin(Raster(plain_grid(20, 20, 1), 0.0), laws);
    basin.fill([](Point) { return Water{0.01, 5, 3}; });
    basin.advance(0.01);
    basin.for_cells([&](Point, std::size_t cell) {
        EXPECT_GE(basin.state.now.qx[cell], 0);
        EXPECT_GE(basin.state.now.qy[cell], 0);
    });
    EXPECT_LT(basin.u(10, 10), 0.05);
}

// chi nu / h^2 alone: u decays by exp(-chi nu t / h^2); the implicit step errs by rate dt / 2 = 1 %.
TEST(FluidResistance, ViscousShearAtTheBedDecays) {
    FluidLaws laws = still_laws();
    laws.viscosity = 10;
    laws.velocity_shape = 3;
    Basin basin(Raster(plain_grid(200, 3, 1), 0.0), laws);
    basin.fill([](Point) { return Water{0.5, 1, 0}; });
    const double rate = 3 * 10.0 / 1000 / 0.25;
    for (int i = 0; i < 50; ++i) basin.advance(0.1);
    EXPECT_NEAR(basin.u(100, 1), std::exp(-rate * 5), 0.01 * std::exp(-rate * 5));
}

// A shear wave v = sin(k x) in still deep water, far from walls, decays as exp(-nu k^2 t) (the stress tensor's xy part
// counts once). Explicit in time and of second order in space: 2 % at 25 cells a wave.
TEST(FluidResistance, ShearWaveDecays) {
    FluidLaws laws = still_laws();
    laws.viscosity = 2e3;  // 2 m2/s
    laws.velocity_shape = 0;
    constexpr double k_wave = 50;
    const double k = 2 * M_PI / k_wave;
    // The wave runs along the channel, its velocity across: wide enough that the side walls' pressure stays away.
    Basin basin(Raster(plain_grid(50, 150, 2), 0.0), laws);
    basin.fill([&](Point p) { return Water{1, 0, 1e-3 * std::cos(k * p.x)}; });
    basin.advance(10);
    const std::size_t crest = basin.nodes.index(25, 75);
    const double v = basin.state.now.qy[crest] / basin.state.now.depth[crest];
    EXPECT_NEAR(v, 1e-3 * std::cos(k * 51) * std::exp(-2 * k * k * 10), 0.02 * 1e-3);
}

// Stress moves momentum and makes none.
TEST(FluidResistance, StressKeepsMomentum) {
    FluidLaws laws = still_laws();
    laws.viscosity = 500;
    laws.velocity_shape = 0;
    Basin with(Raster(plain_grid(60, 60, 1), 0.0), laws);
    const auto jet = [](Point p) {
        const double r2 = (p.x - 30) * (p.x - 30) + (p.y - 30) * (p.y - 30);
        return Water{1, std::exp(-r2 / 20), 0.5 * std::exp(-r2 / 30)};
    };
    with.fill(jet);
    double x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    with.for_cells([&](Point, std::size_t c) { x0 += with.state.now.qx[c], y0 += with.state.now.qy[c]; });
    with.advance(0.5);  // waves run 2 m: far from the walls
    with.for_cells([&](Point, std::size_t c) { x1 += with.state.now.qx[c], y1 += with.state.now.qy[c]; });
    EXPECT_NEAR(x1, x0, 1e-10 * x0);
    EXPECT_NEAR(y1, y0, 1e-10 * y0);
}

// What the fluid sees of solids, for tests: the same value of each kind wherever no function is given.
struct Solids {
    /// @param density of solids and confined fluid together [kg/m3]
    Solids(Basin& basin, double velocity, double fraction, double whole, const std::function<double(Point)>& depth,
           double density = 1000)
        : h(basin.nodes.bed.size(), 0),
          u(h.size(), velocity),
          v(h.size(), 0),
          solids(h.size(), fraction),
          structured(h.size(), whole),
          mass(h.size(), 0),
          pores(h.size(), 0) {
        basin.for_cells([&](Point p, std::size_t cell) {
            h[cell] = depth(p);
            mass[cell] = density * h[cell];
        });
        basin.solid = {h.data(), u.data(), v.data(), solids.data(), structured.data(), mass.data(), pores.data()};
    }
    std::vector<double> h, u, v, solids, structured, mass, pores;
};

// zeta: the difference to the solids' velocity decays with nu_A zeta alpha_s (1 - f_sc) / h^2, nu_A = A nu / alpha_u.
TEST(FluidResistance, SolidsProfileDamps) {
    FluidLaws laws = still_laws();
    laws.viscosity = 1000;  // 1 m2/s
    laws.viscosity_growth = laws.velocity_shape = 0;
    laws.solids_shape = 2;
    laws.mobility = 0.5;
    Basin basin(Raster(plain_grid(200, 3, 1), 0.0), laws);
    basin.fill([](Point) { return Water{1, 3, 0}; });
    const Solids solids(basin, 2, 0.25, 0.2, [](Point) { return 1.0; });
    for (int i = 0; i < 300; ++i) basin.advance(0.01);
    const double rate = 0.5 * 1 / 0.5 * 2 * 0.25 * 0.8 / 4;
    EXPECT_NEAR(basin.u(100, 1), 2 + std::exp(-rate * 3), 0.002);
}

// nu_A: of the enhanced stress -2 nu_A w dalpha_c/dx through a uniform stream over solids at rest whose depth varies,
// the divergence, worked by hand; second order with 50 cells a wave.
TEST(FluidResistance, EnhancedStressOfAVaryingShareOfSolids) {
    FluidLaws laws = still_laws();
    laws.gravity = 0;
    laws.viscosity = 1000;
    laws.viscosity_growth = laws.velocity_shape = 0;
    Basin basin(Raster(plain_grid(100, 3, 1), 0.0), laws);
    basin.fill([](Point) { return Water{1, 1, 0}; });
    const double k = 2 * M_PI / 50;
    const auto fraction = [k](double x) { return 0.3 + 0.1 * std::sin(k * x); };
    const Solids solids(basin, 0, 0.2, 1, [&](Point p) { return fraction(p.x) / (1 - fraction(p.x)); });
    constexpr double dt = 1e-3;
    basin.advance(dt);
    double greatest = 0;
    for (std::int64_t i = 20; i < 80; ++i) {
        const double x = static_cast<double>(i) + 0.5, a = fraction(x), slope = 0.1 * k * std::cos(k * x);
        const double bend = -0.1 * k * k * std::sin(k * x), free = 1 - a;
        const double force = -2 * (bend / free + slope * slope / (free * free));
        EXPECT_NEAR((basin.u(i, 1) - 1) / dt, force, 0.02 * 2 * 0.1 * k * k / 0.6);
        greatest = std::max(greatest, std::abs(force));
    }
    EXPECT_GT(greatest, 2e-3);
}

// Manning's law with the depth of both phases: 0.5 m of water on 2 m of solids that move with the given velocity.
struct StreamOverSolids {
    static constexpr double k_water = 0.5, k_solids = 2, k_slope = 0.01, k_manning = 0.03;

    [[nodiscard]] static double speed(double solids_velocity, bool on_total, double density = 1000,
                                      double structured = 0, double start = 6) {
        FluidLaws laws = still_laws();
        laws.manning = k_manning;
        laws.manning_on_total = on_total;
        Basin basin = plane(k_slope, k_water, laws);
        // Near the speed of the whole column, which it would take minutes to reach from rest: what is wrong at the
        // start decays with exp(-2 g S t/V), V the final speed, to 4 % of it in 100 s.
        for (std::size_t cell = 0; cell < basin.state.now.depth.size(); ++cell)
            basin.state.now.qx[cell] = start * basin.state.now.depth[cell];
        const Solids solids(
            basin, solids_velocity, 0.8, structured, [](Point) { return k_solids; }, density);
        basin.advance(100);
        return basin.u(150, 1);
    }
    // Of uniform flow of this depth.
    [[nodiscard]] static double manning(double depth) {
        return std::pow(depth, 2.0 / 3) * std::sqrt(k_slope) / k_manning;
    }
};

// 1 % is the mark of U25 and of the steady stream over resting solids.
TEST(ManningOnTotalDepth, OverStandingSolidsWaterFeelsItsOwnDepth) {
    const double exact = StreamOverSolids::manning(StreamOverSolids::k_water);
    EXPECT_NEAR(StreamOverSolids::speed(0, true), exact, 0.01 * exact);
    EXPECT_EQ(StreamOverSolids::speed(0, true), StreamOverSolids::speed(0, false));
    // Moving against it. At the upper edge water runs uphill for a moment, with these solids.
    EXPECT_NEAR(StreamOverSolids::speed(-3, true), StreamOverSolids::speed(0, false), 1e-9);
}

TEST(ManningOnTotalDepth, PhasesThatMoveTogetherFlowAsOneColumn) {
    const double exact = StreamOverSolids::manning(StreamOverSolids::k_water + StreamOverSolids::k_solids);
    EXPECT_NEAR(StreamOverSolids::speed(exact, true), exact, 0.01 * exact);
    EXPECT_NEAR(StreamOverSolids::speed(10 * exact, true), exact, 0.01 * exact);  // and none faster
    // The same stress on a column of more mass: V^2 grows with it. 2 m of 2000 kg/m3 and 0.5 m of 1000 over 2.5 m of
    // 1000.
    const double heavy = exact * std::sqrt(4.5 / 2.5);
    EXPECT_NEAR(StreamOverSolids::speed(10 * exact, true, 2000, 0, 8), heavy, 0.01 * heavy);
}

// The bed does not touch what lies on a block: S = n^2 (V - u_c)^2/h_u^(4/3).
TEST(ManningOnTotalDepth, OnABlockWaterFeelsTheBlockAlone) {
    const double own = StreamOverSolids::manning(StreamOverSolids::k_water);
    EXPECT_NEAR(StreamOverSolids::speed(2, true, 1000, 1), 2 + own, 0.01 * (2 + own));
}

// Between the limits: S = n^2 [V^2/h^(4/3) + (1/h_u^(4/3) - 1/h^(4/3)) (V - u_c)^2], solved here by halving.
TEST(ManningOnTotalDepth, SlowerSolidsSlowTheWaterWithoutAStep) {
    const double total = std::pow(StreamOverSolids::k_water + StreamOverSolids::k_solids, -4.0 / 3);
    const double own = std::pow(StreamOverSolids::k_water, -4.0 / 3);
    double before = StreamOverSolids::speed(0, true);
    for (const double solids : {0.01, 0.5, 2.0, 4.0, 6.0}) {
        double low = 0, high = 20;
        while (high - low > 1e-9) {
            const double v = 0.5 * (low + high), apart = std::max(0.0, v - solids);
            const double drag = StreamOverSolids::k_manning * StreamOverSolids::k_manning *
                                (total * v * v + (own - total) * apart * apart);
            (drag < StreamOverSolids::k_slope ? low : high) = v;
        }
        const double speed = StreamOverSolids::speed(solids, true);
        EXPECT_NEAR(speed, low, 0.01 * low) << solids;
        EXPECT_GT(speed, before);
        EXPECT_LT(speed - before, solids);  // the water never gains more than the solids do
        before = speed;
    }
}

// A film, far stiffer than an explicit step bears, keeps to the solids it lies on; nothing reverses.
TEST(ManningOnTotalDepth, AFilmRidesOnItsBlock) {
    FluidLaws laws = still_laws();
    laws.manning = 0.1;
    laws.manning_on_total = true;
    Basin basin(Raster(plain_grid(20, 20, 10), 0.0), laws);
    basin.fill([](Point) { return Water{1e-3, 12, 5}; });
    const Solids solids(basin, 10, 0.5, 1, [](Point) { return 8.0; });
    basin.advance(5);
    // The motion keeps its direction, (12, 5)/13, and of its excess over the block's speed along it, c = 10 12/13 m/s,
    // 2e-4 m/s is left after five seconds: 1/(R t), R = g n^2/d^(4/3) = 981 per metre.
    constexpr double along = 12.0 / 13, c = 10 * along;
    EXPECT_NEAR(basin.u(10, 10), along * c, 1e-3);
    EXPECT_GT(basin.state.now.qy[basin.nodes.index(10, 10)], 0);
}

}  // namespace
}  // namespace frana::structured::test
