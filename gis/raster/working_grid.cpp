// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/working_grid.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {
namespace {

// Beyond this the rasters of a run alone need tens of gigabytes: most probably an error of the cell size.
constexpr double k_most_cells = 1e9;
constexpr double k_same = 1e-6;  // relative; the tolerance of GridSpec::same_cells

std::string text_of(const Bounds& b) {
    return shortest_text(b.west) + " " + shortest_text(b.south) + " " + shortest_text(b.east) + " " +
           shortest_text(b.north);
}

double rounded_to_two_digits(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return power < 1 ? std::round(value / power) / std::round(1 / power) : std::round(value / power) * power;
}

/// Returns the DTM's resolution on the ground in the working CRS, at its centre.
double ground_resolution(const RasterInfo& dtm, const CrsTransform& to_working) {
    const Point centre{(dtm.bounds.west + dtm.bounds.east) / 2, (dtm.bounds.south + dtm.bounds.north) / 2};
    const auto length = [&](double dx, double dy) {
        const Point a = to_working({centre.x - dx / 2, centre.y - dy / 2});
        const Point b = to_working({centre.x + dx / 2, centre.y + dy / 2});
        return std::hypot(b.x - a.x, b.y - a.y);
    };
    return std::min(length(dtm.cell_x, 0), length(0, dtm.cell_y));
}

/// Returns whole cells from a grid's edge, rounded outwards with a tolerance for the rounding of coordinates.
double cells_down(double distance, double cell) {
    return std::floor(distance / cell + k_same * 1e3);
}
double cells_up(double distance, double cell) {
    return std::ceil(distance / cell - k_same * 1e3);
}

Bounds clipped(const Bounds& wanted, const Bounds& have, const std::string& path) {
    const Bounds both{std::max(wanted.west, have.west), std::max(wanted.south, have.south),
                      std::min(wanted.east, have.east), std::min(wanted.north, have.north)};
    if (both.width() <= 0 || both.height() <= 0) {
        throw Error(ErrorKind::input,
                    Problem{"the requested bounds do not overlap the DTM", path, text_of(wanted),
                            "within " + text_of(have) + " (west south east north, working CRS)",
                            "Correct terrain.bounds, or check the DTM's coordinate reference system"});
    }
    return both;
}

}  // namespace

GridSpec working_grid(const RasterInfo& dtm, const std::string& working_crs_wkt, std::optional<Bounds> bounds,
                      std::optional<double> cell_size) {
    const bool local = working_crs_wkt.empty();
    const CrsTransform to_working(local ? "" : dtm.crs_wkt, working_crs_wkt, dtm.bounds);
    const bool same_crs = to_working.is_identity();
    const bool square = std::abs(dtm.cell_x - dtm.cell_y) <= k_same * dtm.cell_x;
    const Bounds have = to_working.around(dtm.bounds);

    GridSpec grid;
    grid.crs_wkt = local ? "" : horizontal_crs(working_crs_wkt);
    if (cell_size) {
        grid.cell_size = *cell_size;
    } else if (same_crs) {
        grid.cell_size = std::min(dtm.cell_x, dtm.cell_y);
    } else {
        grid.cell_size = rounded_to_two_digits(ground_resolution(dtm, to_working));
    }
    const Bounds wanted = bounds ? clipped(*bounds, have, dtm.path) : have;
    const double cell = grid.cell_size;
    const double cells = wanted.width() / cell * (wanted.height() / cell);
    if (!(cells <= k_most_cells)) {
        throw Error(ErrorKind::input,
                    Problem{"the working grid would be too large", dtm.path,
                            shortest_text(std::round(cells)) + " cells of " + shortest_text(cell) + " m",
                            "at most " + shortest_text(k_most_cells) + " cells",
                            "Set terrain.bounds around the slope, or a larger terrain.cell-size"});
    }
    // The DTM's own lattice if its cells are the grid's, else multiples of the cell size.
    const bool own_cells = same_crs && square && !dtm.rotated && std::abs(cell - dtm.cell_x) <= k_same * dtm.cell_x;
    const Point origin = own_cells ? Point{dtm.bounds.west, dtm.bounds.north} : Point{0, 0};
    if (own_cells) grid.cell_size = dtm.cell_x;
    // Requested bounds are widened to whole cells, but no cell reaches beyond the DTM: it would have no elevation.
    const double west = std::max(cells_down(wanted.west - origin.x, cell), cells_up(have.west - origin.x, cell));
    const double east = std::min(cells_up(wanted.east - origin.x, cell), cells_down(have.east - origin.x, cell));
    const double south = std::max(cells_down(wanted.south - origin.y, cell), cells_up(have.south - origin.y, cell));
    const double north = std::min(cells_up(wanted.north - origin.y, cell), cells_down(have.north - origin.y, cell));
    if (east - west < 1 || north - south < 1) {
        throw Error(ErrorKind::input,
                    Problem{"the working grid would have no cell", dtm.path, shortest_text(cell) + " m",
                            "less than the area's " + shortest_text(wanted.width()) + " by " +
                                shortest_text(wanted.height()) + " m",
                            "Set a smaller terrain.cell-size or wider terrain.bounds"});
    }
    grid.west = origin.x + west * cell;
    grid.north = origin.y + north * cell;
    grid.columns = static_cast<std::int64_t>(east - west);
    grid.rows = static_cast<std::int64_t>(north - south);
    return grid;
}

}  // namespace frana::gis
