// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace frana::sample {

/// Returns smooth random relief of one scale: about -1 to 1, zero on the corners of a unit lattice, the same on every
/// machine. `seed` selects the lattice.
double noise(double x, double y, unsigned seed);

/// Returns relief of several scales, each half as wide and `fraction` as high as the previous one; the first has
/// amplitude 1.
double fractal(double x, double y, unsigned seed, int octaves, double fraction);

/// The same folded upwards, 0 to about 1: sharp crests between rounded hollows, as of weathered rock.
double ridged(double x, double y, unsigned seed, int octaves, double fraction);

/// Returns 0 at `from` and before, 1 at `to` and beyond, smooth between; `to` may be below `from`.
double smooth_step(double from, double to, double value);

/// The steepness of a side or a bed at a distance [m] from its foot.
struct Station {
    double distance, steepness;
};

/// Returns the height at a distance: the integral of the steepness, exact, segment by segment.
template <std::size_t N>
double rise(const std::array<Station, N>& stations, double distance) {
    double height = 0;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        const Station &a = stations[i], &b = stations[i + 1];
        if (distance <= a.distance) return height;
        const double end = std::min(distance, b.distance);
        const double fraction = (end - a.distance) / (b.distance - a.distance);
        const double steepness = a.steepness + fraction * (b.steepness - a.steepness);
        height += 0.5 * (a.steepness + steepness) * (end - a.distance);
    }
    return height + std::max(0.0, distance - stations[N - 1].distance) * stations[N - 1].steepness;
}

}  // namespace frana::sample
