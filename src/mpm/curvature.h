// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "core/geometry.h"
#include "core/lanes.h"
#include "mpm/node_grid.h"

namespace frana {

/// Returns the speed along the bed [m/s] for a velocity (u, v) in map view and the vertical velocity `climb` = v . grad
/// Z.
inline double speed_along_bed(double u, double v, double climb) noexcept {
    return std::sqrt(u * u + v * v + climb * climb);
}

/// Returns the vertical velocity v . grad Z of a velocity in map view [m/s], from the neighbouring nodes.
inline double climb_at(const double *bed, std::int64_t stride, double half_inverse_dx, double u, double v) noexcept {
    return half_inverse_dx * (u * (bed[1] - bed[-1]) + v * (bed[stride] - bed[-stride]));
}

// Formulas for one point (double) and for four (Quad). Always inlined: the fast kernels, compiled for another
// instruction set, must share no function with the rest.

template <class Number>
struct PairOf {
    Number x, y;
};
/// A vector in map view.
template <class Number>
using MapVector = std::conditional_t<std::is_same_v<Number, double>, Point, PairOf<Number>>;

/// Inner product of velocities in map view, measured along a bed of slope grad Z: u . v + (u . grad Z)(v . grad Z).
template <class Number>
struct AlongBedOf {
    Number slope_x, slope_y;

    [[nodiscard, gnu::always_inline]] Number dot(const MapVector<Number> &u, const MapVector<Number> &v) const {
        return u.x * v.x + u.y * v.y + (u.x * slope_x + u.y * slope_y) * (v.x * slope_x + v.y * slope_y);
    }
    [[nodiscard, gnu::always_inline]] Number speed(const MapVector<Number> &v) const {
        using std::sqrt;
        const Number climb = v.x * slope_x + v.y * slope_y;
        return sqrt(v.x * v.x + v.y * v.y + climb * climb);
    }
};
using AlongBed = AlongBedOf<double>;

/// BedFrame::in_map of (x, y).
template <class Number>
[[gnu::always_inline]] inline MapVector<Number> in_map(Number x, Number y, Number slope_x, Number slope_y,
                                                       Number root) {
    const Number climb = (x * slope_x + y * slope_y) / (root * (root + 1));
    return {x - climb * slope_x, y - climb * slope_y};
}

/// Velocities along a bed of slope grad Z, rotated into the horizontal about the contour line:
///
///     w = u + (u . grad Z) grad Z / (root + 1),   root = sqrt(1 + |grad Z|^2),
///
/// so that |w| is the speed along the bed, |w|^2 = |u|^2 + (u . grad Z)^2, for the velocity u in map view. The map is
/// linear, so that on a plane the exchange of either velocity is equivalent; across an edge between planes of any slope
/// w is unchanged.
template <class Number>
struct BedFrameOf {
    Number slope_x = 0.0, slope_y = 0.0, root = 1.0;

    [[gnu::always_inline]] static BedFrameOf of(const MapVector<Number> &slope) {
        using std::sqrt;
        return {slope.x, slope.y, sqrt(1 + slope.x * slope.x + slope.y * slope.y)};
    }
    [[nodiscard, gnu::always_inline]] MapVector<Number> along_bed(Number u, Number v) const {
        const Number climb = (u * slope_x + v * slope_y) / (root + 1);
        return {u + climb * slope_x, v + climb * slope_y};
    }
    [[nodiscard, gnu::always_inline]] MapVector<Number> in_map(Number x, Number y) const {
        return frana::in_map<Number>(x, y, slope_x, slope_y, root);
    }
};
using BedFrame = BedFrameOf<double>;

/// Acceleration that motion over a curved bed adds to gravity [m/s2]:
///
///     load = v . grad grad Z . v = u^2 Z_xx + 2 u v Z_xy + v^2 Z_yy
///
/// u, v velocity in map view [m/s]. The bed then supports (g + load) / sqrt(n) per mass, n = 1 + |grad Z|^2, which is g
/// cos(theta) + speed^2 / radius along the motion: more in hollows, less over edges, 0 instead of negative. It pushes
/// by -(g + load) grad Z / n in map view, which conserves the speed along the bed without friction. Exact for a point
/// mass on a surface (share/doc/model.md, "Curvature").
/// Where the support would be negative, a point mass would leave the bed. The depth-averaged flow stays on it, without
/// friction, and keeps its energy: if its map velocity were kept, as in flight, the steep bed under it would convert it
/// into a higher speed.
/// Second derivatives are those of the quadric through the nine nodes by least squares (Evans 1980, Z. Geomorphol.
/// Suppl. 36, 274), smoother than plain differences by sqrt(3) on noisy terrain.
/// 0 at speed zero; independent of depth.
template <class Number>
struct BedCurvatureOf {
    Number xx = 0.0, xy = 0.0, yy = 0.0;  ///< grad grad Z [1/m]
    Number x = 0.0, y = 0.0;              ///< grad Z by Sobel's weights [-]: across an edge oblique to the grid,
                                          ///< differences along rows and columns alone are off in direction and would
                                          ///< deflect the flow that crosses it (from 45 to 70 degrees by up to 33
                                          ///< degrees; with these by 5)

