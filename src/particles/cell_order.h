// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/grid_spec.h"
#include "core/thread_pool.h"
#include "particles/particle_set.h"

namespace frana {

/// A run of particles, [begin, end).
struct ParticleRun {
    std::size_t begin = 0, end = 0;
};

/// The order of particles by square cells, row after row, for methods in which particles interact within a fixed reach.
/// Cells are slightly wider than half the reach, so that all neighbours of a cell's particles are in five runs, one for
/// each of five rows of five cells:
///
///     row + 2   [ - - - - - ]
///     row       [ - - x - - ]      cell side = (reach + slack) / 2
///     row - 2   [ - - - - - ]
///
/// Of more than k_most_empty empty rows or columns in succession only so many are kept: flows far apart cost what each
/// of them does.
///
/// until two particles have approached each other by `slack`. The order depends only on positions and the former order,
/// not on threads.
class CellOrder {
  public:
    static constexpr std::int64_t k_near = 2;  ///< cells on either side
    static constexpr std::size_t k_rows_near = 2 * k_near + 1;
    static constexpr double k_slack = 0.125;  ///< over the reach
    /// More than any method looks at around a cell.
    static constexpr std::int64_t k_most_empty = 8;

    /// @param reach greatest distance at which particles interact [m]
    explicit CellOrder(double reach) : reach_(reach), side_(0.5 * reach * (1 + k_slack)) {}

    /// Sorts the particles by cell (stable) and drops those for which `keep` is 0.
    /// @param keep one byte per particle, or empty to keep all
    void sort(ParticleSet& particles, const std::vector<std::uint8_t>& keep, ThreadPool& pool);

    [[nodiscard]] double reach() const noexcept { return reach_; }
    [[nodiscard]] double side() const noexcept { return side_; }
    /// How much two particles may approach each other until the next sort [m].
    [[nodiscard]] double slack() const noexcept { return reach_ * k_slack; }
    /// The smallest rectangle around all particles at the last sort.
    [[nodiscard]] Bounds bounds() const noexcept { return {west_, south_, east_, north_}; }
    /// Rows and columns that may contain particles, without most of the empty ones; empty cells surround them.
    [[nodiscard]] std::int64_t rows() const noexcept { return rows_; }
    [[nodiscard]] std::int64_t columns() const noexcept { return columns_; }

    /// Particles of one cell, or of a row's cells from `first` to `last`, both included.
    [[nodiscard]] ParticleRun cell(std::int64_t row, std::int64_t column) const noexcept {
        return cells(row, column, column);
    }
    [[nodiscard]] ParticleRun cells(std::int64_t row, std::int64_t first, std::int64_t last) const noexcept {
        return {starts_[place(row, first)], starts_[place(row, last) + 1]};
    }
    /// Particles of the rows from `first` to `last`, both included.
    [[nodiscard]] ParticleRun whole_rows(std::int64_t first, std::int64_t last) const noexcept {
        return {starts_[place(first, 0)], starts_[place(last, columns_ - 1) + 1]};
    }
    [[nodiscard]] std::array<ParticleRun, k_rows_near> around(std::int64_t row, std::int64_t column) const noexcept {
        std::array<ParticleRun, k_rows_near> runs;
        for (std::int64_t r = -k_near; r <= k_near; ++r)
            runs[static_cast<std::size_t>(r + k_near)] = cells(row + r, column - k_near, column + k_near);
        return runs;
    }

    /// Runs a task, parallel, over runs of rows whose particles add to places up to half of `width` [m] away, and
    /// slack: every second strip of rows at a time, the strip between is wider than the places that two of them could
    /// share.
    template <class Task>
    void for_each_strip(double width, ThreadPool& pool, const Task& task) const {
        const auto strip = static_cast<std::int64_t>((width + slack()) / side_) + 1;
        const std::int64_t strips = (rows_ + strip - 1) / strip;
        for (std::int64_t parity = 0; parity < 2; ++parity) {
            pool.for_each(static_cast<std::size_t>((strips - parity + 1) / 2), [&](std::size_t k) {
                const std::int64_t first = (2 * static_cast<std::int64_t>(k) + parity) * strip;
                task(whole_rows(first, std::min(first + strip, rows_) - 1));
            });
        }
    }

    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [reach, cell_side, west, south, east, north, n_rows, n_columns, starts, keys, source,
                                column_of, row_of] = *this;
        archive(west, south, east, north, n_rows, n_columns, starts);  // the others are used by a sort only
    }
    /// After reading: whether this is an order of `count` particles.
    [[nodiscard]] bool orders(std::size_t count) const;

  private:
    [[nodiscard]] std::size_t place(std::int64_t row, std::int64_t column) const noexcept {
        return static_cast<std::size_t>((row + k_near) * (columns_ + 2 * k_near) + column + k_near);
    }

    double reach_, side_;
    double west_ = 0, south_ = 0, east_ = 0, north_ = 0;
    std::int64_t rows_ = 0, columns_ = 0;
    std::vector<std::uint32_t> starts_;  // of each cell, the surrounding ones included, and one more
    std::vector<std::uint32_t> keys_, source_;
    std::vector<std::int32_t> column_of_, row_of_;  // the cell's number by its distance from the west, the south
};

}  // namespace frana
