// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "models/structured/solid/pair_work.h"
#include "models/structured/solid/rest.h"
#include "models/structured/solid/solid_report.h"
#include "mpm/node_grid.h"
#include "particles/cell_order.h"
#include "particles/particle_set.h"

namespace frana::structured {

/// Places closed to particles: cells that are walls, and the outside of edges that are walls.
struct Obstacles {
    const NodeGrid* nodes = nullptr;
    bool edges = false;
    bool gaps_are_walls = false;

    [[nodiscard]] bool none() const noexcept { return !edges && !nodes->any_solid(); }
    [[nodiscard]] bool at(double x, double y) const noexcept {
        if (!nodes->bounds().contains(x, y)) return edges;
        const std::size_t node = nodes->scale().node_of(x, y);
        return nodes->is_wall(node) || (gaps_are_walls && nodes->is_gap(node));
    }
};

/// New velocities and places after dt: accelerations, then bed friction, which can stop but not reverse a particle,
/// then the motion with the new velocity. A particle that would enter an obstacle loses the velocity component towards
/// it and keeps its place in that direction; walls are smooth.
///
/// Reads a_*, resistance, l_* of `w`, push_*; writes x, y, u, v, area there and in the particles.
/// @param widest greatest area of a column [m2]: its neighbours' velocity gradients weigh it with its area, which would
/// grow without bound where neighbours are few
/// @param mean a velocity near that of most particles, the reference of SolidReport::apart2 [m/s]
inline SolidReport move_particles(ParticleRun run, double dt, const Obstacles& obstacles, double widest, Point mean,
                                  ParticleSet& particles, PairWork& w) {
    SolidReport report;
    const bool open = obstacles.none();
    for (std::size_t p = run.begin; p < run.end; ++p) {
        const double ax = w[PairWork::a_x][p] + particles[Field::push_x][p];
        const double ay = w[PairWork::a_y][p] + particles[Field::push_y][p];
        double u = w[PairWork::u][p] + dt * ax, v = w[PairWork::v][p] + dt * ay;
        const double speed = std::sqrt(u * u + v * v), loss = dt * w[PairWork::resistance][p];
        const double kept = speed > loss ? 1 - loss / speed : 0;
        u = kept > 0 ? kept * u : 0;  // never -0: what rests has the same bits whatever pushes it
        v = kept > 0 ? kept * v : 0;
        double x = w[PairWork::x][p] + dt * u, y = w[PairWork::y][p] + dt * v;
        if (!open && obstacles.at(x, y)) {
            const double x0 = w[PairWork::x][p], y0 = w[PairWork::y][p];
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
        // Non-finite particles keep their place for the report; the run ends after this step.
        const bool finite = std::isfinite(x + y + u * u + v * v);
        if (!finite) {
            x = w[PairWork::x][p];
            y = w[PairWork::y][p];
        }
        const double half = 0.5 * dt * (w[PairWork::l_xx][p] + w[PairWork::l_yy][p]);
        const bool sane = std::abs(half) < 0.5;
        double& area = particles[Field::area][p];
        if (sane) area = std::min(area * ((1 + half) / (1 - half)), std::max(area, widest));
        report.clamped += sane ? 0 : 1;
        particles[Field::x][p] = w[PairWork::x][p] = x;
        particles[Field::y][p] = w[PairWork::y][p] = y;
        particles[Field::u][p] = w[PairWork::u][p] = u;
        particles[Field::v][p] = w[PairWork::v][p] = v;
        w[PairWork::area][p] = particles[Field::area][p];
        const double speed2 = u * u + v * v;
        const double apart2 = (u - mean.x) * (u - mean.x) + (v - mean.y) * (v - mean.y);
        report.speed2 = std::max(report.speed2, speed2);
        report.apart2 = std::max(report.apart2, apart2);
        report.acceleration2 = std::max(report.acceleration2, ax * ax + ay * ay);
        report.non_finite += finite ? 0 : 1;
        report.rests = report.rests && speed2 == 0 && friction_holds(ax, ay, w[PairWork::resistance][p]);
    }
    return report;
}

}  // namespace frana::structured
