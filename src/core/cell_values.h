// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace frana {

/// A rectangle of cells of a raster.
struct CellWindow {
    std::int64_t row = 0, column = 0, rows = 0, columns = 0;
};

/// The values of a raster's cells, row by row: all of them side by side, or, on large maps, in square tiles of which
/// only those exist that were written. A cell of a tile that does not exist has the fill value, or comes from a source
/// when it is first asked for. Who needs all values side by side (data(), begin()) gets them, at the cost of all of
/// their memory; loops over large rasters visit what is stored instead.
/// Reading a cell that comes from a source changes the storage: not from several threads at once.
///
/// Copies of values side by side share them until one is changed, so that the members of a study share one terrain.
/// Writing takes a copy then, also of who only asks for places to write: the first access that may write is not to be
/// from several threads at once, and no place that was handed out is to be written after the values were copied.
class CellValues {
  public:
    /// Side of a tile [cells].
    static constexpr std::int64_t k_side = 64;
    /// Rasters of more cells are tiled.
    static constexpr std::int64_t k_most_dense = 10'000'000;
    /// Fills a window, row by row. Windows are made of whole tiles, as far as the raster reaches.
    using Source = std::function<void(const CellWindow& window, double* values)>;

    CellValues();
    CellValues(std::vector<double> values);  // NOLINT(google-explicit-constructor): side by side
    CellValues(std::initializer_list<double> values);
    CellValues(std::int64_t rows, std::int64_t columns, double fill);
    /// Tiles, however few the cells are.
    [[nodiscard]] static CellValues tiled(std::int64_t rows, std::int64_t columns, double fill, Source source = {});

    CellValues(const CellValues& other);
    CellValues(CellValues&& other) noexcept;
    CellValues& operator=(const CellValues& other);
    CellValues& operator=(CellValues&& other) noexcept;
    ~CellValues();

    [[nodiscard]] bool is_tiled() const noexcept { return tiles_ != nullptr; }
    [[nodiscard]] std::size_t size() const noexcept { return tiles_ ? tiled_size() : side_by_side().size(); }
    [[nodiscard]] bool empty() const noexcept { return size() == 0; }
    /// Cells that take memory.
    [[nodiscard]] std::int64_t stored_cells() const noexcept;

    double operator[](std::size_t cell) const { return tiles_ ? tiled_value(cell) : (*dense_)[cell]; }
    double& operator[](std::size_t cell) { return tiles_ ? tiled_place(cell) : own()[cell]; }

    /// Calls visit(first, values, count) for the stored parts of rows, in the order of cells.
    template <class Visit>
    void for_each_run(const Visit& visit) const {
        if (!tiles_) {
            if (!empty()) visit(std::size_t{0}, dense_->data(), dense_->size());
            return;
        }
        visit_tiled([&](std::size_t first, double* values, std::size_t count) {
            visit(first, static_cast<const double*>(values), count);
        });
    }
    /// Calls visit(cell, value) for the stored cells, in order.
    template <class Visit>
    void for_each_stored(const Visit& visit) const {
        for_each_run([&](std::size_t first, const double* values, std::size_t count) {
            for (std::size_t k = 0; k < count; ++k) visit(first + k, values[k]);
        });
    }
    /// The same with references, to change them.
    template <class Visit>
    void change_each_stored(const Visit& visit) {
        const auto run = [&](std::size_t first, double* values, std::size_t count) {
            for (std::size_t k = 0; k < count; ++k) visit(first + k, values[k]);
        };
        if (!tiles_) {
            run(0, own().data(), own().size());
        } else {
            visit_tiled(run);
        }
    }
    /// Windows that hold all stored cells and share none: groups of tiles that touch each other. Dense: everything.
    [[nodiscard]] std::vector<CellWindow> stored_windows(std::int64_t columns) const;
    /// Whether any cell of a window is stored.
    [[nodiscard]] bool stores_any(const CellWindow& window) const;

    /// All values side by side.
    [[nodiscard]] std::vector<double>& dense();
    [[nodiscard]] const std::vector<double>& dense() const;
    [[nodiscard]] double* data() { return dense().data(); }
    [[nodiscard]] const double* data() const { return dense().data(); }
    [[nodiscard]] auto begin() { return dense().begin(); }
    [[nodiscard]] auto end() { return dense().end(); }
    [[nodiscard]] auto begin() const { return dense().begin(); }
    [[nodiscard]] auto end() const { return dense().end(); }
    [[nodiscard]] double front() const { return (*this)[0]; }
    [[nodiscard]] double back() const { return (*this)[size() - 1]; }
    operator const std::vector<double>&() const { return dense(); }  // NOLINT(google-explicit-constructor)
    void push_back(double value) { dense().push_back(value); }
    void resize(std::size_t count, double value = 0) { dense().resize(count, value); }
    template <class First, class Last>
    void assign(First first, Last last) {
        *this = CellValues(std::vector<double>(first, last));
    }
    friend bool operator==(const CellValues& a, const CellValues& b) { return a.dense() == b.dense(); }

  private:
    struct Tiles;

    [[nodiscard]] std::size_t tiled_size() const noexcept;
    [[nodiscard]] double tiled_value(std::size_t cell) const;
    [[nodiscard]] double& tiled_place(std::size_t cell);
    void visit_tiled(const std::function<void(std::size_t, double*, std::size_t)>& visit) const;

    // The values, or none at all.
    [[nodiscard]] const std::vector<double>& side_by_side() const noexcept {
        static const std::vector<double> empty;
        return dense_ ? *dense_ : empty;
    }
    // The values, which no copy shares any more.
    [[nodiscard]] std::vector<double>& own() {
        if (!dense_ || dense_.use_count() > 1) part();
        std::atomic_thread_fence(std::memory_order_acquire);  // who shared them may just have ended reading
        return *dense_;
    }
    void part();

    mutable std::shared_ptr<std::vector<double>> dense_;  // null: empty, or in tiles
    mutable std::unique_ptr<Tiles> tiles_;                // none: dense
};

}  // namespace frana
