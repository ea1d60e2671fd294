// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "particles/particle_set.h"
#include "simulation/scene.h"

namespace frana {

/// What crosses a line between two times, as one row of particles that comes in at the later one.
struct InflowBatch {
    double time = 0;    ///< end of the interval [s]
    double volume = 0;  ///< over the whole line [m3]
    double length = 0;  ///< how far what came first has gone by then, along the bed [m]
    double speed = 0;   ///< mean over the interval, along the bed [m/s]
};

/// Cuts a hydrograph into rows `spacing` long, so that they join one behind the other with the depth that
/// discharge and speed make. Rows also end where the discharge is zero, and at `end`. The volumes add up to
/// the hydrograph's integral until `end`: trapezia, exact for a discharge that is linear between its points.
std::vector<InflowBatch> cut_hydrograph(const std::vector<HydrographPoint>& hydrograph, double spacing, double end);

/// A line that gives particles, row after row.
class InflowSource {
  public:
    /// Throws Error(input) naming inflow.line or inflow.direction: a point of the line without terrain, on a
    /// wall or outside the grid; level ground without a direction; a direction along the line.
    InflowSource(const Scene& scene, const Inflow& inflow);

    [[nodiscard]] bool done() const noexcept { return next_ == batches_.size(); }
    /// When the next row comes in [s].
    [[nodiscard]] double next_time() const { return batches_[next_].time; }
    /// Appends the next row to `particles`; returns its volume [m3].
    double emit(ParticleSet& particles);

    [[nodiscard]] Point midpoint() const;             ///< local metres
    [[nodiscard]] std::vector<Point> places() const;  ///< where rows come in, local metres
    /// Greatest depth [m] and speed along the bed [m/s] with which rows come in.
    struct Extremes {
        double depth = 0, speed = 0;
    };
    [[nodiscard]] Extremes extremes() const;
    /// Particles still to come.
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
    // What a mouth brings of a row.
    struct Piece {
        double length, area, depth, speed;  ///< in map view, but for the speed along the bed
    };
    [[nodiscard]] Piece piece_of(const Mouth& mouth, const InflowBatch& batch) const;

    double gravity_;  ///< [m/s2]
    std::vector<Mouth> mouths_;
    std::vector<InflowBatch> batches_;
    std::size_t next_ = 0;
};

}  // namespace frana
