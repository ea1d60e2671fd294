// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <memory>

#include "bench/set_up/setup.h"
#include "mpm/boundary.h"
#include "mpm/shape.h"
#include "physics/laws.h"
#include "simulation/flow.h"

namespace frana::test {

inline constexpr double k_gravity = 9.81;

/// No friction, no stress.
inline Material water() {
    Material material;
    material.density = 1000;
    material.of<CoulombFriction>().friction_coefficient = 0;
    return material;
}

inline Material dry_friction(double angle_deg) {
    Material material = water();
    material.of<CoulombFriction>().friction_coefficient = std::tan(angle_deg * M_PI / 180);
    return material;
}

inline Numerics numerics(Scheme scheme, SlopeCorrection slope, Boundary boundary) {
    Numerics n;
    n.scheme = scheme;
    n.slope_correction = slope;
    n.boundary = boundary;
    return n;
}

/// Bed elevation by the default scheme: quadratic splines from the nodes.
inline std::function<double(Point)> spline_bed(const Raster& bed, Boundary boundary) {
    auto nodes = std::make_shared<NodeGrid>(bed);
    if (boundary == Boundary::wall) mirror_bed(*nodes);
    return [nodes](Point local) {
        const Stencil<QuadraticSplineShape> stencil(local.x, local.y, nodes->scale());
        return interpolate(stencil, nodes->bed.data(), nodes->stride()).value + nodes->datum();
    };
}

/// Greatest |v| of any particle [m/s].
inline double greatest_speed(const Flow& flow) {
    double speed = 0;
    const ParticleSet& p = flow.particles();
    for (std::size_t i = 0; i < p.size(); ++i) speed = std::max(speed, std::hypot(p[Field::u][i], p[Field::v][i]));
    return speed;
}

}  // namespace frana::test
