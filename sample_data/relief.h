// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace frana::sample
