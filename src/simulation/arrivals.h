// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

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

}  // namespace frana
