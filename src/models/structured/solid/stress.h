// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/strain.h"

namespace frana::structured {

/// Stress of a column without vertical shear (paper, equation 40), tension positive [Pa].
struct Stress {
    Matrix2d plane = Matrix2d::Zero();
    double zz = 0;

    static Stress isotropic(double pressure) noexcept { return {pressure * Matrix2d::Identity(), pressure}; }

    [[nodiscard]] double xx() const noexcept { return plane(0, 0); }
    [[nodiscard]] double yy() const noexcept { return plane(1, 1); }
    [[nodiscard]] double xy() const noexcept { return plane(0, 1); }

    [[nodiscard]] double i1() const noexcept { return plane.trace() + zz; }
    /// s = sigma - I1 / 3
    [[nodiscard]] Stress deviator() const noexcept {
        const double mean = i1() / 3;
        return {plane - mean * Matrix2d::Identity(), zz - mean};
    }
    /// J2 = s : s / 2 [Pa2].
    [[nodiscard]] double j2() const noexcept {
        const Stress s = deviator();
        return 0.5 * (s.plane.squaredNorm() + s.zz * s.zz);
    }
    friend Stress operator+(const Stress& a, const Stress& b) noexcept { return {a.plane + b.plane, a.zz + b.zz}; }
    friend Stress operator-(const Stress& a, const Stress& b) noexcept { return {a.plane - b.plane, a.zz - b.zz}; }
    friend Stress operator*(double k, const Stress& s) noexcept { return {k * s.plane, k * s.zz}; }
};

}  // namespace frana::structured
