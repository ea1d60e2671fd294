// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace frana {

/// Lets one formula serve one value (double) and four (Quad, core/quad.h): comparisons return a Mask, which select, any
/// and count use. Everything is always inlined: the fast kernels, compiled for another instruction set, must share no
/// function with the rest.
template <class Number>
struct Lanes;

/// double or Quad; any other type (the int 0) does not compile.
template <class Number>
concept LaneNumber = requires {
    typename Lanes<Number>::Mask;
};

template <>
struct Lanes<double> {
    using Mask = bool;
    using Count = std::int64_t;

    [[gnu::always_inline]] static Mask first(std::size_t) { return true; }
    [[gnu::always_inline]] static Mask none(Mask m) { return !m; }
    [[gnu::always_inline]] static bool any(Mask m) { return m; }
    [[gnu::always_inline]] static bool at(Mask m, int) { return m; }
    [[gnu::always_inline]] static double at(double a, int) { return a; }
    [[gnu::always_inline]] static void set(double& a, int, double value) { a = value; }
    [[gnu::always_inline]] static double load(const double* from, std::size_t) { return *from; }
    [[gnu::always_inline]] static void store(double a, double* to, std::size_t) { *to = a; }
    /// Stores {a, b, c, d} of each of the first n lanes that are `real` from `to` on, `step` apart.
    [[gnu::always_inline]] static void store_rows(double a, double b, double c, double d, Mask real, std::size_t,
                                                  double* to, std::size_t) {
        if (!real) return;
        to[0] = a;
        to[1] = b;
        to[2] = c;
        to[3] = d;
    }
    [[gnu::always_inline]] static void add(Count& count, Mask m) { count += m ? 1 : 0; }
    [[gnu::always_inline]] static std::int64_t total(Count count) { return count; }
    [[gnu::always_inline]] static double greatest(double a) { return a; }
    [[gnu::always_inline]] static double sum(double a) { return a; }
};

[[gnu::always_inline]] inline double select(bool where, double a, double b) {
    return where ? a : b;
}

/// 0 up to `from`, 1 beyond `to`, smooth between; or falling, if `to` is the lesser.
template <class Number>
[[gnu::always_inline]] inline Number smooth_step(Number from, Number to, Number value) {
    using std::max;
    using std::min;
    const Number t = min(max((value - from) / (to - from), Number(0.0)), Number(1.0));
    return t * t * (3 - 2 * t);
}

}  // namespace frana
