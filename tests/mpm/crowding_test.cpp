// SPDX-License-Identifier: Apache-2.0
// Particles that claim more than there is: what lands (mpm/crowding.h) and what is piled up at rest
// (mpm/particle_update.h) get the depth on the ground.
#include <gtest/gtest.h>

#include "mpm/crowding.h"
#include "mpm/particle_update.h"
#include "support/cases.h"

namespace frana::test {
namespace {

// The depth on the ground and the fraction that particles claim, through the splines.
struct OnGround {
    double depth = 0, fraction = 0;
};

class OnGroundOf {
  public:
    OnGroundOf(const GridSpec& grid, const ParticleSet& particles)
        : nodes_(Raster(grid, 0.0)), at_nodes_(nodes_.size()), particles_(particles) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            visit(p, [&](std::size_t n, double weight) {
                at_nodes_[n].depth += weight * particles[Field::volume][p] / grid.cell_area();
                at_nodes_[n].fraction += weight * particles[Field::area][p] / grid.cell_area();
            });
        }
    }
    [[nodiscard]] OnGround at(std::size_t p) const {
        OnGround sum;
        visit(p, [&](std::size_t n, double weight) {
            sum.depth += weight * at_nodes_[n].depth;
            sum.fraction += weight * at_nodes_[n].fraction;
        });
        return sum;
    }
    [[nodiscard]] OnGround greatest() const {
        OnGround most;
        for (const OnGround& one : at_nodes_) {
            most.depth = std::max(most.depth, one.depth);
            most.fraction = std::max(most.fraction, one.fraction);
        }
        return most;
    }

  private:
    template <class Visit>
    void visit(std::size_t p, const Visit& each) const {
        const Stencil<QuadraticSplineShape> s(particles_[Field::x][p], particles_[Field::y][p], nodes_.scale());
        for (int b = 0; b < 3; ++b)
            for (int a = 0; a < 3; ++a)
                each(s.first + static_cast<std::size_t>(b * nodes_.stride() + a), s.wx[a] * s.wy[b]);
    }

    NodeGrid nodes_;
    std::vector<OnGround> at_nodes_;
    const ParticleSet& particles_;
};

// A hundred thin newcomers as wide as three cells each, with half a cell's volume together, on a pond 4 m deep.
TEST(MakeRoom, GivesNewcomersAndPondTheirCommonDepth) {
    const GridSpec grid = bench::plain_grid(20, 20, 1);
    ParticleSet particles = bench::fill_lattice(grid, 2, 0, [](Point) { return bench::Seed{4}; });
    const std::vector<double> before(particles[Field::area], particles[Field::area] + particles.size());
    ThreadPool pool(1);
    TileOrder order({grid.columns, grid.rows, k_ghost, grid.cell_size});
    order.sort(particles, {}, pool);
    const std::size_t first = particles.size();
    for (int k = 0; k < 100; ++k) {
        ParticleRow row = particles.row(0);
        get(row, Field::x) = 10 + 0.01 * k;
        get(row, Field::y) = 10.5;
        get(row, Field::volume) = 0.02;
        get(row, Field::area) = 3;
        particles.push_back(row);
    }
    EXPECT_GT(OnGroundOf(grid, particles).greatest().fraction, 50);
    const std::vector<std::size_t> changed = fit_appended(NodeGrid(Raster(grid, 0.0)), order, first, particles);
    const OnGround now = OnGroundOf(grid, particles).greatest();
    // The factor of a particle is the mean of those of its nodes: where these differ, a tenth too small.
    EXPECT_LT(now.fraction, k_piled_fraction);
    for (std::size_t p = first; p < particles.size(); ++p) {
        const double depth = particles[Field::volume][p] / particles[Field::area][p];
        EXPECT_GT(depth, 4);
        EXPECT_LT(depth, 1.2 * now.depth);
    }
    for (const std::size_t p : changed) EXPECT_LT(std::abs(particles[Field::x][p] - 10.5), 3.5);
    std::size_t same = 0;
    for (std::size_t p = 0; p < first; ++p) same += particles[Field::area][p] == before[0] ? 1 : 0;
    EXPECT_EQ(same + changed.size(), particles.size());
}

// On dry ground, or on material that leaves room, nothing changes by one bit.
TEST(MakeRoom, LeavesWhatFits) {
    const GridSpec grid = bench::plain_grid(20, 20, 1);
    ParticleSet particles = bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{p.x < 10 ? 4.0 : 0.0}; });
    ThreadPool pool(1);
    TileOrder order({grid.columns, grid.rows, k_ghost, grid.cell_size});
    order.sort(particles, {}, pool);
    const std::size_t first = particles.size();
    ParticleRow row = particles.row(0);
    get(row, Field::x) = 11;
    get(row, Field::y) = 10.5;
    particles.push_back(row);
    const std::vector<double> before(particles[Field::area], particles[Field::area] + particles.size());
    EXPECT_TRUE(fit_appended(NodeGrid(Raster(grid, 0.0)), order, first, particles).empty());
    for (std::size_t p = 0; p < particles.size(); ++p) ASSERT_EQ(particles[Field::area][p], before[p]);
}

// A cone that friction holds, whose particles claim four times the area that there is: without motion they shrink until
// they press with the depth on the ground, and then nothing is computed any more.
TEST(Piled, ShrinksAtRest) {
    const GridSpec grid = bench::plain_grid(60, 60, 1);
    ParticleSet seeds =
        bench::fill_lattice(grid, 2, 0, [](Point p) { return bench::Seed{3 - 0.15 * std::hypot(p.x - 30, p.y - 30)}; });
    for (std::size_t p = 0; p < seeds.size(); ++p) seeds[Field::area][p] *= 4;
    Flow flow(Raster(grid, 0.0), seeds, dry_friction(30),
              numerics(Scheme::standard, SlopeCorrection::normal, Boundary::open), 1);
    double fastest = 0;
    while (flow.time() < 60) fastest = std::max(fastest, flow.advance(60 - flow.time()).particles.speeds.flow);
    EXPECT_EQ(fastest, 0);
    const OnGroundOf ground(grid, flow.particles());
    constexpr double k_rounding = 1 + 1e-9;
    for (std::size_t p = 0; p < flow.particles().size(); ++p) {
        const OnGround there = ground.at(p);
        const double own = flow.particles()[Field::volume][p] / flow.particles()[Field::area][p];
        EXPECT_TRUE(there.fraction <= k_rounding * k_piled_fraction ||
                    there.depth <= k_rounding * k_crowded_fraction * own);
    }
    EXPECT_EQ(flow.advance(1).moved, 0U);
}

}  // namespace
}  // namespace frana::test
