// SPDX-License-Identifier: Apache-2.0
// The fast kernels against the plain templates that specify their results, on random particles over a random bed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "mpm/held_state.h"
#include "mpm/levels.h"
#include "mpm/node_grid.h"
#include "mpm/particles_to_nodes.h"
#include "mpm/pressure.h"
#include "mpm/update_nodes.h"
#include "mpm/vector/kernels.h"
#include "mpm/vector/stress_kernels.h"
#include "physics/friction_voellmy.h"
#include "support/cases.h"

namespace frana::test {
namespace {

using Shape = QuadraticSplineShape;

// A sum of at most a few dozen terms, each rounded to 1.1e-16 of the largest, in another order and with joined
// multiply-adds.
constexpr double k_rounding = 1e-13;

constexpr double k_cell = 2.5;
constexpr FieldMask k_all_fields =
    k_basic_fields | k_affine_fields | k_shape_fields | k_stress_fields | FieldMask{Field::compression};

// A rough bed with a pond, an edge and cells without terrain.
Raster rough_bed(std::mt19937& random) {
    std::uniform_real_distribution<double> noise(-0.3, 0.3);
    Raster bed = bench::sample_raster(bench::plain_grid(45, 40, k_cell), [&](Point p) {
        return 0.3 * p.x + 2 * std::sin(0.1 * p.x) * std::cos(0.07 * p.y) + noise(random);
    });
    bed.at(3, 5) = bed.at(20, 22) = k_no_data;
    return bed;
}

// Particles of one tile, drifted by up to three cells, some at the very edge of the grid.
ParticleSet random_particles(std::size_t count, double low, double high, std::mt19937& random) {
    std::uniform_real_distribution<double> place(low * k_cell, high * k_cell), unit(0, 1), sign(-1, 1);
    ParticleSet particles(k_all_fields);
    for (std::size_t i = 0; i < count; ++i) {
        ParticleRow r = ParticleSet::initial_row();
        get(r, Field::x) = place(random);
        get(r, Field::y) = place(random);
        get(r, Field::u) = 10 * sign(random);
        get(r, Field::v) = 10 * sign(random);
        get(r, Field::area) = (0.05 + 3 * unit(random)) * k_cell * k_cell;
        get(r, Field::volume) = get(r, Field::area) * std::pow(10.0, -4 + 5 * unit(random));
        for (const Field f : {Field::c_xx, Field::c_xy, Field::c_yx, Field::c_yy, Field::compression})
            get(r, f) = 2 * sign(random);
        for (const Field f : {Field::s_xx, Field::s_xy, Field::s_yy}) get(r, f) = 5 * sign(random);
        get(r, Field::q_xx) = (0.2 + unit(random)) * k_cell * k_cell;
        get(r, Field::q_yy) = (0.2 + unit(random)) * k_cell * k_cell;
        get(r, Field::q_xy) = 0.1 * sign(random) * k_cell * k_cell;
        particles.push_back(r);
    }
    return particles;
}

struct Fields {
    NodeGrid nodes;
    explicit Fields(const Raster& bed) : nodes(bed) { nodes.allocate_levels(); }
};

template <class Visit>
void for_all_nodes(NodeGrid& nodes, const Visit& visit) {
    const TileGrid tiles{nodes.columns(), nodes.rows(), k_ghost, nodes.cell_size()};
    for (std::int64_t t = 0; t < tiles.tiles_x() * tiles.tiles_y(); ++t) visit(NodeRange(t, tiles, nodes));
}

void work_out_levels(NodeGrid& nodes) {
    for_all_nodes(nodes, [&](const NodeRange& range) { mean_levels(range, nodes); });
    nodes.phase = NodePhase::forces;
    for_all_nodes(nodes, [&](const NodeRange& range) { node_references(range, nodes); });
    for_all_nodes(nodes, [&](const NodeRange& range) { hold_on_grid(range, 9.81, false, nodes); });
}

// Every double of the nodes' records, against the largest of its kind.
void expect_same_nodes(const NodeGrid& plain, const NodeGrid& fast) {
    constexpr std::size_t k_lanes = sizeof(NodeRecord) / sizeof(double);
    for (std::size_t lane = 0; lane < k_lanes; ++lane) {
        double largest = 0;
        for (std::size_t i = 0; i < plain.size(); ++i)
            largest = std::max(largest, std::abs((&plain.records[i].sums.px)[lane]));
        for (std::size_t i = 0; i < plain.size(); ++i) {
            ASSERT_NEAR((&plain.records[i].sums.px)[lane], (&fast.records[i].sums.px)[lane], k_rounding * largest)
                << "lane " << lane << ", node " << i;
        }
    }
}

void expect_same_particles(const ParticleSet& plain, const ParticleSet& fast) {
    for (std::size_t f = 0; f < k_fields; ++f) {
        if (!plain.mask().has(static_cast<Field>(f))) continue;
        const double *a = plain[static_cast<Field>(f)], *b = fast[static_cast<Field>(f)];
        double largest = 0;
        for (std::size_t p = 0; p < plain.size(); ++p) largest = std::max(largest, std::abs(a[p]));
        for (std::size_t p = 0; p < plain.size(); ++p) {
            ASSERT_NEAR(a[p], b[p], k_rounding * largest) << k_field_table[f].name << " of particle " << p;
        }
    }
}

Instructions tested = Instructions::avx2;  // of the kernels in the test that runs

class VectorKernelsTest : public testing::TestWithParam<std::tuple<std::size_t, Instructions>> {
  protected:
    void SetUp() override {
        tested = std::get<Instructions>(GetParam());
        if (!vector_kernels(tested)) GTEST_SKIP() << "this processor has not the instructions of these kernels";
    }
    static std::size_t count() { return std::get<std::size_t>(GetParam()); }
    std::mt19937 random_{20240517};
    Raster bed_ = rough_bed(random_);
};

template <bool Levels>
void compare_gather(const Raster& bed, const ParticleSet& particles, const ParticleTile& tile) {
    Fields plain(bed), fast(bed);
    const VectorKernels& kernels = *vector_kernels(tested);
    particles_to_nodes<Shape, true, Levels>(tile, particles, plain.nodes);
    (Levels ? kernels.particles_and_levels_to_nodes : kernels.particles_to_nodes)(tile, particles, fast.nodes);
    expect_same_nodes(plain.nodes, fast.nodes);
}

TEST_P(VectorKernelsTest, ParticlesToNodes) {
    const ParticleSet particles = random_particles(count() + 2, 13, 35, random_);
    compare_gather<true>(bed_, particles, {1, 1 + count(), 0});
    compare_gather<false>(bed_, particles, {1, 1 + count(), 0});
}

template <bool Stress>
void compare_pressure(const Raster& bed, const ParticleSet& particles, const ParticleTile& tile) {
    Fields plain(bed), fast(bed);
    const VectorKernels& kernels = *vector_kernels(tested);
    for (Fields* fields : {&plain, &fast}) {
        particles_to_nodes<Shape, true, true>(tile, particles, fields->nodes);
        work_out_levels(fields->nodes);
    }
    pressure_to_nodes<Shape, true, Stress>(tile, particles, 9.81, plain.nodes);
    (Stress ? kernels.pressure_and_stress_to_nodes : kernels.pressure_to_nodes)(tile, particles, 9.81, fast.nodes);
    expect_same_nodes(plain.nodes, fast.nodes);
}

TEST_P(VectorKernelsTest, PressureToNodes) {
    const ParticleSet particles = random_particles(count() + 2, 13, 35, random_);
    compare_pressure<false>(bed_, particles, {1, 1 + count(), 0});
    compare_pressure<true>(bed_, particles, {1, 1 + count(), 0});
}

// Over nearly level ground, where the state held on the grid has any share.
TEST_P(VectorKernelsTest, PressureToNodesOfStateHeldOnGrid) {
    Raster bed = bed_;
    for (double& z : bed.values) z *= 0.01;
    std::uniform_real_distribution<double> sign(-1, 1), depth(4, 6);
    ParticleSet particles(k_all_fields);
    for (int i = 0; i < 42 * 42; ++i) {
        ParticleRow r = ParticleSet::initial_row();
        get(r, Field::x) = (13 + 0.5 * (i % 42 + 0.5 + 0.4 * sign(random_))) * k_cell;
        get(r, Field::y) = (13 + 0.5 * (static_cast<double>(i / 42) + 0.5 + 0.4 * sign(random_))) * k_cell;
        get(r, Field::area) = 0.25 * k_cell * k_cell;
        get(r, Field::volume) = get(r, Field::area) * depth(random_);
        get(r, Field::compression) = sign(random_);
        particles.push_back(r);
    }
    const ParticleTile tile{0, particles.size(), 0};
    Fields fields(bed);
    particles_to_nodes<Shape, true, true>(tile, particles, fields.nodes);
    work_out_levels(fields.nodes);
    int full = 0, part = 0;
    for (std::size_t i = 0; i < fields.nodes.size(); ++i) {
        full += fields.nodes.levels[i].share == 1;
        part += fields.nodes.levels[i].share > 0 && fields.nodes.levels[i].share < 1;
    }
    EXPECT_GT(full, 50);
    EXPECT_GT(part, 20);
    compare_pressure<false>(bed, particles, tile);
    compare_pressure<true>(bed, particles, tile);
}

// Particles over more nodes than a local copy contains, and over the whole grid with its edges.
TEST_P(VectorKernelsTest, PressureToNodesOfParticlesFarApart) {
    const ParticleSet particles = random_particles(count(), 0, 40, random_);
    compare_pressure<false>(bed_, particles, {0, count(), 0});
}

// Every bit of records and levels after each sweep, at fronts, shores, walls, in crowds and where nothing is.
void compare_sweeps(const Raster& bed, const ParticleSet& particles, const ParticleTile& tile) {
    Fields plain(bed), fast(bed);
    const VectorNodeKernels& kernels = *vector_node_kernels(tested);
    int computed = 0;
    const auto sweep = [&](auto rest, VectorNodeKernels::Sweep fast_sweep) {
        for_all_nodes(plain.nodes, [&](const NodeRange& range) {
            rest(range, plain.nodes);
            const bool fours = four_at_a_time(range, fast.nodes);
            computed += fours ? 1 : 0;
            (fours ? fast_sweep : rest)(range, fast.nodes);
        });
        for (std::size_t i = 0; i < plain.nodes.size(); ++i) {
            ASSERT_EQ(std::memcmp(&plain.nodes.records[i], &fast.nodes.records[i], sizeof(NodeRecord)), 0) << i;
            ASSERT_EQ(std::memcmp(&plain.nodes.levels[i], &fast.nodes.levels[i], sizeof(NodeLevel)), 0) << i;
        }
    };
    for (Fields* fields : {&plain, &fast}) particles_to_nodes<Shape, true, true>(tile, particles, fields->nodes);
    sweep(mean_levels, kernels.mean_levels);
    plain.nodes.phase = fast.nodes.phase = NodePhase::forces;
    sweep(node_references, kernels.node_references);
    sweep(momenta_to_map, kernels.momenta_to_map);
    EXPECT_GT(computed, 0);
    int partly = 0, ponding = 0, crowded = 0;
    for (std::size_t i = 0; i < plain.nodes.size(); ++i) {
        const NodeLevel& level = plain.nodes.levels[i];
        partly += level.support > 0 && level.support < 1 ? 1 : 0;
        ponding += level.ponding > 0 ? 1 : 0;
        crowded += plain.nodes.forces()[i].crowding > 1 ? 1 : 0;
    }
    if (tile.end - tile.begin < 50) return;
    EXPECT_GT(partly, 0);
    EXPECT_GT(ponding, 0);
    EXPECT_GT(crowded, 0);
}

TEST_P(VectorKernelsTest, SweepsOverNodes) {
    ParticleSet particles = random_particles(count() + 2, 13, 35, random_);
    compare_sweeps(bed_, particles, {1, 1 + count(), 0});
    Raster pond = bed_;  // level beds have no shore
    for (double& z : pond.values)
        if (!std::isnan(z)) z = std::max(z, 12.0);
    compare_sweeps(pond, particles, {1, 1 + count(), 0});
}

// Nodes in the state before nodes_to_particles.
template <bool FollowsBed>
void step_nodes(const ParticleSet& particles, const ParticleTile& tile, double dt, NodeGrid& nodes) {
    particles_to_nodes<Shape, true, true>(tile, particles, nodes);
    work_out_levels(nodes);
    pressure_to_nodes<Shape, true, false>(tile, particles, 9.81, nodes);
    const VoellmyFriction frictionless;
    Maxima maxima(nodes.size());
    for_all_nodes(nodes, [&](const NodeRange& range) {
        using Slope = std::conditional_t<FollowsBed, Curved<NormalSlope>, NormalSlope>;
        update_nodes<Slope>(range, {dt, 9.81, 0, 0, 0.01}, UniformFriction{frictionless}, 0, nodes, maxima);
    });
    nodes.phase = NodePhase::motion;
    for (std::size_t i = 0; i < nodes.size(); ++i) {  // velocities of a flow that can be stepped
        NodeMotion& node = nodes.motion()[i];
        for (double* velocity : {&node.u, &node.v, &node.back_u, &node.back_v})
            *velocity = 20 * std::tanh(*velocity / 20);
    }
}

// Nodes of every kind: at rest, held, solid, at fronts, without material.
// Tiles that are not four_at_a_time are updated by `rest`.
template <class Update, class Rest, class FastUpdate>
void compare_nodes(const Raster& bed, const ParticleSet& particles, const ParticleTile& tile, bool solid,
                   const Update& update, const Rest& rest, const FastUpdate& fast_update) {
    Fields plain(bed), fast(bed);
    Maxima plain_maxima(plain.nodes.size()), fast_maxima(plain.nodes.size());
    NodeReport plain_report, fast_report;
    NodeUpdate k{0.05, 9.81, 0, 0, 0.01};
    k.moving_speed = 1;
    k.drift = 0.05;
    Raster walls = bed;
    for (std::size_t c = 0; c < walls.values.size(); ++c) walls.values[c] = solid && c % 7 == 0 ? 1 : 0;
    int computed = 0;
    for (Fields* fields : {&plain, &fast}) {
        NodeGrid& nodes = fields->nodes;
        if (solid) nodes.mark_walls(walls);
        particles_to_nodes<Shape, true, true>(tile, particles, nodes);
        work_out_levels(nodes);
        pressure_to_nodes<Shape, true, false>(tile, particles, 9.81, nodes);
        for (std::size_t i = 0; i < nodes.size(); i += 5) nodes.forces()[i].held = 1;
        for_all_nodes(nodes, [&](const NodeRange& range) {
            if (fields == &plain) {
                plain_report.merge(update(range, k, nodes, plain_maxima));
            } else if (four_at_a_time(range, nodes)) {
                ++computed;
                fast_report.merge(fast_update(range, k, nodes, fast_maxima));
            } else {
                fast_report.merge(rest(range, k, nodes, fast_maxima));
            }
        });
    }
    EXPECT_GT(computed, 0);
    EXPECT_EQ(
        std::memcmp(plain.nodes.records.data(), fast.nodes.records.data(), plain.nodes.size() * sizeof(NodeRecord)), 0);
    for (std::size_t i = 0; i < plain.nodes.size(); ++i) {
        EXPECT_EQ(plain_maxima.depth[i], fast_maxima.depth[i]);
        EXPECT_EQ(plain_maxima.speed[i], fast_maxima.speed[i]);
        EXPECT_EQ(plain_maxima.arrival_plus_1[i], fast_maxima.arrival_plus_1[i]);
    }
    EXPECT_EQ(plain_report.covered, fast_report.covered);
    EXPECT_EQ(plain_report.unsupported, fast_report.unsupported);
    EXPECT_EQ(plain_report.moves, fast_report.moves);
    for (const auto part : {&NodeReport::max_depth, &NodeReport::max_speed, &NodeReport::moving, &NodeReport::thin,
                            &NodeReport::volume, &NodeReport::energy, &NodeReport::kinetic, &NodeReport::dissipated})
        EXPECT_NEAR(plain_report.*part, fast_report.*part, k_rounding * std::abs(plain_report.energy));
}

TEST_P(VectorKernelsTest, UpdateNodes) {
    using Slope = Curved<NormalSlope>;
    const ParticleSet particles = random_particles(count() + 2, 13, 35, random_);
    const ParticleTile tile{1, 1 + count(), 0};
    const VoellmyFriction law{0.2, 1.0 / 500};
    const VectorNodeKernels& kernels = *vector_node_kernels(tested);
    const auto plain = [&](const NodeRange& range, const NodeUpdate& k, NodeGrid& nodes, Maxima& maxima) {
        return update_nodes<Slope>(range, k, UniformFriction{law}, 3, nodes, maxima);
    };
    const auto fast = [&](const NodeRange& range, const NodeUpdate& k, NodeGrid& nodes, Maxima& maxima) {
        return kernels.uniform(range, k, UniformFriction{law}, 3, nodes, maxima);
    };
    compare_nodes(bed_, particles, tile, false, plain, plain, fast);
    compare_nodes(bed_, particles, tile, true, plain, plain, fast);
}

TEST_P(VectorKernelsTest, UpdateNodesUnderASumOfLaws) {
    using Slope = Curved<NormalSlope>;
    const ParticleSet particles = random_particles(count() + 2, 13, 35, random_);
    const NodeGrid size(bed_);
    std::vector<BedState> states(size.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        const auto x = static_cast<double>(i % 11);
        states[i] = {0.1 + x, 9, 0.3 * x, 0.01 * x, 0.02 * x, 0, 0};
    }
    std::vector<BedState> plain_states = states;
    const NoExcess none;
    const VectorNodeKernels& kernels = *vector_node_kernels(tested);
    const auto plainly = [&](std::vector<BedState>& of) {
        return [&](const NodeRange& range, const NodeUpdate& k, NodeGrid& nodes, Maxima& maxima) {
            return update_nodes<Slope>(range, k, SummedFriction<NoExcess>{none, of.data(), true}, 3, nodes, maxima);
        };
    };
    const auto fast = [&](const NodeRange& range, const NodeUpdate& k, NodeGrid& nodes, Maxima& maxima) {
        return kernels.summed(range, k, {none, states.data(), true}, 3, nodes, maxima);
    };
    compare_nodes(bed_, particles, {1, 1 + count(), 0}, true, plainly(plain_states), plainly(states), fast);
    for (std::size_t i = 0; i < states.size(); ++i) EXPECT_EQ(states[i].resistance, plain_states[i].resistance);
}

template <bool FollowsBed, class Stress>
void compare_update(const Raster& bed, ParticleSet particles, const ParticleTile& tile, const Stress& stress, bool wall,
                    double shift = 0, double kept = 0) {
    Fields fields(bed);
    NodeGrid& nodes = fields.nodes;
    const double dt = 0.05;
    step_nodes<FollowsBed>(particles, tile, dt, nodes);
    ParticleSet fast = particles;
    const ParticleUpdate update{dt, 9.81, 1e-3, wall, {10, 20}, shift, kept};
    const VectorKernels& kernels = *vector_kernels(tested);
    const ParticleReport a =
        nodes_to_particles<Shape, ApicTransfer, Stress, true>(tile, update, stress, nodes, particles);
    const ParticleReport b = kernels.nodes_to_particles.of<Stress>()(tile, update, stress, nodes, fast);
    expect_same_particles(particles, fast);
    EXPECT_NEAR(a.speeds.wave, b.speeds.wave, k_rounding * a.speeds.wave);
    EXPECT_NEAR(a.speeds.carried_wave, b.speeds.carried_wave, k_rounding * a.speeds.wave);
    EXPECT_NEAR(a.speeds.flow, b.speeds.flow, k_rounding * a.speeds.wave);
    EXPECT_NEAR(a.diffusivity, b.diffusivity, k_rounding * a.diffusivity);
    EXPECT_NEAR(a.front_squared, b.front_squared, k_rounding * a.front_squared);
    EXPECT_NEAR(a.kinetic, b.kinetic, k_rounding * a.kinetic);
    EXPECT_NEAR(a.volume, b.volume, k_rounding * a.volume);
    EXPECT_NEAR(a.longest, b.longest, k_rounding * a.longest);
    EXPECT_EQ(a.outside, b.outside);
    EXPECT_EQ(a.non_finite, b.non_finite);
    EXPECT_EQ(a.no_data, b.no_data);
    EXPECT_EQ(a.clamped, b.clamped);
}

TEST_P(VectorKernelsTest, NodesToParticles) {
    const ParticleSet particles = random_particles(count() + 2, 13, 35, random_);
    const ParticleTile tile{1, 1 + count(), 0};
    compare_update<false>(bed_, particles, tile, NoStress{}, false);
    compare_update<true>(bed_, particles, tile, NoStress{}, false);
    compare_update<false>(bed_, particles, tile, BinghamStress{0.5, 0.25, 0.01}, false);
    compare_update<true>(bed_, particles, tile, BinghamStress{0.5, 0.25, 0.01}, false);
    compare_update<false>(bed_, particles, tile, BinghamStress{0.5, 0, 0.01}, false);
    compare_update<false>(bed_, particles, tile, BinghamStress{0, 0.25, 0.01}, false);
    const auto earth_pressure = EarthPressureStress::of(0.7, 0.3, 9.81);
    compare_update<false>(bed_, particles, tile, earth_pressure, false);
    compare_update<true>(bed_, particles, tile, earth_pressure, true);
    compare_update<false>(bed_, particles, tile, NoStress{}, false, 0, 0.3);
    compare_update<true>(bed_, particles, tile, NoStress{}, false, 0, 0.3);
}

// Small ones, of which 15 000 claim 22 x 22 cells about once: overlapping particles are not shifted, nor isolated ones.
ParticleSet side_by_side(std::size_t count, std::mt19937& random) {
    ParticleSet particles = random_particles(count, 13, 35, random);
    for (std::size_t p = 0; p < count; ++p) {
        particles[Field::area][p] *= 0.02;
        particles[Field::volume][p] *= 0.02;
    }
    return particles;
}

TEST_P(VectorKernelsTest, NodesToParticlesThatShift) {
    const std::size_t many = 15 * count();
    const ParticleSet particles = side_by_side(many + 2, random_);
    const ParticleTile tile{1, 1 + many, 0};
    compare_update<false>(bed_, particles, tile, NoStress{}, false, k_shift);
    compare_update<true>(bed_, particles, tile, NoStress{}, true, k_shift);
    compare_update<true>(bed_, particles, tile, BinghamStress{0.5, 0.25, 0.01}, false, k_shift);
    compare_update<true>(bed_, particles, tile, EarthPressureStress::of(0.7, 0.3, 9.81), false, k_shift);
}

// Shifting moves particles and changes their areas; volume, momentum and kinetic energy keep every bit, particle by
// particle.
TEST(Shifting, ChangesNeitherVolumeNorVelocity) {
    std::mt19937 random(20240517);
    const Raster bed = rough_bed(random);
    ParticleSet still = side_by_side(15000, random);
    ParticleSet shifted = still;
    Fields fields(bed);
    const double dt = 0.05;
    const ParticleTile tile{0, still.size(), 0};
    step_nodes<true>(still, tile, dt, fields.nodes);
    ParticleUpdate update{dt, 9.81, 1e-3, false, {10, 20}};
    nodes_to_particles<Shape, ApicTransfer, NoStress, true>(tile, update, {}, fields.nodes, still);
    update.shift = k_shift;
    nodes_to_particles<Shape, ApicTransfer, NoStress, true>(tile, update, {}, fields.nodes, shifted);
    std::size_t moved = 0;
    for (std::size_t p = 0; p < still.size(); ++p) {
        for (const Field f : {Field::u, Field::v, Field::volume, Field::c_xx, Field::c_xy, Field::c_yx, Field::c_yy})
            ASSERT_EQ(still[f][p], shifted[f][p])
                << k_field_table[static_cast<std::size_t>(f)].name << " of particle " << p;
        const double x = shifted[Field::x][p] - still[Field::x][p], y = shifted[Field::y][p] - still[Field::y][p];
        // To the rounding of a sum of coordinates, some tens of metres.
        ASSERT_LE(std::max(std::abs(x), std::abs(y)), k_shift_farthest * k_cell + 1e-13);
        moved += x != 0 || y != 0;
    }
    EXPECT_GT(moved, still.size() / 2);
}

// Some leave, some come to rest on cells without terrain, some are kept inside by walls.
TEST_P(VectorKernelsTest, NodesToParticlesAtTheEdge) {
    const ParticleSet particles = random_particles(count(), 0, 40, random_);
    compare_update<true>(bed_, particles, {0, count(), 0}, NoStress{}, false);
    compare_update<false>(bed_, particles, {0, count(), 0}, NoStress{}, true);
}

// One flow by the kernels of each set, a step from particles to particles: results do not depend on the machine.
TEST(VectorKernels, OfBothSetsOfInstructionsGiveTheSameBits) {
    if (!vector_kernels(Instructions::avx512)) GTEST_SKIP() << "this processor, or this build, has no AVX-512";
    std::mt19937 random(20240517);
    const Raster bed = rough_bed(random);
    const ParticleSet start = random_particles(1025, 13, 35, random);
    const ParticleTile tile{1, 1024, 0};
    const double dt = 0.05;
    Fields narrow(bed), wide(bed);
    ParticleSet narrow_particles = start, wide_particles = start;
    const auto same_nodes = [&](const char* stage) {
        ASSERT_EQ(std::memcmp(narrow.nodes.records.data(), wide.nodes.records.data(),
                              narrow.nodes.size() * sizeof(NodeRecord)),
                  0)
            << stage;
    };
    const auto both = [&](const auto& stage) {
        stage(*vector_kernels(Instructions::avx2), narrow.nodes, narrow_particles);
        stage(*vector_kernels(Instructions::avx512), wide.nodes, wide_particles);
    };
    both([&](const VectorKernels& k, NodeGrid& nodes, ParticleSet& particles) {
        k.particles_and_levels_to_nodes(tile, particles, nodes);
    });
    same_nodes("particles to nodes");
    both([&](const VectorKernels& k, NodeGrid& nodes, ParticleSet& particles) {
        work_out_levels(nodes);
        k.pressure_and_stress_to_nodes(tile, particles, 9.81, nodes);
    });
    same_nodes("pressure");
    const BinghamStress stress{0.5, 0.25, 0.01};
    both([&](const VectorKernels& k, NodeGrid& nodes, ParticleSet& particles) {
        step_nodes<true>(start, tile, dt, nodes);
        const ParticleUpdate update{dt, 9.81, 1e-3, false, {10, 20}, k_shift};
        k.nodes_to_particles.of<BinghamStress>()(tile, update, stress, nodes, particles);
    });
    for (std::size_t f = 0; f < k_fields; ++f) {
        const auto field = static_cast<Field>(f);
        if (!start.mask().has(field)) continue;
        EXPECT_EQ(std::memcmp(narrow_particles[field], wide_particles[field], start.size() * sizeof(double)), 0)
            << k_field_table[f].name;
    }
    EXPECT_NE(std::memcmp(narrow_particles[Field::x], start[Field::x], start.size() * sizeof(double)), 0);
}

INSTANTIATE_TEST_SUITE_P(Avx2, VectorKernelsTest,
                         testing::Combine(testing::Values<std::size_t>(1, 2, 3, 4, 5, 1023),
                                          testing::Values(Instructions::avx2)),
                         [](const auto& one) { return std::to_string(std::get<0>(one.param)); });
INSTANTIATE_TEST_SUITE_P(Avx512, VectorKernelsTest,
                         testing::Combine(testing::Values<std::size_t>(5, 1023), testing::Values(Instructions::avx512)),
                         [](const auto& one) { return std::to_string(std::get<0>(one.param)); });

}  // namespace
}  // namespace frana::test
