// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

#include "core/lanes.h"

namespace frana {

// Four doubles in one value: one 256-bit register where the instruction set has them, two of 128 bits elsewhere (SSE2,
// NEON). The type is in an unnamed namespace: sources compiled for different instruction sets must not share a single
// function, or the linker might keep the wrong one.
namespace {

#define FRANA_INLINE inline __attribute__((always_inline))
#define FRANA_INLINE_LAMBDA __attribute__((always_inline))

struct Quad {
    using Lanes [[gnu::vector_size(32)]] = double;
    using Mask [[gnu::vector_size(32)]] = long long;
    Lanes v;

    Quad() = default;  // cppcheck-suppress uninitMemberVar; filled lane by lane afterwards
    FRANA_INLINE Quad(double s) : v{s, s, s, s} {}
    FRANA_INLINE Quad(double a, double b, double c, double d) : v{a, b, c, d} {}
    FRANA_INLINE explicit Quad(Lanes lanes) : v(lanes) {}

    static FRANA_INLINE Quad load(const double* from) {
        Quad q;
        std::memcpy(&q.v, from, sizeof q.v);
        return q;
    }
    FRANA_INLINE void store(double* to) const { std::memcpy(to, &v, sizeof v); }
    FRANA_INLINE double operator[](int lane) const { return v[lane]; }

    friend FRANA_INLINE Quad operator+(Quad a, Quad b) { return Quad(a.v + b.v); }
    friend FRANA_INLINE Quad operator-(Quad a, Quad b) { return Quad(a.v - b.v); }
    friend FRANA_INLINE Quad operator*(Quad a, Quad b) { return Quad(a.v * b.v); }
    friend FRANA_INLINE Quad operator/(Quad a, Quad b) { return Quad(a.v / b.v); }
    friend FRANA_INLINE Quad operator-(Quad a) { return Quad(-a.v); }
    FRANA_INLINE Quad& operator+=(Quad b) { return *this = *this + b; }
    friend FRANA_INLINE Mask operator<(Quad a, Quad b) { return a.v < b.v; }
    friend FRANA_INLINE Mask operator>(Quad a, Quad b) { return a.v > b.v; }
    friend FRANA_INLINE Mask operator>=(Quad a, Quad b) { return a.v >= b.v; }
};

FRANA_INLINE Quad select(Quad::Mask where, Quad a, Quad b) {
    return Quad(where ? a.v : b.v);
}
// As std::max and std::min: returns the first argument if the two are unordered or equal. AVX has an instruction for
// each, with the same bits, which compilers do not use by themselves.
FRANA_INLINE Quad max(Quad a, Quad b) {
#if defined(__AVX__)
    return Quad(__builtin_ia32_maxpd256(b.v, a.v));
#else
    return select(a < b, b, a);
#endif
}
FRANA_INLINE Quad min(Quad a, Quad b) {
#if defined(__AVX__)
    return Quad(__builtin_ia32_minpd256(b.v, a.v));
#else
    return select(b < a, b, a);
#endif
}
FRANA_INLINE Quad abs(Quad a) {
    return max(a, -a);
}
FRANA_INLINE Quad sqrt(Quad a) {
    return {__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
}
FRANA_INLINE Quad floor(Quad a) {
    return {__builtin_floor(a[0]), __builtin_floor(a[1]), __builtin_floor(a[2]), __builtin_floor(a[3])};
}
/// Number of true lanes, for sums of masks (true is -1).
FRANA_INLINE long long count(Quad::Mask m) {
    return -(m[0] + m[1] + m[2] + m[3]);
}
FRANA_INLINE bool any(Quad::Mask m) {
#if defined(__AVX__)
    return __builtin_ia32_movmskpd256(reinterpret_cast<Quad::Lanes>(m)) != 0;  // lanes are all bits or none
#else
    const Quad::Mask halves = m | __builtin_shufflevector(m, m, 2, 3, 0, 1);
    return (halves[0] | halves[1]) != 0;
#endif
}
FRANA_INLINE Quad::Mask first_lanes(std::size_t n) {
    const Quad::Mask lane{0, 1, 2, 3};
    const auto limit = static_cast<long long>(n);
    return lane < Quad::Mask{limit, limit, limit, limit};
}
/// The greatest lane.
FRANA_INLINE double greatest(Quad a) {
    double r = a[0];
    for (int i = 1; i < 4; ++i) r = r < a[i] ? a[i] : r;
    return r;
}
FRANA_INLINE double sum(Quad a) {
    return (a[0] + a[2]) + (a[1] + a[3]);
}
/// The sum of all lanes, in every lane.
FRANA_INLINE Quad sum_everywhere(Quad a) {
    const Quad halves = a + Quad(__builtin_shufflevector(a.v, a.v, 2, 3, 0, 1));
    return halves + Quad(__builtin_shufflevector(halves.v, halves.v, 1, 0, 3, 2));
}
FRANA_INLINE void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
    const auto ab_even = __builtin_shufflevector(a.v, b.v, 0, 4, 2, 6);
    const auto ab_odd = __builtin_shufflevector(a.v, b.v, 1, 5, 3, 7);
    const auto cd_even = __builtin_shufflevector(c.v, d.v, 0, 4, 2, 6);
    const auto cd_odd = __builtin_shufflevector(c.v, d.v, 1, 5, 3, 7);
    a.v = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
    b.v = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
    c.v = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
    d.v = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// The first two lanes of both.
FRANA_INLINE Quad first_halves(Quad a, Quad b) {
    return Quad(__builtin_shufflevector(a.v, b.v, 0, 1, 4, 5));
}

/// The first n (1 to 4) of four values; the others repeat the first. Stores the first n only.
FRANA_INLINE Quad load_some(const double* from, std::size_t n) {
    if (n == 4) return Quad::load(from);
    Quad q(from[0]);
    for (std::size_t i = 1; i < n; ++i) q.v[i] = from[i];
    return q;
}
FRANA_INLINE void store_some(Quad q, double* to, std::size_t n) {
    if (n == 4) return q.store(to);
    for (std::size_t i = 0; i < n; ++i) to[i] = q.v[i];
}

/// Calls work(p, n) over a range of values, with n = 4 as long as possible and then with the rest; the 4 is a
/// compile-time constant.
template <class Work>
FRANA_INLINE void for_chunks(std::size_t begin, std::size_t end, const Work& work) {
    std::size_t p = begin;
    for (; p + 4 <= end; p += 4) work(p, std::integral_constant<std::size_t, 4>{});
    if (p < end) work(p, end - p);
}

}  // namespace

template <>
struct Lanes<Quad> {
    using Mask = Quad::Mask;
    using Count = Quad::Mask;  // downwards: true is -1

