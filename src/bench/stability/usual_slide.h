// SPDX-License-Identifier: Apache-2.0
// From the usual slide to hard cases, for the lists of them.
#pragma once

#include "bench/stability/stability.h"

namespace frana::bench {

/// Returns the scene of which most cases change one property: a slope of 1 : 2 that ends in level ground at x = 80 m, a
/// grid of 160 m x 80 m in cells of 2 m, a cap 3 m deep and 15 m in radius at (30, 40) m, phi = 15 degrees, xi = 500
/// m/s2, open sides, slope correction `normal`.
Setup usual_slide(const Variant& variant = {});
/// Returns the same on other ground.
Setup usual_slide_on(const Variant& variant, double cell_size, const std::function<double(Point)>& bed);
/// Depth of the usual cap [m].
double usual_cap(Point place);
/// Elevation of the usual slope [m].
double usual_slope(Point place);

using Change = std::function<void(Setup&)>;
using Surface = std::function<double(Point)>;

/// The usual slide on other ground, with a change.
HardCase slide_on(const char* name, const char* what, double end, const Surface& bed, const Change& change = {},
                  double cell = 2);
HardCase slide(const char* name, const char* what, double end, const Change& change);
/// A case with other variants and figures.
HardCase of(HardCase one, unsigned variants, unsigned figures = k_usual,
            std::function<Figure(const Setup&, TimedFlow&)> own = {});
/// Other material at the start.
Change seeded(const std::function<Seed(Point)>& state);
/// One change, then the other.
Change both(const Change& first, const Change& second);
void as_water(Setup& setup);
void walled(Setup& setup);

}  // namespace frana::bench
