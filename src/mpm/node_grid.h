// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/raster.h"
#include "core/zero_array.h"
#include "particles/tile_order.h"

namespace frana {

// A node's record of one cache line, whose slots have a different meaning in each phase of a step. Each half is loaded
// at once by a fast kernel; `mass` is the same in all phases.

/// Sums over particles.
struct alignas(64) NodeSums {
    double px, py;           ///< momentum, along the bed if particles carry it so [m4/s]
    double bed_squares;      ///< area times squared elevation of the bed relative to the node's bed [m4]
    double surface_squares;  ///< the same of the particles' surface; both only with reference levels
    double mass;             ///< volume: density is constant and divided out [m3]
    double area;             ///< area that the particles claim [m2]
    double area_bed;         ///< area times elevation of the bed relative to the node's bed [m3]; with reference levels
                             ///< only
    double unused;           ///< vector loads take four at a time
};

/// Forces on the node.
struct alignas(64) NodeForces {
    double px, py;    ///< momentum in map view [m4/s]
    double fx, fy;    ///< force over density [m4/s2]
    double mass;      ///< [m3]
    double area;      ///< [m2]
    double crowding;  ///< see crowding(), 0 without reference levels
    double held;      ///< 1: friction keeps the node at rest
};

/// Results that the particles gather; kept until the node is cleared.
struct alignas(64) NodeMotion {
    double u, v;            ///< velocity in map view [m/s]
    double back_u, back_v;  ///< velocity, along the bed if particles carry it so, without NodeUpdate::kept [m/s]
    double mass;            ///< [m3]
    double fraction;        ///< of the cell that the particles claim, phi [-]
    double unused;
    double support;  ///< NodeLevel::support + share, which is 0 unless support is 1
};

/// The phase of the records of a grid.
enum class NodePhase { sums, forces, motion };

union NodeRecord {
    NodeSums sums;
    NodeForces forces;
    NodeMotion motion;
};

/// Nodes outside the terrain on every side: a particle in the outermost half cell reaches one of them.
inline constexpr std::int64_t k_ghost = 2;

/// The reference state for the pressure of a node (share/doc/numerics.md, "Reference level").
struct NodeLevel {
    double depth;    ///< mean depth of the node's particles [m]
    double level;    ///< mean free surface of the node's particles [m]
    double ponding;  ///< 1: the surface is level (still-water reference); 0: it follows the bed (thickness
                     ///< reference)
    double support;  ///< 1: filled all round; 0: a free front
    double held;     ///< depth of the state held on the grid (mpm/held_state.h) [m]
    double share;    ///< fraction of the reference that this state is
};

/// Fraction of a cell from which it counts as filled (share/doc/numerics.md, "Reference level").
inline constexpr double k_filled_fraction = 0.6;

/// Fraction of a cell from which its particles overlap on top of each other rather than being unevenly spaced: their
/// claimed areas then shrink faster, and they are not shifted.
inline constexpr double k_crowded_fraction = 1.1;

/// A terrain, and the elevation that the engine subtracts to limit rounding: a run uses the elevation under its
/// release, so that results are independent of distant terrain.
///
/// Tiled terrain (CellValues) is read only where the flow arrives (NodeGrid::cover), and must outlive the grid made of
/// it.
struct Ground {
    /// The datum is the lowest cell.
    Ground(const Raster& bed);  // NOLINT(google-explicit-constructor): a terrain is a ground
    Ground(const Raster& bed, double counted_from) : terrain(bed), datum(counted_from) {}

    const Raster& terrain;
    double datum;
};

/// Conversion of local metres to nodes.
struct NodeScale {
    double dx, inverse_dx;
    std::int64_t stride;
    std::int64_t origin_x, origin_y;  ///< padded numbers of the node in the origin's cell

