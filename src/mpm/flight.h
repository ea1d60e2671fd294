// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "core/default_values.h"
#include "core/geometry.h"
#include "core/thread_pool.h"
#include "core/zero_array.h"
#include "mpm/node_grid.h"
#include "mpm/node_report.h"
#include "mpm/update_nodes.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"
#include "physics/bed_state.h"

namespace frana {

/// Length over which an edge is judged [cells], [thicknesses of the flow]: the splines smooth a step over two cells,
/// and a flow bridges what is short against its own thickness.
inline constexpr double k_edge_cells = 3, k_edge_thicknesses = 10;

/// An edge is one within this many cells.
inline constexpr std::int64_t k_edge_sight = 24;

/// From this much below JumpRules::angle to this much above it, the part of a flow that flies grows from 0 to 1 [rad].
inline constexpr double k_half_ramp = 15 * std::numbers::pi / 180;

/// Speed in the air [m/s]: in map view, and upwards.
struct AirSpeed {
    double along = 0, up = 0;
    [[nodiscard]] double squared() const noexcept { return along * along + up * up; }
};

/// A free fall between two places on the bed.
struct Jump {
    double fraction = 0;  ///< of the flow that leaves the bed at this edge
    Point from;           ///< local metres
    double glide = 0;     ///< time along the bed until it begins [s]
    Point velocity;       ///< in map view [m/s]
    double climb = 0;     ///< vertical velocity at the beginning [m/s]
    double drag = 0;      ///< of the air: deceleration over squared speed [1/m]
    double duration = 0;  ///< from the beginning to landing [s]; 0: hardly more leaves the bed than has flown
    Point to;             ///< local metres, inside of the terrain
    Point landed;         ///< velocity along the bed (BedFrame) after landing [m/s]
    double height = 0;    ///< greatest height above the ground [m]
    bool left = false;    ///< across an open edge
    struct Place {
        std::size_t node;  ///< whose cell is flown over
        double height;     ///< above the bed [m]
        double time;       ///< since the beginning [s]
        double speed;      ///< including the vertical part [m/s]

        template <class Archive>
        void serialise(Archive& archive) {
            archive(node, height, time, speed);
        }
    };
    std::vector<Place> over;
};

/// Conditions of jumps.
struct JumpRules {
    double gravity = k_standard_gravity;  ///< [m/s2]
    bool wall = false;                    ///< edges of the terrain are walls; a particle that meets one falls down it
    double angle = 0;        ///< by which the ground falls away below the path where half of a flow flies [rad]
    double drag = 0;         ///< deceleration in the air times thickness over squared speed [-]
    NodeValue friction{};    ///< Coulomb friction coefficient at landing [-]
    double clearance = 0;    ///< height above the ground up to which what flies reaches a place [m]
    double least_depth = 0;  ///< from which it does [m]
    double bearing = 1;      ///< 1 - r: effective fraction of the normal stress under pore pressure, of a particle [-]
};

/// Returns the jump of a particle that moves straight along its bed for a time `reach` [s], if there is a place on its
/// way where the bed of the quadratic splines falls away faster than a free fall,
///
///     v . grad grad Z . v < -g.
///
/// The part of the flow that leaves the bed there follows from the mean angle by which the ground falls away below the
/// path of a free fall over k_edge_cells and k_edge_thicknesses: a dense flow bridges a bump, but not a cliff
/// (share/doc/model.md, "Flight"). It falls under gravity and the drag of the air. On landing the velocity component
/// normal to the bed is lost, and by friction a part of that along it.
/// @param along velocity along the bed (BedFrame) [m/s]  @param thickness vertical depth of the flow [m]
/// @param flown Field::flown
std::optional<Jump> find_jump(const NodeGrid& nodes, const JumpRules& rules, Point place, Point along, double thickness,
                              double reach, double flown = 0);

/// Returns the directions of the grid, a bit for each of eight, in which the ground falls away below the bed's tangent
/// at a node by about `least` [rad] or more in the mean over k_edge_cells or any number of cells up to k_edge_sight.
/// @param column, row padded
std::uint8_t edges_at(const NodeGrid& nodes, std::int64_t column, std::int64_t row, double least) noexcept;

/// Returns the direction of edges_at nearest to that of a motion, and its two neighbours.
std::uint8_t directions_near(Point along) noexcept;

/// Computes, for each node of a range of at most a tile, a bound of -e . grad grad Z . e for all directions e and all
/// places that a particle in its cell can reach in a step [1/m]: where it is less than g over the squared speed there
/// is no jump, which spares most particles the search.
void greatest_convexity(const NodeRange& range, const NodeGrid& nodes, double* bounds) noexcept;

/// The edges of the ground, tile by tile.
class Edges {
  public:
    Edges() = default;
    /// @param nodes padded
    explicit Edges(std::size_t nodes) : near_(nodes) {}

