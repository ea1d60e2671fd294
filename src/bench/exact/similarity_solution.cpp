// SPDX-License-Identifier: Apache-2.0
#include "bench/exact/similarity_solution.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frana::bench {
namespace {

using Variables = std::array<double, 4>;  // f, f', g, g'

Variables plus(const Variables& a, double dt, const Variables& b) {
    return {a[0] + dt * b[0], a[1] + dt * b[1], a[2] + dt * b[2], a[3] + dt * b[3]};
}

}  // namespace

SimilaritySolution::SimilaritySolution(double slope_deg, double friction_deg, double height, double radius, double time,
                                       double earth_pressure)
    : height_(height), radius_(radius) {
    const double normal = k_gravity * std::cos(slope_deg * k_degree);
    const double friction = normal * std::tan(friction_deg * k_degree);
    const double drive = k_gravity * std::sin(slope_deg * k_degree) - friction;
    const double spread = 2 * earth_pressure * normal * height / (radius * radius);
    const auto rate = [&](double t, const Variables& y) {
        return Variables{y[1], spread / (y[0] * y[0] * y[2]), y[3],
                         spread / (y[0] * y[2] * y[2]) - friction * y[3] / (drive * t)};
    };
    // At the start g' = r t with r = spread - friction r / drive, since u = drive t.
    const double start = 1e-6 * time, sideways = spread * drive / (drive + friction);
    Variables y{1 + 0.5 * spread * start * start, spread * start, 1 + 0.5 * sideways * start * start, sideways * start};
    // Steps that grow with time: the rate of the sideways friction is friction / (drive t).
    for (double t = start; t < time;) {
        const double dt = std::min({0.01 * t, 1e-3 * time, time - t});
        const Variables k1 = rate(t, y), k2 = rate(t + 0.5 * dt, plus(y, 0.5 * dt, k1));
        const Variables k3 = rate(t + 0.5 * dt, plus(y, 0.5 * dt, k2)), k4 = rate(t + dt, plus(y, dt, k3));
        for (std::size_t i = 0; i < 4; ++i) y[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        if (time - t <= dt) break;
        t += dt;
    }
    f_ = y[0];
    f_rate_ = y[1];
    g_ = y[2];
    g_rate_ = y[3];
    middle_ = 0.5 * drive * time * time;
    speed_ = drive * time;
}

ExactState SimilaritySolution::at(Point place) const {
    const double x = place.x - middle_, y = place.y;
    const double a = x / (radius_ * f_), b = y / (radius_ * g_), depth = height_ / (f_ * g_) * (1 - a * a - b * b);
    if (!(depth > 0)) return {};
    return {depth, depth * (speed_ + x * f_rate_ / f_), depth * y * g_rate_ / g_};
}

}  // namespace frana::bench
