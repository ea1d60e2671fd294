// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <utility>

#include "models/structured/solid/damage_spread.h"
#include "models/structured/solid/move_particles.h"
#include "models/structured/solid/solid_laws.h"
#include "models/structured/solid/solid_nodes.h"
#include "models/structured/solid/stress_nodes.h"

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
          order(2.5 * laws.side),
          nodes(std::move(on_grid)),
          stress(bounds, laws.side),
          spread(bounds, laws.damage_length) {}

    ParticleSet particles;
    CellOrder order;
    SolidWork work;  ///< in the particles' order
    SolidNodes nodes;
    Point mean;                                              ///< velocity against which `drift` is measured [m/s]
    double drift = std::numeric_limits<double>::infinity();  ///< of a particle relative to others since the sort [m]
    double moved = 0;                                        ///< of any particle since the sort [m]
    SolidReport last;                                        ///< of the last substep
    bool elastic = true;  ///< whether any particle has stress other than earth pressure; at the last step's end
    double sound = 0;     ///< of shallow water with the greatest depth of a column, sqrt(g h) [m/s]; likewise
    LeftDomain left;
    StressNodes stress;  ///< these two hold nothing between substeps
    DamageSpread spread;
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
    [[maybe_unused]] auto& [particles, order, work, nodes, mean, drift, moved, last, elastic, sound, left, stress,
                            spread] = state;
    archive(particles, order, work, nodes, mean.x, mean.y, drift, moved, last, elastic, sound, left);
    if constexpr (Archive::k_reads) archive.require(fits(state));
}

/// The sweeps over solids, chosen for a scene.
struct SolidStages {
    FieldMask fields;
    void (*update_material)(ParticleRun, double dt, const SolidLaws&, StressNodes&, ParticleSet&, SolidWork&) = nullptr;
    void (*solids_to_nodes)(ParticleRun, const SolidLaws&, const ParticleSet&, const NodeGrid&, SolidNodes&) = nullptr;
    void (*nodes_to_solids)(ParticleRun, const SolidLaws&, double dt, const NodeGrid&, const SolidNodes&,
                            ParticleSet&) = nullptr;
    /// Null: none in the scene.
    void (*advance_pore_pressure)(ParticleRun, double dt, const SolidLaws&, const NodeGrid&, ParticleSet&) = nullptr;
    bool releases = false;  ///< confined fluid can become free
};

/// Returns the stages for solids with or without cohesion that can be lost, with or without fluid in the scene, and
/// with pore pressure where it is active.
SolidStages choose_solid_stages(bool cohesive, bool wet, const PorePressure& pores = {});

/// Sorts the particles, dropping those beyond the edges, and sets `mean`.
void sort_solids(SolidState& state, const SolidLaws& laws, const NodeGrid& grid, ThreadPool& pool);

/// Longest substep of the solids alone (share/doc/structured.md, "Time step") [s]: waves, acceleration.
///     dt <= 0.8 d / c,   0.28 sqrt(d / |a|)
/// The nodes' greatest frequency is under c / d: symplectic steps are stable beyond 2 d / c; shorter ones follow the
/// waves. If all material is broken, c is the speed of shallow water.
double stable_substep(const SolidState& state, const SolidLaws& laws);

/// Advances the solids by dt in as many substeps as necessary, under the push of the grid. Returns their number; the
/// report of the last is in state.last, maxima over all of them in `maxima`.
int run_substeps(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
                 const Obstacles& obstacles, double dt, SolidReport& maxima, ThreadPool& pool);

/// Clears the nodes and sums all solids on them.
void gather_solids(SolidState& state, const SolidStages& stages, const SolidLaws& laws, const NodeGrid& grid,
                   ThreadPool& pool);

}  // namespace frana::structured