    /// Looks for them round a tile that is not yet known. Returns whether any of its nodes is near one.
    bool examine(std::int64_t tile, const TileGrid& tiles, const NodeGrid& nodes, const JumpRules& rules);
    /// These tiles are to be examined again: their bed has changed.
    void forget(const std::vector<std::int64_t>& tiles) noexcept {
        for (const std::int64_t tile : tiles)
            if (!known_.empty()) known_[static_cast<std::size_t>(tile)] = k_unknown;
    }
    /// Whether what moves in a node's cell of an examined tile, by its velocity along the bed, may jump within a step.
    [[nodiscard]] bool may_jump(std::size_t node, Point along, double gravity) const noexcept {
        const Near& near = near_[node];
        return (along.x * along.x + along.y * along.y) * near.convexity > gravity &&
               (near.edges & directions_near(along)) != 0;
    }

  private:
    static constexpr std::uint8_t k_unknown = 0, k_none = 1, k_edge = 2;
    std::vector<std::uint8_t> known_;  // by tile: whether any of its nodes is near an edge
    struct Near {
        float convexity;     // greatest_convexity near an edge, otherwise 0
        std::uint8_t edges;  // edges_at of the nodes within reach
    };
    ZeroArray<Near> near_;  // padded; of the tiles known
};

/// Jumps so far.
struct JumpStatistics {
    double volume = 0;   ///< sum over all jumps [m3]
    double highest = 0;  ///< above the ground [m]
    double longest = 0;  ///< in map view [m]
    double way = 0;      ///< sum of volume times length in map view [m4]
    Point from, to;      ///< of the longest; local metres

    void add(double jumped, const Jump& jump) noexcept;
    void merge(const JumpStatistics& other) noexcept;

    template <class Archive>
    void serialise(Archive& archive) {
        archive(volume, highest, longest, way, from.x, from.y, to.x, to.y);
    }
};

/// Particles in free fall, stored apart from those on the ground, so that those have no extra cost. Where the bed falls
/// away faster than a free fall, neither friction nor pressure acts until landing. The whole path is known at take-off,
/// since only gravity acts.
class Flights {
  public:
    Flights() = default;
    /// @param nodes padded
    explicit Flights(std::size_t nodes) : heights_(nodes), low_(nodes), edges_(nodes) {}

    [[nodiscard]] bool empty() const noexcept { return flights_.empty(); }
    [[nodiscard]] std::size_t size() const noexcept { return flights_.size(); }
    /// Returns when the first of them lands [s]; infinite if there is none.
    [[nodiscard]] double next_landing() const noexcept { return next_landing_; }
    [[nodiscard]] double volume() const noexcept;
    /// Returns the sum of V v^2 / 2 including the vertical part [m5/s2].
    [[nodiscard]] double kinetic() const noexcept;
    /// Returns the sum of V |v| including the vertical part [m4/s].
    [[nodiscard]] double momentum() const noexcept;
    [[nodiscard]] const JumpStatistics& statistics() const noexcept { return statistics_; }
    /// Greatest height above the ground at which each padded node's cell was flown over [m]; 0 where it was not.
    [[nodiscard]] const ZeroArray<float>& heights() const noexcept { return heights_; }
    /// Maxima of what flew no higher than JumpRules::clearance above the ground.
    [[nodiscard]] const Maxima& low() const noexcept { return low_; }

    /// Moves what flies until `time` [s].
    void advance_to(double time, const JumpRules& rules);

    /// Adds what leaves the bed within the time `reach` to the flights: takes its volume from its particle, which keeps
    /// its area, since the upper part of a flow leaves it. Field::flown remembers which part has left at the edge that
    /// a particle passes. Examines all particles near edges, since a step may be almost a cell long and end beyond the
    /// edge.
    /// @param time of the particles' positions [s]
    /// @return the particles that leave as a whole, in ascending order
    std::vector<std::size_t> take_off(ParticleSet& particles, const TileOrder& order, const NodeGrid& nodes,
                                      const JumpRules& rules, double time, double reach, ThreadPool& pool);

    struct Landed {
        std::size_t count = 0;  ///< particles appended
        double left = 0;        ///< volume that crossed open edges instead [m3]
    };
    /// Appends the particles that have landed by `time`.
    Landed land(double time, ParticleSet& particles);

    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [flights, heights, low, next_landing, statistics, edges] = *this;
        archive(flights, heights, low, next_landing, statistics);  // edges are those of the bed
    }

  private:
    struct Flight {
        ParticleRow particle{};  // in its state after landing
        double begins = 0, ends = 0;
        AirSpeed speed;  // at `now`, at least `begins`
        double now = 0, drag = 0, depth = 0;
        bool left = false;
        std::vector<Jump::Place> over;  // still to come, the next one last

        template <class Archive>
        void serialise(Archive& archive) {
            archive(particle, begins, ends, speed.along, speed.up, now, drag, depth, left, over);
        }
    };

    void begin(const ParticleRow& particle, const Jump& jump, double time, double cell_area);

    std::vector<Flight> flights_;
    ZeroArray<float> heights_;
    Maxima low_;
    double next_landing_ = std::numeric_limits<double>::infinity();
    JumpStatistics statistics_;
    Edges edges_;
};

}  // namespace frana
