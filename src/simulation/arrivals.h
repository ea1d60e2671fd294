// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/grid_spec.h"
#include "particles/particle_set.h"
#include "simulation/release.h"
#include "simulation/scene.h"

namespace frana {

/// The inflow across a line between two times, as one row of particles that enters at the later one.
struct InflowBatch {
    double time = 0;    ///< end of the interval [s]
    double volume = 0;  ///< over the whole line [m3]
    double length = 0;  ///< distance along the bed travelled by then by the first part [m]
    double speed = 0;   ///< mean over the interval, along the bed [m/s]
};

/// Divides a hydrograph into rows of length `spacing`, contiguous along the flow, with the depth given by discharge and
/// speed. Rows also end where the discharge is zero, and at `end`. The volumes add up to the hydrograph's integral
/// until `end`: trapezoidal, exact for a discharge that is linear between its points.
std::vector<InflowBatch> cut_hydrograph(const std::vector<HydrographPoint>& hydrograph, double spacing, double end);

/// Greatest time [s], discharge [m3/s] and speed [m/s], and volume [m3], of a hydrograph: more than any flood, and sums
/// remain finite.
inline constexpr double k_most_of_hydrograph = 1e12;
/// Returns the length of a line [m].
double length_of(const Polyline& line);
/// Returns the critical speed (g Q / L)^(1/3) [m/s], with which material crosses a line of length L [m] if a hydrograph
/// gives none.
double critical_speed(double gravity, double discharge, double length);
/// Returns the volume that an inflow gives until `end` [m3].
double volume_of(const Inflow& inflow, double end);
/// Returns the number of particles that an inflow gives until `end`, `spacing` apart.
double particles_of(const Inflow& inflow, double spacing, double end);

/// A line that emits particles row by row.
class InflowSource {
  public:
    /// Throws Error(input) naming inflow.line or inflow.direction: a point of the line without terrain, on a wall or
    /// outside the grid; level ground without a direction; a direction along the line.
    InflowSource(const Scene& scene, const Inflow& inflow);

    [[nodiscard]] bool done() const noexcept { return next_ == batches_.size(); }
    /// Time of the next row [s].
    [[nodiscard]] double next_time() const { return batches_[next_].time; }
    /// Appends the next row to `particles`; returns its volume [m3].
    double emit(ParticleSet& particles);

    [[nodiscard]] Point midpoint() const;             ///< local metres
    [[nodiscard]] std::vector<Point> places() const;  ///< places of the rows, local metres
    /// Greatest depth [m] and speed along the bed [m/s] of the rows.
    struct Extremes {
        double depth = 0, speed = 0;
    };
    [[nodiscard]] Extremes extremes() const;
    /// Number of particles still to enter.
    [[nodiscard]] std::size_t particles_left() const noexcept { return (batches_.size() - next_) * mouths_.size(); }

    template <class Archive>
    void serialise(Archive& archive) {
        archive(next_);
        if constexpr (Archive::k_reads) archive.require(next_ <= batches_.size());
    }

  private:
    struct Mouth {
        Point place, direction;  ///< local metres; unit vector
        double map_fraction;     ///< of lengths and speeds along the bed
        double width;            ///< across the direction [m]
        double fraction;         ///< of the discharge
    };
    // The part of a row through one mouth.
    struct Piece {
        double length, area, depth, speed;  ///< in map view, except the speed along the bed
    };
    [[nodiscard]] Piece piece_of(const Mouth& mouth, const InflowBatch& batch) const;

    double gravity_;  ///< [m/s2]
    std::vector<Mouth> mouths_;
    std::vector<InflowBatch> batches_;
    std::size_t next_ = 0;
};

/// Everything that enters a flow after its start, in order of time: areas that fail later, and inflow.
class Arrivals {
  public:
    /// Moves in the areas that fail later. Throws as InflowSource.
    Arrivals(const Scene& scene, std::vector<Entry> later);

    /// Returns the time of the next entry [s]; infinity: none.
    [[nodiscard]] double next_time() const;
    [[nodiscard]] bool done() const { return next_time() == std::numeric_limits<double>::infinity(); }

    struct Arrived {
        ParticleSet particles;           ///< of areas, then of lines
        std::vector<std::size_t> areas;  ///< release areas that fail now
        ParticleSet failed;              ///< their particles
        double inflow = 0;               ///< volume through lines [m3]
    };
    /// Returns everything due by `time`, areas before lines, each in the scene's order.
    Arrived collect(double time);

    [[nodiscard]] const std::vector<InflowSource>& sources() const noexcept { return sources_; }
    /// Returns the areas that have not failed yet.
    [[nodiscard]] std::span<const Entry> waiting() const noexcept { return std::span(later_).subspan(next_entry_); }
    /// Returns the number of particles still to enter.
    [[nodiscard]] std::size_t particles_left() const;

    /// Transfers the position in the list of entries.
    template <class Archive>
    void serialise(Archive& archive) {
        archive(next_entry_);
        if constexpr (Archive::k_reads) archive.require(next_entry_ <= later_.size());
        for (InflowSource& source : sources_) archive(source);
    }

  private:
    std::vector<Entry> later_;
    std::size_t next_entry_ = 0;
    std::vector<InflowSource> sources_;
};

/// The places from which the distance of a front is measured, each front from the nearest: the centroid of every
/// release and the middle of every inflow. A release is a group of cells that touch; groups with less than a hundredth
/// of the greatest one's volume do not count.
class FrontOrigins {
  public:
    FrontOrigins(const Release& release, const Arrivals& arrivals);
    explicit FrontOrigins(Point only) : places_{only} {}

    [[nodiscard]] bool single() const noexcept { return places_.size() == 1; }
    /// The only place, or the westernmost. Local metres.
    [[nodiscard]] Point first() const { return places_.front(); }
    /// Returns the squared distance [m2] of a place from the nearest of them.
    [[nodiscard]] double squared_distance(Point place) const noexcept;

  private:
    std::vector<Point> places_;  // local metres, from west to east
};

}  // namespace frana
