// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/study/record_files.h"
#include "core/grid_spec.h"

namespace frana::app::study {

/// The values of many records by cells of a grid. Each record is read once, whatever is asked for afterwards. What
/// memory has no place for is in a file without a name beside the records, in batches of records, each sorted by tiles:
///
///     batch:  tile 0 | tile 1 | ...        tile:  cells | records | quantity 0 | quantity 1 | ...
///
/// so that a tile's values of one quantity are a few pieces of it. Time and disk grow with what the records contain,
/// memory does not.
class CellStore {
  public:
    explicit CellStore(std::vector<RecordPlace> records);
    ~CellStore();
    CellStore(const CellStore&) = delete;
    CellStore& operator=(const CellStore&) = delete;

    struct Value {
        std::uint32_t record = 0;
        float value = 0;
    };
    /// Calls visit(cell, values) for every cell of the grid that any record reached, in order of cells; values has
    /// those of the records that came, in their order. Throws Error(environment) for a record that cannot be read and a
    /// file that cannot be written.
    void for_each_cell(Quantity quantity, const GridSpec& grid,
                       const std::function<void(std::size_t cell, std::span<const Value> values)>& visit);

    /// Bytes that may be in memory at once, for a batch and for a tile.
    static constexpr std::size_t k_budget_bytes = 256'000'000;

  private:
    /// Values of one tile, by quantity: of as many cells of records.
    struct Piece {
        std::vector<std::uint32_t> cells, records;
        std::vector<float> values;
    };
    struct Batch {
        std::vector<std::uint64_t> begins;  ///< by tile, and the end: numbers of its first values
        std::uint64_t at = 0;               ///< its first byte in the file
        std::string bytes;                  ///< empty: in the file
    };
    void load(const GridSpec& grid);
    void add(const std::vector<std::uint64_t>& cells, const std::vector<std::uint32_t>& records,
             const std::vector<std::vector<float>>& values);
    void write(Batch& batch);
    [[nodiscard]] Piece piece(const Batch& batch, std::size_t tile, std::size_t quantity) const;

    std::vector<RecordPlace> records_;
    GridSpec grid_;
    bool is_loaded_ = false;
    std::uint64_t tile_cells_ = 1;
    std::vector<Batch> batches_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, nullptr};
};

}  // namespace frana::app::study
