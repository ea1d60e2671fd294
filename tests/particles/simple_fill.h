// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/geometry.h"
#include "particles/particle_set.h"

namespace frana::test {

/// What fill_outline does, to the bit where it goes by strips, in time that grows with the square of the
/// vertices.
double simple_fill(const MultiPolygon& outline, double spacing, const std::function<double(Point)>& thickness,
                   ParticleSet& particles);

}  // namespace frana::test
