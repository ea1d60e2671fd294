// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/cell_store.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/error.h"

namespace frana::app::study {
namespace {

constexpr Quantity k_stored[] = {Quantity::depth,    Quantity::velocity,  Quantity::arrival,
                                 Quantity::pressure, Quantity::intensity, Quantity::momentum};
constexpr std::size_t k_parts = std::size(k_stored),
                      k_bytes = 2 * sizeof(std::uint32_t) + k_parts * sizeof(float);  // of a cell of a record

[[noreturn]] void fail(const std::string& what, const std::string& folder) {
    throw Error(ErrorKind::environment,
                Problem{what + ": " + std::strerror(errno), folder, "", "", "Check the disk and its free space"});
}

}  // namespace

CellStore::CellStore(std::vector<RecordPlace> records) : records_(std::move(records)) {}

CellStore::~CellStore() = default;

void CellStore::load(const GridSpec& grid) {
    if (is_loaded_ && grid_.same_cells(grid)) return;
    batches_.clear();
    file_.reset();
    grid_ = grid;
    // What a tile contains has a place in memory even where all records reach all its cells, unless the grid has so
    // many cells that no record reaches but a few of them.
    constexpr std::uint64_t k_most_tiles = 65536;
    const auto cells_of_grid = static_cast<std::uint64_t>(grid.rows * grid.columns);
    tile_cells_ = std::max<std::uint64_t>(
        {1, k_budget_bytes / 4 / k_bytes / std::max<std::size_t>(1, records_.size()), cells_of_grid / k_most_tiles});
    std::vector<std::uint64_t> cells;
    std::vector<std::uint32_t> numbers;
    std::vector<std::vector<float>> values(k_parts);
    const auto store = [&] {
        add(cells, numbers, values);
        cells.clear();
        numbers.clear();
        for (std::vector<float>& one : values) one.clear();
    };
    for (std::size_t r = 0; r < records_.size(); ++r) {
        const MemberRecord record = require_record(records_[r]);
        record.for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
            if (row < 0 || column < 0 || row >= grid.rows || column >= grid.columns) return;
            cells.push_back(static_cast<std::uint64_t>(row * grid.columns + column));
            numbers.push_back(static_cast<std::uint32_t>(r));
            for (std::size_t q = 0; q < k_parts; ++q) {
                const std::vector<float>& of = record.of(k_stored[q]);
                values[q].push_back(of.empty() ? 0.0F : of[index]);
            }
        });
        if (2 * k_bytes * cells.size() < k_budget_bytes / 2) continue;
        store();
        write(batches_.back());
    }
    store();
    is_loaded_ = true;
}

void CellStore::add(const std::vector<std::uint64_t>& cells, const std::vector<std::uint32_t>& records,
                    const std::vector<std::vector<float>>& values) {
    const std::size_t tiles = static_cast<std::size_t>(grid_.rows * grid_.columns) / tile_cells_ + 1;
    Batch batch;
    batch.begins.assign(tiles + 1, 0);
    for (const std::uint64_t cell : cells) ++batch.begins[cell / tile_cells_ + 1];
    for (std::size_t tile = 0; tile < tiles; ++tile) batch.begins[tile + 1] += batch.begins[tile];
    batch.bytes.resize(cells.size() * k_bytes);
    std::vector<std::uint64_t> filled(tiles);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t tile = cells[i] / tile_cells_;
        const std::uint64_t count = batch.begins[tile + 1] - batch.begins[tile], at = filled[tile]++;
        char* const begin = batch.bytes.data() + batch.begins[tile] * k_bytes;
        const auto put = [&](std::size_t part, const auto& value) {
            std::memcpy(begin + (part * count + at) * sizeof value, &value, sizeof value);
        };
        put(0, static_cast<std::uint32_t>(cells[i] % tile_cells_));
        put(1, records[i]);
        for (std::size_t q = 0; q < k_parts; ++q) put(2 + q, values[q][i]);
    }
    batches_.push_back(std::move(batch));
}

void CellStore::write(Batch& batch) {
    const std::string folder = std::filesystem::path(records_.front().file).parent_path().string();
    if (!file_) {
        std::string name = folder + "/cellsXXXXXX";
        const int descriptor = ::mkstemp(name.data());
        if (descriptor < 0) fail("cannot be written to", folder);
        ::unlink(name.c_str());
        file_ = {::fdopen(descriptor, "w+b"), std::fclose};
    }
    batch.at = batches_.size() < 2
                   ? 0
                   : batches_[batches_.size() - 2].at + batches_[batches_.size() - 2].begins.back() * k_bytes;
    const bool good = std::fseek(file_.get(), static_cast<long>(batch.at), SEEK_SET) == 0 &&
                      std::fwrite(batch.bytes.data(), 1, batch.bytes.size(), file_.get()) == batch.bytes.size() &&
                      std::fflush(file_.get()) == 0;
    if (!good) fail("cannot be written to", folder);
    batch.bytes = {};
}

CellStore::Piece CellStore::piece(const Batch& batch, std::size_t tile, std::size_t quantity) const {
    const std::uint64_t count = batch.begins[tile + 1] - batch.begins[tile], begin = batch.begins[tile] * k_bytes;
    Piece piece;
    const auto get = [&](std::size_t part, auto& list) {
        list.resize(count);
        const std::size_t bytes = count * sizeof list[0], from = begin + part * bytes;
        if (!batch.bytes.empty()) {
            std::memcpy(list.data(), batch.bytes.data() + from, bytes);
        } else if (std::fseek(file_.get(), static_cast<long>(batch.at + from), SEEK_SET) != 0 ||
                   std::fread(list.data(), 1, bytes, file_.get()) != bytes) {
            fail("cannot be read from", std::filesystem::path(records_.front().file).parent_path().string());
        }
    };
    get(0, piece.cells);
    get(1, piece.records);
    get(2 + quantity, piece.values);
    return piece;
}

void CellStore::for_each_cell(Quantity quantity, const GridSpec& grid,
                              const std::function<void(std::size_t cell, std::span<const Value> values)>& visit) {
    load(grid);
    const auto stored =
        static_cast<std::size_t>(std::find(std::begin(k_stored), std::end(k_stored), quantity) - std::begin(k_stored));
    std::vector<Value> sorted;          // by cell
    std::vector<std::uint64_t> begins;  // of each cell's
    for (std::size_t tile = 0; tile + 1 < batches_.front().begins.size(); ++tile) {
        std::vector<Piece> pieces;
        for (const Batch& batch : batches_)
            if (batch.begins[tile] < batch.begins[tile + 1]) pieces.push_back(piece(batch, tile, stored));
        if (pieces.empty()) continue;
        begins.assign(tile_cells_ + 1, 0);
        for (const Piece& one : pieces)
            for (const std::uint32_t cell : one.cells) ++begins[cell + 1];
        for (std::size_t cell = 0; cell < tile_cells_; ++cell) begins[cell + 1] += begins[cell];
        sorted.resize(begins.back());
        std::vector<std::uint64_t> next(begins.begin(), begins.end() - 1);
        for (const Piece& one : pieces)
            for (std::size_t i = 0; i < one.cells.size(); ++i)
                sorted[next[one.cells[i]]++] = {one.records[i], one.values[i]};
        for (std::size_t cell = 0; cell < tile_cells_; ++cell) {
            const std::span<const Value> values(sorted.data() + begins[cell], begins[cell + 1] - begins[cell]);
            if (!values.empty()) visit(tile * tile_cells_ + cell, values);
        }
    }
}

}  // namespace frana::app::study
