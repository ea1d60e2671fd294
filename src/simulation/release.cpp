// SPDX-License-Identifier: Apache-2.0
#include "simulation/release.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/error.h"
#include "particles/seeding.h"

namespace frana {
namespace {

MultiPolygon to_local(const MultiPolygon& map, const GridSpec& grid) {
    MultiPolygon local = map;
    for (Polygon& polygon : local) {
        for (Point& p : polygon.outer) p = grid.local_from_map(p);
        for (Ring& hole : polygon.holes) {
            for (Point& p : hole) p = grid.local_from_map(p);
        }
    }
    return local;
}

// Row and column of a local point, clamped into the grid.
struct Cell {
    std::int64_t row, column;
};
Cell cell_of(const GridSpec& grid, Point local) {
    const auto column = static_cast<std::int64_t>(std::floor(local.x / grid.cell_size));
    const auto from_south = static_cast<std::int64_t>(std::floor(local.y / grid.cell_size));
    return {std::clamp<std::int64_t>(grid.rows - 1 - from_south, 0, grid.rows - 1),
            std::clamp<std::int64_t>(column, 0, grid.columns - 1)};
}

// Bilinear between the cell centres that have data; NaN where none of the four has.
double sample(const Raster& raster, Point local) {
    const GridSpec& grid = raster.grid;
    const double s = local.x / grid.cell_size - 0.5, t = local.y / grid.cell_size - 0.5;
    const double i = std::floor(s), j = std::floor(t);
    double sum = 0, total = 0;
    for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) {
            const double w = (a ? s - i : 1 - (s - i)) * (b ? t - j : 1 - (t - j));
            const Cell c = cell_of(grid, {(i + a + 0.5) * grid.cell_size, (j + b + 0.5) * grid.cell_size});
            const double value = raster.at(c.row, c.column);
            if (std::isnan(value) || !(w > 0)) continue;
            sum += w * value;
            total += w;
        }
    }
    return total > 0 ? sum / total : k_no_data;
}

// sqrt(1 + |grad Z|^2) of the terrain at a cell, from the neighbours that have data.
double secant_of_slope(const Raster& terrain, Cell c) {
    const auto difference = [&](std::int64_t dr, std::int64_t dc) {
        const auto value = [&](std::int64_t sign) {
            const std::int64_t r = std::clamp<std::int64_t>(c.row + sign * dr, 0, terrain.grid.rows - 1);
            const std::int64_t k =
                std::clamp<std::int64_t>(c.column + sign * dc, 0, terrain.grid.columns - 1);
            const double z = terrain.at(r, k);
            return std::isnan(z) ? terrain.at(c.row, c.column) : z;
        };
        return (value(1) - value(-1)) / (2 * terrain.grid.cell_size);
    };
    const double gx = difference(0, 1), gy = difference(1, 0);
    return std::sqrt(1 + gx * gx + gy * gy);
}

void refuse_gaps(const Scene& scene, const ParticleSet& particles) {
    std::vector<std::uint8_t> seen(scene.terrain.values.size(), 0);
    std::int64_t count = 0;
    std::string first;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Cell c = cell_of(scene.grid, {particles[Field::x][p], particles[Field::y][p]});
        const std::size_t n = scene.terrain.index(c.row, c.column);
        if (scene.terrain.has_data(c.row, c.column) || seen[n]) continue;
        seen[n] = 1;
        if (++count <= 3) {
            const Point map = scene.grid.cell_centre(c.row, c.column);
            char text[128];
            std::snprintf(text, sizeof text, "%srow %lld column %lld (%.1f, %.1f)", count > 1 ? ", " : "",
                          static_cast<long long>(c.row), static_cast<long long>(c.column), map.x, map.y);
            first += text;
        }
    }
    if (count == 0) return;
    throw Error(ErrorKind::input, Problem{"the terrain has no data under the release", "terrain.dtm",
                                          std::to_string(count) + " cells, among them " + first, "",
                                          "Give a DTM that covers the release, shrink the perimeter, or set "
                                          "terrain.nodata-policy = fill"});
}

}  // namespace

Release make_release(const Scene& scene) {
    const GridSpec& grid = scene.grid;
    const double per_side = std::round(std::sqrt(static_cast<double>(scene.numerics.particles_per_cell)));
    const double spacing = grid.cell_size / per_side;
    Release release;
    for (const ReleaseArea& area : scene.release) {
        const auto thickness = [&](Point local) {
            double t = area.thickness_raster ? sample(*area.thickness_raster, local) : area.thickness;
            if (area.normal_to_bed && t > 0) t *= secant_of_slope(scene.terrain, cell_of(grid, local));
            return t;
        };
        const std::size_t first = release.particles.size();
        double volume = fill_outline(to_local(area.outline, grid), spacing, thickness, release.particles);
        if (area.volume && volume > 0) {
            const double factor = *area.volume / volume;
            for (std::size_t p = first; p < release.particles.size(); ++p)
                release.particles[Field::volume][p] *= factor;
            volume = *area.volume;
            if (std::abs(factor - 1) > std::abs(release.scaled - 1)) release.scaled = factor;
        }
        release.volume += volume;
    }
    if (release.particles.size() == 0) {
        throw Error(
            ErrorKind::input,
            Problem{"nothing would be released: the perimeter holds no thickness above zero",
                    "release.thickness", "", "",
                    "Check that the thickness raster covers the perimeter and is positive inside it"});
    }
    refuse_gaps(scene, release.particles);

    release.depth = Raster(grid, k_no_data);
    for (std::size_t p = 0; p < release.particles.size(); ++p) {
        const Cell c = cell_of(grid, {release.particles[Field::x][p], release.particles[Field::y][p]});
        double& depth = release.depth.at(c.row, c.column);
        depth = (std::isnan(depth) ? 0 : depth) + release.particles[Field::volume][p] / grid.cell_area();
    }
    release.bed = scene.terrain;
    if (scene.terrain_contains_release) {
        for (std::size_t i = 0; i < release.bed.values.size(); ++i) {
            if (!std::isnan(release.depth.values[i])) release.bed.values[i] -= release.depth.values[i];
        }
    }
    return release;
}

}  // namespace frana
