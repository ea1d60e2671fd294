// SPDX-License-Identifier: Apache-2.0
#include "models/structured/solid/placement.h"

#include <algorithm>
#include <cmath>

namespace frana::structured {
namespace {

constexpr FieldMask k_placed_fields = k_basic_fields | FieldMask{Field::confined};

double positive(double depth) {
    return depth > 0 ? depth : 0;  // also NaN: none
}

double sum_of(const ParticleSet& particles, Field field) {
    double sum = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) sum += particles[field][p];
    return sum;
}

void scale_to(double sum, ParticleSet& particles, Field field) {
    const double now = sum_of(particles, field);
    if (!(now > 0)) return;
    for (std::size_t p = 0; p < particles.size(); ++p) particles[field][p] *= sum / now;
}

}  // namespace

Point r2_point(std::int64_t n) {
    // The root of g^3 = g + 1 in closed form: Cardano's.
    static const double root = std::cbrt((9 + std::sqrt(69.0)) / 18) + std::cbrt((9 - std::sqrt(69.0)) / 18);
    const auto place = [n](double step) {
        const double s = 0.5 + static_cast<double>(n) * step;
        return s - std::floor(s);
    };
    return {place(1 / root), place(1 / (root * root))};
}

ParticleSet place_by_depth(const Raster& solid_depth, const Raster& confined_depth, int per_column) {
    const GridSpec& grid = solid_depth.grid;
    double deepest = 0, solids = 0, confined = 0;
    solid_depth.values.for_each_stored([&](std::size_t cell, double depth) {
        deepest = std::max(deepest, positive(depth));
        solids += positive(depth) * grid.cell_area();
        confined += positive(confined_depth.values[cell]) * grid.cell_area();
    });
    ParticleSet particles(k_placed_fields);
    if (!(deepest > 0)) return particles;
    const double each = deepest * grid.cell_area() / per_column;
    double left_solids = 0, left_confined = 0;
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        if (!solid_depth.values.stores_any({row, 0, 1, grid.columns})) continue;
        const std::int64_t from_origin = grid.rows - 1 - row - grid.origin_row;
        for (std::int64_t k = 0; k < grid.columns; ++k) {
            const std::int64_t column = from_origin % 2 == 0 ? k : grid.columns - 1 - k;
            const double h_s = positive(solid_depth.at(row, column));
            if (!(h_s > 0)) continue;
            const double h_fc = positive(confined_depth.at(row, column));
            left_solids += h_s * grid.cell_area();
            left_confined += h_fc * grid.cell_area();
            const auto n = static_cast<std::int64_t>(std::floor(left_solids / each + 0.5));
            for (std::int64_t i = 0; i < n; ++i) {
                const Point in_cell = r2_point(i);
                ParticleRow r = ParticleSet::initial_row();
                get(r, Field::x) = (static_cast<double>(column - grid.origin_column) + in_cell.x) * grid.cell_size;
                get(r, Field::y) = (static_cast<double>(from_origin) + in_cell.y) * grid.cell_size;
                get(r, Field::volume) = each;
                get(r, Field::confined) = left_confined / static_cast<double>(n);
                get(r, Field::area) = each / h_s;
                particles.push_back(r);
            }
            if (n == 0) continue;
            left_solids -= static_cast<double>(n) * each;
            left_confined = 0;
        }
    }
    scale_to(solids, particles, Field::volume);
    scale_to(confined, particles, Field::confined);
    return particles;
}

ParticleSet place_again(const ParticleSet& placed, const GridSpec& grid, int per_column) {
    Raster solids(grid, 0), confined(grid, 0), u(grid, 0), v(grid, 0);
    const auto index = [&](double x, double y) {
        const auto cell = [&](double place, std::int64_t origin, std::int64_t count) {
            return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(place / grid.cell_size)) + origin, 0,
                                            count - 1);
        };
        return solids.index(grid.rows - 1 - cell(y, grid.origin_row, grid.rows),
                            cell(x, grid.origin_column, grid.columns));
    };
    for (std::size_t p = 0; p < placed.size(); ++p) {
        const std::size_t c = index(placed[Field::x][p], placed[Field::y][p]);
        const double depth = placed[Field::volume][p] / grid.cell_area();
        solids.values[c] += depth;
        confined.values[c] += placed[Field::confined][p] / grid.cell_area();
        u.values[c] += depth * placed[Field::u][p];
        v.values[c] += depth * placed[Field::v][p];
    }
    ParticleSet particles = place_by_depth(solids, confined, per_column);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const std::size_t c = index(particles[Field::x][p], particles[Field::y][p]);
        particles[Field::u][p] = u.values[c] / solids.values[c];
        particles[Field::v][p] = v.values[c] / solids.values[c];
    }
    return particles;
}

ParticleSet split_phases(const ParticleSet& columns, const std::function<SolidMaterial(Point)>& material,
                         double thinnest) {
    ParticleSet particles(k_placed_fields);
    double solids = 0, confined = 0;
    for (std::size_t p = 0; p < columns.size(); ++p) {
        ParticleRow r = columns.row(p);
        const double whole = get(r, Field::volume);
        const SolidMaterial m = material({get(r, Field::x), get(r, Field::y)});
        if (!(m.solid_fraction > 0)) continue;
        get(r, Field::volume) = m.solid_fraction * whole;
        get(r, Field::confined) = m.confined_fluid() * whole;
        solids += get(r, Field::volume);
        confined += get(r, Field::confined);
        if (whole >= thinnest * get(r, Field::area)) particles.push_back(r);
    }
    if (particles.size() == 0 && solids > 0) return split_phases(columns, material);  // nothing but thin columns
    if (thinnest > 0) {
        scale_to(solids, particles, Field::volume);
        scale_to(confined, particles, Field::confined);
    }
    return particles;
}

ParticleSet assign_material(const ParticleSet& placed, FieldMask fields,
                            const std::function<SolidMaterial(Point)>& material) {
    ParticleSet particles(fields);
    particles.resize(placed.size());
    for (std::size_t p = 0; p < placed.size(); ++p) {
        ParticleRow r = placed.row(p);
        const SolidMaterial m = material({get(r, Field::x), get(r, Field::y)});
        get(r, Field::confined_start) = get(r, Field::confined);
        get(r, Field::pores) = (1 - m.solid_fraction) / m.solid_fraction * get(r, Field::volume);
        get(r, Field::pore_pressure) = m.pore_pressure;
        get(r, Field::solid_fraction) = m.solid_fraction;
        get(r, Field::cohesion) = m.cohesion;
        get(r, Field::cohesion_ratio) = m.cohesion > 0 ? 1 : 0;
        get(r, Field::friction) = m.friction;
        get(r, Field::bed_friction) = m.bed_friction;
        get(r, Field::grain_density) = m.grain_density;
        get(r, Field::grain_diameter) = m.grain_diameter;
        particles.set_row(p, r);
    }
    return particles;
}

}  // namespace frana::structured