    [[nodiscard, gnu::always_inline]] Number load(Number u, Number v) const {
        return u * u * xx + 2 * u * v * xy + v * v * yy;
    }
};
using BedCurvature = BedCurvatureOf<double>;

/// @param z bed of the first node; all have eight neighbours
template <class Number>
[[gnu::always_inline]] inline BedCurvatureOf<Number> bed_curvature(const double *z, std::int64_t stride, double dx) {
    const auto at = [](const double *from) __attribute__((always_inline)) {
        return Lanes<Number>::load(from, 4);
    };
    const double *const south = z - stride, *const north = z + stride;
    const Number sw = at(south - 1), sm = at(south), se = at(south + 1), mw = at(z - 1), mm = at(z), me = at(z + 1);
    const Number nw = at(north - 1), nm = at(north), ne = at(north + 1);
    const Number west = sw + mw + nw, east = se + me + ne, below = sw + sm + se, above = nw + nm + ne;
    const double third = 1 / (3 * dx * dx), quarter = 1 / (4 * dx * dx), eighth = 0.125 / dx;
    return {third * (west - 2 * (sm + mm + nm) + east), quarter * (ne + sw - nw - se),
            third * (below - 2 * (mw + mm + me) + above), eighth * (east - west + (me - mw)),
            eighth * (above - below + (nm - sm))};
}

/// @param column, row padded; 0 on the outermost ring, which no particle reaches
inline BedCurvature bed_curvature(const NodeGrid &nodes, std::size_t i, std::int64_t column,
                                  std::int64_t row) noexcept {
    if (column <= 0 || row <= 0 || column >= nodes.stride() - 1 || row >= nodes.padded_rows() - 1) return {};
    return bed_curvature<double>(nodes.bed.data() + i, nodes.stride(), nodes.cell_size());
}

/// Rotates a velocity in map view [m/s] over a time dt by the bed alone. Where the fall line turns along the motion, w
/// turns as well, at the rate
///
///     (grad Z x grad grad Z u) / (root (root + 1)),
///
/// which makes the path a geodesic; its magnitude, the speed along the bed, is unchanged.
template <class Number>
[[gnu::always_inline]] inline void turn_by_bed(const BedCurvatureOf<Number> &k, const BedFrameOf<Number> &frame,
                                               Number dt, MapVector<Number> &u) {
    using std::sqrt;
    const Number rise_x = k.xx * u.x + k.xy * u.y, rise_y = k.xy * u.x + k.yy * u.y;
    const Number root = sqrt(1 + k.x * k.x + k.y * k.y);
    const Number half = 0.5 * dt * (k.x * rise_y - k.y * rise_x) / (root * (root + 1));
    const Number cosine = (1 - half * half) / (1 + half * half), sine = 2 * half / (1 + half * half);
    const MapVector<Number> w = frame.along_bed(u.x, u.y);
    u = frame.in_map(cosine * w.x - sine * w.y, sine * w.x + cosine * w.y);
}

/// The velocity in map view with which a particle moves over `dt` [m/s]: its velocity along the bed stays, but the
/// slope halfway is not that of the start, grad Z + dt/2 grad grad Z u. Positions are of second order with it.
/// @param u velocity in map view at the start, of `frame`
template <class Number>
[[gnu::always_inline]] inline MapVector<Number> velocity_underway(const BedCurvatureOf<Number> &k,
                                                                  const BedFrameOf<Number> &frame, Number dt,
                                                                  const MapVector<Number> &u) {
    const MapVector<Number> along = frame.along_bed(u.x, u.y);
    const Number half = 0.5 * dt;
    return BedFrameOf<Number>::of(
               {frame.slope_x + half * (k.xx * u.x + k.xy * u.y), frame.slope_y + half * (k.xy * u.x + k.yy * u.y)})
        .in_map(along.x, along.y);
}

}  // namespace frana
