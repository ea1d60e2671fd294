// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

namespace frana {

/// Results of a tile's nodes in a step.
struct NodeReport {
    double max_depth = 0;          ///< [m]
    double max_speed = 0;          ///< along the bed [m/s]
    std::int64_t covered = 0;      ///< nodes deeper than the minimum
    std::int64_t unsupported = 0;  ///< nodes, however thin, whose motion over a convex bed lifts them off it
    bool moves = false;            ///< whether any node is in motion after the step
    double moving = 0;             ///< volume that is faster than NodeUpdate::moving_speed, however thin [m3]
    double thin = 0;               ///< volume on nodes that are not as deep as the minimum [m3]
    double volume = 0;             ///< of all nodes [m3]
    double energy = 0;             ///< kinetic and potential, over density, at the present positions [m5/s2]
    double kinetic = 0;            ///< of which kinetic
    double levelled = 0;           ///< of which the potential of a level surface above that of a flow along the bed
    double sloping = 0;            ///< what it would have more if every surface were level
    double dissipated = 0;         ///< energy over density dissipated by friction and walls [m5/s2]

    template <class Archive>
    void serialise(Archive& archive) {
        auto& [depth, speed, cells, lifted, any_moves, fast, shallow, all, energies, motion, level, slope, lost] =
            *this;
        archive(depth, speed, cells, lifted, any_moves, fast, shallow, all, energies, motion, level, slope, lost);
    }

    void merge(const NodeReport& r) noexcept {
        max_depth = std::max(max_depth, r.max_depth);
        max_speed = std::max(max_speed, r.max_speed);
        moves = moves || r.moves;
        covered += r.covered;
        unsupported += r.unsupported;
        moving += r.moving;
        thin += r.thin;
        volume += r.volume;
        energy += r.energy;
        kinetic += r.kinetic;
        levelled += r.levelled;
        sloping += r.sloping;
        dissipated += r.dissipated;
    }
};

}  // namespace frana
