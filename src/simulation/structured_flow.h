// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/raster.h"
#include "core/thread_pool.h"
#include "models/structured/step.h"
#include "mpm/update_nodes.h"
#include "particles/particle_set.h"
#include "simulation/model.h"

namespace frana {

/// Returns the principal strain of greatest magnitude in the plane of particle p, from the fields e_xx, e_yy, e_xy [-].
double greatest_strain(const ParticleSet& particles, std::size_t p);

/// The structured model: the counterpart of Flow. Depths are totals of a cell, speeds those of its faster phase.
class StructuredFlow final : public Model {
  public:
    /// @param ground elevation [m], NaN: no data
    /// @param walls 1 where there is a wall, on the same grid
    /// @param released columns of full thickness in local metres: fluid, or split into solids and fluid
    StructuredFlow(const Ground& ground, const std::optional<Raster>& walls, const StructuredMaterial& material,
                   const Numerics& numerics, const ParticleSet& released, int threads);

    /// Adds fluid, with the particles' volume and momentum, to the cells that contain them.
    void add_fluid(const ParticleSet& particles);
    /// Adds columns of full thickness that fail now: fluid, or split into solids and fluid.
    void add_release(const ParticleSet& columns);
    void add(const Arrivals::Arrived& arrived) override;
    void lower_bed(const Raster& depth) override;
    void set_origins(const FrontOrigins& origins) override { origins_ = origins; }
    void set_moving_speed(double speed) override { moving_speed_ = speed; }
    void set_time(double time) override { state_.time = time; }

    /// At most the time in which a wave on the minimum depth crosses a cell, so that a map at rest is sampled too.
    [[nodiscard]] double stable_step() override;
    StepStatistics step(double dt_limit) override;

    [[nodiscard]] double time() const noexcept override { return state_.time; }
    [[nodiscard]] std::int64_t steps() const noexcept override { return steps_; }
    [[nodiscard]] bool empty() const override { return volume() == 0; }
    /// Solids and all fluid inside [m3].
    [[nodiscard]] double volume() const override;
    [[nodiscard]] double volume_left() const noexcept override;
    [[nodiscard]] BedBudget bed_budget() const noexcept override;
    /// Budget of solids and fluid; none for a scene without solids.
    [[nodiscard]] std::optional<PhaseBudget> phase_budget() const;
    /// Solids and fluid together; of fluid if only fluid entered.
    [[nodiscard]] double density() const override;
    /// The solids.
    [[nodiscard]] const ParticleSet* particle_set() const noexcept override {
        return state_.solid ? &state_.solid->particles : nullptr;
    }
    [[nodiscard]] std::int64_t particle_count() const noexcept override;
    [[nodiscard]] std::int64_t particle_steps() const noexcept override { return particle_steps_; }
    [[nodiscard]] std::size_t bytes_per_particle() const noexcept override;
    [[nodiscard]] std::size_t bytes_per_node() const noexcept override;
    [[nodiscard]] std::int64_t rasters_at_once() const noexcept override { return particle_count() > 0 ? 31 : 16; }
    [[nodiscard]] const NodeGrid& nodes() const noexcept override { return state_.grid; }
    [[nodiscard]] const structured::State& state() const noexcept { return state_; }
    [[nodiscard]] const GridSpec& grid() const noexcept override { return grid_; }
    [[nodiscard]] std::optional<Point> cell_with(RunProblem::Kind kind) const override;

    [[nodiscard]] Snapshot snapshot() override;
    /// The phases: their depths, velocities and the state of the solids. For fluid alone, its velocity.
    [[nodiscard]] std::vector<NamedRaster> more_rasters() const override;
    [[nodiscard]] PointTable particle_table() const override;
    std::vector<NamedRaster> plane_stress(const Raster&, PointTable&) override { return {}; }
    /// After every step this is done anyway.
    void record_present() override;
    [[nodiscard]] const Maxima& maxima() const noexcept override { return maxima_; }
    /// At every step the greater of the phases' own, density times speed along the bed squared [kPa]; NaN where it is
    /// not finite.
    [[nodiscard]] Raster max_pressure(const Raster& max_velocity) const override;
    void add_to(RunResult& result) const override;

    [[nodiscard]] bool shows_end() const noexcept override { return true; }
    [[nodiscard]] std::vector<std::int64_t> shown_tiles() const override;
    [[nodiscard]] const TileGrid& tile_grid() const noexcept override { return tiles_; }
    void states(std::span<const std::size_t> cells, NodeState* states) const override;
    /// A cell: depth [m], and discharge per width of solids and fluid together [m2/s].
    struct Column {
        double depth = 0, qx = 0, qy = 0;
    };
    [[nodiscard]] Column column(std::size_t cell) const noexcept;
    /// Of the column's two phases together.
    [[nodiscard]] double momentum() const override;
    /// Speed along the bed of the faster phase in a cell [m/s].
    [[nodiscard]] double speed(std::size_t cell) const;

    void transfer(StateWriter& archive) override { serialise(archive); }
    void transfer(StateReader& archive) override { serialise(archive); }
    /// Everything that changes during a step.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [grid, numerics, material, pool, laws, state, tiles, maxima, pressure, origins,
                                moving_speed, released_mass, released_volume, entered, steps, particle_steps] = *this;
        archive(state, maxima, pressure, released_mass, released_volume, entered, steps, particle_steps);
        if constexpr (Archive::k_reads) {
            if (state.fluid) structured::set_ground(*state.fluid, laws.fluid);
        }
    }

  private:
    [[nodiscard]] double still_step() const;
    [[nodiscard]] bool inside(std::int64_t i, std::int64_t j) const noexcept {
        return i >= k_ghost && j >= k_ghost && i < state_.grid.columns() + k_ghost && j < state_.grid.rows() + k_ghost;
    }
    [[nodiscard]] double fluid_depth(std::size_t cell) const noexcept {
        return state_.fluid ? state_.fluid->now.depth[cell] : 0;
    }
    /// Of solids and their confined fluid [m].
    [[nodiscard]] double coupled_depth(std::size_t cell) const noexcept {
        return state_.solid ? state_.solid->nodes.depth[cell] : 0;
    }
    [[nodiscard]] double fluid_speed(std::size_t cell) const;
    [[nodiscard]] double solid_speed(std::size_t cell) const;
    /// @param fluid, solid their speeds along the bed [m/s]
    [[nodiscard]] double dynamic_pressure(std::size_t cell, double fluid, double solid) const;
    void receive(const ParticleSet& particles, bool columns);
    void receive_lying();
    void lay_soil();
    void add_rain_maps();
    void take(const std::vector<structured::FluidSource>& sources);
    StepStatistics observe();

    GridSpec grid_;
    Numerics numerics_;
    StructuredMaterial material_;
    mutable ThreadPool pool_;
    structured::Laws laws_;
    structured::State state_;
    TileGrid tiles_;
    Maxima maxima_;
    ZeroArray<double> pressure_;
    FrontOrigins origins_{Point{}};
    double moving_speed_ = 0;
    double released_mass_ = 0, released_volume_ = 0;  // [kg], [m3]
    PhaseVolumes entered_;
    std::int64_t steps_ = 0, particle_steps_ = 0;
};

}  // namespace frana
