// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "models/structured/solid/column_state.h"
#include "models/structured/solid/solid_report.h"
#include "particles/cell_order.h"

namespace frana::structured {

/// Friction exceeds the forces on a particle at rest by this fraction, so that it stays for any length of the next
/// substep, rounding included.
inline constexpr double k_static_margin = 1e-9;
[[nodiscard]] inline bool friction_holds(double ax, double ay, double resistance) noexcept {
    const double limit = (1 - k_static_margin) * resistance;
    return ax * ax + ay * ay <= limit * limit;
}

/// Whether a substep with neighbours that are still too would change nothing of these particles, to the bit: none
/// moves, they flow freely, so that earth pressure, which is part of the push, is their only stress, and friction
/// resists the push of this step. SolidReport::rests says so; if so, the report is the one of such a substep.
///
/// @param mean reference of SolidReport::apart2 [m/s]
template <class Kind>
SolidReport still_report(ParticleRun run, const SolidLaws& laws, Point mean, const ParticleSet& particles) {
    SolidReport report;
    const auto is_zero = [&](Field field, std::size_t p) { return particles[field][p] == 0; };
    for (std::size_t p = run.begin; p < run.end && report.rests; ++p) {
        report.rests = is_zero(Field::u, p) && is_zero(Field::v, p);
        if (!report.rests) break;
        const ParticleLoad column = particle_load<Kind>(laws, particles, p);
        report.rests = flows_freely(laws, column) && is_zero(Field::t_xx, p) && is_zero(Field::t_yy, p) &&
                       is_zero(Field::t_xy, p) && is_zero(Field::t_zz, p) &&
                       (laws.earth_pressure != EarthPressure::passive || is_zero(Field::divergence, p));
        const double ax = particles[Field::push_x][p], ay = particles[Field::push_y][p];
        const double resistance = bed_resistance(laws, column, column.mass / particles[Field::area][p],
                                                 particles[Field::bed_friction][p], particles[Field::flatness][p]);
        report.rests = report.rests && friction_holds(ax, ay, resistance);
        report.apart2 = mean.x * mean.x + mean.y * mean.y;
        report.acceleration2 = std::max(report.acceleration2, ax * ax + ay * ay);
    }
    return report;
}

}  // namespace frana::structured
