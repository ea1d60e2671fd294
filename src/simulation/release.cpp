// SPDX-License-Identifier: Apache-2.0
#include "simulation/release.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "core/error.h"
#include "core/reached_raster.h"
#include "mpm/boundary.h"
#include "mpm/node_grid.h"
#include "mpm/shape.h"
#include "particles/seeding.h"
#include "simulation/scene.h"

namespace frana {
namespace {

MultiPolygon to_local(const MultiPolygon& map, const GridSpec& grid) {
    return moved(map, [&](Point p) { return grid.local_from_map(p); });
}

// Interpolates bilinearly between the cell centres that have data; NaN where none of the four has. The raster is on the
// scene's grid.
double sample(const Raster& raster, const GridSpec& grid, Point local) {
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

void refuse_gaps(const Scene& scene, const ParticleSet& particles) {
    std::set<std::size_t> counted;
    std::int64_t count = 0;
    std::string first;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Cell c = cell_of(scene.grid, {particles[Field::x][p], particles[Field::y][p]});
        const std::size_t n = scene.terrain.index(c.row, c.column);
        if (scene.terrain.has_data(c.row, c.column) || !counted.insert(n).second) continue;
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

void refuse_walls(const Scene& scene, const ParticleSet& particles) {
    if (!scene.walls) return;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Point local{particles[Field::x][p], particles[Field::y][p]};
        const Cell c = cell_of(scene.grid, local);
        if (scene.walls->at(c.row, c.column) == 0) continue;
        const Point map = scene.grid.map_from_local(local);
        char text[64];
        std::snprintf(text, sizeof text, "(%.1f, %.1f)", map.x, map.y);
        throw Error(ErrorKind::input, Problem{"a wall stands on the release", "terrain.walls", text, "",
                                              "Move the wall or the perimeter"});
    }
}

// Refuses a release that would appear on no map and reach no cell.
void refuse_thin(const Scene& scene, const Raster& depth) {
    double greatest = 0;
    depth.values.for_each_stored([&](std::size_t, double d) {
        if (d > greatest) greatest = d;
    });
    const double minimum = scene.numerics.minimum_depth;
    if (!(greatest > 0) || greatest >= minimum || !scene.inflows.empty()) return;
    char value[96], limit[96], remedy[192];
    std::snprintf(value, sizeof value, "%.3g m at most, mean over cells of %.4g m", greatest, scene.grid.cell_size);
    std::snprintf(limit, sizeof limit, "at least numerics.minimum-depth = %.4g m", minimum);
    std::snprintf(
        remedy, sizeof remedy, "Set numerics.minimum-depth = %.1g or less%s", greatest / 10,
        ", choose smaller cells (terrain.cell-size) if the release is smaller than a cell, or check the unit");
    throw Error(ErrorKind::input, Problem{"the release is thinner than the depth that counts as reached",
                                          "release.thickness", value, limit, remedy});
}

// Returns the mean of a value per particle, weighted by volume.
template <class Value>
Point mean_of(const ParticleSet& particles, const Value& value) {
    Point sum;
    double total = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double volume = particles[Field::volume][p];
        const Point v = value({particles[Field::x][p], particles[Field::y][p]});
        sum.x += volume * v.x;
        sum.y += volume * v.y;
        total += volume;
    }
    return total > 0 ? Point{sum.x / total, sum.y / total} : sum;
}

// Sets the particles' speed along the bed, all in the same direction of the map.
void set_in_motion(const Scene& scene, const ReleaseArea& area, ParticleSet& particles) {
    if (!(area.speed > 0)) return;
    const auto slope = [&](Point local) { return gradient(scene.terrain, cell_of(scene.grid, local)); };
    Point direction;
    if (area.azimuth) {
        direction = {std::sin(*area.azimuth), std::cos(*area.azimuth)};
    } else {
        const Point mean = mean_of(particles, slope);
        const double steepness = std::hypot(mean.x, mean.y);
        if (!(steepness > 1e-6)) {
            throw Error(ErrorKind::input, Problem{"a release area on level ground has a velocity but no direction",
                                                  "release.velocity", "", "", "Give release.direction"});
        }
        direction = {-mean.x / steepness, -mean.y / steepness};
    }
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Point g = slope({particles[Field::x][p], particles[Field::y][p]});
        const double speed = area.speed * map_fraction(scene.numerics, g, direction);
        particles[Field::u][p] = speed * direction.x;
        particles[Field::v][p] = speed * direction.y;
    }
}

void scale_by(double factor, ParticleSet& particles, ReleasedArea& area) {
    for (std::size_t p = 0; p < particles.size(); ++p) particles[Field::volume][p] *= factor;
    area.scaled *= factor;
    area.volume *= factor;
}

// Scales the thicknesses so that all areas together have a volume.
void scale_to(double volume, std::vector<ParticleSet>& filled, std::vector<ReleasedArea>& areas) {
    double sum = 0;
    for (const ReleasedArea& area : areas) sum += area.volume;
    if (!(sum > 0)) return;
    for (std::size_t i = 0; i < filled.size(); ++i) scale_by(volume / sum, filled[i], areas[i]);
}

// The bed that is computed with: the cells' own of finite volumes; of particles that of the nodes' splines.
std::function<double(Point)> computed_bed(const Scene& scene) {
    if (scene.structured || scene.numerics.scheme == Scheme::finite_volume)
        return [&scene](Point local) {
            const Cell c = cell_of(scene.grid, local);
            return scene.terrain.at(c.row, c.column);
        };
    auto nodes = std::make_shared<NodeGrid>(scene.terrain);
    if (scene.numerics.boundary == Boundary::wall) mirror_bed(*nodes);
    return [nodes](Point local) {
        nodes->cover_round(local);
        const Stencil<QuadraticSplineShape> stencil(local.x, local.y, nodes->scale());
        return interpolate(stencil, nodes->bed.data(), nodes->stride()).value + nodes->datum();
    };
}

// Seeds one area's particles and returns the actual release.
ReleasedArea fill_area(const Scene& scene, const ReleaseArea& area, ParticleSet& particles) {
    const GridSpec& grid = scene.grid;
    const auto bed = area.level ? computed_bed(scene) : nullptr;
    const auto thickness = [&](Point local) {
        if (bed) return *area.level - bed(local);
        double t = area.thickness_raster ? sample(*area.thickness_raster, grid, local) : area.thickness;
        if (area.normal_to_bed && t > 0) {
            const Point g = gradient(scene.terrain, cell_of(grid, local));
            t *= std::sqrt(1 + g.x * g.x + g.y * g.y);
        }
        return t;
    };
    ReleasedArea released;
    released.name = area.name;
    released.start = area.start;
    released.volume = fill_outline(to_local(area.outline, grid), lattice_spacing(scene), thickness, particles);
    for (std::size_t p = 0; p < particles.size(); ++p) released.area += particles[Field::area][p];
    if (area.volume && released.volume > 0) {
        scale_by(*area.volume / released.volume, particles, released);
        released.volume = *area.volume;
    }
    set_in_motion(scene, area, particles);
    return released;
}

void remove(const Raster& depth, Raster& bed) {
    depth.values.for_each_stored([&](std::size_t cell, double d) {
        if (!std::isnan(d)) bed.values[cell] -= d;
    });
}

}  // namespace