    /// Index in the padded arrays of a node by its numbers counted from the origin.
    [[nodiscard]] std::size_t index(std::int64_t i, std::int64_t j) const noexcept {
        return static_cast<std::size_t>((j + origin_y) * stride + i + origin_x);
    }
    /// The node of the cell that contains a local point.
    [[nodiscard]] std::size_t node_of(double x, double y) const noexcept {
        return index(whole_below(x * inverse_dx), whole_below(y * inverse_dx));
    }
};

/// The background grid: one node at each cell centre of the terrain, rows from the south, with ghost nodes
/// around.
///
///     node (i, j) lies at ((i + 1/2) dx, (j + 1/2) dx) from the terrain's south-western corner,
///     i in [-k_ghost, columns + k_ghost)
class NodeGrid {
  public:
    /// Reads bed elevations from a north-up raster; NaN marks cells without terrain, which become solid. Tiled terrain
    /// is read by cover().
    explicit NodeGrid(const Ground& ground);
    NodeGrid(NodeGrid&&) noexcept;
    NodeGrid& operator=(NodeGrid&&) noexcept;
    ~NodeGrid();

    /// Nodes by padded numbers, [i0, i1) x [j0, j1).
    struct Block {
        std::int64_t i0, i1, j0, j1;
    };
    /// Reads the terrain of those of these nodes that exist, unless it was read before; the bed of uncovered nodes is
    /// not read. Callable from several threads, none of which may read the bed there before. An exception of the
    /// terrain's source is stored for require_ground; the nodes are then not covered.
    void cover(const Block& block) const noexcept;
    /// Covers the nodes within stencil reach of a local point.
    void cover_round(Point place) const noexcept;
    /// Calls fill(nodes) for all nodes; if terrain is read on demand, for each block when it is covered, from the
    /// thread that covers it, one at a time, as long as the grid exists. Exceptions of `fill` are stored for
    /// require_ground.
    void fill_with_ground(std::function<void(const Block&)> fill);
    /// Whether a terrain read failed since the last call of require_ground.
    [[nodiscard]] bool lacks_ground() const noexcept;
    /// Rethrows the read error, if there is one.
    void require_ground() const;
    /// Whether terrain is read on demand.
    [[nodiscard]] bool is_on_demand() const noexcept { return demand_ != nullptr; }
    /// Lowest terrain read so far, before or after the release was removed [m]; infinity: none.
    [[nodiscard]] double lowest() const noexcept;
    /// Calls visit(j, i0, i1) for runs of the terrain's nodes, [i0, i1) in row j from the south, which contain all
    /// covered nodes; for all nodes if the terrain is not read on demand.
    template <class Visit>
    void for_each_covered_run(const Visit& visit) const {
        for_each_covered_block([&](const Block& b) {
            const std::int64_t i0 = std::max<std::int64_t>(b.i0 - k_ghost, 0), i1 = std::min(b.i1 - k_ghost, columns_);
            for (std::int64_t j = std::max<std::int64_t>(b.j0 - k_ghost, 0); j < std::min(b.j1 - k_ghost, rows_); ++j)
                if (i0 < i1) visit(j, i0, i1);
        });
    }

    /// Calls visit(k) for the nodes k in [first, last) of one row or column that may be covered, numbered from the
    /// terrain's corner; for all if the terrain is not read on demand.
    enum class Along { row, column };
    template <class Visit>
    void for_each_covered_part(std::int64_t first, std::int64_t last, std::int64_t line, Along along,
                               const Visit& visit) const {
        for (std::int64_t k = first; k < last;) {
            const std::int64_t end =
                is_on_demand() ? std::min(last, ((k + k_ghost) / CellValues::k_side + 1) * CellValues::k_side - k_ghost)
                               : last;
            if (along == Along::row ? covers(k, line) : covers(line, k))
                for (; k < end; ++k) visit(k);
            k = end;
        }
    }
    /// Whether a node's bed can be read, by its numbers counted from the terrain's corner.
    [[nodiscard]] bool covers(std::int64_t i, std::int64_t j) const noexcept;
    /// Terrain read from now on has, in the first ring beyond its edges, the bed of the mirror image inside.
    void mirror_edges_when_read() noexcept;

