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
#include "simulation/model.h"

namespace frana {

/// Gravity of a frame tilted along the bed, to test solutions in slope coordinates on a flat bed [m/s2].
struct TiltedGravity {
    double along_x = 0, along_y = 0, normal = k_standard_gravity;
};

/// A flow in one phase. Used by `run` and by the benches.
class Flow final : public Model {
  public:
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
    void add(const Arrivals::Arrived& arrived) override { add_particles(arrived.particles); }
    void lower_bed(const Raster& depth) override {
        state_.nodes.lower_bed(depth);
        state_.active.activate(state_.order);
    }
    /// From now on material at rest is computed as well, for comparison.
    void compute_what_rests() noexcept { laws_.skips_rest = false; }

    voellmy_bingham::StepReport advance(double dt_limit);
    StepStatistics step(double dt_limit) override;
    void synchronise() override;
    /// Steps until `time` and synchronises.
    void advance_to(double time);

    [[nodiscard]] double time() const noexcept override { return state_.time; }
    [[nodiscard]] const ParticleSet& particles() const noexcept { return state_.particles; }
    [[nodiscard]] const ParticleSet* particle_set() const noexcept override { return &state_.particles; }
    [[nodiscard]] std::int64_t particle_count() const noexcept override {
        return static_cast<std::int64_t>(state_.particles.size() + state_.flights.size());
    }
    /// Returns the velocity of a particle in map view [m/s]. Particles that follow a curved bed store theirs along the
    /// bed (BedFrame).
    [[nodiscard]] Point map_velocity(std::size_t p) const;
    /// Whether particles carry the velocity along the bed.
    [[nodiscard]] bool follows_bed() const noexcept { return stages_.follows_bed; }
    [[nodiscard]] bool empty() const override { return state_.particles.size() == 0 && state_.flights.empty(); }
    /// Particles in the air.
    [[nodiscard]] const Flights& flights() const noexcept { return state_.flights; }
    [[nodiscard]] std::size_t bytes_per_particle() const noexcept override {
        return state_.particles.bytes_per_particle();
    }
    /// Number of tiles of nodes that the particles can touch: those that a step clears and updates.
    [[nodiscard]] std::size_t reached_tiles() const noexcept { return state_.order.node_tiles().size(); }
    [[nodiscard]] std::size_t bytes_per_node() const noexcept override;
    [[nodiscard]] std::int64_t rasters_at_once() const noexcept override { return 16; }
    [[nodiscard]] const NodeGrid& nodes() const noexcept override { return state_.nodes; }
    [[nodiscard]] const GridSpec& grid() const noexcept override { return grid_; }
    /// Whether speeds along the bed and in map view differ.
    [[nodiscard]] bool metric() const noexcept { return slope_correction(numerics_) != SlopeCorrection::none; }
    [[nodiscard]] bool shows_end() const noexcept override { return false; }
    [[nodiscard]] std::vector<std::int64_t> shown_tiles() const override { return state_.order.node_tiles(); }
    [[nodiscard]] const TileGrid& tile_grid() const noexcept override { return state_.order.grid(); }
    [[nodiscard]] const voellmy_bingham::Laws& laws() const noexcept { return laws_; }
    [[nodiscard]] double pressure_factor() const noexcept override { return laws_.stress.wave_factor; }
    [[nodiscard]] double density() const override { return laws_.exchange.density; }
    [[nodiscard]] double volume_left() const noexcept override { return state_.volume_left; }
    /// Of the particles in their order, those in flight included.
    [[nodiscard]] double momentum() const override;
    [[nodiscard]] BedBudget bed_budget() const noexcept override {
        return {state_.exchanged.eroded, state_.exchanged.deposited};
    }
    /// Amounts exchanged between bed and flow so far.
    [[nodiscard]] const ExchangeReport& exchanged() const noexcept { return state_.exchanged; }
    /// Greatest height above the ground at which each cell was flown over [m]; NaN where it was not.
    [[nodiscard]] Raster jump_height() const;
    [[nodiscard]] std::vector<NamedRaster> low_flights() const;
    [[nodiscard]] std::int64_t steps() const noexcept override { return steps_; }
    [[nodiscard]] std::int64_t particle_steps() const noexcept override { return particle_steps_; }
    /// Including particles in the air.
    [[nodiscard]] double volume() const override;
    /// Centroid of the material on the ground (local metres).
    [[nodiscard]] Point centroid() const;
    void set_origins(const FrontOrigins& origins) override {
        origins_ = origins;
        laws_.origin = origins.first();
    }
    void set_time(double time) override { state_.time = time; }
    void set_moving_speed(double speed) override { laws_.moving_speed = speed; }
    [[nodiscard]] double stable_step() override;

    /// Returns the speed along the bed of a velocity in map view at a node [m/s], in the frame in which the node
    /// gathered it.
    [[nodiscard]] double speed_along_bed(std::size_t node, Point v) const;
    /// Of the particles; it does not change what follows: velocities remain those of the last motion.
    [[nodiscard]] Snapshot snapshot() override;
    void end() override { ended_ = true; }
    [[nodiscard]] PointTable particle_table() const override;
    std::vector<NamedRaster> plane_stress(const Raster& depth, PointTable& particles) override;
    void add_to(RunResult& result) const override;
    /// Depth and momentum (h u, h v) at every node, zero where dry, for comparison with exact solutions.
    struct NodalFields {
        Raster depth, momentum_x, momentum_y;
    };
    NodalFields nodal_fields();
    /// From now on stores the velocities in map view that the nodes gather from the particles.
    void record_gathered_velocities() override;
    /// Depth and the velocity gathered from the particles, as for the maxima, at the beginning of the last step.
    void states(std::span<const std::size_t> nodes, NodeState* states) const override;
    /// The maxima are otherwise updated at the start of each step.
    void record_present() override;
    [[nodiscard]] const Maxima& maxima() const noexcept override { return maxima_; }

    void transfer(StateWriter& archive) override { serialise(archive); }
    void transfer(StateReader& archive) override { serialise(archive); }
    /// Everything that changes during a step.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [grid, numerics, pool, stages, state, laws, maxima, origins, steps, particle_steps,
                                ended] = *this;
        archive(state, maxima, steps, particle_steps);
    }

  private:
    void hold_volume(Raster& depth, const std::vector<std::pair<std::size_t, double>>& beside) const;
    void gather();
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
    FrontOrigins origins_{Point{}};
    std::int64_t steps_ = 0, particle_steps_ = 0;
    bool ended_ = false;
};

}  // namespace frana
