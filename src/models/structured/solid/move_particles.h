// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "models/structured/solid/solid_report.h"
#include "models/structured/solid/solid_work.h"
#include "models/structured/solid/stress_nodes.h"
#include "mpm/ground_walls.h"
#include "mpm/node_grid.h"
#include "particles/cell_order.h"
#include "particles/particle_set.h"

namespace frana::structured {

/// Places closed to particles: cells that are walls, and the outside of edges that are walls.
struct Obstacles {
    const NodeGrid* nodes = nullptr;
    bool edges = false;
    bool gaps_are_walls = false;
    double critical = 0;  ///< sqrt(g) [m^(1/2)/s]; of walls of the ground (mpm/ground_walls.h)

    [[nodiscard]] bool none() const noexcept { return !edges && !nodes->any_solid(); }
    [[nodiscard]] bool at(double x, double y) const noexcept {
        if (!nodes->bounds().contains(x, y)) return edges;
        const std::size_t node = nodes->scale().node_of(x, y);
        return nodes->is_wall(node) || (gaps_are_walls && nodes->is_gap(node));
    }
};

/// Friction exceeds the forces on a particle at rest by this fraction, so that it stays for any length of the next
/// substep, rounding included.
inline constexpr double k_static_margin = 1e-9;

/// Greatest logarithm by which a particle's area changes in a substep; substeps are four times shorter
/// (stable_substep), but what meets within one is seen after it.
inline constexpr double k_greatest_growth = 2;

/// New velocities and places after dt: accelerations, then bed friction, which can stop but not reverse a particle. It
/// takes over the nodes' velocity while a wave crosses their spacing, as in the first model whatever the substep, and
/// moves with the very field whose gradients strained it: where particles moved with their own velocities instead, what
/// alternates from one to the next would leave stress that no force balances (ours). A particle that would enter an
/// obstacle loses the velocity component towards it and keeps its place in that direction; walls are smooth.
///
/// Reads the forces on the nodes, resistance, sound, opening in `w`, push_*; writes x, y, u, v, c_*, area.
/// @param wave_cfl fraction of the nodes' spacing that waves cross in the longest substep
/// @param widest greatest area of a column [m2]: its neighbours' velocity gradients weigh it with its area, which would
/// grow without bound where neighbours are few
/// @param mean a velocity near that of most particles, the reference of SolidReport::apart2 [m/s]
inline SolidReport move_particles(ParticleRun run, double dt, double wave_cfl, const Obstacles& obstacles,
                                  double widest, Point mean, StressNodes& nodes, const SolidWork& w,
                                  ParticleSet& particles) {
    SolidReport report;
    const bool open = obstacles.none();
    for (std::size_t p = run.begin; p < run.end; ++p) {
        const double x0 = particles[Field::x][p], y0 = particles[Field::y][p];
        const double u0 = particles[Field::u][p], v0 = particles[Field::v][p];
        const NodeMotion motion = nodes.motion(nodes.at(x0, y0), dt, w[SolidWork::bonds][p] > 0);
        const double ax = motion.ax + particles[Field::push_x][p], ay = motion.ay + particles[Field::push_y][p];
        const double blend = std::min(1.0, dt * w[SolidWork::sound][p] / (wave_cfl * nodes.side()));
        double u = u0 + dt * ax + blend * (motion.u - u0), v = v0 + dt * ay + blend * (motion.v - v0);
        const double speed = std::sqrt(u * u + v * v), loss = dt * w[SolidWork::resistance][p];
        const double kept = speed > loss ? 1 - loss / speed : 0;
        u = kept > 0 ? kept * u : 0;  // never -0: what rests has the same bits whatever pushes it
        v = kept > 0 ? kept * v : 0;
        // What the bed holds turns and stretches with nothing around it.
        particles[Field::c_xx][p] = kept > 0 ? motion.c_xx : 0;
        particles[Field::c_xy][p] = kept > 0 ? motion.c_xy : 0;
        particles[Field::c_yx][p] = kept > 0 ? motion.c_yx : 0;
        particles[Field::c_yy][p] = kept > 0 ? motion.c_yy : 0;
        double x = x0 + dt * motion.u, y = y0 + dt * motion.v;
        if (!open && obstacles.at(x, y)) {
            const bool x_blocked = obstacles.at(x, y0), y_blocked = obstacles.at(x0, y) || !x_blocked;
            if (x_blocked) {
                x = x0;
                u = 0;
            }
            if (y_blocked) {
                y = y0;
                v = 0;
            }
        }
        Point to{x, y};
        const double depth = particles[Field::volume][p] / particles[Field::area][p];
        const Kept beside = keep_at_walls(*obstacles.nodes, depth, dt * obstacles.critical, {x0, y0}, to);
        x = to.x;
        y = to.y;
        if (beside.x < 1) u = beside.x > 0 ? beside.x * u : 0;
        if (beside.y < 1) v = beside.y > 0 ? beside.y * v : 0;
        const double volume = particles[Field::volume][p];
        report.walls.merge({volume * beside.part.met, volume * beside.part.passed});
        // Non-finite particles keep their place for the report; the run ends after this step.
        const bool finite = std::isfinite(x + y + u * u + v * v);
        const double opening = w[SolidWork::opening][p], growth = dt * opening;
        const bool sane = std::abs(growth) < k_greatest_growth;
        double& area = particles[Field::area][p];
        if (sane) area = std::min(area * std::exp(growth), std::max(area, widest));
        report.clamped += sane ? 0 : 1;
        particles[Field::x][p] = finite ? x : x0;
        particles[Field::y][p] = finite ? y : y0;
        particles[Field::u][p] = u;
        particles[Field::v][p] = v;
        const double speed2 = u * u + v * v, acceleration2 = ax * ax + ay * ay;
        const auto apart2 = [&](double a, double b) {
            return (a - mean.x) * (a - mean.x) + (b - mean.y) * (b - mean.y);
        };
        const double holds = (1 - k_static_margin) * w[SolidWork::resistance][p];
        report.speed2 = std::max(report.speed2, speed2);
        report.apart2 = std::max({report.apart2, apart2(u, v), apart2(motion.u, motion.v)});
        report.acceleration2 = std::max(report.acceleration2, acceleration2);
        report.opening = std::max(report.opening, std::abs(opening));
        report.non_finite += finite ? 0 : 1;
        report.rests = report.rests && speed2 == 0 && acceleration2 <= holds * holds;
    }
    return report;
}

}  // namespace frana::structured
