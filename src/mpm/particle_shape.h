// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana {

/// The squared extents Q of a particle, a symmetric tensor [m2].
template <class Number>
struct ParticleShape {
    Number xx, xy, yy;
};

/// Returns F Q F^T, the shape after a motion x -> F x. One formula for one particle (double) and for four (Quad).
/// Always inlined: the fast kernels, compiled for another instruction set, must share no function with the rest.
template <class Number>
[[gnu::always_inline]] inline ParticleShape<Number> deformed(const ParticleShape<Number>& q, Number fxx, Number fxy,
                                                             Number fyx, Number fyy) {
    const Number axx = fxx * q.xx + fxy * q.xy, axy = fxx * q.xy + fxy * q.yy;
    const Number ayx = fyx * q.xx + fyy * q.xy, ayy = fyx * q.xy + fyy * q.yy;
    return {axx * fxx + axy * fxy, axx * fyx + axy * fyy, ayx * fyx + ayy * fyy};
}

}  // namespace frana
