// SPDX-License-Identifier: Apache-2.0
#include "core/cell_values.h"

#include <algorithm>
#include <mutex>

namespace frana {
namespace {

constexpr std::int64_t k_side = CellValues::k_side;
constexpr std::size_t k_tile_cells = static_cast<std::size_t>(k_side * k_side);
// A source is asked for so many tiles at once along each side: files are read in blocks about as large.
constexpr std::int64_t k_tiles_at_once = 4;

}  // namespace

struct CellValues::Tiles {
    std::int64_t rows, columns;
    double fill;
    Source source;
    std::int64_t across, down;                      // tiles
    std::vector<std::unique_ptr<double[]>> values;  // NOLINT(modernize-avoid-c-arrays): by tile, row by row

    Tiles(std::int64_t r, std::int64_t c, double f, Source s)
        : rows(r),
          columns(c),
          fill(f),
          source(std::move(s)),
          across((c + k_side - 1) / k_side),
          down((r + k_side - 1) / k_side),
          values(static_cast<std::size_t>(across * down)) {}
    Tiles(const Tiles& other)
        : rows(other.rows),
          columns(other.columns),
          fill(other.fill),
          source(other.source),
          across(other.across),
          down(other.down),
          values(other.values.size()) {
        for (std::size_t t = 0; t < values.size(); ++t) {
            if (!other.values[t]) continue;
            values[t] = std::make_unique<double[]>(k_tile_cells);  // NOLINT(modernize-avoid-c-arrays)
            std::copy_n(other.values[t].get(), k_tile_cells, values[t].get());
        }
    }

