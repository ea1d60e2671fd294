// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace frana::structured {

/// Stress of a column that carries no vertical shear (paper, equation 40), tension positive [Pa].
struct Stress {
    double xx = 0, yy = 0, zz = 0, xy = 0;

    [[nodiscard]] double i1() const noexcept { return xx + yy + zz; }
    /// Second invariant of the deviator [Pa2].
    [[nodiscard]] double j2() const noexcept {
        const double mean = i1() / 3, a = xx - mean, b = yy - mean, c = zz - mean;
        return 0.5 * (a * a + b * b + c * c) + xy * xy;
    }
    friend Stress operator+(const Stress& a, const Stress& b) noexcept {
        return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy};
    }
    friend Stress operator-(const Stress& a, const Stress& b) noexcept {
        return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy};
    }
};

/// Velocity gradient in the plane, L_ab = dv_a / dx_b [1/s].
struct VelocityGradient {
    double xx = 0, xy = 0, yx = 0, yy = 0;

    [[nodiscard]] double divergence() const noexcept { return xx + yy; }
    /// Shear component of the strain rate, and angular velocity, counter-clockwise positive [1/s].
    [[nodiscard]] double shear() const noexcept { return 0.5 * (xy + yx); }
    [[nodiscard]] double spin() const noexcept { return 0.5 * (yx - xy); }
};

/// Turns a stress with its material by `angle` [rad], exactly: R sigma R^T keeps the invariants, which the explicit
/// Jaumann rate does not (share/doc/structured.md, "Solids with confined fluid").
inline Stress rotated(const Stress& s, double angle) noexcept {
    if (angle == 0) return s;  // to the bit
    const double turn = 2 * angle;
    double sine, cosine;
    if (std::abs(turn) < 0.02) {  // to all digits of a double there
        const double t2 = turn * turn;
        sine = turn * (1 - t2 / 6 * (1 - t2 / 20 * (1 - t2 / 42)));
        cosine = 1 - t2 / 2 * (1 - t2 / 12 * (1 - t2 / 30 * (1 - t2 / 56)));
    } else {
        sine = std::sin(turn);
        cosine = std::cos(turn);
    }
    const double mean = 0.5 * (s.xx + s.yy), half = 0.5 * (s.xx - s.yy);
    const double half_turned = half * cosine - s.xy * sine;
    return {mean + half_turned, mean - half_turned, s.zz, half * sine + s.xy * cosine};
}

}  // namespace frana::structured
