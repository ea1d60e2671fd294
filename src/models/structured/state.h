// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>

#include "models/structured/coupling/exchange.h"
#include "models/structured/fluid/fluid_step.h"
#include "models/structured/solid/solid_state.h"

namespace frana::structured {

/// Parameters and laws; constant during a run.
struct Laws {
    /// The stress's nodes are 2/5 of a cell apart, with nine particles per cell 1.4 to each, or 3/5 of the damage
    /// length where that is more: with less, material parts before it is broken (a bar that is pulled apart).
    /// @param cell_size, damage_length [m]
    Laws(double cell_size, double damage_length) : solid(0.4 * std::max(cell_size, 1.5 * damage_length)) {
        solid.damage_length = damage_length;
    }

    SolidLaws solid;
    CouplingLaws coupling;
    FluidLaws fluid;
    double move_cfl = 0.25;  ///< fraction of a cell that solids and thrust waves may cross in a step
    bool gaps_are_walls = false;
};

/// Solids, free fluid, or both, over one terrain.
struct State {
    State(NodeGrid ground, const Laws& laws, ParticleSet solids, const SolidStages& stages, bool with_fluid);

    std::unique_ptr<NodeGrid> terrain;  ///< stays in its place when the state is moved
    NodeGrid& grid = *terrain;
    SolidStages stages;
    std::unique_ptr<SolidState> solid;  ///< null in a scene without solids
    std::unique_ptr<FluidState> fluid;  ///< null in a scene that has no fluid and cannot release any
    double time = 0;                    ///< [s]
    double deepest = 0;                 ///< column of any particle [m]
    double released = 0;                ///< confined fluid released so far [m3]
    double released_outside = 0;        ///< of which beyond the edges [m3]
    WallContact walls{};                ///< of the ground, that solids came to
};

template <class Archive>
void serialise(Archive& archive, State& state) {
    [[maybe_unused]] auto& [terrain, grid, stages, solid, fluid, time, deepest, released, released_outside, walls] =
        state;
    archive(grid, solid, fluid, time, deepest, released, released_outside, walls);
    if constexpr (Archive::k_reads)
        archive.require((!solid || has_own_tiles(solid->nodes)) && (!fluid || has_own_tiles(*fluid)));
}

/// Adds solids with the fields of the state's stages, between two steps; then call prepare.
void add_solids(State& state, const ParticleSet& solids);

/// Sorts the solids, sums them on the nodes and sets the fluid's inputs; call before the first step and whenever
/// particles were added.
void prepare(State& state, const Laws& laws, ThreadPool& pool);

/// Inputs of the fluid from the solids; null pointers without solids.
SolidsOnGrid solids_on_grid(const State& state);

}  // namespace frana::structured
