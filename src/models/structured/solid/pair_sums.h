// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/quad.h"
#include "models/structured/solid/pair_kernels.h"

namespace frana::structured {
namespace {

// Keeps the lane of the particle itself finite, whose distance is zero and whose gradient vanishes [smoothing lengths].
constexpr double k_least_distance = 1e-9;

/// Calls visit(i) for the particles of a row in cells that are not at rest.
template <class Visit>
inline void for_each_moving(const CellOrder& order, std::int64_t row, const PairWork& w, Visit&& visit) {
    const std::uint8_t* const resting = w.resting.empty() ? nullptr : w.resting.data() + row * order.columns();
    for (std::int64_t column = 0; column < order.columns(); ++column) {
        const ParticleRun own = order.cell(row, column);
        if (own.begin == own.end || (resting != nullptr && resting[column] != 0)) continue;
        for (std::size_t i = own.begin; i < own.end; ++i) visit(i);
    }
}

/// Four particles near particle i, at least one of them within the kernel's radius.
struct NearQuad {
    std::size_t first;       ///< of the four in PairWork
    std::size_t count;       ///< of the four; the others are not of the run
    Quad dx, dy, distance2;  ///< from each of them to particle i [m], [m2]
};

/// Calls add(NearQuad) for the quads of particle i in its row's list.
template <class Add>
inline void for_each_near(const PairWork& w, std::int64_t row, std::size_t i, const Quad& reach2, Add&& add) {
    const Quad x(w[PairWork::x][i]), y(w[PairWork::y][i]);
    const std::uint32_t* const quads = w.near.row(row);
    const NearQuads::Range range = w.near.range(i);
    for (std::uint32_t n = range.begin; n < range.end; ++n) {
        const std::size_t k = NearQuads::first(quads[n]);
        const Quad dx = x - Quad::load(w[PairWork::x] + k), dy = y - Quad::load(w[PairWork::y] + k);
        const Quad distance2 = dx * dx + dy * dy;
        if (any(distance2 < reach2)) add(NearQuad{k, NearQuads::count(quads[n]), dx, dy, distance2});
    }
}

/// L_ab = sum_j A_j (v_j - v_i)_a grad_b W, times the inverse of B = sum_j A_j (x_j - x_i) (x) grad W, which makes it
/// exact for linear velocities (Randles & Libersky 1996). Uncorrected where B is nearly singular: few neighbours, or
/// all in one line, across which the inverse would magnify any difference. The sums of a cohesive particle are over
/// cohesive ones alone, unless it has almost none: a crumb among loose material is strained with that.
void velocity_gradients(const CellOrder& order, std::int64_t row, const CubicKernel& kernel, PairWork& w) {
    // About 0.06 and 0.11 at a corner.
    constexpr double k_least_determinant = 0.01, k_least_of_trace = 0.05, k_alone = 0.1;
    const double length = kernel.length(), scale = kernel.value(0) / (length * length);
    const Quad inverse(1 / length), reach2(4 * length * length);
    // Writes L, with weights of at least `least` times the area; returns the trace of B, inside of material 2.
    const auto gradient_of = [&](std::size_t i, const Quad& least) {
        const Quad u(w[PairWork::u][i]), v(w[PairWork::v][i]);
        Quad l_xx(0.0), l_xy(0.0), l_yx(0.0), l_yy(0.0), b_xx(0.0), b_xy(0.0), b_yy(0.0);
        for_each_near(w, row, i, reach2, [&](const NearQuad& near) {
            const auto& [k, count, dx, dy, distance2] = near;
            const Quad q = sqrt(distance2) * inverse;
            const Quad outer = max(2.0 - q, 0.0), inner = max(1.0 - q, 0.0);
            const Quad slope = (3.0 * inner * inner - 0.75 * outer * outer) / max(q, k_least_distance);
            const auto real = first_lanes(count);
            const Quad area = Quad::load(w[PairWork::area] + k) * max(Quad::load(w[PairWork::bonds] + k), least);
            const Quad weight = select(real, slope * area, 0.0);
            const Quad gx = weight * dx, gy = weight * dy;
            const Quad du = Quad::load(w[PairWork::u] + k) - u, dv = Quad::load(w[PairWork::v] + k) - v;
            l_xx += du * gx;
            l_xy += du * gy;
            l_yx += dv * gx;
            l_yy += dv * gy;
            b_xx += -(dx * gx);
            b_xy += -(dx * gy);
            b_yy += -(dy * gy);
        });
        const double bxx = scale * sum(b_xx), bxy = scale * sum(b_xy), byy = scale * sum(b_yy);
        const double lxx = scale * sum(l_xx), lxy = scale * sum(l_xy);
        const double lyx = scale * sum(l_yx), lyy = scale * sum(l_yy);
        const double determinant = bxx * byy - bxy * bxy;
        const bool enough = determinant >= std::max(k_least_determinant, k_least_of_trace * (bxx + byy));
        const double d = 1 / determinant;
        w[PairWork::l_xx][i] = enough ? d * (lxx * byy - lxy * bxy) : lxx;
        w[PairWork::l_xy][i] = enough ? d * (lxy * bxx - lxx * bxy) : lxy;
        w[PairWork::l_yx][i] = enough ? d * (lyx * byy - lyy * bxy) : lyx;
        w[PairWork::l_yy][i] = enough ? d * (lyy * bxx - lyx * bxy) : lyy;
        return bxx + byy;
    };
    for_each_moving(order, row, w, [&](std::size_t i) {
        const double cohesive = w[PairWork::bonds][i];
        if (gradient_of(i, 1 - cohesive) < k_alone && cohesive > 0) gradient_of(i, 1.0);
    });
}

/// dv_i/dt = sum_j m_j [ T_i + T_j + (F^4 - 1)+ (R_i + R_j) - Pi_ij ] grad_i W,   F = W / W(dp)   (paper, equation 78
/// with the sign of Pi restored; exponent 4 after Monaghan 2000 and Gray et al. 2001). The -1 and the bound at zero are
/// ours: the artificial stress acts only on pairs closer than the spacing dp, that is, on clumping; acting on all pairs
/// it would reduce the tension of evenly spaced material. Every term is symmetric in the pair, so momentum is conserved
/// to rounding.
double accelerations(const CellOrder& order, std::int64_t row, const PairLaws& laws, PairWork& w) {
    const double length = laws.kernel.length(), full = laws.kernel.value(0);
    const double scale = full / (length * length), at_spacing = laws.kernel.value(laws.spacing) / full;
    const Quad inverse(1 / length), inverse_at_spacing(1 / at_spacing);
    const Quad smoothing(length), reach2(4 * length * length), spacing2(laws.spacing * laws.spacing);
    const Quad softening(ArtificialViscosity::k_softening * length * length);
    const Quad linear(0.5 * laws.viscosity.linear), quadratic(laws.viscosity.quadratic);
    Quad least(0.0);
    for_each_moving(order, row, w, [&](std::size_t i) {
        const Quad u(w[PairWork::u][i]), v(w[PairWork::v][i]);
        const Quad density(w[PairWork::density][i]), sound(w[PairWork::sound][i]);
        const Quad t_xx(w[PairWork::t_xx][i]), t_yy(w[PairWork::t_yy][i]), t_xy(w[PairWork::t_xy][i]);
        const Quad r_xx(w[PairWork::r_xx][i]), r_yy(w[PairWork::r_yy][i]), r_xy(w[PairWork::r_xy][i]);
        Quad a_x(0.0), a_y(0.0);
        for_each_near(w, row, i, reach2, [&](const NearQuad& near) {
            const auto& [k, count, dx, dy, distance2] = near;
            const Quad q = sqrt(distance2) * inverse;
            const Quad outer = max(2.0 - q, 0.0), inner = max(1.0 - q, 0.0);
            const Quad outer2 = outer * outer, inner2 = inner * inner;
            const Quad sum_density = density + Quad::load(w[PairWork::density] + k);
            const Quad softened = distance2 + softening, distance = max(q, k_least_distance);
            // One division for all: 1 / (r^2 + ..), 1 / (Sigma_i + Sigma_j) and 1 / q.
            const Quad fraction = 1.0 / (softened * sum_density * distance);
            const Quad approach =
                min((u - Quad::load(w[PairWork::u] + k)) * dx + (v - Quad::load(w[PairWork::v] + k)) * dy, 0.0);
            const Quad phi = smoothing * approach * (fraction * sum_density * distance);
            const Quad sounds = linear * (sound + Quad::load(w[PairWork::sound] + k));  // twice the mean
            const Quad pi = (quadratic * phi - sounds) * phi * (2.0 * fraction * softened * distance);
            const Quad slope = (3.0 * inner2 - 0.75 * outer2) * (fraction * softened * sum_density);
            const auto real = first_lanes(count);
            const auto reached = real & (q < 2.0);
            least = min(least, select(reached, phi, 0.0));
            const Quad weight = select(reached, slope * Quad::load(w[PairWork::mass] + k), 0.0);
            Quad s_xx = t_xx + Quad::load(w[PairWork::t_xx] + k) - pi;
            Quad s_yy = t_yy + Quad::load(w[PairWork::t_yy] + k) - pi;
            Quad s_xy = t_xy + Quad::load(w[PairWork::t_xy] + k);
            if (any(distance2 < spacing2)) {  // one quad in four
                const Quad f = (0.25 * outer2 * outer - inner2 * inner) * inverse_at_spacing;
                const Quad f2 = f * f, nearness = max(f2 * f2 - 1.0, 0.0);
                s_xx += nearness * (r_xx + Quad::load(w[PairWork::r_xx] + k));
                s_yy += nearness * (r_yy + Quad::load(w[PairWork::r_yy] + k));
                s_xy += nearness * (r_xy + Quad::load(w[PairWork::r_xy] + k));
            }
            a_x += weight * (s_xx * dx + s_xy * dy);
            a_y += weight * (s_xy * dx + s_yy * dy);
        });
        w[PairWork::a_x][i] = scale * sum(a_x);
        w[PairWork::a_y][i] = scale * sum(a_y);
    });
    return -(std::min({least[0], least[1], least[2], least[3]}));
}

}  // namespace
}  // namespace frana::structured