double volume_in_cells(const Raster& thickness, double side, const MultiPolygon& outline) {
    const GridSpec& grid = thickness.grid;
    ParticleSet pieces;
    return fill_outline(
        outline, side,
        [&](Point p) {
            const auto column = static_cast<std::int64_t>(std::floor(p.x / side));
            const auto row = grid.rows - 1 - static_cast<std::int64_t>(std::floor(p.y / side));
            const bool inside = column >= 0 && column < grid.columns && row >= 0 && row < grid.rows;
            return inside ? thickness.at(row, column) : k_no_data;
        },
        pieces);
}

double lattice_spacing(const Scene& scene) {
    return scene.grid.cell_size / std::round(std::sqrt(static_cast<double>(scene.numerics.particles_per_cell)));
}

Raster cell_depth(const ParticleSet& particles, const GridSpec& grid) {
    Raster cells = reached_raster(grid, k_no_data);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Cell c = cell_of(grid, {particles[Field::x][p], particles[Field::y][p]});
        double& depth = cells.at(c.row, c.column);
        depth = (std::isnan(depth) ? 0 : depth) + particles[Field::volume][p] / grid.cell_area();
    }
    return cells;
}

Release make_release(const Scene& scene) {
    Release release;
    std::map<double, Entry> later;
    std::vector<ParticleSet> filled(scene.release.size());
    for (std::size_t i = 0; i < filled.size(); ++i)
        release.areas.push_back(fill_area(scene, scene.release[i], filled[i]));
    if (scene.release_volume) scale_to(*scene.release_volume, filled, release.areas);
    ParticleSet all;
    for (std::size_t i = 0; i < filled.size(); ++i) {
        const ReleaseArea& area = scene.release[i];
        const ParticleSet& particles = filled[i];
        release.volume += release.areas[i].volume;
        Entry& entry = later[area.start > 0 ? area.start : 0];
        entry.time = area.start;
        entry.areas.push_back(i);
        for (std::size_t p = 0; p < particles.size(); ++p) {
            entry.particles.push_back(particles.row(p));
            all.push_back(particles.row(p));
        }
    }
    if (all.size() == 0 && scene.inflows.empty()) {
        throw Error(ErrorKind::input,
                    Problem{"nothing would be released: the thickness in the perimeter is nowhere above zero",
                            "release.thickness", "", "",
                            "Check that the thickness raster covers the perimeter and is positive inside it"});
    }
    refuse_gaps(scene, all);
    refuse_walls(scene, all);
    release.centroid = mean_of(all, [](Point local) { return local; });
    release.depth = cell_depth(all, scene.grid);
    refuse_thin(scene, release.depth);
    for (auto& [time, entry] : later) {
        if (time > 0) {
            release.later.push_back(std::move(entry));
        } else {
            release.particles = std::move(entry.particles);
        }
    }
    release.bed = scene.terrain;
    if (scene.terrain_contains_release) remove(release.depth, release.bed);
    release.bed_at_start = release.later.empty() ? release.bed : scene.terrain;
    if (scene.terrain_contains_release && !release.later.empty())
        remove(cell_depth(release.particles, scene.grid), release.bed_at_start);
    return release;
}

}  // namespace frana