    [[nodiscard]] std::int64_t columns() const noexcept { return columns_; }
    [[nodiscard]] std::int64_t rows() const noexcept { return rows_; }
    [[nodiscard]] std::int64_t stride() const noexcept { return columns_ + 2 * k_ghost; }
    [[nodiscard]] std::int64_t padded_rows() const noexcept { return rows_ + 2 * k_ghost; }
    [[nodiscard]] double cell_size() const noexcept { return cell_size_; }
    /// The terrain's edges in local metres.
    [[nodiscard]] const Bounds& bounds() const noexcept { return bounds_; }
    [[nodiscard]] NodeScale scale() const noexcept {
        return {cell_size_, 1 / cell_size_, stride(), origin_column_ + k_ghost, origin_row_ + k_ghost};
    }
    /// Middle of a node's cell in local metres, by its padded numbers.
    [[nodiscard]] Point middle(std::int64_t i, std::int64_t j) const noexcept {
        return {(static_cast<double>(i - k_ghost - origin_column_) + 0.5) * cell_size_,
                (static_cast<double>(j - k_ghost - origin_row_) + 0.5) * cell_size_};
    }
    [[nodiscard]] std::size_t index(std::int64_t i, std::int64_t j) const noexcept {
        return static_cast<std::size_t>((j + k_ghost) * stride() + i + k_ghost);
    }
    /// Whether a node of the terrain has no elevation and is not a wall either.
    [[nodiscard]] bool is_gap(std::size_t node) const noexcept { return any_solid() && solid_[node] == k_gap; }
    [[nodiscard]] bool is_wall(std::size_t node) const noexcept { return any_solid() && solid_[node] == k_wall; }
    /// Whether a node lies outside the terrain, by its padded numbers.
    [[nodiscard]] bool is_ghost(std::int64_t i, std::int64_t j) const noexcept {
        return i < k_ghost || j < k_ghost || i >= stride() - k_ghost || j >= padded_rows() - k_ghost;
    }
    [[nodiscard]] bool any_solid() const noexcept { return solid_.size() != 0; }
    [[nodiscard]] const std::uint8_t* solid() const noexcept { return any_solid() ? solid_.data() : nullptr; }

    /// Makes the cells that are 1 in a north-up raster solid; their bed stays as it is.
    void mark_walls(const Raster& walls);
    /// Lowers the bed by the depth in each cell of a north-up raster [m]; NaN: not.
    void lower_bed(const Raster& depth);

    static constexpr std::uint8_t k_gap = 1, k_wall = 2;  ///< why a node is solid

    /// Ground::datum, which `bed` is relative to.
    [[nodiscard]] double datum() const noexcept { return datum_; }

    ZeroArray<double> bed;        ///< padded, relative to datum [m]
    ZeroArray<NodeLevel> levels;  ///< padded; empty when no term needs it

    bool bed_changes = false;  ///< the bed may differ from the terrain

    [[nodiscard]] std::size_t size() const noexcept { return records.size(); }
    /// Volume on a node, in every phase [m3].
    [[nodiscard]] double mass(std::size_t node) const noexcept { return records[node].sums.mass; }
    /// The records in their present phase; builds with assertions stop if the phase is another.
    [[nodiscard]] NodeSums* sums() noexcept { return (check(NodePhase::sums), &records.data()->sums); }
    [[nodiscard]] const NodeSums* sums() const noexcept { return (check(NodePhase::sums), &records.data()->sums); }
    [[nodiscard]] NodeForces* forces() noexcept { return (check(NodePhase::forces), &records.data()->forces); }
    [[nodiscard]] const NodeForces* forces() const noexcept {
        return (check(NodePhase::forces), &records.data()->forces);
    }
    [[nodiscard]] NodeMotion* motion() noexcept { return (check(NodePhase::motion), &records.data()->motion); }
    [[nodiscard]] const NodeMotion* motion() const noexcept {
        return (check(NodePhase::motion), &records.data()->motion);
    }

    ZeroArray<NodeRecord> records;  ///< padded
    NodePhase phase = NodePhase::sums;

