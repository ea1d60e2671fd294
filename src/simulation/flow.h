// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/default_values.h"
#include "core/raster.h"
#include "core/thread_pool.h"
#include "models/voellmy_bingham/step.h"
#include "mpm/node_grid.h"
#include "mpm/update_nodes.h"
#include "simulation/dispatch.h"
#include "simulation/scene.h"

namespace frana {

/// Gravity of a frame tilted along the bed, to test solutions in slope coordinates on a flat bed [m/s2].
struct TiltedGravity {
    double along_x = 0, along_y = 0, normal = k_standard_gravity;
};

/// A flow that can be stepped: the engine without scenes, files and clocks. Used by `run` and by the benches.
class Flow {
  public:
    /// After a step the nodes have the state at its beginning.
    static constexpr bool k_shows_end = false;

    /// @param ground elevation [m], NaN: no data; its grid specifies cell size and extent
    /// @param kernels plain: without the processor's vector instructions, for comparison
    /// @param particles in local metres, velocities in map view; fields the scheme needs are added with their initial
    ///                  values
    /// @param zones rasters on the ground's grid
    Flow(const Ground& ground, const ParticleSet& particles, const Material& material, const Numerics& numerics,
         int threads, std::optional<TiltedGravity> tilt = std::nullopt, const MaterialZones& zones = {},
         const Entrainment& entrainment = {}, Kernels kernels = Kernels::fastest);

    /// Sets walls: 1 in a raster on the same grid.
    void add_walls(const Raster& walls);
    /// Adds particles between two steps, in local metres; those outside count as left.
    void add_particles(const ParticleSet& particles);
    /// Lowers the bed between two steps: depth in each cell [m], NaN for none.
    void lower_bed(const Raster& depth) {
        state_.nodes.lower_bed(depth);
        state_.active.activate(state_.order);
    }
    /// From now on material at rest is computed as well, for comparison.
    void compute_what_rests() noexcept { laws_.skips_rest = false; }

    voellmy_bingham::StepReport advance(double dt_limit);
    /// Advances the velocities, which lag half a step, to the present time. Call before reading them.
    void synchronise();
    /// Steps until `time` and synchronises.
    void advance_to(double time);

