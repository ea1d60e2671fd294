// SPDX-License-Identifier: Apache-2.0
#include "sample_data/relief.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace frana::sample {
namespace {

/// Returns well-mixed bits of a lattice point.
std::uint64_t mixed(std::int64_t column, std::int64_t row, unsigned seed) {
    std::uint64_t bits = static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15U +
                         static_cast<std::uint64_t>(row) * 0xc2b2ae3d27d4eb4fU + seed * 0x165667b19e3779f9U;
    bits ^= bits >> 31;
    bits *= 0xd6e8feb86659fd93U;
    bits ^= bits >> 29;
    bits *= 0xa0761d6478bd642fU;
    return bits ^ (bits >> 32);
}

/// Returns the height at a place from one lattice point's random gradient.
double pull(std::int64_t column, std::int64_t row, double dx, double dy, unsigned seed) {
    const std::uint64_t bits = mixed(column, row, seed);
    const double gx = static_cast<double>(bits & 0xffffU) / 32767.5 - 1;
    const double gy = static_cast<double>((bits >> 16) & 0xffffU) / 32767.5 - 1;
    return gx * dx + gy * dy;
}

double fade(double t) {
    return t * t * t * (t * (6 * t - 15) + 10);
}

}  // namespace

double noise(double x, double y, unsigned seed) {
    const double column = std::floor(x), row = std::floor(y);
    const double dx = x - column, dy = y - row;
    const auto c = static_cast<std::int64_t>(column), r = static_cast<std::int64_t>(row);
    const double u = fade(dx), v = fade(dy);
    const double south = (1 - u) * pull(c, r, dx, dy, seed) + u * pull(c + 1, r, dx - 1, dy, seed);
    const double north = (1 - u) * pull(c, r + 1, dx, dy - 1, seed) + u * pull(c + 1, r + 1, dx - 1, dy - 1, seed);
    return 1.6 * ((1 - v) * south + v * north);
}

double fractal(double x, double y, unsigned seed, int octaves, double fraction) {
    double sum = 0, height = 1, scale = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += height * noise(x * scale, y * scale, seed + static_cast<unsigned>(octave));
        height *= fraction;
        scale *= 2;
    }
    return sum;
}

double ridged(double x, double y, unsigned seed, int octaves, double fraction) {
    double sum = 0, height = 1, scale = 1, total = 0;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += height * (1 - std::abs(noise(x * scale, y * scale, seed + static_cast<unsigned>(octave))));
        total += height;
        height *= fraction;
        scale *= 2;
    }
    return sum / total;
}

double smooth_step(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace frana::sample
