// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/lanes.h"
#include "mpm/node_grid.h"

namespace frana {

// Walls of the ground (share/doc/numerics.md, "Cliffs and walls"): a corner that is sharper than the flow is thick
// takes the velocity normal to the ground behind it.

/// Monotonised central limiter (van Leer 1977): 0 at an extremum.
template <class Number>
[[gnu::always_inline]] inline Number limited(Number a, Number b) {
    using std::abs;
    using std::max;
    using std::min;
    const Number least = min(min(2 * abs(a), 2 * abs(b)), 0.5 * abs(a + b));
    return select(a * b > 0, select(a > 0, least, -least), Number(0.0));
}

/// Ground between two cells whose rise beyond the slopes beside it is steeper than this is a wall (50 degrees): a bend
/// of 45 degrees has half as much at each of its faces.
inline constexpr double k_sharp = 1.2;

/// Rise from a cell to the next beyond the slopes beside it, from the differences of elevations: of the one before, of
/// both, of the one after.
template <class Number>
[[gnu::always_inline]] inline Number corner_of(Number before, Number rise, Number after) {
    return rise - 0.5 * (limited<Number>(before, rise) + limited<Number>(rise, after));
}

/// Whether the ground rises like a wall from a node of the terrain to the next one.
/// @param next index of that node less that of the first
inline bool is_wall_ahead(const NodeGrid& nodes, std::size_t node, std::int64_t next) noexcept {
    const double* const z = nodes.bed.data() + node;
    const double rise = z[next] - z[0], sharp = k_sharp * nodes.cell_size();
    return rise > sharp && corner_of(z[0] - z[-next], rise, z[2 * next] - z[next]) > sharp;
}

/// What of a flow comes to walls of the ground that are higher than it, and what goes over walls [m3].
struct WallContact {
    double met = 0, passed = 0;

    void merge(const WallContact& other) noexcept {
        met += other.met;
        passed += other.passed;
    }
    template <class Archive>
    void serialise(Archive& archive) {
        archive(met, passed);
    }
};

/// Factors of the components of a motion.
struct Kept {
    double x = 1, y = 1;
    WallContact part{};  ///< of what moves
};

/// What moves in the cell before a wall of the ground, or from one place to another over walls between them, keeps of
/// its motion. Over a crest goes the layer that is higher than it, at its own speed or that of a weir. In the cell
/// before, the flow slows down evenly to what goes over the crest, and what is below it loses its velocity within the
/// time in which it crosses the cell, as in finite volumes: nothing depends on the step.
/// @param depth of the flow over the bed of its cell [m]  @param root dt sqrt(g) [m^(1/2)]
/// @param from, to local metres, the first in the terrain; `to` is where it comes
/// @return the factors of its velocity
Kept keep_at_walls(const NodeGrid& nodes, double depth, double root, Point from, Point& to) noexcept;

/// The same for a jet: it keeps all above a wall. @param height of the jet [m, as bed]  @return whether it met one
bool stop_jet_at_walls(const NodeGrid& nodes, double height, Point from, Point& to) noexcept;

/// The tiles of nodes that are within a step of a wall of the ground.
class WalledTiles {
  public:
    /// Looks for walls near a tile that is not yet known. Returns whether there are any.
    bool examine(std::int64_t tile, const TileGrid& tiles, const NodeGrid& nodes);
    /// These tiles are to be examined again: their bed has changed.
    void forget(const std::vector<std::int64_t>& tiles) noexcept {
        for (const std::int64_t tile : tiles)
            if (!known_.empty()) known_[static_cast<std::size_t>(tile)] = k_unknown;
    }

  private:
    static constexpr std::uint8_t k_unknown = 0, k_none = 1, k_some = 2;
    std::vector<std::uint8_t> known_;
};

}  // namespace frana