    double* make(std::int64_t tile) {
        auto& made = values[static_cast<std::size_t>(tile)];
        made = std::make_unique<double[]>(k_tile_cells);  // NOLINT(modernize-avoid-c-arrays)
        std::fill_n(made.get(), k_tile_cells, fill);
        return made.get();
    }
    // Sources read from files, which copies of the values share: one at a time, and one may ask another.
    void ask(const CellWindow& window, double* to) const {
        static std::recursive_mutex one_at_a_time;
        const std::lock_guard lock(one_at_a_time);
        source(window, to);
    }
    // Reads the tiles round one that does not exist yet.
    void fetch(std::int64_t i, std::int64_t j) {
        const std::int64_t i0 = i / k_tiles_at_once * k_tiles_at_once, j0 = j / k_tiles_at_once * k_tiles_at_once;
        const std::int64_t i1 = std::min(i0 + k_tiles_at_once, across), j1 = std::min(j0 + k_tiles_at_once, down);
        const CellWindow window{j0 * k_side, i0 * k_side, std::min(j1 * k_side, rows) - j0 * k_side,
                                std::min(i1 * k_side, columns) - i0 * k_side};
        std::vector<double> read(static_cast<std::size_t>(window.rows * window.columns));
        ask(window, read.data());
        for (std::int64_t b = j0; b < j1; ++b) {
            for (std::int64_t a = i0; a < i1; ++a) {
                if (values[static_cast<std::size_t>(b * across + a)]) continue;
                double* const to = make(b * across + a);
                const std::int64_t wide = std::min(k_side, columns - a * k_side);
                for (std::int64_t r = b * k_side; r < std::min((b + 1) * k_side, rows); ++r)
                    std::copy_n(read.data() + (r - window.row) * window.columns + a * k_side - window.column, wide,
                                to + (r - b * k_side) * k_side);
            }
        }
    }
    // Null: not stored, and no source.
    double* find(std::int64_t i, std::int64_t j) {
        const auto tile = static_cast<std::size_t>(j * across + i);
        if (!values[tile] && source) fetch(i, j);
        return values[tile].get();
    }
};

CellValues::CellValues() = default;
CellValues::CellValues(std::vector<double> values) : dense_(std::make_shared<std::vector<double>>(std::move(values))) {}
CellValues::CellValues(std::initializer_list<double> values) : dense_(std::make_shared<std::vector<double>>(values)) {}
CellValues::CellValues(std::int64_t rows, std::int64_t columns, double fill) {
    if (rows * columns > k_most_dense) {
        tiles_ = std::make_unique<Tiles>(rows, columns, fill, Source());
    } else {
        dense_ = std::make_shared<std::vector<double>>(static_cast<std::size_t>(rows * columns), fill);
    }
}

CellValues CellValues::tiled(std::int64_t rows, std::int64_t columns, double fill, Source source) {
    CellValues values;
    values.tiles_ = std::make_unique<Tiles>(rows, columns, fill, std::move(source));
    return values;
}

CellValues::CellValues(const CellValues& other)
    : dense_(other.dense_), tiles_(other.tiles_ ? std::make_unique<Tiles>(*other.tiles_) : nullptr) {}
CellValues::CellValues(CellValues&& other) noexcept = default;
CellValues& CellValues::operator=(const CellValues& other) {
    if (this != &other) *this = CellValues(other);
    return *this;
}
CellValues& CellValues::operator=(CellValues&& other) noexcept = default;
CellValues::~CellValues() = default;

std::size_t CellValues::tiled_size() const noexcept {
    return static_cast<std::size_t>(tiles_->rows * tiles_->columns);
}

std::int64_t CellValues::stored_cells() const noexcept {
    if (!tiles_) return static_cast<std::int64_t>(size());
    return std::count_if(tiles_->values.begin(), tiles_->values.end(), [](const auto& tile) { return !!tile; }) *
           k_side * k_side;
}

double CellValues::tiled_value(std::size_t cell) const {
    const auto n = static_cast<std::int64_t>(cell);
    const std::int64_t row = n / tiles_->columns, column = n - row * tiles_->columns;
    const double* const tile = tiles_->find(column / k_side, row / k_side);
    return tile == nullptr ? tiles_->fill : tile[row % k_side * k_side + column % k_side];
}

double& CellValues::tiled_place(std::size_t cell) {
    const auto n = static_cast<std::int64_t>(cell);
    const std::int64_t row = n / tiles_->columns, column = n - row * tiles_->columns;
    const std::int64_t i = column / k_side, j = row / k_side;
    double* tile = tiles_->find(i, j);
    if (tile == nullptr) tile = tiles_->make(j * tiles_->across + i);
    return tile[row % k_side * k_side + column % k_side];
}

void CellValues::visit_tiled(const std::function<void(std::size_t, double*, std::size_t)>& visit) const {
    const Tiles& t = *tiles_;
    std::vector<std::int64_t> there;
    for (std::int64_t j = 0; j < t.down; ++j) {
        there.clear();
        for (std::int64_t i = 0; i < t.across; ++i)
            if (t.values[static_cast<std::size_t>(j * t.across + i)]) there.push_back(i);
        if (there.empty()) continue;
        for (std::int64_t row = j * k_side; row < std::min((j + 1) * k_side, t.rows); ++row) {
            for (const std::int64_t i : there)
                visit(static_cast<std::size_t>(row * t.columns + i * k_side),
                      t.values[static_cast<std::size_t>(j * t.across + i)].get() + (row - j * k_side) * k_side,
                      static_cast<std::size_t>(std::min(k_side, t.columns - i * k_side)));
        }
    }
}

bool CellValues::stores_any(const CellWindow& w) const {
    if (!tiles_) return !empty();
    const Tiles& t = *tiles_;
    for (std::int64_t j = w.row / k_side; j <= (w.row + w.rows - 1) / k_side && j < t.down; ++j)
        for (std::int64_t i = w.column / k_side; i <= (w.column + w.columns - 1) / k_side && i < t.across; ++i)
            if (t.values[static_cast<std::size_t>(j * t.across + i)]) return true;
    return false;
}

std::vector<CellWindow> CellValues::stored_windows(std::int64_t columns) const {
    if (!tiles_) {
        const auto cells = static_cast<std::int64_t>(size());
        return cells == 0 ? std::vector<CellWindow>() : std::vector{CellWindow{0, 0, cells / columns, columns}};
    }
    struct Box {
        std::int64_t i0, i1, j0, j1;  // tiles, [i0, i1) x [j0, j1)
    };
    const Tiles& t = *tiles_;
    std::vector<Box> boxes;
    for (std::int64_t j = 0; j < t.down; ++j) {
        for (std::int64_t i = 0; i < t.across; ++i) {
            if (!t.values[static_cast<std::size_t>(j * t.across + i)]) continue;
            // Takes in all boxes that it touches, and all that these then touch.
            Box box{i, i + 1, j, j + 1};
            for (bool grew = true; grew;) {
                const auto touched = std::partition(boxes.begin(), boxes.end(), [&](const Box& b) {
                    return b.i1 < box.i0 || b.i0 > box.i1 || b.j1 < box.j0 || b.j0 > box.j1;
                });
                grew = touched != boxes.end();
                for (auto b = touched; b != boxes.end(); ++b)
                    box = {std::min(box.i0, b->i0), std::max(box.i1, b->i1), std::min(box.j0, b->j0),
                           std::max(box.j1, b->j1)};
                boxes.erase(touched, boxes.end());
            }
            boxes.push_back(box);
        }
    }
    std::sort(boxes.begin(), boxes.end(),
              [](const Box& a, const Box& b) { return a.j0 != b.j0 ? a.j0 < b.j0 : a.i0 < b.i0; });
    std::vector<CellWindow> windows;
    for (const Box& b : boxes)
        windows.push_back({b.j0 * k_side, b.i0 * k_side, std::min(b.j1 * k_side, t.rows) - b.j0 * k_side,
                           std::min(b.i1 * k_side, t.columns) - b.i0 * k_side});
    return windows;
}

std::vector<double>& CellValues::dense() {
    static_cast<void>(std::as_const(*this).dense());
    return own();
}

void CellValues::part() {
    dense_ = std::make_shared<std::vector<double>>(side_by_side());
}

const std::vector<double>& CellValues::dense() const {
    if (!tiles_) return side_by_side();
    std::vector<double> all(tiled_size(), tiles_->fill);
    if (tiles_->source) tiles_->ask({0, 0, tiles_->rows, tiles_->columns}, all.data());
    for_each_run([&](std::size_t first, const double* values, std::size_t count) {
        std::copy_n(values, count, all.begin() + static_cast<std::ptrdiff_t>(first));
    });
    dense_ = std::make_shared<std::vector<double>>(std::move(all));
    tiles_.reset();
    return *dense_;
}

}  // namespace frana
