// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/geometry.h"

namespace frana {

/// The part of a lattice cell covered by an outline: its area and first moments about the origin.
struct Covered {
    double area = 0, moment_x = 0, moment_y = 0;
};

/// Computes the part of each cell of a square lattice that an outline covers: exactly, except where edges of
/// overlapping parts cross. Holes count as outside, area in several parts counts once. The lattice is anchored at the
/// origin.
///
/// The cost grows with the number of vertices times its logarithm, whatever the outline's shape.
class LatticeCover {
  public:
    LatticeCover(const MultiPolygon& outline, double spacing);

    [[nodiscard]] std::int64_t first_row() const noexcept { return first_row_; }
    [[nodiscard]] std::int64_t last_row() const noexcept { return last_row_; }

    /// Returns the cells of one row from west to east; valid until the next call. Rows must be requested from south to
    /// north.
    const std::vector<Covered>& row(std::int64_t row);

  private:
    struct Edge {
        Point from, to;  // in the ring's order
        double low, high;
        std::size_t polygon;
        double sense;  // +1: the polygon's inside is to the left
    };
    struct Band;

    void add_ring(const Ring& ring, std::size_t polygon, bool hole);
    void enter_row(double from, double to);
    [[nodiscard]] std::vector<double> strip_heights(const Band& band) const;
    [[nodiscard]] bool too_many_strips(const Band& band) const;
    void cover_by_strips(const std::vector<double>& heights);
    void cover_along_edges(const Band& band);
    void add_piece(const Band& band, std::int64_t column, Point from, Point to, double sense);

    double spacing_;
    std::int64_t first_row_, last_row_, first_column_, last_column_;
    std::size_t parts_;
    bool parts_are_apart_;
    std::vector<Edge> edges_;  // by their lower ends
    std::size_t entered_ = 0;
    std::vector<std::size_t> active_;  // edges in the row, by their lower ends
    std::vector<Covered> cells_;
    std::vector<std::pair<double, double>> beyond_;  // height and its first moment of pieces that end in a cell
};

}  // namespace frana