    /// Everything that may differ from the state after construction and mark_walls.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [z, node_levels, changes, node_records, now, nx, ny, oi, oj, dx, lowest, edges, marks,
                                on_demand] = *this;
        archive(changes);
        std::vector<std::uint64_t> blocks = covered_blocks();
        std::uint64_t ground = changes ? 0 : ground_checksum();
        archive(blocks, ground);
        if constexpr (Archive::k_reads) cover_again(blocks, changes ? 0 : ground);
        if (changes) archive(z);
        if constexpr (Archive::k_reads) keep_place();
        archive(node_records, node_levels);
        if constexpr (Archive::k_reads) now = NodePhase::motion;
    }

    void allocate_levels() { levels = ZeroArray<NodeLevel>(size()); }

  private:
    void check([[maybe_unused]] NodePhase wanted) const noexcept { assert(phase == wanted); }
    void for_each_covered_block(const std::function<void(const Block&)>& visit) const;
    // Numbers of the blocks covered on demand.
    [[nodiscard]] std::vector<std::uint64_t> covered_blocks() const;
    // Checksum of the elevations read on demand.
    [[nodiscard]] std::uint64_t ground_checksum() const;
    // Rereads the blocks of the checkpoint. Throws Error(input) if their checksum differs; a checksum of 0 is not
    // compared.
    void cover_again(const std::vector<std::uint64_t>& blocks, std::uint64_t checksum);
    // Restores the derived values after the bed was read.
    void keep_place();
    // The node of a terrain cell, rows from the north.
    [[nodiscard]] std::size_t node_of_cell(std::size_t cell) const noexcept {
        const auto n = static_cast<std::int64_t>(cell);
        return index(n % columns_, rows_ - 1 - n / columns_);
    }
    struct Beds;
    struct Demand;
    void fill(const Raster& terrain, const Beds& beds) const;
    void read_block(std::int64_t block_column, std::int64_t block_row) const;
    void extend_beyond_edges(const Beds& beds) const;
    [[nodiscard]] Beds all_beds() const;

    std::int64_t columns_, rows_, origin_column_, origin_row_;
    double cell_size_, datum_;
    Bounds bounds_;
    ZeroArray<std::uint8_t> solid_;
    std::unique_ptr<Demand> demand_;  // null: the terrain was read as a whole
};

/// The padded index range [i0, i1) x [j0, j1) of a tile's nodes; each node belongs to exactly one tile.
struct NodeRange {
    std::int64_t i0, i1, j0, j1;

    NodeRange(std::int64_t west, std::int64_t east, std::int64_t south, std::int64_t north) noexcept
        : i0(west), i1(east), j0(south), j1(north) {}
    NodeRange(std::int64_t tile, const TileGrid& tiles, const NodeGrid& nodes) noexcept
        : i0(within(tile % tiles.tiles_x() * k_tile - tiles.before_x(), nodes.stride())),
          i1(within((tile % tiles.tiles_x() + 1) * k_tile - tiles.before_x(), nodes.stride())),
          j0(within(tile / tiles.tiles_x() * k_tile - tiles.before_y(), nodes.padded_rows())),
          j1(within((tile / tiles.tiles_x() + 1) * k_tile - tiles.before_y(), nodes.padded_rows())) {}

    /// Calls visit(index, i, j) for every node, i and j padded.
    template <class Visit>
    void for_each(std::int64_t stride, const Visit& visit) const {
        for (std::int64_t j = j0; j < j1; ++j) {
            for (std::int64_t i = i0; i < i1; ++i) visit(static_cast<std::size_t>(j * stride + i), i, j);
        }
    }

  private:
    static std::int64_t within(std::int64_t node, std::int64_t count) noexcept {
        return std::clamp<std::int64_t>(node, 0, count);
    }
};

/// Zeroes the records of one tile's nodes, in any phase.
inline void clear_nodes(const NodeRange& range, NodeGrid& nodes) {
    for (std::int64_t j = range.j0; j < range.j1; ++j) {
        NodeRecord* row = nodes.records.data() + j * nodes.stride();
        std::fill(row + range.i0, row + range.i1, NodeRecord{});
    }
}

}  // namespace frana
