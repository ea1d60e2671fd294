// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/thread_pool.h"
#include "models/finite_volume/step.h"
#include "simulation/flow.h"
#include "simulation/model.h"

namespace frana {

/// The first model by finite volumes: the counterpart of Flow, without particles.
class FiniteVolumeFlow final : public Model {
  public:
    /// @param released particles in local metres, velocities in map view
    /// @param walls 1 where there is a wall, on the ground's grid
    FiniteVolumeFlow(const Ground& ground, const std::optional<Raster>& walls, const ParticleSet& released,
                     const Material& material, const Numerics& numerics, int threads, const MaterialZones& zones = {},
                     const Entrainment& entrainment = {}, std::optional<TiltedGravity> tilt = std::nullopt);

    void add(const Arrivals::Arrived& arrived) override { add_particles(arrived.particles); }
    void add_particles(const ParticleSet& particles);
    void lower_bed(const Raster& depth) override;
    void set_origins(const FrontOrigins& origins) override { origins_ = origins; }
    void set_moving_speed(double speed) override { laws_.values.moving_speed = speed; }
    void set_time(double time) override { state_.time = time; }

    [[nodiscard]] double stable_step() override { return finite_volume::stable_step(state_, laws_); }
    StepStatistics step(double dt_limit) override;
    void record_present() override;

    [[nodiscard]] const NodeGrid& nodes() const noexcept override { return state_.nodes; }
    [[nodiscard]] const GridSpec& grid() const noexcept override { return grid_; }
    [[nodiscard]] const Maxima& maxima() const noexcept override { return maxima_; }
    [[nodiscard]] double time() const noexcept override { return state_.time; }
    [[nodiscard]] std::int64_t steps() const noexcept override { return state_.steps; }
    [[nodiscard]] bool empty() const override { return state_.wet.empty(); }
    [[nodiscard]] double volume() const override;
    [[nodiscard]] double volume_left() const noexcept override { return state_.volume_left; }
    [[nodiscard]] BedBudget bed_budget() const noexcept override {
        return {state_.exchanged.eroded, state_.exchanged.deposited};
    }
    [[nodiscard]] double momentum() const override { return state_.momentum; }
    [[nodiscard]] double density() const override { return laws_.exchange.density; }
    [[nodiscard]] double pressure_factor() const noexcept override { return laws_.values.wave_factor; }
    [[nodiscard]] const ParticleSet* particle_set() const noexcept override { return nullptr; }
    [[nodiscard]] std::int64_t particle_count() const noexcept override { return 0; }
    [[nodiscard]] std::int64_t particle_steps() const noexcept override { return 0; }
    [[nodiscard]] std::size_t bytes_per_particle() const noexcept override { return 0; }
    [[nodiscard]] std::size_t bytes_per_node() const noexcept override;
    [[nodiscard]] std::int64_t rasters_at_once() const noexcept override { return 16; }
    [[nodiscard]] std::optional<Point> cell_with(RunProblem::Kind kind) const override;

    [[nodiscard]] bool shows_end() const noexcept override { return true; }
    [[nodiscard]] std::vector<std::int64_t> shown_tiles() const override { return state_.wet; }
    [[nodiscard]] const TileGrid& tile_grid() const noexcept override { return state_.tiles; }
    void states(std::span<const std::size_t> nodes, NodeState* states) const override;

    [[nodiscard]] Snapshot snapshot() override;
    [[nodiscard]] PointTable particle_table() const override { return {}; }
    std::vector<NamedRaster> plane_stress(const Raster& depth, PointTable& particles) override;
    void add_to(RunResult& result) const override;
    [[nodiscard]] const finite_volume::State& state() const noexcept { return state_; }
    [[nodiscard]] finite_volume::CellMotion motion_of(std::size_t cell) const {
        return finite_volume::motion_of(state_, laws_, cell);
    }
    /// Steps until `time`.
    void advance_to(double time);

    void transfer(StateWriter& archive) override { archive(nodes_, state_, maxima_); }
    void transfer(StateReader& archive) override {
        archive(nodes_, state_, maxima_);
        finite_volume::renew_ground(state_, laws_);
    }

  private:
    [[nodiscard]] double farthest_front() const;
    void add_half_of_energies(StepStatistics& statistics) const;

    GridSpec grid_;
    ThreadPool pool_;
    NodeGrid nodes_;
    finite_volume::State state_;
    finite_volume::Laws laws_;
    Maxima maxima_;
    FrontOrigins origins_{Point{}};
};

}  // namespace frana
