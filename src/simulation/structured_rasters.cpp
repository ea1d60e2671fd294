// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "simulation/particle_table.h"
#include "simulation/structured_flow.h"
#include "simulation/terrain_sample.h"

// Rasters of a structured flow's cells and particles.

namespace frana {
namespace {

// Returns the volume-weighted mean over the particles of each cell; NaN where there is none.
template <class Value>
Raster mean_by_cell(const ParticleSet& particles, const GridSpec& grid, const Value& value) {
    Raster sum(grid, k_no_data), weight(grid, 0);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Cell c = cell_of(grid, {particles[Field::x][p], particles[Field::y][p]});
        const double volume = particles[Field::volume][p];
        double& here = sum.at(c.row, c.column);
        here = (std::isnan(here) ? 0 : here) + volume * value(p);
        weight.at(c.row, c.column) += volume;
    }
    sum.values.change_each_stored([&](std::size_t cell, double& here) {
        if (!std::isnan(here)) here = weight.values[cell] > 0 ? here / weight.values[cell] : k_no_data;
    });
    return sum;
}

}  // namespace

StructuredFlow::Column StructuredFlow::column(std::size_t cell) const noexcept {
    Column c;
    if (state_.fluid) {
        c.depth = state_.fluid->now.depth[cell];
        c.qx = state_.fluid->now.qx[cell];
        c.qy = state_.fluid->now.qy[cell];
    }
    if (state_.solid) {
        const structured::SolidNodes& nodes = state_.solid->nodes;
        c.depth += nodes.depth[cell];
        c.qx += nodes.depth[cell] * nodes.u[cell];
        c.qy += nodes.depth[cell] * nodes.v[cell];
    }
    return c;
}

double StructuredFlow::along_bed(std::size_t cell, double u, double v) const noexcept {
    double climb = 0;
    if (laws_.fluid.steep) {
        climb = climb_at(state_.grid.bed.data() + cell, state_.grid.stride(), 0.5 / grid_.cell_size, u, v);
    }
    return speed_along_bed(u, v, climb);
}

double StructuredFlow::fluid_speed(std::size_t cell) const {
    const double h = fluid_depth(cell);
    if (!(h >= laws_.fluid.dry)) return 0;
    return along_bed(cell, state_.fluid->now.qx[cell] / h, state_.fluid->now.qy[cell] / h);
}

double StructuredFlow::solid_speed(std::size_t cell) const {
    if (!state_.solid || !(state_.solid->nodes.depth[cell] >= laws_.fluid.dry)) return 0;
    return along_bed(cell, state_.solid->nodes.u[cell], state_.solid->nodes.v[cell]);
}

double StructuredFlow::dynamic_pressure(std::size_t cell) const {
    const double fluid = fluid_speed(cell), solid = solid_speed(cell);
    double most = material_.fluid_density * fluid * fluid;
    if (solid > 0) {
        const structured::SolidSums& sums = state_.solid->nodes.sums[cell];
        most = std::max(most, sums.mass / (sums.solids + sums.confined) * solid * solid);
    }
    return most / 1000;
}

Raster StructuredFlow::max_pressure_where(const Raster& max_velocity) const {
    Raster pressure(grid_, k_no_data);
    max_velocity.values.for_each_stored([&](std::size_t cell, double speed) {
        if (std::isnan(speed)) return;
        const auto n = static_cast<std::int64_t>(cell);
        const double most = pressure_[state_.grid.index(n % grid_.columns, grid_.rows - 1 - n / grid_.columns)];
        if (std::isfinite(most)) pressure.values[cell] = most;
    });
    return pressure;
}

double StructuredFlow::momentum() const {
    double sum = 0;
    for_each_active_node([&](std::size_t cell) {
        const Column c = column(cell);
        sum += std::sqrt(c.qx * c.qx + c.qy * c.qy);
    });
    return sum * grid_.cell_area();
}

double StructuredFlow::speed(std::size_t cell) const {
    return std::max(fluid_speed(cell), solid_speed(cell));
}

template <class Value>
Raster StructuredFlow::raster_of(const Value& value) const {
    Raster raster(grid_, k_no_data);
    state_.grid.for_each_covered_run([&](std::int64_t j, std::int64_t i0, std::int64_t i1) {
        for (std::int64_t i = i0; i < i1; ++i) {
            const double here = value(state_.grid.index(i, j));
            if (!std::isnan(here)) raster.at(grid_.rows - 1 - j, i) = here;
        }
    });
    return raster;
}

StructuredFlow::Snapshot StructuredFlow::snapshot() const {
    const auto shown = [&](std::size_t cell) { return column(cell).depth >= numerics_.minimum_depth; };
    return {raster_of([&](std::size_t cell) { return shown(cell) ? column(cell).depth : k_no_data; }),
            raster_of([&](std::size_t cell) { return shown(cell) ? speed(cell) : k_no_data; })};
}

std::vector<NamedRaster> StructuredFlow::phases() const {
    const double least = numerics_.minimum_depth;
    std::vector<NamedRaster> rasters;
    const auto add = [&](const char* name, Raster raster) { rasters.push_back({name, std::move(raster)}); };
    if (state_.fluid)
        add("fluid_velocity",
            raster_of([&](std::size_t cell) { return fluid_depth(cell) >= least ? fluid_speed(cell) : k_no_data; }));
    if (!state_.solid) return rasters;
    const structured::SolidNodes& nodes = state_.solid->nodes;
    const auto solid_depth = [&](std::size_t cell) { return nodes.sums[cell].solids / grid_.cell_area(); };
    const auto where_solid = [&](std::size_t cell, double value) {
        return solid_depth(cell) >= least ? value : k_no_data;
    };
    add("solid_depth", raster_of([&](std::size_t cell) { return where_solid(cell, solid_depth(cell)); }));
    add("solid_velocity", raster_of([&](std::size_t cell) { return where_solid(cell, solid_speed(cell)); }));
    const ParticleSet& particles = state_.solid->particles;
    if (particles[Field::cohesion_ratio] != nullptr)
        add("cohesion_ratio",
            mean_by_cell(particles, grid_, [&](std::size_t p) { return particles[Field::cohesion_ratio][p]; }));
    if (particles[Field::e_xx] != nullptr)
        add("strain", mean_by_cell(particles, grid_, [&](std::size_t p) { return greatest_strain(particles, p); }));
    if (!state_.fluid) return rasters;
    add("fluid_depth",
        raster_of([&](std::size_t cell) { return fluid_depth(cell) >= least ? fluid_depth(cell) : k_no_data; }));
    add("solid_fraction", raster_of([&](std::size_t cell) {
            return column(cell).depth >= least ? solid_depth(cell) / column(cell).depth : k_no_data;
        }));
    if (particles[Field::confined] != nullptr) {
        const double *left = particles[Field::confined], *start = particles[Field::confined_start];
        Raster lost(grid_, k_no_data);
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const Cell c = cell_of(grid_, {particles[Field::x][p], particles[Field::y][p]});
            double& depth = lost.at(c.row, c.column);
            const double volume = start != nullptr ? start[p] - left[p] : 0;
            depth = (std::isnan(depth) ? 0 : depth) + volume / grid_.cell_area();
        }
        add("released_water", std::move(lost));
    }
    return rasters;
}

Raster StructuredFlow::to_raster(const ZeroArray<double>& padded, double shift) const {
    return raster_of([&](std::size_t cell) { return padded[cell] != 0 ? padded[cell] - shift : k_no_data; });
}

}  // namespace frana
