// SPDX-License-Identifier: Apache-2.0
#include "placed_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "simulation/release.h"
#include "simulation/scene.h"

namespace frana {
namespace {

using Place = std::function<Point(Point)>;

// Moves every point and direction of a scene. Azimuths are clockwise, the turn [rad] is not.
void move_marks(Scene& scene, const Place& place, double turn) {
    for (ReleaseArea& area : scene.release) {
        area.outline = moved(std::move(area.outline), place);
        if (area.azimuth) *area.azimuth -= turn;
    }
    for (Inflow& inflow : scene.inflows) {
        for (Point& p : inflow.line) p = place(p);
        if (inflow.azimuth) *inflow.azimuth -= turn;
    }
    scene.recording = {};
    scene.time.frame_interval = 0;
}

enum class RasterKind { elevation, depth, zone };

// Visits every raster of a scene with its quantity.
template <class Visit>
void for_each_raster(Scene& scene, const Visit& visit) {
    visit(scene.terrain, RasterKind::elevation);
    const auto optional = [&](std::optional<Raster>& raster, RasterKind kind) {
        if (raster) visit(*raster, kind);
    };
    for (ReleaseArea& area : scene.release) optional(area.thickness_raster, RasterKind::depth);
    optional(scene.walls, RasterKind::zone);
    for (const ZoneRaster& zone : k_zone_rasters) optional(scene.zones.*zone.raster, RasterKind::zone);
    if (!scene.structured) return;
    for (SolidZone& zone : scene.structured->zones) visit(zone.raster, RasterKind::zone);
    optional(scene.structured->initial_fluid, RasterKind::depth);
}

GridSpec plain_grid(const GridSpec& like, std::int64_t columns, std::int64_t rows) {
    GridSpec grid;
    grid.cell_size = like.cell_size;
    grid.columns = columns;
    grid.rows = rows;
    grid.north = grid.cell_size * static_cast<double>(rows);
    return grid;
}

// Relative to the scene's south-western corner, metres are exact; a second quarter is relative to that of the first.
Scene quarter_turned(Scene scene) {
    const GridSpec old = scene.grid;
    move_marks(
        scene,
        [&](Point p) {
            return Point{old.north - p.y, p.x - old.west};
        },
        std::numbers::pi / 2);
    scene.grid = plain_grid(old, old.rows, old.columns);
    for_each_raster(scene, [&](Raster& raster, RasterKind) {
        raster = quarter_turned(raster);
        raster.grid = scene.grid;
    });
    return scene;
}

// Keys' cubic convolution with a = -1/2: exact for polynomials of the second degree.
std::array<double, 4> cubic_weights(double t) {
    return {((-0.5 * t + 1) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1, ((-1.5 * t + 2) * t + 0.5) * t,
            (0.5 * t - 0.5) * t * t};
}

// A raster interpolated between the centres of its cells, at a place in cells from that of row 0, column 0.
class Interpolated {
  public:
    explicit Interpolated(const Raster& raster) : raster_(raster) {}

    [[nodiscard]] double nearest(double row, double column) const {
        return at(static_cast<std::int64_t>(std::lround(row)), static_cast<std::int64_t>(std::lround(column)));
    }
    // From the cells that have a value; NaN where the nearest has none.
    [[nodiscard]] double bilinear(double row, double column) const {
        if (std::isnan(nearest(row, column))) return k_no_data;
        const auto i = static_cast<std::int64_t>(std::floor(row)), j = static_cast<std::int64_t>(std::floor(column));
        const double t = row - std::floor(row), s = column - std::floor(column);
        double sum = 0, total = 0;
        for (int b = 0; b < 2; ++b) {
            for (int a = 0; a < 2; ++a) {
                const double w = (b ? t : 1 - t) * (a ? s : 1 - s), value = at(i + b, j + a);
                if (std::isnan(value) || !(w > 0)) continue;
                sum += w * value;
                total += w;
            }
        }
        return sum / total;
    }
    [[nodiscard]] double cubic(double row, double column) const {
        const auto i = static_cast<std::int64_t>(std::floor(row)), j = static_cast<std::int64_t>(std::floor(column));
        const auto wi = cubic_weights(row - std::floor(row)), wj = cubic_weights(column - std::floor(column));
        double sum = 0;
        for (int b = 0; b < 4; ++b)
            for (int a = 0; a < 4; ++a)
                sum += wi[static_cast<std::size_t>(b)] * wj[static_cast<std::size_t>(a)] * at(i - 1 + b, j - 1 + a);
        return std::isnan(sum) ? bilinear(row, column) : sum;
    }

  private:
    // Beyond the edge the value of the edge.
    [[nodiscard]] double at(std::int64_t row, std::int64_t column) const {
        return raster_.at(std::clamp<std::int64_t>(row, 0, raster_.grid.rows - 1),
                          std::clamp<std::int64_t>(column, 0, raster_.grid.columns - 1));
    }

    const Raster& raster_;
};

// The position of a new grid's cells on the old one.
struct Cells {
    GridSpec grid;
    double cosine, sine;               // of the turn
    double middle_row, middle_column;  // of the old grid, counted as Interpolated does
    double off;  // displacement of the new grid's middle from the old one's, to the east and to the north [cells]

    struct OldPlace {
        double row, column, beyond;  // beyond: distance outside of the old grid [cells]
    };
    [[nodiscard]] OldPlace old_place(const GridSpec& old, std::int64_t row, std::int64_t column) const {
        const double x = static_cast<double>(column) - 0.5 * static_cast<double>(grid.columns - 1) + off;
        const double y = 0.5 * static_cast<double>(grid.rows - 1) - static_cast<double>(row) + off;
        const double r = middle_row - (-sine * x + cosine * y), c = middle_column + (cosine * x + sine * y);
        const auto out = [](double at, std::int64_t count) {
            return std::max({0.0, -0.5 - at, at - (static_cast<double>(count) - 0.5)});
        };
        return {r, c, std::hypot(out(r, old.rows), out(c, old.columns))};
    }
};

Cells cells_of(const GridSpec& old, const GridPlacement& placement, double turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    const auto width = static_cast<double>(old.columns), height = static_cast<double>(old.rows);
    // A millionth of a cell is rounding. A shifted grid consists of the cells that are wholly inside.
    const auto count = [&](double cells) {
        return std::max<std::int64_t>(
            1, static_cast<std::int64_t>(std::ceil(cells - 1e-6)) - (placement.shift > 0 ? 1 : 0));
    };
    const std::int64_t columns = count(width * std::abs(c) + height * std::abs(s)),
                       rows = count(width * std::abs(s) + height * std::abs(c));
    return {plain_grid(old, columns, rows),
            c,
            s,
            0.5 * (height - 1),
            0.5 * (width - 1),
            placement.shift > 0 ? placement.shift - 0.5 : 0};
}

Raster interpolated(const Raster& raster, const Cells& cells, RasterKind kind) {
    constexpr double k_fall_cells = 5;
    const Interpolated old(raster);
    Raster other(cells.grid);
    for (std::int64_t row = 0; row < cells.grid.rows; ++row) {
        for (std::int64_t column = 0; column < cells.grid.columns; ++column) {
            const Cells::OldPlace at = cells.old_place(raster.grid, row, column);
            double& value = other.at(row, column);
            if (kind == RasterKind::elevation) {
                value = std::isnan(old.nearest(at.row, at.column)) ? k_no_data : old.cubic(at.row, at.column);
                value -= cells.grid.cell_size * std::min(at.beyond, k_fall_cells);
            } else if (kind == RasterKind::depth) {
                value = at.beyond > 0 ? k_no_data : old.bilinear(at.row, at.column);
            } else {
                value = old.nearest(at.row, at.column);
            }
        }
    }
    return other;
}

// A raster cannot be turned without changing its volume at the edge.
void keep_volumes(const Scene& from, Scene& scene) {
    if (scene.release_volume || scene.release.empty()) return;
    const Release released = make_release(from);
    for (std::size_t i = 0; i < scene.release.size(); ++i) {
        ReleaseArea& area = scene.release[i];
        if (area.thickness_raster && !area.volume) area.volume = released.areas[i].volume;
    }
}

}  // namespace

Raster quarter_turned(const Raster& raster) {
    GridSpec grid = raster.grid;
    std::swap(grid.columns, grid.rows);
    grid.north = raster.grid.south() + grid.cell_size * static_cast<double>(grid.rows);
    Raster other(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row)
        for (std::int64_t column = 0; column < grid.columns; ++column)
            other.at(row, column) = raster.at(column, raster.grid.columns - 1 - row);
    return other;
}

void place_origin_at(Scene& scene, OriginCell corner) {
    if (corner.column < scene.grid.columns && corner.row < scene.grid.rows)
        put_origin(scene, corner);
    else
        place_origin(scene);
}

PlacedScene placed_otherwise(const Scene& scene, const GridPlacement& placement) {
    PlacedScene placed{scene, {}};
    Scene& other = placed.scene;
    const double quarters = placement.turn_deg / 90;
    if (placement.shift == 0 && quarters == std::round(quarters)) {
        OriginCell corner{scene.grid.origin_column, scene.grid.origin_row};
        for (int i = 0; i < static_cast<int>(quarters); ++i) {
            corner = {other.grid.rows - corner.row, corner.column};
            other = quarter_turned(std::move(other));
        }
        place_origin_at(other, corner);
        return placed;
    }
    const GridSpec& old = scene.grid;
    const double turn = placement.turn_deg * std::numbers::pi / 180;
    const Cells cells = cells_of(old, placement, turn);
    const Point middle{0.5 * (old.west + old.east()), 0.5 * (old.south() + old.north)};
    const double off = cells.off * old.cell_size;
    const Point new_middle{0.5 * cells.grid.east(), 0.5 * cells.grid.north};
    move_marks(
        other,
        [&](Point p) {
            const double x = p.x - middle.x, y = p.y - middle.y;
            return Point{new_middle.x - off + (cells.cosine * x - cells.sine * y),
                         new_middle.y - off + (cells.sine * x + cells.cosine * y)};
        },
        turn);
    other.grid = cells.grid;
    placed.inside = Raster(cells.grid, 1);
    for (std::int64_t row = 0; row < cells.grid.rows; ++row)
        for (std::int64_t column = 0; column < cells.grid.columns; ++column)
            if (cells.old_place(old, row, column).beyond > 0) placed.inside.at(row, column) = 0;
    if (other.numerics.boundary == Boundary::wall && !other.walls) other.walls = Raster(old, 0);
    for_each_raster(other, [&](Raster& raster, RasterKind kind) { raster = interpolated(raster, cells, kind); });
    if (other.walls) {
        for (std::size_t i = 0; i < placed.inside.values.size(); ++i)
            if (placed.inside.values[i] == 0) other.walls->values[i] = other.numerics.boundary == Boundary::wall;
    }
    keep_volumes(scene, other);
    place_origin(other);
    return placed;
}

}  // namespace frana
