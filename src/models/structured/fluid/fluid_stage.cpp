// SPDX-License-Identifier: Apache-2.0
#include "models/structured/fluid/fluid_stage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "models/structured/fluid/fluid_state.h"
#include "models/structured/fluid/fluid_step.h"
#include "particles/tile_order.h"

namespace frana::structured {
namespace {

/// Halo: cells beside a tile that its faces read, on each side.
constexpr int k_halo = 2;
constexpr int k_side = static_cast<int>(k_tile);
constexpr int k_length = k_side + 2 * k_halo;

/// One tile with its halo along the direction of a sweep: [place along the sweep][place across].
struct SweepCells {
    double depth[k_length][k_side];   ///< [m]
    double along[k_length][k_side];   ///< velocity along the sweep [m/s]
    double across[k_length][k_side];  ///< and across [m/s]
    double bed[k_length][k_side];     ///< effective bed Z [m]
    double factor[k_length][k_side];  ///< of gravity, 1 / (1 + |grad b|^2)
    std::uint8_t kind[k_length][k_side];
};

/// Rates of change of the tile's cells by the faces of one sweep, times the cell size.
struct SweepRates {
    double depth[k_side][k_side];   ///< [m2/s]
    double along[k_side][k_side];   ///< [m3/s2]
    double across[k_side][k_side];  ///< [m3/s2]
    double left = 0;                ///< discharge per width through open edges, summed over faces [m2/s]
    double into_gaps = 0;           ///< the same into cells without terrain [m2/s]
};

double minmod(double a, double b) noexcept {
    return a * b > 0 ? (std::abs(a) < std::abs(b) ? a : b) : 0;
}

/// Values at the lower and upper face of a row of cells.
struct FaceValues {
    double depth[k_side], along[k_side], across[k_side], bed[k_side];
    double factor[k_side];  ///< the cell's
};

/// Reconstruction in one row: slopes by minmod of depth, surface and velocity, so that the mean discharge is conserved
/// and a level surface stays level (Audusse et al. 2004; Delestre et al. 2014, section 3.2):
///     h_-+ = h -+ dh/2,  Z_-+ = eta_-+ - h_-+,  u_+ = u + (h_-/h) du/2,  u_- = u - (h_+/h) du/2
/// Beside a wall all slopes are zero; beside an open edge only the surface has a slope, that of the other side.
template <bool second_order, bool plain>
void reconstruct(const SweepCells& cells, int c, FaceValues& lower, FaceValues& upper) {
    for (int a = 0; a < k_side; ++a) {
        const double h = cells.depth[c][a], z = cells.bed[c][a];
        double dh = 0, de = 0, du = 0, dv = 0;
        if constexpr (second_order) {
            double h_low = h - cells.depth[c - 1][a], h_up = cells.depth[c + 1][a] - h;
            double e_low = h_low + (z - cells.bed[c - 1][a]), e_up = h_up + (cells.bed[c + 1][a] - z);
            double u_low = cells.along[c][a] - cells.along[c - 1][a];
            double u_up = cells.along[c + 1][a] - cells.along[c][a];
            double v_low = cells.across[c][a] - cells.across[c - 1][a];
            double v_up = cells.across[c + 1][a] - cells.across[c][a];
            if constexpr (!plain) {
                const int below = cells.kind[c - 1][a], above = cells.kind[c + 1][a];
                if (below != k_fluid_cell) h_low = e_low = u_low = v_low = 0;
                if (above != k_fluid_cell) h_up = e_up = u_up = v_up = 0;
                if (below >= k_open_cell) e_low = e_up;
                if (above >= k_open_cell) e_up = e_low;
            }
            dh = 0.5 * minmod(h_low, h_up);
            de = 0.5 * minmod(e_low, e_up);
            du = 0.5 * minmod(u_low, u_up);
            dv = 0.5 * minmod(v_low, v_up);
        }
        const double h_lower = h - dh, h_upper = h + dh;
        const double inverse = h > 0 ? 1 / h : 0;
        lower.factor[a] = upper.factor[a] = cells.factor[c][a];
        lower.depth[a] = h_lower;
        upper.depth[a] = h_upper;
        // eta -+ de less h -+ dh, without the sum eta, to limit rounding.
        lower.bed[a] = z - (de - dh);
        upper.bed[a] = z + (de - dh);
        lower.along[a] = cells.along[c][a] - h_upper * inverse * du;
        upper.along[a] = cells.along[c][a] + h_lower * inverse * du;
        lower.across[a] = cells.across[c][a] - h_upper * inverse * dv;
        upper.across[a] = cells.across[c][a] + h_lower * inverse * dv;
    }
}

/// Fluxes through a row of faces. The momentum flux along the sweep is carried + k pushed_left for the cell below the
/// face and carried + k pushed_right for the cell above, with k the cell's own gravity factor.
struct FaceFluxes {
    double depth[k_side], across[k_side], carried[k_side], pushed_left[k_side], pushed_right[k_side];
};

/// Least outward speed of outflow through an open edge, as a fraction of the wave speed: rounding must not drain a
/// lake.
constexpr double k_leaving = 1e-9;

/// Boundary values at walls and open edges: a wall mirrors the cell; open edges are passed by outward flow only.
void close_faces(const SweepCells& cells, int c, double gravity, FaceValues& left, FaceValues& right) {
    const auto copy = [](const FaceValues& from, int a, double sign, FaceValues& to) {
        to.depth[a] = from.depth[a];
        to.bed[a] = from.bed[a];
        to.factor[a] = from.factor[a];
        to.across[a] = from.across[a];
        to.along[a] = sign * from.along[a];
    };
    const auto moves = [&](double outward, double depth) { return outward > k_leaving * std::sqrt(gravity * depth); };
    for (int a = 0; a < k_side; ++a) {
        const int below = cells.kind[c - 1][a], above = cells.kind[c][a];
        if (below == k_fluid_cell && above != k_fluid_cell) {
            const bool leaves = above >= k_open_cell && moves(left.along[a], left.depth[a]);
            copy(left, a, leaves ? 1 : -1, right);
        } else if (below != k_fluid_cell && above == k_fluid_cell) {
            const bool leaves = below >= k_open_cell && moves(-right.along[a], right.depth[a]);
            copy(right, a, leaves ? 1 : -1, left);
        }
    }
}

/// Hydrostatic reconstruction at the step of the bed (Audusse et al. 2004) and the HLL flux with the exact speeds of a
/// front on a dry bed (Toro 2001, section 10.5); transverse momentum is advected with the mass. No flux between two
/// cells below the dry depth.
void face_fluxes(const SweepCells& cells, int c, const FaceValues& left, const FaceValues& right, double gravity,
                 double dry, FaceFluxes& flux) {
    const double half_g = 0.5 * gravity;
    // Where a surface ends exactly at a step of the bed, rounding must not decide whether the face is dry.
    const double grain = 1e-6 * dry;
    constexpr double k_least_speed = 1e-150;  // [m/s]
    for (int a = 0; a < k_side; ++a) {
        const double z = std::max(left.bed[a], right.bed[a]);
        const double hl = std::max(0.0, left.depth[a] + (left.bed[a] - z));
        const double hr = std::max(0.0, right.depth[a] + (right.bed[a] - z));
        const double ul = left.along[a], ur = right.along[a];
        const double cl = std::sqrt(gravity * left.factor[a] * hl);
        const double cr = std::sqrt(gravity * right.factor[a] * hr);
        const bool wet_l = hl > grain, wet_r = hr > grain;
        const double low = wet_l ? (wet_r ? std::min(ul - cl, ur - cr) : ul - cl) : ur - 2 * cr;
        const double high = wet_r ? (wet_l ? std::max(ul + cl, ur + cr) : ur + cr) : ul + 2 * cl;
        const double s1 = std::min(low, 0.0), s2 = std::max(high, 0.0);
        // Speeds die away to where an inverse is infinite; then nothing moves.
        const bool moves = std::max(cells.depth[c - 1][a], cells.depth[c][a]) >= dry && s2 - s1 > k_least_speed;
        const double inverse = moves ? 1 / (s2 - s1) : 0;
        const double ql = hl * ul, qr = hr * ur;
        const double mass = (s2 * ql - s1 * qr + s1 * s2 * (hr - hl)) * inverse;
        const double pushed = half_g * (s2 * hl * hl - s1 * hr * hr) * inverse;
        flux.depth[a] = mass;
        flux.across[a] = mass * (mass > 0 ? left.across[a] : right.across[a]);
        flux.carried[a] = (s2 * ql * ul - s1 * qr * ur + s1 * s2 * (qr - ql)) * inverse;
        flux.pushed_left[a] = pushed + half_g * (left.depth[a] * left.depth[a] - hl * hl);
        flux.pushed_right[a] = pushed + half_g * (right.depth[a] * right.depth[a] - hr * hr);
    }
}

/// Sums the outflow through the faces of this tile's own cells.
void count_leaving(const SweepCells& cells, int c, const FaceFluxes& flux, SweepRates& rates) {
    const auto count = [&](int kind, double leaving) {
        if (kind < k_open_cell) return;
        rates.left += leaving;
        if (kind == k_gap_cell) rates.into_gaps += leaving;
    };
    for (int a = 0; a < k_side; ++a) {
        const int below = cells.kind[c - 1][a], above = cells.kind[c][a];
        if (below == k_fluid_cell && c - 1 >= k_halo) count(above, flux.depth[a]);
        if (above == k_fluid_cell && c < k_halo + k_side) count(below, -flux.depth[a]);
    }
}

/// Rates of change by all faces in one direction:
///     d(h)/dt = -[F_h],   d(h u)/dt = -[F_u] - k (g/2)(h_- + h_+)(Z_+ - Z_-),   d(h v)/dt = -[F_v]
/// [ ] is the value at the upper face minus that at the lower one. Rates of cells that are not fluid are computed too,
/// and not used.
template <bool second_order, bool plain>
void sweep(const SweepCells& cells, double gravity, double dry, SweepRates& rates) {
    FaceValues lower, upper, upper_before;
    FaceFluxes flux, flux_before;
    double source[k_side] = {};
    reconstruct<second_order, plain>(cells, k_halo - 1, lower, upper_before);
    for (int c = k_halo; c <= k_halo + k_side; ++c) {
        reconstruct<second_order, plain>(cells, c, lower, upper);
        double next_source[k_side];
        for (int a = 0; a < k_side; ++a)
            next_source[a] = 0.5 * gravity * (lower.depth[a] + upper.depth[a]) * (upper.bed[a] - lower.bed[a]);
        if constexpr (!plain) close_faces(cells, c, gravity, upper_before, lower);
        face_fluxes(cells, c, upper_before, lower, gravity, dry, flux);
        if constexpr (!plain) count_leaving(cells, c, flux, rates);
        if (c > k_halo) {
            const int r = c - 1 - k_halo;
            for (int a = 0; a < k_side; ++a) {
                const double k = cells.factor[c - 1][a];
                rates.depth[r][a] = flux_before.depth[a] - flux.depth[a];
                rates.along[r][a] = flux_before.carried[a] - flux.carried[a] +
                                    k * (flux_before.pushed_right[a] - flux.pushed_left[a] - source[a]);
                rates.across[r][a] = flux_before.across[a] - flux.across[a];
            }
        }
        flux_before = flux;
        upper_before = upper;
        std::copy(next_source, next_source + k_side, source);
    }
}

// A tile's window on the padded arrays, and the direction of the sweep.
struct Window {
    std::int64_t i0, j0;         // padded, of the tile's first cell
    std::int64_t columns, rows;  // of the padded arrays
    bool along_x;

