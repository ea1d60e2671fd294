// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "core/grid_spec.h"
#include "simulation/inflow.h"
#include "simulation/release.h"

namespace frana {

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
