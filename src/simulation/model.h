// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/archive.h"
#include "core/point_table.h"
#include "core/raster.h"
#include "core/reached_raster.h"
#include "mpm/erodible_bed.h"
#include "mpm/node_grid.h"
#include "mpm/update_nodes.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"
#include "simulation/arrivals.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Results of a step, used for the run's series, checks and counts.
struct StepStatistics {
    double dt = 0;              ///< [s]
    double volume = 0;          ///< inside the domain [m3]
    double max_depth = 0;       ///< [m]
    double max_speed = 0;       ///< along the bed [m/s]
    double fastest = 0;         ///< of a particle in map view, however thin [m/s]
    double front_distance = 0;  ///< from the nearest of the run's origins, in map view [m]
    double kinetic = 0;         ///< energy over density [m5/s2]
    double energy = std::numeric_limits<double>::quiet_NaN();
    ///< kinetic and potential, over density, at the beginning of the step [m5/s2]; NaN: not known
    double energy_moving = 0;      ///< of which kinetic [m5/s2]
    double energy_levelled = 0;    ///< of which the potential of a level surface above that of a flow along the bed
    double energy_sloping = 0;     ///< what it would have more if every surface were level [m5/s2]
    double energy_volume = 0;      ///< of the volume to which it belongs [m3]
    double energy_dissipated = 0;  ///< by friction and walls in the step, over density [m5/s2]
    double moving = 0;             ///< volume faster than the run's moving speed, however thin [m3]
    double thin_fraction = 0;      ///< of the volume at the beginning of the step, thinner than the minimum depth
    std::int64_t covered = 0;      ///< cells deeper than the minimum depth
    std::int64_t unsupported = 0;  ///< see RunResult::unsupported
    std::int64_t non_finite = 0;   ///< particles or cells with a non-finite state
    std::int64_t clamped = 0;      ///< particles whose area had to be bounded
    std::int64_t no_data = 0;      ///< particles or flows that reached cells without terrain
};

/// A node or cell as it is recorded; all zero where there is no material.
struct NodeState {
    double depth = 0;         ///< depth for maps [m]
    double volume_depth = 0;  ///< volume over cell area, which enters the flux [m]
    double u = 0, v = 0, speed = 0;
    double moved_x = 0, moved_y = 0;  ///< discharge per width by the velocities of the motion [m2/s]
};

/// Volumes that came from the bed and the sky and went into the bed so far [m3].
struct BedBudget {
    double eroded = 0, deposited = 0;
    double rained = 0, infiltrated = 0;
};

/// What a run steps and observes: a model without scenes, files and clocks. Each function is called once per step,
/// tile, frame or run, never per particle.
class Model {
  public:
    Model() = default;
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;
    virtual ~Model() = default;

    /// Adds later arrivals: columns of failed material, and inflow, which in the structured model is fluid.
    virtual void add(const Arrivals::Arrived& arrived) = 0;
    /// Lowers the bed between two steps: depth in each cell [m], NaN for none.
    virtual void lower_bed(const Raster& depth) = 0;
    /// The places from which the front's distance is measured.
    virtual void set_origins(const FrontOrigins& origins) = 0;
    /// Speed from which volume counts as moving [m/s].
    virtual void set_moving_speed(double speed) = 0;
    /// Sets the time exactly, without the rounding of the sum of steps.
    virtual void set_time(double time) = 0;
    /// From now on `states` has velocities.
    virtual void record_gathered_velocities() {}

    /// Returns the longest step that the present state allows [s].
    [[nodiscard]] virtual double stable_step() = 0;
    virtual StepStatistics step(double dt_limit) = 0;
    /// Advances the velocities, if they lag, to the present time. Call before reading them.
    virtual void synchronise() {}
    /// Updates the maxima with the present state.
    virtual void record_present() = 0;

    [[nodiscard]] virtual const NodeGrid& nodes() const noexcept = 0;
    [[nodiscard]] virtual const GridSpec& grid() const noexcept = 0;
    [[nodiscard]] virtual const Maxima& maxima() const noexcept = 0;
    [[nodiscard]] virtual double time() const noexcept = 0;
    [[nodiscard]] virtual std::int64_t steps() const noexcept = 0;
    [[nodiscard]] virtual bool empty() const = 0;
    /// Volume inside [m3].
    [[nodiscard]] virtual double volume() const = 0;
    [[nodiscard]] virtual double volume_left() const noexcept = 0;
    [[nodiscard]] virtual BedBudget bed_budget() const noexcept { return {}; }
    /// Sum of volume times speed [m4/s].
    [[nodiscard]] virtual double momentum() const = 0;
    /// Mean density of all released so far [kg/m3].
    [[nodiscard]] virtual double density() const = 0;
    /// Square of the ratio of pressure waves' speed to that in water.
    [[nodiscard]] virtual double pressure_factor() const noexcept { return 1; }
    /// Null: the model has none.
    [[nodiscard]] virtual const ParticleSet* particle_set() const noexcept = 0;
    [[nodiscard]] virtual std::int64_t particle_count() const noexcept = 0;
    [[nodiscard]] virtual std::int64_t particle_steps() const noexcept = 0;
    [[nodiscard]] virtual std::size_t bytes_per_particle() const noexcept = 0;
    /// Memory of a node of the map once it was touched [bytes].
    [[nodiscard]] virtual std::size_t bytes_per_node() const noexcept = 0;
    /// Number of rasters, as doubles, at the peak of a run: read, stored, in frames waiting for the disk, and about to
    /// be written. Measured.
    [[nodiscard]] virtual std::int64_t rasters_at_once() const noexcept = 0;
    /// Without particles: a cell with a problem of this kind, local metres.
    [[nodiscard]] virtual std::optional<Point> cell_with(RunProblem::Kind) const { return std::nullopt; }