    // Padded index of a cell by its place along the sweep (halo included) and across it; outside the arrays, where
    // there is no fluid, that of the nearest cell.
    [[nodiscard]] std::size_t index(int c, int a) const noexcept {
        const std::int64_t i = std::clamp<std::int64_t>(i0 + (along_x ? c - k_halo : a), 0, columns - 1);
        const std::int64_t j = std::clamp<std::int64_t>(j0 + (along_x ? a : c - k_halo), 0, rows - 1);
        return static_cast<std::size_t>(j * columns + i);
    }
};

void load(const Window& window, const NodeGrid& nodes, const FluidLaws& laws, const FluidState& state,
          const double* solid_depth, const FluidFields& from, SweepCells& cells) {
    const double* along = window.along_x ? from.qx.data() : from.qy.data();
    const double* across = window.along_x ? from.qy.data() : from.qx.data();
    const auto fill = [&](int c, int a, std::size_t cell) {
        const double h = from.depth[cell];
        const double inverse = h >= laws.dry ? 1 / h : 0;
        cells.depth[c][a] = h;
        cells.along[c][a] = along[cell] * inverse;
        cells.across[c][a] = across[cell] * inverse;
        cells.bed[c][a] = nodes.bed[cell] + (solid_depth != nullptr ? solid_depth[cell] : 0);
        cells.factor[c][a] = state.slope_factor.size() == 0 ? 1 : state.slope_factor[cell];
        cells.kind[c][a] = state.cell_kind[cell];
    };
    // Rows of the arrays are along x: read in that order.
    if (window.along_x) {
        for (int a = 0; a < k_side; ++a)
            for (int c = 0; c < k_length; ++c) fill(c, a, window.index(c, a));
    } else {
        for (int c = 0; c < k_length; ++c)
            for (int a = 0; a < k_side; ++a) fill(c, a, window.index(c, a));
    }
}

bool is_plain(const SweepCells& cells) {
    int sum = 0;
    for (const auto& row : cells.kind)
        for (const std::uint8_t kind : row) sum |= kind;
    return sum == k_fluid_cell;
}

void sweep_tile(const SweepCells& cells, const FluidLaws& laws, SweepRates& rates) {
    const bool plain = is_plain(cells);
    if (laws.second_order) {
        plain ? sweep<true, true>(cells, laws.gravity, laws.dry, rates)
              : sweep<true, false>(cells, laws.gravity, laws.dry, rates);
    } else {
        plain ? sweep<false, true>(cells, laws.gravity, laws.dry, rates)
              : sweep<false, false>(cells, laws.gravity, laws.dry, rates);
    }
}

}  // namespace

TileReport fluid_stage(const NodeRange& range, const NodeGrid& nodes, const FluidLaws& laws, const FluidState& state,
                       const double* solid_depth, double dt, double fraction, const FluidFields& from,
                       const FluidFields& before, FluidFields& to) {
    // Tolerance for rounding in a cell that becomes empty; a more negative depth means that the step was too long.
    const double grain = 1e-12 * laws.dry;
    SweepCells cells;
    SweepRates x, y;
    // The first tile may begin outside the arrays: a window is as wide as a tile all the same, and ends where it ends.
    const std::int64_t i0 = range.i0 == 0 ? range.i1 - k_side : range.i0,
                       j0 = range.j0 == 0 ? range.j1 - k_side : range.j0;
    Window window{i0, j0, nodes.stride(), nodes.padded_rows(), true};
    load(window, nodes, laws, state, solid_depth, from, cells);
    sweep_tile(cells, laws, x);
    window.along_x = false;
    load(window, nodes, laws, state, solid_depth, from, cells);
    sweep_tile(cells, laws, y);

    TileReport report;
    report.left = nodes.cell_size() * (x.left + y.left);
    report.into_gaps = nodes.cell_size() * (x.into_gaps + y.into_gaps);
    const double ratio = dt / nodes.cell_size();
    range.for_each(nodes.stride(), [&](std::size_t cell, std::int64_t i, std::int64_t j) {
        if (state.cell_kind[cell] != k_fluid_cell) return;
        const auto a = static_cast<int>(i - i0), b = static_cast<int>(j - j0);
        double depth = from.depth[cell] + ratio * (x.depth[a][b] + y.depth[b][a]);
        double qx = from.qx[cell] + ratio * (x.along[a][b] + y.across[b][a]);
        double qy = from.qy[cell] + ratio * (x.across[a][b] + y.along[b][a]);
        if (!(std::isfinite(depth) && std::isfinite(qx) && std::isfinite(qy))) ++report.non_finite;
        report.lowest = std::min(report.lowest, depth < -grain ? depth : 0.0);
        depth = std::max(depth, 0.0);
        if (fraction < 1) {
            depth = fraction * depth + (1 - fraction) * before.depth[cell];
            qx = fraction * qx + (1 - fraction) * before.qx[cell];
            qy = fraction * qy + (1 - fraction) * before.qy[cell];
        }
        const bool wet = depth >= laws.dry;
        report.wet_cells += wet;
        to.depth[cell] = depth;
        to.qx[cell] = wet ? qx : 0;
        to.qy[cell] = wet ? qy : 0;
    });
    return report;
}

}  // namespace frana::structured
