// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/default_values.h"
#include "core/geometry.h"
#include "core/thread_pool.h"
#include "core/zero_array.h"
#include "mpm/node_grid.h"
#include "mpm/node_report.h"
#include "particles/particle_set.h"
#include "particles/tile_order.h"

namespace frana {

/// A jump must clear the ground by the flow's depth and by this fraction of a cell; below it, the cells of the terrain
/// do not resolve the difference between an edge and roughness.
inline constexpr double k_least_clearance = 0.1;

/// Greatest width of an edge, from the take-off to its steepest fall [cells]: the splines smooth a step over two cells.
inline constexpr double k_edge_width = 2;

/// A free fall between two places on the bed.
struct Jump {
    Point from;           ///< local metres
    double glide = 0;     ///< time along the bed until it begins [s]
    Point velocity;       ///< in map view [m/s]
    double climb = 0;     ///< vertical velocity at the beginning [m/s]
    double duration = 0;  ///< from the beginning to landing [s]
    Point to;             ///< local metres, inside of the terrain
    Point landed;         ///< velocity along the bed (BedFrame) after landing [m/s]
    double height = 0;    ///< greatest height above the ground [m]
    bool left = false;    ///< across an open edge
    struct Place {
        std::size_t node;  ///< whose cell is flown over
        double height;     ///< above the bed [m]
    };
    std::vector<Place> over;
};

/// Conditions of jumps.
struct JumpRules {
    double gravity = k_standard_gravity;  ///< [m/s2]
    bool wall = false;                    ///< edges of the terrain are walls; a particle that meets one falls down it
    double edge = 0;                      ///< least fall of an edge in the direction of motion [-]
};

/// Returns the jump, if there is one, of a particle that moves straight along its bed for a time `reach` [s]. It begins
/// at the first place where the bed of the quadratic splines falls away faster than a free fall,
///
///     v . grad grad Z . v < -g,
///
/// from which the parabola clears the ground by more than `clearance` [m], if the edge falls by JumpRules::edge or more
/// in its direction within k_edge_width. A fast flow also separates from gentler ground, but not as a whole: the upper
/// part of the flow and drag retain some of it. Without that bound every bump of a gully threw particles, which then
/// had no friction: 71 m/s where most codes have 41 to 53 (share/doc/model.md). On landing the velocity component
/// normal to the bed is lost.
/// @param along velocity along the bed (BedFrame) [m/s]
std::optional<Jump> find_jump(const NodeGrid& nodes, const JumpRules& rules, Point place, Point along, double reach,
                              double clearance);

/// Returns a bound of the fall -grad Z . v / |v| [-] that such a particle can meet in its direction of motion within
/// k_edge_width of any place where it may take off; infinity where the nodes for it do not all exist. Where it is less
/// than JumpRules::edge there is no jump, which spares most particles on steep ground the search.
double steepest_fall_ahead(const NodeGrid& nodes, Point place, Point along, double reach) noexcept;

/// Jumps so far.
struct JumpStatistics {
    double volume = 0;   ///< sum over all jumps [m3]
    double highest = 0;  ///< above the ground [m]
    double longest = 0;  ///< in map view [m]
    double way = 0;      ///< sum of volume times length in map view [m4]
    Point from, to;      ///< of the longest; local metres

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
    explicit Flights(std::size_t nodes) : heights_(nodes), near_edge_(nodes) {}

    [[nodiscard]] bool empty() const noexcept { return flights_.empty(); }
    [[nodiscard]] std::size_t size() const noexcept { return flights_.size(); }
    /// Returns when the first of them lands [s]; infinite if there is none.
    [[nodiscard]] double next_landing() const noexcept { return next_landing_; }
    [[nodiscard]] double volume() const noexcept;
    /// Returns the sum of V v^2 / 2 including the vertical part [m5/s2].
    [[nodiscard]] double kinetic(double time, double gravity) const noexcept;
    /// Returns the sum of V |v| including the vertical part [m4/s].
    [[nodiscard]] double momentum(double time, double gravity) const noexcept;
    [[nodiscard]] const JumpStatistics& statistics() const noexcept { return statistics_; }
    /// Greatest height above the ground at which each padded node's cell was flown over [m]; 0 where it was not.
    [[nodiscard]] const ZeroArray<float>& heights() const noexcept { return heights_; }

    /// Adds the particles that leave the bed within the time `reach` to the flights: marks them 0 in `keep`, one byte
    /// per particle, empty if there are none. Examines all particles near edges, since a step may be almost a cell long
    /// and end beyond the edge.
    /// @param time of the particles' positions [s]
    void take_off(const ParticleSet& particles, const TileOrder& order, const NodeGrid& nodes, const JumpRules& rules,
                  double time, double reach, std::vector<std::uint8_t>& keep, ThreadPool& pool);

    struct Landed {
        std::size_t count = 0;  ///< particles appended
        double left = 0;        ///< volume that crossed open edges instead [m3]
    };
    /// Appends the particles that have landed by `time`.
    Landed land(double time, ParticleSet& particles);

    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [flights, heights, next_landing, statistics, edges, near_edge] = *this;
        archive(flights, heights, next_landing, statistics);  // edges are those of the bed
    }

  private:
    struct Flight {
        ParticleRow particle{};  // in its state after landing
        double begins = 0, ends = 0, climb = 0;
        double speed = 0;  // in map view [m/s]
        bool left = false;

        [[nodiscard]] double squared_speed(double time, double gravity) const noexcept;  // the vertical part included
        template <class Archive>
        void serialise(Archive& archive) {
            archive(particle, begins, ends, climb, speed, left);
        }
    };

    void begin(const ParticleRow& particle, const Jump& jump, double time, double cell_area);

    static constexpr std::uint8_t k_unknown = 0, k_none = 1, k_edge = 2;
    [[nodiscard]] bool has_edge(std::int64_t tile, const TileGrid& tiles, const NodeGrid& nodes, double edge);

    std::vector<Flight> flights_;
    ZeroArray<float> heights_;
    double next_landing_ = std::numeric_limits<double>::infinity();
    JumpStatistics statistics_;
    std::vector<std::uint8_t> edges_;    // by tile: whether any of its nodes is near an edge
    ZeroArray<std::uint8_t> near_edge_;  // padded; of the tiles known
};

}  // namespace frana