    static FRANA_INLINE Mask first(std::size_t n) { return first_lanes(n); }
    static FRANA_INLINE Mask none(Mask m) { return ~m; }
    static FRANA_INLINE bool any(Mask m) { return frana::any(m); }
    static FRANA_INLINE bool at(Mask m, int lane) { return m[lane] != 0; }
    static FRANA_INLINE double at(Quad a, int lane) { return a[lane]; }
    static FRANA_INLINE void set(Quad& a, int lane, double value) { a.v[lane] = value; }
    static FRANA_INLINE Quad load(const double* from, std::size_t n) { return load_some(from, n); }
    static FRANA_INLINE void store(Quad a, double* to, std::size_t n) { store_some(a, to, n); }
    static FRANA_INLINE void store_rows(Quad a, Quad b, Quad c, Quad d, Mask real, std::size_t n, double* to,
                                        std::size_t step) {
        transpose(a, b, c, d);
        const Quad rows[4] = {a, b, c, d};
        for (std::size_t i = 0; i < n; ++i)
            if (real[static_cast<int>(i)] != 0) rows[i].store(to + i * step);
    }
    static FRANA_INLINE void add(Count& count, Mask m) { count += m; }
    static FRANA_INLINE std::int64_t total(Count count) { return frana::count(count); }
    static FRANA_INLINE double greatest(Quad a) { return frana::greatest(a); }
    static FRANA_INLINE double sum(Quad a) { return frana::sum(a); }
};

}  // namespace frana
