// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "analysis/touched_cells.h"
#include "core/geometry.h"
#include "core/raster.h"

namespace frana {

/// ExposureRow's place of a feature that is wholly on the map.
inline constexpr const char* k_on_map = "on the map";

/// What a flow, or the worst of several, does to each exposed feature. A feature counts every cell that it touches
/// (analysis/touched_cells.h).
struct ExposureRasters {
    const Raster *depth, *velocity, *pressure, *arrival;
    const Raster* terrain;             ///< NaN: no elevation; null: all ground is known
    const Raster* momentum = nullptr;  ///< null: nobody asks for it
};

/// The worst that happens to one feature.
struct ExposureValues {
    double depth = 0, velocity = 0, pressure = 0;
    double arrival = k_no_data, momentum = k_no_data;  ///< momentum: NaN: nobody asks for it
    bool has_ground = true;
};

/// A feature whose figures are known: columns of the table besides its own attributes.
struct ExposureRow {
    MapPlace place = MapPlace::outside;
    bool has_ground = true;
    std::vector<std::pair<std::string, double>> numbers;  ///< NaN: NULL
    std::vector<std::pair<std::string, std::string>> texts;
    double depth = 0;

    /// Whether the map says anything about it.
    [[nodiscard]] bool is_on_map() const noexcept { return place != MapPlace::outside && has_ground; }
    [[nodiscard]] bool is_reached() const noexcept { return is_on_map() && depth > 0; }
    /// Returns a number that there is.
    [[nodiscard]] double number(const std::string& name) const;
};

/// Returns what the rasters say of each feature's cells.
std::vector<ExposureValues> exposure_values(const std::vector<std::vector<std::size_t>>& cells,
                                            const ExposureRasters& rasters);

/// Returns the row of a feature: reached (1, 0), max_depth_m, max_velocity_ms, max_pressure_kpa (0 where it is not
/// reached), arrival_s (NULL there), and its place in words; all numbers NULL for a feature off the map.
/// @param map what was computed; cells may cover less, where nothing else was reached
ExposureRow exposure_row(const MixedShape& shape, const ExposureValues& values, const Bounds& map);

}  // namespace frana
