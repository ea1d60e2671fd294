// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/geometry.h"
#include "particles/particle_set.h"

namespace frana::test {

/// Gives the result of fill_outline, to the bit where that uses strips, in time proportional to the square of the
/// number of vertices.
double simple_fill(const MultiPolygon& outline, double spacing, const std::function<double(Point)>& thickness,
                   ParticleSet& particles);

}  // namespace frana::test
