// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/grid_spec.h"

namespace frana {

inline constexpr double k_no_data = std::numeric_limits<double>::quiet_NaN();

/// One value per cell of a GridSpec, row by row from the north. In memory "no data" is NaN; in files it is -9999.
struct Raster {
    GridSpec grid;
    std::vector<double> values;  ///< rows x columns

    Raster() = default;
    explicit Raster(GridSpec spec, double value = 0.0)
        : grid(std::move(spec)), values(static_cast<std::size_t>(grid.cell_count()), value) {}

    [[nodiscard]] std::size_t index(std::int64_t row, std::int64_t column) const noexcept {
        return static_cast<std::size_t>(row * grid.columns + column);
    }
    [[nodiscard]] double at(std::int64_t row, std::int64_t column) const noexcept { return values[index(row, column)]; }
    [[nodiscard]] double& at(std::int64_t row, std::int64_t column) noexcept { return values[index(row, column)]; }
    [[nodiscard]] bool has_data(std::int64_t row, std::int64_t column) const noexcept {
        return !std::isnan(at(row, column));
    }
};

}  // namespace frana
