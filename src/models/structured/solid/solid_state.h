// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <utility>

#include "models/structured/solid/damage_spread.h"
#include "models/structured/solid/move_particles.h"
#include "models/structured/solid/pair_kernels.h"
#include "models/structured/solid/solid_laws.h"
#include "models/structured/solid/solid_nodes.h"

namespace frana::structured {

/// Outflow through open edges.
struct LeftDomain {
    double solids = 0, confined = 0;  ///< volume [m3]
    double mass = 0, px = 0, py = 0;  ///< [kg], [kg m/s]
};

/// Solids with their confined fluid.
struct SolidState {
    SolidState(ParticleSet set, const SolidLaws& laws, const Bounds& bounds, SolidNodes on_grid)
        : particles(std::move(set)),
          order(laws.kernel.reach()),
          nodes(std::move(on_grid)),
          spread(bounds, laws.damage_length) {}

    ParticleSet particles;
    CellOrder order;
    PairWork work;  ///< in the particles' order; includes x, y, u, v, area
    SolidNodes nodes;
    Point mean;                                              ///< velocity against which `drift` is measured [m/s]
    double drift = std::numeric_limits<double>::infinity();  ///< of a particle relative to others since the sort [m]
    double moved = 0;                                        ///< of any particle since the sort [m]
    SolidReport last;                                        ///< of the last substep
    bool elastic = true;  ///< whether any particle has stress other than earth pressure; at the last step's end
    double sound = 0;     ///< of shallow water with the greatest depth of a column, sqrt(g h) [m/s]; likewise
    LeftDomain left;
    DamageSpread spread;  ///< holds nothing between substeps
};

/// Checks, after reading a state, that order and work are those of the particles, and that their places are finite.
[[nodiscard]] bool fits(const SolidState& state);

template <class Archive>
void serialise(Archive& archive, LeftDomain& left) {
    auto& [solids, confined, mass, px, py] = left;
    archive(solids, confined, mass, px, py);
}

template <class Archive>
void serialise(Archive& archive, SolidState& state) {
    [[maybe_unused]] auto& [particles, order, work, nodes, mean, drift, moved, last, elastic, sound, left, spread] =
        state;
    archive(particles, order, work, nodes, mean.x, mean.y, drift, moved, last, elastic, sound, left);
    if constexpr (Archive::k_reads) archive.require(fits(state));
}

/// The sweeps over solids, chosen for a scene.
struct SolidStages {
    FieldMask fields;
    const PairKernels* pairs = nullptr;
    void (*update_material)(ParticleRun, double dt, const SolidLaws&, ParticleSet&, PairWork&) = nullptr;
    SolidReport (*still_report)(ParticleRun, const SolidLaws&, Point mean, const ParticleSet&) = nullptr;
    void (*solids_to_nodes)(ParticleRun, const SolidLaws&, const ParticleSet&, const NodeGrid&, SolidNodes&) = nullptr;
    void (*nodes_to_solids)(ParticleRun, const SolidLaws&, double dt, const NodeGrid&, const SolidNodes&,
                            ParticleSet&) = nullptr;
    bool releases = false;  ///< confined fluid can become free
};

/// Returns the stages for solids with or without cohesion that can be lost, and with or without fluid in the scene.
SolidStages choose_solid_stages(bool cohesive, bool wet, bool fast = true);

/// Sorts the particles, dropping those beyond the edges, and sets `mean`.
void sort_solids(SolidState& state, const SolidLaws& laws, const NodeGrid& grid, ThreadPool& pool);

/// Lists the neighbours of each particle; valid until the next sort.
void find_neighbours(SolidState& state, ThreadPool& pool);

/// Longest substep of the solids alone (share/doc/structured.md, "Time step") [s]: waves, viscosity, acceleration.
///     dt <= 0.5 l / c,   0.8 l / (s + 0.6 (a s + b |phi|)),   0.25 sqrt(l / |a|)
/// The sums' greatest frequency is 1.07 c / l and their greatest damping 1.9 a s / l on an even lattice of any spacing
/// (ours: usual is min(l, dp)): alone, symplectic steps are stable up to 1.9 l / c and 1.0 l / s. Columns of uneven
/// mass are stiffer by up to the root of their ratio. If all material is broken, c is 0 and s that of shallow water.
double stable_substep(const SolidState& state, const SolidLaws& laws);

/// Advances the solids by dt in as many substeps as necessary, under the push of the grid. Returns their number; the
/// report of the last is in state.last, maxima over all of them in `maxima`.
int run_substeps(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
                 const Obstacles& obstacles, double dt, SolidReport& maxima, ThreadPool& pool);

/// Clears the nodes and sums all solids on them.
void gather_solids(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
                   ThreadPool& pool);

}  // namespace frana::structured
