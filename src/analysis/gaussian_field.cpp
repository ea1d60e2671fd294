// SPDX-License-Identifier: Apache-2.0
#include "analysis/gaussian_field.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace frana {
namespace {

constexpr double k_reach = 4;           // of the kernel, in s: beyond, it is less than 4e-4 of its greatest value
constexpr double k_finest_lattice = 8;  // points of the lattice within s, at least, where s is many cells

/// Mixes a word so that every bit of it changes every bit of the result (Steele, Lea & Flood 2014, SplitMix64).
std::uint64_t mixed(std::uint64_t word) {
    word += 0x9E3779B97F4A7C15ULL;
    word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9ULL;
    word = (word ^ (word >> 27)) * 0x94D049BB133111EBULL;
    return word ^ (word >> 31);
}

/// A normal deviate of a place of the lattice (Box & Muller 1958).
double deviate(std::int64_t seed, std::int64_t i, std::int64_t j) {
    const std::uint64_t place = mixed(mixed(mixed(static_cast<std::uint64_t>(seed)) ^ static_cast<std::uint64_t>(i)) ^
                                      static_cast<std::uint64_t>(j));
    constexpr double k_unit = 1.0 / 9007199254740992.0;  // 2^-53
    const double u = (static_cast<double>(place >> 11) + 0.5) * k_unit,
                 v = static_cast<double>(mixed(place) >> 11) * k_unit;
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// Weights of the lattice's points round each cell of a row or column, scaled so that their squares add up to 1.
class Kernel {
  public:
    /// @param first number of the first cell, counted from the origin of the coordinates
    /// @param s in cells
    Kernel(std::int64_t first, std::int64_t count, std::int64_t step, double s) {
        reach_ =
            std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(k_reach * s / static_cast<double>(step))));
        for (std::int64_t cell = first; cell < first + count; ++cell) {
            const std::int64_t middle = floor_divide(cell, step);
            begins_.push_back(middle - reach_);
            double squares = 0;
            const std::size_t start = weights_.size();
            for (std::int64_t i = middle - reach_; i <= middle + reach_ + 1; ++i) {
                const double d = static_cast<double>(cell - i * step) / s;
                weights_.push_back(std::exp(-d * d / 2));
                squares += weights_.back() * weights_.back();
            }
            for (std::size_t w = start; w < weights_.size(); ++w) weights_[w] /= std::sqrt(squares);
        }
    }
    [[nodiscard]] std::int64_t taps() const { return 2 * reach_ + 2; }
    [[nodiscard]] std::int64_t begin(std::int64_t cell) const { return begins_[static_cast<std::size_t>(cell)]; }
    [[nodiscard]] const double* weights(std::int64_t cell) const { return weights_.data() + cell * taps(); }
    [[nodiscard]] std::int64_t first() const { return begins_.front(); }
    [[nodiscard]] std::int64_t last() const { return begins_.back() + taps(); }

  private:
    std::int64_t reach_ = 0;
    std::vector<std::int64_t> begins_;
    std::vector<double> weights_;
};

}  // namespace

void add_field(const GaussianField& field, const GridSpec& grid, const CellWindow& window, double* values) {
    const double s = field.range / std::sqrt(12.0) / grid.cell_size;
    std::int64_t step = 1;
    while (s / static_cast<double>(2 * step) >= k_finest_lattice) step *= 2;
    const Kernel across(std::llround(grid.west / grid.cell_size) + window.column, window.columns, step, s),
        down(window.row - std::llround(grid.north / grid.cell_size), window.rows, step, s);
    // First along the rows of the lattice, then down the columns of the map.
    const std::int64_t lattice_rows = down.last() - down.first(), lattice_columns = across.last() - across.first();
    std::vector<double> deviates(static_cast<std::size_t>(lattice_columns)),
        rows(static_cast<std::size_t>(lattice_rows * window.columns));
    for (std::int64_t j = 0; j < lattice_rows; ++j) {
        for (std::int64_t i = 0; i < lattice_columns; ++i)
            deviates[static_cast<std::size_t>(i)] = deviate(field.seed, across.first() + i, down.first() + j);
        for (std::int64_t column = 0; column < window.columns; ++column) {
            const double* const weights = across.weights(column);
            const double* const from = deviates.data() + (across.begin(column) - across.first());
            double sum = 0;
            for (std::int64_t k = 0; k < across.taps(); ++k) sum += weights[k] * from[k];
            rows[static_cast<std::size_t>(j * window.columns + column)] = sum;
        }
    }
    for (std::int64_t row = 0; row < window.rows; ++row) {
        const double* const weights = down.weights(row);
        const double* const from = rows.data() + (down.begin(row) - down.first()) * window.columns;
        for (std::int64_t column = 0; column < window.columns; ++column) {
            double sum = 0;
            for (std::int64_t k = 0; k < down.taps(); ++k) sum += weights[k] * from[k * window.columns + column];
            values[row * window.columns + column] += field.standard_deviation * sum;
        }
    }
}

}  // namespace frana
