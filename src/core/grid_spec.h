// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace frana {

/// A point or vector in the plane: map coordinates (easting, northing) or local metres, depending on the context.
struct Point {
    double x = 0;
    double y = 0;
};

/// An axis-parallel rectangle in map coordinates.
struct Bounds {
    double west = 0, south = 0, east = 0, north = 0;

    [[nodiscard]] double width() const noexcept { return east - west; }
    [[nodiscard]] double height() const noexcept { return north - south; }
    /// Returns whether a point is inside; the western and southern edges are included, non-finite points are not.
    [[nodiscard]] bool contains(double x, double y) const noexcept {
        return x >= west && y >= south && x < east && y < north;
    }
};

/// A north-up grid of square cells. Row 0 is the northernmost, as in GDAL; a value belongs to the centre of its cell.
///
/// The engine uses local metres with y to the north, counted from the south-western corner of one cell (see
/// local_from_map): one near the release, so that the extent of the grid beyond it changes no bit.
struct GridSpec {
    double west = 0;       ///< easting of the grid's western edge [m]
    double north = 0;      ///< northing of the grid's northern edge [m]
    double cell_size = 1;  ///< side of a cell [m]
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    std::string crs_wkt;  ///< WKT2 of the projected CRS; empty for plain local metres. Opaque to the engine.
    std::int64_t origin_column = 0, origin_row = 0;  ///< cell of the local origin; rows counted from the south

    [[nodiscard]] double east() const noexcept { return west + cell_size * static_cast<double>(columns); }
    [[nodiscard]] double south() const noexcept { return north - cell_size * static_cast<double>(rows); }
    [[nodiscard]] Bounds bounds() const noexcept { return {west, south(), east(), north}; }
    [[nodiscard]] std::int64_t cell_count() const noexcept { return columns * rows; }
    [[nodiscard]] double cell_area() const noexcept { return cell_size * cell_size; }
    [[nodiscard]] Point cell_centre(std::int64_t row, std::int64_t column) const noexcept {
        return {west + (static_cast<double>(column) + 0.5) * cell_size,
                north - (static_cast<double>(row) + 0.5) * cell_size};
    }
    /// Map coordinates of the local origin.
    [[nodiscard]] Point origin() const noexcept {
        return {west + cell_size * static_cast<double>(origin_column),
                south() + cell_size * static_cast<double>(origin_row)};
    }
    /// Converts to local metres; the subtraction happens once, in double precision.
    [[nodiscard]] Point local_from_map(Point map) const noexcept { return {map.x - origin().x, map.y - origin().y}; }
    [[nodiscard]] Point map_from_local(Point local) const noexcept {
        return {local.x + origin().x, local.y + origin().y};
    }
    /// Returns the grid's edges in local metres.
    [[nodiscard]] Bounds local_bounds() const noexcept {
        return {-cell_size * static_cast<double>(origin_column), -cell_size * static_cast<double>(origin_row),
                cell_size * static_cast<double>(columns - origin_column),
                cell_size * static_cast<double>(rows - origin_row)};
    }

    /// Returns whether the cells coincide (to 1e-6 of a cell); the CRS text is not compared.
    [[nodiscard]] bool same_cells(const GridSpec& other) const noexcept;
    /// Returns whether all cells of the other grid are cells of this one (to 1e-6 of a cell).
    [[nodiscard]] bool covers(const GridSpec& other) const noexcept;
};

}  // namespace frana
