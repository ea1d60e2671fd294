// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::sample {

/// Smooth random relief of one scale: about -1 to 1, zero on the corners of a unit lattice, the same on every
/// machine. `seed` chooses the lattice.
double noise(double x, double y, unsigned seed);

/// Relief of several scales, each half as wide and `share` as high as the one before; the first has
/// amplitude 1.
double fractal(double x, double y, unsigned seed, int octaves, double fraction);

/// The same folded upwards, 0 to about 1: sharp crests between rounded hollows, as weathered rock shows.
double ridged(double x, double y, unsigned seed, int octaves, double fraction);

/// 0 at `from` and before, 1 at `to` and beyond, smooth between; `to` may lie below `from`.
double smooth_step(double from, double to, double value);

}  // namespace frana::sample
