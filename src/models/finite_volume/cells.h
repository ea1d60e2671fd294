// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "mpm/update_nodes.h"

namespace frana::finite_volume {

/// Arrays of the cells, padded as the nodes are (NodeGrid): h the vertical depth, w the velocity along the bed in the
/// frame of BedFrame.
struct Cells {
    double *depth, *qx, *qy;                                   ///< h [m], h w [m2/s]
    const double* bed;                                         ///< walls raised by k_wall_height [m]
    const double *slope_x, *slope_y, *root;                    ///< of the bed; 0 and 1 without slope correction
    const double *curvature_xx, *curvature_xy, *curvature_yy;  ///< BedCurvature [1/m]
    double* weight;                                            ///< g' [m/s2]
    double *slowed_x, *slowed_y;                               ///< change of w by friction in half a step [m/s]
    double *pull_x, *pull_y, *bound;                           ///< momentum after a step without friction, and what
                                                               ///< friction stops in it, per time [m2/s2]; after
                                                               ///< the sweeps what passed the faces [m2/s]
    double* spare;                                   ///< speed that friction could also stop in half a step [m/s]
    double* held;                                    ///< 1: friction keeps the cell at rest
    double* head;                                    ///< greatest energy over weight, times g [m2/s2]
    double* start;                                   ///< speed before the step; negative: dry [m/s]
    double* before;                                  ///< depth before the step [m]
    double *max_depth, *max_speed, *arrival_plus_1;  ///< Maxima
    std::int64_t stride;
};

/// Friction of a step acts on the mean of the mass before and after it: what flowed in brings that of half a step, by
/// the predictor. With the mass after it the step would be of first order. Returns its ratio to the mass after it.
template <class Number>
[[gnu::always_inline]] inline Number friction_share(Number before, Number after) {
    using std::min;
    return min(Number(2.0), 0.5 + 0.5 * before / after);
}

/// What the kernels of a step need besides the cells.
struct StepValues {
    double dt = 0, cell_size = 1, gravity = 0;  ///< [s], [m], vertical [m/s2]
    double gravity_x = 0, gravity_y = 0;        ///< of a tilted frame, for verification [m/s2]
    double dry = 0;                             ///< depth that does not move [m]
    double minimum_depth = 0;                   ///< depth that counts as reached [m]
    double time = 0;                            ///< at the end of the step [s]
    double moving_speed = 0;                    ///< from which volume counts as moving [m/s]
    double wave_factor = 1;                     ///< square of the factor on the speed of pressure waves
    bool weight_of_bed = false;                 ///< g' = g / n whatever the surface (slope-correction = surface)
};

inline constexpr double k_wall_height = 1e4;  ///< [m], more than any flow climbs

/// A row of cells in the direction of a sweep: h, velocity in map view normal to the faces, along the bed normal and
/// tangential, g', its effect on the normal velocity along the bed, elevation, 1 where held or dry.
struct CellRow {
    double *depth, *speed, *normal, *tangential, *weight, *drive, *bed, *closed, *spare;
    static constexpr int k_arrays = 9;
};

/// The states of a row of cells at their faces before or after them: h, velocities as in CellRow, elevation of the bed.
struct SideRow {
    double *depth, *speed, *normal, *tangential, *bed;
    static constexpr int k_arrays = 5;
};

/// Fluxes through a row of faces; pressure over g' and height of the bed at the face above that of the cell, as seen
/// from the cell below and above it.
struct FaceRow {
    double *mass, *normal, *tangential, *pressure_below, *pressure_above, *step_below, *step_above;
    static constexpr int k_arrays = 7;
};

/// Greatest values and sums over the cells of a strip, in four lanes that are joined in order.
struct StripTotals {
    double max_speed[4] = {}, wave[4] = {};                       ///< [m/s]
    double dissipated[4] = {}, moving[4] = {}, momentum[4] = {};  ///< per cell area [m3/s2], [m], [m2/s]
    double unsupported[4] = {}, not_finite[4] = {};               ///< cells
};

/// The loops over rows, in one set of instructions. All give the same bits.
struct RowKernels {
    using Uniform = UniformFriction;
    using Summed = SummedFriction<NoExcess>;
    void (*prepare)(const Cells&, std::size_t first, std::size_t count, const StepValues&, const Uniform&);
    void (*prepare_summed)(const Cells&, std::size_t first, std::size_t count, const StepValues&, const Summed&);
    void (*hold)(const Cells&, std::size_t first, std::size_t count, const StepValues&);
    /// @param depth, qx, qy of the row's first cell, which may be copies
    void (*read_row)(const Cells&, std::size_t first, std::size_t count, const double* depth, const double* qx,
                     const double* qy, bool along_y, double dry, const CellRow&);
    /// The states of the cells of row b half a step later at both their faces; a before b, c after it. In a row itself
    /// all are that row, moved. This and `faces` go on to the next multiple of four cells.
    void (*sides)(const CellRow& a, const CellRow& b, const CellRow& c, std::size_t count, const StepValues&,
                  const SideRow& before, const SideRow& after);
    /// The faces between cells of rows b and c, whose states there are `below` and `above`; a before b, d after c.
    void (*faces)(const CellRow& a, const CellRow& b, const CellRow& c, const CellRow& d, const SideRow& below,
                  const SideRow& above, std::size_t count, const StepValues&, const FaceRow&);
    void (*update)(const Cells&, std::size_t first, std::size_t count, bool along_y, const StepValues&,
                   const FaceRow& before, const FaceRow& after);
    void (*finish)(const Cells&, std::size_t first, std::size_t count, const StepValues&, const Uniform&, StripTotals&);
    void (*finish_summed)(const Cells&, std::size_t first, std::size_t count, const StepValues&, const Summed&,
                          StripTotals&);
};

/// The same for a law that is no polynomial of the speed, one cell at a time.
void prepare_excess(const Cells& cells, std::size_t first, std::size_t count, const StepValues& values,
                    const ExcessLaw& law, BedState* states);
void finish_excess(const Cells& cells, std::size_t first, std::size_t count, const StepValues& values,
                   const ExcessLaw& law, BedState* states, StripTotals& totals);

/// The kernels in the newest instructions that the processor has; `plain`: those that every processor has.
const RowKernels& row_kernels(bool plain = false);

}  // namespace frana::finite_volume
