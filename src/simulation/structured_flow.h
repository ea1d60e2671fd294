// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"
#include "core/thread_pool.h"
#include "models/structured/fluid/fluid_step.h"
#include "mpm/maxima.h"
#include "particles/particle_set.h"
#include "simulation/scene.h"
#include "simulation/step_figures.h"

namespace frana {

/// The structured model as a run drives it: the engine without scenes, files and clocks; Flow's counterpart.
class StructuredFlow {
  public:
    /// After a step the cells show the moment it ended.
    static constexpr bool k_shows_end = true;

    /// @param bed elevation [m], NaN where there is none
    StructuredFlow(const Raster& bed, const StructuredMaterial& material, const Numerics& numerics, int threads);

    /// Marks where walls stand: 1 in a raster on the same grid. Before anything flows.
    void add_walls(const Raster& walls);
    /// Adds what particles hold, volume and momentum, to the cells they lie in.
    void add_particles(const ParticleSet& particles);
    /// Takes ground away between two steps: depth in each cell [m], NaN for none.
    void lower_bed(const Raster& depth);
    void set_origin(Point origin) { origin_ = origin; }
    void set_moving_speed(double speed) { moving_speed_ = speed; }
    void set_time(double time) { time_ = time; }

    /// Longest step the present state allows [s]; no longer than the stiffest wave of the minimum depth would take, so
    /// that an empty map is watched too.
    [[nodiscard]] double stable_step();
    StepFigures advance(double dt_limit);
    void synchronise() {}  // velocities are never behind

    [[nodiscard]] double time() const noexcept { return time_; }
    [[nodiscard]] std::int64_t steps() const noexcept { return steps_; }
    [[nodiscard]] bool empty() { return volume() == 0; }
    [[nodiscard]] double volume();
    [[nodiscard]] double volume_left() const noexcept { return state_.volume_left; }
    [[nodiscard]] std::int64_t particle_count() const noexcept { return 0; }
    [[nodiscard]] std::int64_t particle_steps() const noexcept { return 0; }
    [[nodiscard]] std::size_t bytes_per_particle() const noexcept { return 0; }
    /// Bytes that a cell of the map takes once it was touched.
    [[nodiscard]] std::size_t bytes_per_node() const noexcept;
    [[nodiscard]] const NodeGrid& nodes() const noexcept { return nodes_; }
    [[nodiscard]] const structured::FluidState& fluid() const noexcept { return state_; }

    /// Depth and speed along the bed, as north-up rasters; NaN under the minimum depth.
    struct Snapshot {
        Raster depth, speed;
    };
    [[nodiscard]] Snapshot snapshot() const;
    /// Folds the present into the maxima; advance does it after every step.
    void see_present();
    [[nodiscard]] const Maxima& maxima() const noexcept { return maxima_; }
    /// A padded array as a north-up raster; values of 0 become NaN, `shift` is subtracted from the others.
    [[nodiscard]] Raster to_raster(const ZeroArray<double>& padded, double shift = 0) const;

    /// Calls visit(index) for every cell that may hold moving fluid.
    template <class Visit>
    void for_each_active_node(const Visit& visit) const {
        for (const std::int64_t tile : state_.tiles) {
            const NodeRange range(tile, state_.grid, nodes_);
            range.for_each(nodes_.stride(), [&](std::size_t cell, std::int64_t, std::int64_t) {
                if (state_.cell_kind[cell] == structured::k_fluid_cell) visit(cell);
            });
        }
    }
    /// Speed along the bed in a cell [m/s].
    [[nodiscard]] double speed(std::size_t cell) const;

  private:
    StepFigures observe();

    GridSpec grid_;
    Numerics numerics_;
    ThreadPool pool_;
    NodeGrid nodes_;
    structured::FluidLaws laws_;
    structured::FluidState state_;
    Maxima maxima_;
    Point origin_;
    double moving_speed_ = 0, time_ = 0;
    std::int64_t steps_ = 0;
};

}  // namespace frana
