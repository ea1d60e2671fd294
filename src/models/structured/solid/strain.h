// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace frana::structured {

using Eigen::Matrix2d;

/// A tensor in the plane (with lists of lists, Eigen's constructor would loop), and a symmetric one.
inline Matrix2d tensor(double xx, double xy, double yx, double yy) noexcept {
    Matrix2d m;
    m << xx, xy, yx, yy;
    return m;
}
inline Matrix2d symmetric(double xx, double yy, double xy) noexcept {
    return tensor(xx, xy, xy, yy);
}

/// Rate of strain e = (L + L^T) / 2 of a velocity gradient in the plane, L_ab = dv_a / dx_b [1/s] (paper, equation 12
/// corrected), and angular velocity, counter-clockwise positive, of (L - L^T) / 2.
inline Matrix2d strain_rate(const Matrix2d& l) noexcept {
    return 0.5 * (l + l.transpose());
}
inline double spin(const Matrix2d& l) noexcept {
    return 0.5 * (l(1, 0) - l(0, 1));
}

/// Matrix of a rotation by `angle` [rad].
inline Matrix2d rotation(double angle) noexcept {
    double sine, cosine;
    if (std::abs(angle) < 0.02) {  // to all digits of a double in this range
        const double a2 = angle * angle;
        sine = angle * (1 - a2 / 6 * (1 - a2 / 20 * (1 - a2 / 42)));
        cosine = 1 - a2 / 2 * (1 - a2 / 12 * (1 - a2 / 30 * (1 - a2 / 56)));
    } else {
        sine = std::sin(angle);
        cosine = std::cos(angle);
    }
    return tensor(cosine, -sine, sine, cosine);
}

/// R s R^T, a symmetric tensor rotated with its material. Its invariants are conserved, unlike with the explicit
/// Jaumann rate (share/doc/structured.md, "Solids with confined fluid").
inline Matrix2d rotated(const Matrix2d& s, const Matrix2d& rotation) noexcept {
    return rotation * s * rotation.transpose();
}

}  // namespace frana::structured
