// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/raster.h"
#include "core/thread_pool.h"
#include "models/voellmy_bingham/step.h"
#include "mpm/maxima.h"
#include "simulation/dispatch.h"
#include "simulation/scene.h"

namespace frana {

/// Gravity of a frame tilted along the bed, so that solutions in slope coordinates are tested on a flat bed
/// [m/s2].
struct TiltedGravity {
    double along_x = 0, along_y = 0, normal = 9.81;
};

/// A flow that can be stepped: the engine without scenes, files and clocks. `run` drives it; so do the
/// benches.
class Flow {
  public:
    /// @param bed elevation [m], NaN where there is none; its grid gives cell size and extent
    /// @param kernels plain: without the processor's vector instructions, for comparison
    /// @param particles in local metres; fields the scheme needs are added with their initial values
    Flow(const Raster& bed, const ParticleSet& particles, const Material& material, const Numerics& numerics,
         int threads, std::optional<TiltedGravity> tilt = std::nullopt, Kernels kernels = Kernels::fastest);

    voellmy_bingham::StepReport advance(double dt_limit);
    /// Brings the velocities, which lag half a step, to the present time. Before looking at them.
    void synchronise();
    /// Steps until `time` and synchronises.
    void advance_to(double time);

    [[nodiscard]] double time() const noexcept { return state_.time; }
    [[nodiscard]] const ParticleSet& particles() const noexcept { return state_.particles; }
    /// Tiles of nodes that the particles can touch: what a step clears and updates.
    [[nodiscard]] std::size_t reached_tiles() const noexcept { return state_.order.node_tiles().size(); }
    /// Bytes that a node of the map takes once it was touched.
    [[nodiscard]] std::size_t bytes_per_node() const noexcept;
    [[nodiscard]] const NodeGrid& nodes() const noexcept { return state_.nodes; }
    [[nodiscard]] const voellmy_bingham::Laws& laws() const noexcept { return laws_; }
    [[nodiscard]] double volume_left() const noexcept { return state_.volume_left; }
    [[nodiscard]] std::int64_t steps() const noexcept { return steps_; }
    [[nodiscard]] std::int64_t particle_steps() const noexcept { return particle_steps_; }
    /// Volume inside and its centroid (local metres).
    [[nodiscard]] double volume() const;
    [[nodiscard]] Point centroid() const;
    /// Measures the front distance from here on [local metres].
    void set_origin(Point origin) { laws_.origin = origin; }
    /// First stable step from the present state [s].
    [[nodiscard]] double stable_step() const;

    /// Depth and speed along the bed of the particles as they are, as north-up rasters; NaN under the minimum
    /// depth.
    struct Snapshot {
        Raster depth, speed;
    };
    Snapshot snapshot();
    /// Depth and momentum (h u, h v) at every node, zero where dry, for comparison with exact solutions.
    struct NodalFields {
        Raster depth, momentum_x, momentum_y;
    };
    NodalFields nodal_fields();
    /// Folds the present depth into the maxima (they are otherwise taken at the start of each step).
    void see_present();
    [[nodiscard]] const Maxima& maxima() const noexcept { return maxima_; }
    /// A padded node array as a north-up raster; values of 0 become NaN, `shift` is subtracted from the
    /// others.
    [[nodiscard]] Raster to_raster(const ZeroArray<double>& padded, double shift = 0) const;

  private:
    // Calls visit(row, column, node) for the cells that particles can touch, tile by tile.
    template <class Visit>
    void for_each_reached_cell(const Visit& visit) const;

    GridSpec grid_;
    Numerics numerics_;
    ThreadPool pool_;
    voellmy_bingham::Stages stages_;
    voellmy_bingham::Laws laws_;
    voellmy_bingham::State state_;
    Maxima maxima_;
    std::int64_t steps_ = 0, particle_steps_ = 0;
};

}  // namespace frana
