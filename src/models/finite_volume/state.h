// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/thread_pool.h"
#include "models/finite_volume/cells.h"
#include "models/voellmy_bingham/state.h"
#include "mpm/flight.h"
#include "mpm/node_grid.h"
#include "mpm/tile_lists.h"
#include "particles/tile_order.h"

namespace frana::finite_volume {

/// Cells [i0, i1) x [j0, j1), padded.
struct Region {
    std::int64_t i0 = 0, i1 = 0, j0 = 0, j1 = 0;
};

/// What a tile of cells contains after a step.
struct TileRecord {
    std::int32_t i0, i1, j0, j1;  ///< what may move lies in [i0, i1) x [j0, j1), padded; i1 = 0: nothing
    std::int32_t wet, covered;    ///< cells with material; those as deep as the minimum depth
    double depth, thin, deepest;  ///< sums over cells: of all, of those not as deep [m]; greatest depth [m]
    /// Sums over cells, per cell area and density [m3/s2]: kinetic energy, that and the potential one, what of this a
    /// flow along the bed would have less and a level one more.
    double kinetic, energy, levelled, sloping;
};

/// Adjacent tiles that are computed together.
struct Strip {
    Region region;
    std::vector<double> work{};  ///< rows of a sweep
    StripTotals totals{};
    double left = 0;         ///< through open edges in this step, depth in a cell [m]
    double diffusivity = 0;  ///< greatest of the in-plane stress [m2/s]
};

/// Laws and numbers that are constant during a run.
struct Laws {
    StepValues values;
    double cfl = 0;
    bool along_bed = true;  ///< with slope correction
    bool curved = true;     ///< with the load of the bed's curvature
    bool wall = false;      ///< at the edges of the terrain
    bool gap_is_wall = false;
    bool flies = true;  ///< what would leave the ground is told of
    /// Friction may balance the fall within a step: what leaves at an edge is then told with that of half a step, of
    /// which friction alone has acted.
    bool films = false;
    JumpRules jumps;
    voellmy_bingham::BedFriction friction;
    voellmy_bingham::PlaneStressLaw stress;
    voellmy_bingham::BedExchange exchange;
};

/// The cells and where the flow is.
struct State {
    /// @param grid must outlive the state
    explicit State(NodeGrid& grid);

    NodeGrid& nodes;
    TileGrid tiles;
    ZeroArray<double> depth, qx, qy;  ///< padded as the nodes are: Cells
    ZeroArray<double> carried[2];     ///< h r and h m of PorePressure [m]; empty: the scene lacks them
    std::vector<std::int64_t> wet;    ///< tiles with any material, ascending
    ZeroArray<TileRecord> records;    ///< by tile
    double time = 0;                  ///< [s]
    double wave = 0;                  ///< greatest |u| + sqrt(g' h), by direction [m/s]
    double diffusivity = 0;           ///< greatest of the in-plane stress [m2/s]
    double volume_left = 0;           ///< through open edges [m3]
    double momentum = 0;              ///< sum of volume times speed [m4/s]
    std::int64_t steps = 0;
    ZeroArray<ErodibleBed> erodible_beds;  ///< padded; empty if the bed does not change
    ExchangeReport exchanged;
    JumpStatistics jumps;  ///< that find_jumps found
    double untested = 0;   ///< time since it looked [s]

    const double* lying = nullptr;  ///< depth of what lies on the bed under the flow, padded [m]; null: nothing

    // What follows from the ground, read where the flow arrives, and what lives within a step.
    ZeroArray<double> bed, slope_x, slope_y, root, curvature_xx, curvature_xy, curvature_yy;
    ZeroArray<double> weight, slowed_x, slowed_y, pull_x, pull_y, bound, spare, held, head, start, before;
    ZeroArray<double> force_x, force_y;  ///< of the in-plane stress, over density [m2/s2]; else empty
    ZeroArray<std::uint8_t> ready;       ///< by tile: the ground was read
    ZeroArray<BedState> bed_states;      ///< if friction is summed
    Edges edges;
    std::vector<Strip> strips;
    std::size_t n_strips = 0;
    std::vector<Region> prepared;  ///< the same with one more cell on every side

    /// @param maxima null: not wanted
    [[nodiscard]] Cells cells(Maxima* maxima);
    /// Of a cell with material.
    [[nodiscard]] PorePressure::State pores(std::size_t k) const noexcept {
        const auto of = [&](const ZeroArray<double>& content) {
            return content.size() != 0 ? std::clamp(content[k] / depth[k], 0.0, 1.0) : 0;
        };
        return {of(carried[0]), of(carried[1])};
    }
    /// Sets, or with `more` adds, what a depth of material carries.
    void set_pores(std::size_t k, double of_depth, const PorePressure::State& pores, bool more = false) noexcept {
        const double values[] = {pores.ratio, pores.solid_fraction};
        for (std::size_t n = 0; n < 2; ++n)
            if (carried[n].size() != 0) carried[n][k] = (more ? carried[n][k] : 0) + of_depth * values[n];
    }
    [[nodiscard]] double cell_area() const noexcept { return nodes.cell_size() * nodes.cell_size(); }
    [[nodiscard]] std::int64_t tile_of(std::int64_t i, std::int64_t j) const noexcept {
        return (j + tiles.before_y()) / k_tile * tiles.tiles_x() + (i + tiles.before_x()) / k_tile;
    }
};

template <class Archive>
void serialise(Archive& archive, TileRecord& record) {
    auto& [i0, i1, j0, j1, wet, covered, depth, thin, deepest, kinetic, energy, levelled, sloping] = record;
    archive(i0, i1, j0, j1, wet, covered, depth, thin, deepest, kinetic, energy, levelled, sloping);
}

template <class Archive>
void serialise(Archive& archive, State& s) {
    archive(s.depth, s.qx, s.qy, s.carried[0], s.carried[1], s.held, s.weight, s.wet, s.records, s.time, s.wave,
            s.diffusivity, s.volume_left, s.momentum, s.steps, s.erodible_beds, s.exchanged, s.jumps, s.untested);
}

}  // namespace frana::finite_volume
