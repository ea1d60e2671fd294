// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "bench/set_up/setup.h"
#include "models/structured/fluid/fluid_step.h"

namespace frana::structured::test {

/// No friction, walls all round, gentle slopes.
inline FluidLaws still_laws() {
    FluidLaws laws;
    laws.wall = true;
    laws.steep = false;
    return laws;
}

/// What stands in a cell at the start.
struct Water {
    double depth = 0, u = 0, v = 0;
};

/// A free fluid with its grid, in local metres.
struct Basin {
    Basin(const Raster& bed, FluidLaws fluid_laws, int threads = 1, const Raster* walls = nullptr)
        : ground(std::make_unique<NodeGrid>(with_walls(bed, walls))),
          laws(std::move(fluid_laws)),
          state(nodes, laws),
          pool(std::make_unique<ThreadPool>(threads)) {}

    void fill(const std::function<Water(Point)>& at) {
        std::vector<FluidSource> sources;
        for_cells([&](Point p, std::size_t cell) {
            const Water w = at(p);
            if (w.depth > 0 && has_fluid(cell)) sources.push_back({cell, w.depth, w.depth * w.u, w.depth * w.v});
        });
        receive(sources, state, laws);
    }
    /// Whether a cell may have fluid: neither wall nor gap.
    [[nodiscard]] bool has_fluid(std::size_t cell) const { return !nodes.is_gap(cell) && !nodes.is_wall(cell); }
    FluidReport advance(double dt) { return structured::advance(state, laws, solid, dt, *pool); }
    [[nodiscard]] double volume() { return fluid_volume(state); }

    template <class Visit>
    void for_cells(const Visit& visit) const {
        for (std::int64_t j = 0; j < nodes.rows(); ++j)
            for (std::int64_t i = 0; i < nodes.columns(); ++i)
                visit(Point{(static_cast<double>(i) + 0.5) * nodes.cell_size(),
                            (static_cast<double>(j) + 0.5) * nodes.cell_size()},
                      nodes.index(i, j));
    }
    /// Velocity of a cell [m/s]; zero under the dry depth.
    [[nodiscard]] double velocity(double depth, double discharge) const {
        return depth > laws.dry ? discharge / depth : 0;
    }
    [[nodiscard]] double depth(std::int64_t i, std::int64_t j) const { return state.now.depth[nodes.index(i, j)]; }
    [[nodiscard]] double u(std::int64_t i, std::int64_t j) const {
        const std::size_t cell = nodes.index(i, j);
        return state.now.depth[cell] > laws.dry ? state.velocity(cell).x : 0;
    }
    /// Greatest speed of any cell [m/s].
    [[nodiscard]] double greatest_speed() const {
        double greatest = 0;
        for_cells([&](Point, std::size_t cell) {
            const double h = state.now.depth[cell];
            const double speed = std::hypot(velocity(h, state.now.qx[cell]), velocity(h, state.now.qy[cell]));
            if (!(speed <= greatest)) greatest = speed;
        });
        return greatest;
    }
    /// sum |h - exact| / sum exact
    [[nodiscard]] double l1_depth(const std::function<double(Point)>& exact) const {
        double error = 0, sum = 0;
        for_cells([&](Point p, std::size_t cell) {
            error += std::abs(state.now.depth[cell] - exact(p));
            sum += exact(p);
        });
        return error / sum;
    }

    std::unique_ptr<NodeGrid> ground;  // so that a basin can be moved
    NodeGrid& nodes = *ground;
    FluidLaws laws;
    FluidState state;
    SolidsOnGrid solid;
    std::unique_ptr<ThreadPool> pool;

  private:
    static NodeGrid with_walls(const Raster& bed, const Raster* walls) {
        NodeGrid grid(bed);
        if (walls != nullptr) grid.mark_walls(*walls);
        return grid;
    }
};

}  // namespace frana::structured::test