    /// Whether after a step the nodes have the state at its end; otherwise they have that at its beginning.
    [[nodiscard]] virtual bool shows_end() const noexcept = 0;
    /// Returns the tiles in which something may move.
    [[nodiscard]] virtual std::vector<std::int64_t> shown_tiles() const = 0;
    [[nodiscard]] virtual const TileGrid& tile_grid() const noexcept = 0;
    /// Writes the states of these nodes.
    virtual void states(std::span<const std::size_t> nodes, NodeState* states) const = 0;

    /// Depth and speed along the bed, as north-up rasters; NaN below the minimum depth.
    struct Snapshot {
        Raster depth, speed;
    };
    [[nodiscard]] virtual Snapshot snapshot() = 0;
    /// The run ends here: snapshots hold the volume of what they show. Before, they are within the maxima.
    virtual void end() {}
    /// Rasters of the present state besides depth and speed (params/keys/result_rasters.h describes each).
    [[nodiscard]] virtual std::vector<NamedRaster> more_rasters() const { return {}; }
    /// Returns the particles in their present state, for files: depth_m, bed_m, speed_ms, velocity_x_ms, velocity_y_ms,
    /// volume_m3 in this order, and for structured solids the further columns listed in share/doc/results.md. Stresses
    /// in kPa, positive in tension, without the geostatic part. Velocities must be synchronised.
    [[nodiscard]] virtual PointTable particle_table() const = 0;
    /// Returns the maximum dynamic pressure in the cells that have a maximum speed [kPa].
    /// Density times speed along the bed squared, unless the model has its own.
    [[nodiscard]] virtual Raster max_pressure(const Raster& max_velocity) const;
    /// Returns the normal stresses in the plane (plane_stress.h), and adds them to a table of the particles that has
    /// any. Not for the structured model.
    /// @param depth of the present state, as shown
    virtual std::vector<NamedRaster> plane_stress(const Raster& depth, PointTable& particles) = 0;
    /// At the end of a run: adds what this model alone computes.
    virtual void add_to(RunResult& result) const = 0;

    virtual void transfer(StateWriter& archive) = 0;
    virtual void transfer(StateReader& archive) = 0;
    template <class Archive>
    void serialise(Archive& archive) {
        transfer(archive);
    }

    /// Calls visit(index) for every node of a tile that is on the terrain.
    template <class Visit>
    void for_each_node_of(std::int64_t tile, const Visit& visit) const {
        const NodeGrid& n = nodes();
        const std::int64_t columns = n.columns() + k_ghost, rows = n.rows() + k_ghost;
        NodeRange(tile, tile_grid(), n).for_each(n.stride(), [&](std::size_t index, std::int64_t i, std::int64_t j) {
            if (i >= k_ghost && j >= k_ghost && i < columns && j < rows) visit(index);
        });
    }
    /// Calls visit(index) for every node of the terrain that may contain moving material, in the state after the last
    /// step.
    template <class Visit>
    void for_each_active_node(const Visit& visit) const {
        for (const std::int64_t tile : shown_tiles()) for_each_node_of(tile, visit);
    }
    /// The same, a tile at a time: visit(node, its NodeState).
    template <class Visit>
    void for_each_active_state(const Visit& visit) const {
        std::vector<std::size_t> nodes;
        std::vector<NodeState> states_of_tile;
        for (const std::int64_t tile : shown_tiles()) {
            nodes.clear();
            for_each_node_of(tile, [&](std::size_t node) { nodes.push_back(node); });
            states_of_tile.assign(nodes.size(), {});
            states(nodes, states_of_tile.data());
            for (std::size_t k = 0; k < nodes.size(); ++k) visit(nodes[k], states_of_tile[k]);
        }
    }
    /// Adds depths and volumes that were exchanged with the bed.
    void add_exchange(const ZeroArray<ErodibleBed>& beds, const ExchangeReport& exchanged, RunResult& result) const;
    /// Returns value(node) of every covered node as a north-up raster; NaN: none.
    template <class Value>
    [[nodiscard]] Raster raster_of(const Value& value) const {
        Raster raster = reached_raster(grid(), k_no_data);
        const NodeGrid& n = nodes();
        n.for_each_covered_run([&](std::int64_t j, std::int64_t i0, std::int64_t i1) {
            for (std::int64_t i = i0; i < i1; ++i) {
                const double here = value(n.index(i, j));
                if (!std::isnan(here)) raster.at(n.rows() - 1 - j, i) = here;
            }
        });
        return raster;
    }
    /// Returns a padded node array as a north-up raster; values of 0 become NaN, `shift` is subtracted from the others.
    template <class Value>
    [[nodiscard]] Raster to_raster(const ZeroArray<Value>& padded, double shift = 0) const {
        return raster_of([&](std::size_t node) {
            const auto value = static_cast<double>(padded[node]);
            return value != 0 ? value - shift : k_no_data;
        });
    }
};

/// Returns the scene's model with this material on this ground.
/// @param released particles in local metres
std::unique_ptr<Model> make_model(const Scene& scene, const Ground& ground, const ParticleSet& released, int threads);

}  // namespace frana
