// SPDX-License-Identifier: Apache-2.0
#include "kernels.h"

#include <cmath>
#include <memory>
#include <optional>

#include "bench/set_up/setup.h"
#include "mpm/held_state.h"
#include "mpm/levels.h"
#include "mpm/node_grid.h"
#include "mpm/particles_to_nodes.h"
#include "mpm/pressure.h"
#include "mpm/update_nodes.h"
#include "mpm/vector/kernels.h"
#include "mpm/vector/stress_kernels.h"
#include "physics/friction_voellmy.h"

namespace frana::bench {
namespace {

using Shape = QuadraticSplineShape;
constexpr double k_cell = 5, k_fall = 9.81;

// A tile's particles, and the nodes in the states before the two kinds of sweeps.
struct Tile {
    ParticleSet particles;
    ParticleTile run{0, k_kernel_particles, 0};
    NodeGrid gathered, moved;  // sums of particles; velocities
    BinghamStress stress{0.5, 0.25};
    // Time step zero, so that a repeated sweep finds the particles in the same place.
    ParticleUpdate update{0, k_fall, 1e-3, false, {}};

    explicit Tile(const Raster& bed) : gathered(bed), moved(bed) {
        constexpr FieldMask k_all =
            k_basic_fields | k_affine_fields | k_shape_fields | k_stress_fields | FieldMask{Field::compression};
        const auto inside = [](double v) { return v > 16 * k_cell && v < 32 * k_cell; };
        const ParticleSet seeds = fill_lattice(bed.grid, 2, 0.5, [&](Point p) {
            return Seed{inside(p.x) && inside(p.y) ? 3 + std::sin(0.1 * p.x) : 0, 8 + std::sin(0.07 * p.y), 0.1};
        });
        particles = ParticleSet(k_all);
        particles.resize(seeds.size());
        for (std::size_t p = 0; p < seeds.size(); ++p) {
            ParticleRow row = seeds.row(p);
            get(row, Field::q_xx) = get(row, Field::q_yy) = get(row, Field::area);
            particles.set_row(p, row);
        }
        run.end = particles.size();
        const TileGrid tiles{gathered.columns(), gathered.rows(), k_ghost, k_cell};
        for (NodeGrid* nodes : {&gathered, &moved}) {
            nodes->allocate_levels();
            particles_to_nodes<Shape, true, true>(run, particles, *nodes);
            const auto for_all = [&](const auto& visit) {
                for (std::int64_t t = 0; t < tiles.tiles_x() * tiles.tiles_y(); ++t) visit(NodeRange(t, tiles, *nodes));
            };
            for_all([&](const NodeRange& range) { mean_levels(range, *nodes); });
            for_all([&](const NodeRange& range) { node_references(range, *nodes); });
            for_all([&](const NodeRange& range) { hold_on_grid(range, k_fall, false, *nodes); });
            if (nodes == &gathered) continue;
            pressure_to_nodes<Shape, true, false>(run, particles, k_fall, *nodes);
            const VoellmyFriction frictionless;
            Maxima maxima(nodes->size());
            for_all([&](const NodeRange& range) {
                update_nodes<NormalSlope>(range, {0, k_fall, 0, 0, 0.01}, UniformFriction{frictionless}, 0, *nodes,
                                          maxima);
            });
        }
    }
};

}  // namespace

std::vector<KernelCase> kernel_cases() {
    const Raster bed = sample_raster(plain_grid(48, 48, k_cell),
                                     [](Point p) { return 0.3 * p.x + std::sin(0.05 * p.x) * std::cos(0.04 * p.y); });
    const auto t = std::make_shared<Tile>(bed);
    std::vector<KernelCase> cases;
    cases.push_back({"particles to nodes, plain",
                     [t] { particles_to_nodes<Shape, true, true>(t->run, t->particles, t->gathered); }});
    cases.push_back(
        {"pressure, plain", [t] { pressure_to_nodes<Shape, true, false>(t->run, t->particles, k_fall, t->gathered); }});
    cases.push_back({"pressure and stress, plain",
                     [t] { pressure_to_nodes<Shape, true, true>(t->run, t->particles, k_fall, t->gathered); }});
    cases.push_back({"nodes to particles, plain", [t] {
                         nodes_to_particles<Shape, ApicTransfer, NoStress, true>(t->run, t->update, {}, t->moved,
                                                                                 t->particles);
                     }});
    cases.push_back({"nodes to particles with stress, plain", [t] {
                         nodes_to_particles<Shape, ApicTransfer, BinghamStress, true>(t->run, t->update, t->stress,
                                                                                      t->moved, t->particles);
                     }});
    const VectorKernels* fast = vector_kernels();
    if (!fast) return cases;
    const auto plain = fast->nodes_to_particles.of<NoStress>();
    const auto stressed = fast->nodes_to_particles.of<BinghamStress>();
    cases.push_back(
        {"particles to nodes, fast", [=] { fast->particles_and_levels_to_nodes(t->run, t->particles, t->gathered); }});
    cases.push_back({"pressure, fast", [=] { fast->pressure_to_nodes(t->run, t->particles, k_fall, t->gathered); }});
    cases.push_back({"pressure and stress, fast",
                     [=] { fast->pressure_and_stress_to_nodes(t->run, t->particles, k_fall, t->gathered); }});
    cases.push_back({"nodes to particles, fast", [=] { plain(t->run, t->update, {}, t->moved, t->particles); }});
    cases.push_back({"nodes to particles, shifting, fast", [=] {
                         ParticleUpdate shifting = t->update;
                         shifting.shift = k_shift;
                         plain(t->run, shifting, {}, t->moved, t->particles);
                     }});
    cases.push_back({"nodes to particles with stress, fast",
                     [=] { stressed(t->run, t->update, t->stress, t->moved, t->particles); }});
    return cases;
}

}  // namespace frana::bench
