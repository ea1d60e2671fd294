// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/raster.h"
#include "core/thread_pool.h"
#include "models/structured/step.h"
#include "mpm/update_nodes.h"
#include "particles/particle_set.h"
#include "simulation/arrivals.h"
#include "simulation/result.h"
#include "simulation/scene.h"
#include "simulation/stepped_run.h"

namespace frana {

/// The structured model for a run: the engine without scenes, files and clocks; the counterpart of Flow. Depths are
/// totals of a cell, speeds those of its faster phase.
class StructuredFlow {
  public:
    /// After a step the cells have the state at its end.
    static constexpr bool k_shows_end = true;

    /// @param ground elevation [m], NaN: no data
    /// @param walls 1 where there is a wall, on the same grid
    /// @param released columns of full thickness in local metres: fluid, or split into solids and fluid
    StructuredFlow(const Ground& ground, const std::optional<Raster>& walls, const StructuredMaterial& material,
                   const Numerics& numerics, const ParticleSet& released, int threads);

    /// Adds fluid, with the particles' volume and momentum, to the cells that contain them.
    void add_fluid(const ParticleSet& particles);
    /// Adds columns of full thickness that fail now: fluid, or split into solids and fluid.
    void add_release(const ParticleSet& columns);
    /// Lowers the bed between two steps: depth in each cell [m], NaN for none.
    void lower_bed(const Raster& depth);
    void set_origins(const FrontOrigins& origins) { origins_ = origins; }
    void set_moving_speed(double speed) { moving_speed_ = speed; }
    void set_time(double time) { state_.time = time; }

    /// Returns the longest step that the present state allows [s]; at most the time in which a wave on the minimum
    /// depth crosses a cell, so that a map at rest is sampled too.
    [[nodiscard]] double stable_step();
    StepStatistics advance(double dt_limit);
    void synchronise() {}  // velocities never lag

    [[nodiscard]] double time() const noexcept { return state_.time; }
    [[nodiscard]] std::int64_t steps() const noexcept { return steps_; }
    [[nodiscard]] bool empty() { return volume() == 0; }
    /// Solids and all fluid inside [m3].
    [[nodiscard]] double volume();
    [[nodiscard]] double volume_left() const noexcept;
    /// Budget of solids and fluid; none for a scene without solids.
    [[nodiscard]] std::optional<PhaseBudget> phase_budget();
    /// Mean density of all released so far, solids and fluid together [kg/m3]; of fluid if only fluid entered.
    [[nodiscard]] double density() const;
    [[nodiscard]] std::int64_t particle_count() const noexcept;
    [[nodiscard]] std::int64_t particle_steps() const noexcept { return particle_steps_; }
    [[nodiscard]] std::size_t bytes_per_particle() const noexcept;
    /// Memory of a cell of the map once it was touched [bytes].
    [[nodiscard]] std::size_t bytes_per_node() const noexcept;
    [[nodiscard]] const NodeGrid& nodes() const noexcept { return state_.grid; }
    [[nodiscard]] const structured::State& state() const noexcept { return state_; }
    [[nodiscard]] const GridSpec& grid() const noexcept { return grid_; }
    /// Whether speeds along the bed and in map view differ.
    [[nodiscard]] bool metric() const noexcept { return laws_.fluid.steep; }

    /// Depth and speed along the bed, as north-up rasters; NaN below the minimum depth.
    struct Snapshot {
        Raster depth, speed;
    };
    [[nodiscard]] Snapshot snapshot() const;
    /// The phases: their depths, velocities and the state of the solids (params/keys/result_rasters.h describes each).
    /// For fluid alone, its velocity.
    [[nodiscard]] std::vector<NamedRaster> phases() const;
    /// Updates the maxima with the present state; advance does so after every step.
    void record_present();
    [[nodiscard]] const Maxima& maxima() const noexcept { return maxima_; }
    /// Maximum dynamic pressure in the cells that have a greatest speed: at every step the greater of the phases' own,
    /// density times speed along the bed squared [kPa]; NaN elsewhere and where it is not finite.
    [[nodiscard]] Raster max_pressure_where(const Raster& max_velocity) const;
    /// A padded array as a north-up raster; values of 0 become NaN, `shift` is subtracted from the others.
    [[nodiscard]] Raster to_raster(const ZeroArray<double>& padded, double shift = 0) const;

    /// Calls visit(index) for every cell of the terrain that may contain moving material.
    template <class Visit>
    void for_each_active_node(const Visit& visit) const {
        const NodeGrid& n = state_.grid;
        for (const std::int64_t tile : shown_tiles()) {
            NodeRange(tile, tiles_, n).for_each(n.stride(), [&](std::size_t cell, std::int64_t i, std::int64_t j) {
                if (inside(i, j)) visit(cell);
            });
        }
    }
    /// A cell: depth [m], and discharge per width of solids and fluid together [m2/s].
    struct Column {
        double depth = 0, qx = 0, qy = 0;
    };
    [[nodiscard]] Column column(std::size_t cell) const noexcept;
    /// Sum over the cells of depth times speed of the column's two phases together, times their area [m4/s].
    [[nodiscard]] double momentum() const;
    /// Speed along the bed of the faster phase in a cell [m/s].
    [[nodiscard]] double speed(std::size_t cell) const;

    /// Everything that changes during a step.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [grid, numerics, material, pool, laws, state, tiles, maxima, pressure, origins,
                                moving_speed, released_mass, released_volume, entered, steps, particle_steps] = *this;
        archive(state, maxima, pressure, released_mass, released_volume, entered, steps, particle_steps);
        if constexpr (Archive::k_reads) {
            if (state.fluid) structured::set_ground(*state.fluid, state.grid, laws.fluid);
        }
    }

  private:
    [[nodiscard]] double still_step() const;
    [[nodiscard]] std::vector<std::int64_t> shown_tiles() const;
    [[nodiscard]] bool inside(std::int64_t i, std::int64_t j) const noexcept {
        return i >= k_ghost && j >= k_ghost && i < state_.grid.columns() + k_ghost && j < state_.grid.rows() + k_ghost;
    }
    [[nodiscard]] double along_bed(std::size_t cell, double u, double v) const noexcept;
    [[nodiscard]] double fluid_depth(std::size_t cell) const noexcept {
        return state_.fluid ? state_.fluid->now.depth[cell] : 0;
    }
    [[nodiscard]] double fluid_speed(std::size_t cell) const;
    [[nodiscard]] double solid_speed(std::size_t cell) const;
    [[nodiscard]] double dynamic_pressure(std::size_t cell) const;
    void receive(const ParticleSet& particles, bool columns);
    void receive_lying();
    void take(const std::vector<structured::FluidSource>& sources);
    StepStatistics observe();
    template <class Value>
    [[nodiscard]] Raster raster_of(const Value& value) const;

    GridSpec grid_;
    Numerics numerics_;
    StructuredMaterial material_;
    ThreadPool pool_;
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
