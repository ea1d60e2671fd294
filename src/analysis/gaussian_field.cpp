// SPDX-License-Identifier: Apache-2.0
#include "analysis/gaussian_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace frana {
namespace {

constexpr double k_reach = 4;      // of the kernel, in s: beyond, it is less than 4e-4 of its greatest value
constexpr double k_per_width = 2;  // lattice points within s: sums over them are the integrals to 2e-17 of the variance
/// Least s in cells: there cells that touch have a correlation of 0.002. Shorter ranges would only cost more.
constexpr double k_least_width = 0.2;
constexpr double k_places = 1 << 20;  // of a metre: coordinates are rounded to this part, so that parts of a map agree

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

/// Weights of the lattice's points round each cell of a row or column, scaled so that their squares add up to 1.
class Kernel {
  public:
    /// @param edge coordinate at which cell 0 begins [m]
    /// @param s width of the kernel, and `spacing` of the lattice [m]
    Kernel(double edge, double cell_size, std::int64_t first, std::int64_t count, double s, double spacing) {
        for (std::int64_t cell = first; cell < first + count; ++cell) {
            const double x = std::round((edge + (static_cast<double>(cell) + 0.5) * cell_size) * k_places) / k_places;
            begins_.push_back(static_cast<std::int64_t>(std::floor(x / spacing)) - k_side);
            double squares = 0;
            const std::size_t start = weights_.size();
            for (std::int64_t i = 0; i < k_taps; ++i) {
                const double d = (x - static_cast<double>(begins_.back() + i) * spacing) / s;
                weights_.push_back(std::exp(-d * d / 2));
                squares += weights_.back() * weights_.back();
            }
            for (std::size_t w = start; w < weights_.size(); ++w) weights_[w] /= std::sqrt(squares);
        }
    }
    static constexpr std::int64_t k_side = static_cast<std::int64_t>(k_reach * k_per_width), k_taps = 2 * k_side + 2;
    [[nodiscard]] std::int64_t begin(std::int64_t cell) const { return begins_[static_cast<std::size_t>(cell)]; }
    [[nodiscard]] const double* weights(std::int64_t cell) const { return weights_.data() + cell * k_taps; }
    [[nodiscard]] std::int64_t first() const { return begins_.front(); }
    [[nodiscard]] std::int64_t last() const { return begins_.back() + k_taps; }

  private:
    std::vector<std::int64_t> begins_;
    std::vector<double> weights_;
};

}  // namespace

void add_field(const GaussianField& field, const GridSpec& grid, const CellWindow& window, double* values) {
    const double s = std::max(field.range / std::sqrt(12.0), k_least_width * grid.cell_size), spacing = s / k_per_width;
    const Kernel across(grid.west, grid.cell_size, window.column, window.columns, s, spacing),
        down(-grid.north, grid.cell_size, window.row, window.rows, s, spacing);
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
            for (std::int64_t k = 0; k < Kernel::k_taps; ++k) sum += weights[k] * from[k];
            rows[static_cast<std::size_t>(j * window.columns + column)] = sum;
        }
    }
    for (std::int64_t row = 0; row < window.rows; ++row) {
        const double* const weights = down.weights(row);
        const double* const from = rows.data() + (down.begin(row) - down.first()) * window.columns;
        for (std::int64_t column = 0; column < window.columns; ++column) {
            double sum = 0;
            for (std::int64_t k = 0; k < Kernel::k_taps; ++k) sum += weights[k] * from[k * window.columns + column];
            values[row * window.columns + column] += field.standard_deviation * sum;
        }
    }
}

}  // namespace frana
