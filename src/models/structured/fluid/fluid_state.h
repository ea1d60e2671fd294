// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/default_values.h"
#include "core/zero_array.h"
#include "models/structured/tile_lists.h"
#include "mpm/node_grid.h"

namespace frana::structured {

/// Free fluid in every cell, padded like the nodes (NodeGrid::index), in map view.
struct FluidFields {
    ZeroArray<double> depth;   ///< h_u, vertical [m]; never negative
    ZeroArray<double> qx, qy;  ///< unit discharge h_u u_u [m2/s]; zero below the dry depth

    FluidFields() = default;
    explicit FluidFields(std::size_t size) : depth(size), qx(size), qy(size) {}
};

/// Depth, velocity and fractions of solid particles in the cells, padded like the nodes; null pointers in a scene
/// without solids. The fluid lies on the effective bed b + depth; the other fields affect only its viscous stress.
struct SolidsOnGrid {
    const double* depth = nullptr;           ///< h_c, solids and confined fluid [m]
    const double* u = nullptr;               ///< u_c [m/s]
    const double* v = nullptr;               ///< v_c [m/s]
    const double* solid_fraction = nullptr;  ///< alpha_s of the whole cell [-]
    const double* structured = nullptr;      ///< f_sc, fraction of the solids that is structured [-]
    const double* mass = nullptr;            ///< m_c [kg/m2]
    const double* pores = nullptr;  ///< between the solids when they were placed, a fifth of their depth at least [m]
};

/// Fluid added to a cell between two steps, with its momentum: release of confined fluid, inflow.
struct FluidSource {
    std::size_t cell = 0;   ///< NodeGrid::index
    double depth = 0;       ///< [m], not negative
    double qx = 0, qy = 0;  ///< unit discharge added with it [m2/s]
};

/// Parameters of the free fluid; constant during a run.
struct FluidLaws {
    double gravity = k_standard_gravity;  ///< [m/s2]
    double cfl = 0.5;                     ///< at most 0.5, which keeps depths positive
    double dry = k_dry_depth;             ///< depth under which fluid does not move [m]
    bool second_order = true;             ///< false: cell values and one Euler stage
    bool steep = true;                    ///< gravity over 1 + |grad b|^2, resistance along the bed
    bool wall = false;                    ///< the edge of the grid; false: open
    bool gaps_are_open = true;            ///< flow may enter cells without terrain (and is counted); false: walls
    double manning = 0;                   ///< n [s/m^(1/3)]
    /// R_n by depth and mass of solids and fluid together (paper, equation 46) as far as they move together; in excess
    /// of the solids' velocity by the fluid's own (ours: a film is braked by the block that it runs over). Needs
    /// SolidsOnGrid::u, mass.
    bool manning_on_total = false;
    double density = k_fluid_density;  ///< rho_u [kg/m3]
    double viscosity = 0;              ///< a_eta: eta = a_eta exp(b_eta alpha_s) [Pa s]; 0: no viscous term
    double viscosity_growth = 10;      ///< b_eta [-]
    double velocity_shape = 3;         ///< chi: bed shear by viscosity, chi nu u / h^2 [-]
    double mobility = 1;               ///< A of the enhanced non-Newtonian stress [-]; 0: off
    double solids_shape = 2;           ///< zeta: damping by the vertical profile of solids [-]
};

/// Everything of the fluid that changes during a run.
struct FluidState {
    /// No fluid anywhere.
    FluidState(const NodeGrid& nodes, const FluidLaws& laws);

    FluidFields now;  ///< the present; a coupling may change qx and qy of wet cells between steps

    TileGrid grid;
    std::vector<std::int64_t> tiles;  ///< with moving fluid, and their neighbours; ascending
    double volume_left = 0;           ///< through open boundaries, into gaps included [m3]
    double volume_into_gaps = 0;      ///< of which into cells without terrain [m3]

    /// Change of the velocity by stress and resistance in the last advance [m/s]; only in cells with solids.
    ZeroArray<double> resistance_x, resistance_y;

    // Used by fluid_step.cpp only.
    std::vector<std::int64_t> touched;  ///< tiles that were ever in `tiles`; ascending
    FluidFields stage, next;            ///< buffers; as `now` outside `tiles`
    ZeroArray<std::uint8_t> wet;        ///< by tile: contains fluid deeper than the dry depth

    // Of the ground; valid in tiles that have it (need_ground).
    ZeroArray<std::uint8_t> cell_kind;   ///< padded; CellKind
    ZeroArray<double> slope_factor;      ///< padded 1 / (1 + |grad b|^2); empty unless steep
    ZeroArray<std::uint8_t> has_ground;  ///< by tile
};

template <class Archive>
void serialise(Archive& archive, FluidFields& fields) {
    auto& [depth, qx, qy] = fields;
    archive(depth, qx, qy);
}

/// Checks, after reading a state, that its tiles are those of its grid.
[[nodiscard]] inline bool has_own_tiles(const FluidState& state) {
    return are_tiles_of(state.grid, state.tiles) && are_tiles_of(state.grid, state.touched);
}

/// Everything except what set_ground, need_ground and advance compute.
template <class Archive>
void serialise(Archive& archive, FluidState& state) {
    [[maybe_unused]] auto& [now, grid, tiles, volume_left, volume_into_gaps, resistance_x, resistance_y, touched, stage,
                            next, wet, cell_kind, slope_factor, has_ground] = state;
    archive(now, tiles, volume_left, volume_into_gaps, touched, stage, next, wet);
}

/// Cell type for the fluid.
enum CellKind : std::uint8_t { k_fluid_cell = 0, k_wall_cell = 1, k_open_cell = 2, k_gap_cell = 3 };

/// Results of an advance.
struct FluidReport {
    int steps = 0;                   ///< Heun steps
    int retries = 0;                 ///< of which repeated at half length, because a depth would have been negative
    std::int64_t non_finite = 0;     ///< cells
    std::int64_t wet_cells = 0;      ///< deeper than the dry depth, at the end
    std::int64_t updated_cells = 0;  ///< sum over steps of the cells computed
};

}  // namespace frana::structured