    [[nodiscard]] double time() const noexcept { return state_.time; }
    [[nodiscard]] const ParticleSet& particles() const noexcept { return state_.particles; }
    [[nodiscard]] std::int64_t particle_count() const noexcept {
        return static_cast<std::int64_t>(state_.particles.size() + state_.flights.size());
    }
    /// Returns the velocity of a particle in map view [m/s]. Particles that follow a curved bed store theirs along the
    /// bed (BedFrame).
    [[nodiscard]] Point map_velocity(std::size_t p) const;
    /// Whether particles carry the velocity along the bed.
    [[nodiscard]] bool follows_bed() const noexcept { return stages_.follows_bed; }
    [[nodiscard]] bool empty() const noexcept { return state_.particles.size() == 0 && state_.flights.empty(); }
    /// Particles in the air.
    [[nodiscard]] const Flights& flights() const noexcept { return state_.flights; }
    [[nodiscard]] std::size_t bytes_per_particle() const noexcept { return state_.particles.bytes_per_particle(); }
    /// Number of tiles of nodes that the particles can touch: those that a step clears and updates.
    [[nodiscard]] std::size_t reached_tiles() const noexcept { return state_.order.node_tiles().size(); }
    /// Memory of a node of the map once it was touched [bytes].
    [[nodiscard]] std::size_t bytes_per_node() const noexcept;
    [[nodiscard]] const NodeGrid& nodes() const noexcept { return state_.nodes; }
    [[nodiscard]] const GridSpec& grid() const noexcept { return grid_; }
    /// Whether speeds along the bed and in map view differ.
    [[nodiscard]] bool metric() const noexcept { return numerics_.slope_correction != SlopeCorrection::none; }
    /// Calls visit(index) for every node of the terrain that may have mass, in the state after the last step.
    template <class Visit>
    void for_each_active_node(const Visit& visit) const {
        const NodeGrid& n = state_.nodes;
        for (const std::int64_t tile : state_.order.node_tiles()) {
            const NodeRange range(tile, state_.order.grid(), n);
            range.for_each(n.stride(), [&](std::size_t index, std::int64_t i, std::int64_t j) {
                const bool ghost = i < k_ghost || j < k_ghost || i >= n.columns() + k_ghost || j >= n.rows() + k_ghost;
                if (!ghost) visit(index);
            });
        }
    }
    [[nodiscard]] const voellmy_bingham::Laws& laws() const noexcept { return laws_; }
    [[nodiscard]] double volume_left() const noexcept { return state_.volume_left; }
    /// Sum over the particles of volume times speed [m4/s], those in flight included, in their order.
    [[nodiscard]] double momentum() const noexcept;
    /// Amounts exchanged between bed and flow so far.
    [[nodiscard]] const ExchangeReport& exchanged() const noexcept { return state_.exchanged; }
    /// Depth eroded from and deposited on each cell so far [m]; NaN where none. Only for scenes with exchange.
    [[nodiscard]] Raster eroded_depth() const;
    [[nodiscard]] Raster deposited_depth() const;
    /// Greatest height above the ground at which each cell was flown over [m]; NaN where it was not.
    [[nodiscard]] Raster jump_height() const;
    [[nodiscard]] std::int64_t steps() const noexcept { return steps_; }
    [[nodiscard]] std::int64_t particle_steps() const noexcept { return particle_steps_; }
    /// Volume inside, including particles in the air.
    [[nodiscard]] double volume() const;
    /// Centroid of the material on the ground (local metres).
    [[nodiscard]] Point centroid() const;
    /// Sets the point from which the front distance is measured [local metres].
    void set_origin(Point origin) { laws_.origin = origin; }
    /// Sets the time exactly, without the rounding of the sum of steps.
    void set_time(double time) { state_.time = time; }
    /// Speed from which StepReport counts volume as moving [m/s].
    void set_moving_speed(double speed) { laws_.moving_speed = speed; }
    /// Returns the first stable step from the present state [s].
    [[nodiscard]] double stable_step() const;

    /// Returns the speed along the bed of a velocity in map view at a node [m/s], in the frame in which the node
    /// gathered it.
    [[nodiscard]] double speed_along_bed(std::size_t node, Point v) const;
    /// Depth and speed along the bed of the particles in their present state, as north-up rasters; NaN below the
    /// minimum depth.
    struct Snapshot {
        Raster depth, speed;
    };
    Snapshot snapshot();
    /// Depth and momentum (h u, h v) at every node, zero where dry, for comparison with exact solutions.
    struct NodalFields {
        Raster depth, momentum_x, momentum_y;
    };
    NodalFields nodal_fields();
    /// From now on stores the velocities in map view that the nodes gather from the particles, for gathered_velocity.
    void record_gathered_velocities();
    /// Velocity of a node's particles at the beginning of the last step [m/s].
    [[nodiscard]] Point gathered_velocity(std::size_t node) const { return state_.gathered[node]; }
    /// Updates the maxima with the present depth (they are otherwise updated at the start of each step).
    void record_present();
    [[nodiscard]] const Maxima& maxima() const noexcept { return maxima_; }
    /// Returns a padded node array as a north-up raster; values of 0 become NaN, `shift` is subtracted from the others.
    template <class Value>
    [[nodiscard]] Raster to_raster(const ZeroArray<Value>& padded, double shift = 0) const;

    /// Everything that changes during a step.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [grid, numerics, pool, stages, state, laws, maxima, steps, particle_steps] = *this;
        archive(state, maxima, steps, particle_steps);
    }

  private:
    void gather();
    [[nodiscard]] Raster bed_depth_raster(double ErodibleBed::*depth) const;
    // Calls visit(row, column, node) for the cells that particles can touch, tile by tile.
    template <class Visit>
    void for_each_reached_cell(const Visit& visit) const;

    GridSpec grid_;
    Numerics numerics_;
    ThreadPool pool_;
    voellmy_bingham::Stages stages_;
    voellmy_bingham::State state_;
    voellmy_bingham::Laws laws_;
    Maxima maxima_;
    std::int64_t steps_ = 0, particle_steps_ = 0;
};

}  // namespace frana
