// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/default_values.h"
#include "core/zero_array.h"
#include "models/finite_volume/state.h"
#include "mpm/curvature.h"
#include "physics/parameters.h"

namespace frana::structured {

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
    double cfl = k_courant_of_sweeps;     ///< of a sweep
    double dry = k_dry_depth;             ///< depth under which fluid does not move [m]
    bool steep = true;                    ///< gravity over 1 + |grad b|^2, resistance along the bed
    bool wall = false;                    ///< the edge of the grid; false: open
    bool gaps_are_open = true;            ///< flow may enter cells without terrain (and is counted); false: walls
    double manning = 0;                   ///< n [s/m^(1/3)]
    /// R_n by depth and mass of solids and fluid together (paper, equation 46) as far as they move together; in excess
    /// of the solids' velocity by the fluid's own (ours: a film is braked by the block that it runs over). Needs
    /// SolidsOnGrid::u, mass.
    bool manning_on_total = false;
    /// R_n acts in the sweeps, on the fluxes too, where there are no solids: films in which it balances the slope
    /// within a step flow at its speed. Split off it is of first order in the step over that time. Not with viscosity.
    bool manning_in_sweeps = false;
    double density = k_fluid_density;  ///< rho_u [kg/m3]
    double viscosity = 0;              ///< a_eta: eta = a_eta exp(b_eta alpha_s) [Pa s]; 0: no viscous term
    double viscosity_growth = 10;      ///< b_eta [-]
    double velocity_shape = 3;         ///< chi: bed shear by viscosity, chi nu u / h^2 [-]
    double mobility = 1;               ///< A of the enhanced non-Newtonian stress [-]; 0: off
    double solids_shape = 2;           ///< zeta: damping by the vertical profile of solids [-]
    Rain rain;
};

/// Everything of the fluid that changes during a run.
struct FluidState {
    /// No fluid anywhere.
    /// @param nodes must outlive the state
    FluidState(NodeGrid& nodes, const FluidLaws& laws);

    finite_volume::State now;            ///< depth h_u, and momentum along the bed; no cell of walls and gaps has any
    double volume_into_gaps = 0;         ///< of what left, into cells without terrain [m3]
    ZeroArray<double> force_x, force_y;  ///< of the in-plane stress, over density [m2/s2]; empty without viscosity

    /// Change of the velocity in map view by stress and resistance in the last advance [m/s]; only in cells with
    /// solids.
    ZeroArray<double> resistance_x, resistance_y;
    std::vector<std::int64_t> resisted;  ///< tiles in which it is not 0; ascending

    /// Rain by place from one time to another [s].
    struct RainMap {
        double from = 0, until = 0;
        ZeroArray<double> intensity;  ///< [m/s], by cell
    };
    std::vector<RainMap> rain_maps;
    double volume_rained_by_place = 0;     ///< from them, so far [m3]
    double rained = 0;                     ///< depth of rain so far, in every open cell [m]
    std::vector<std::int64_t> open_tiles;  ///< on which rain falls; only with rain
    std::int64_t open_cells = 0;           ///< in them
    ZeroArray<double> infiltrated;         ///< so far, by cell [m]; empty: tight ground
    double volume_infiltrated = 0;         ///< their sum [m3]
    GreenAmpt soil;                        ///< where `soils` is empty
    ZeroArray<GreenAmpt> soils;            ///< by cell

    [[nodiscard]] double volume_rained() const noexcept {
        return rained * static_cast<double>(open_cells) * now.cell_area() + volume_rained_by_place;
    }
    [[nodiscard]] BedFrame frame(std::size_t cell) const noexcept {
        return {now.slope_x[cell], now.slope_y[cell], now.root[cell]};
    }
    /// In map view, of a cell with fluid [m/s].
    [[nodiscard]] Point velocity(std::size_t cell) const noexcept {
        return frame(cell).in_map(now.qx[cell] / now.depth[cell], now.qy[cell] / now.depth[cell]);
    }
    /// Adds momentum in map view, over density [m2/s].
    void push(std::size_t cell, double x, double y) noexcept {
        const Point along = frame(cell).along_bed(x, y);
        now.qx[cell] += along.x;
        now.qy[cell] += along.y;
    }
};

/// Checks, after reading a state, that its tiles are those of its grid.
[[nodiscard]] inline bool has_own_tiles(const FluidState& state) {
    return are_tiles_of(state.now.tiles, state.now.wet);
}

template <class Archive>
void serialise(Archive& archive, FluidState& state) {
    archive(state.now, state.volume_into_gaps, state.rained, state.volume_rained_by_place, state.infiltrated,
            state.volume_infiltrated);
}

/// Results of an advance.
struct FluidReport {
    int steps = 0;
    std::int64_t non_finite = 0;     ///< cells
    std::int64_t updated_cells = 0;  ///< sum over steps of the cells computed
};

}  // namespace frana::structured
