// SPDX-License-Identifier: Apache-2.0
#include "simulation/structured_flow.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace frana {
namespace {

using structured::FluidLaws;
using structured::FluidSource;
using structured::k_fluid_cell;

FluidLaws laws_of(const StructuredMaterial& material, const Numerics& numerics) {
    FluidLaws laws;
    laws.gravity = numerics.gravity;
    laws.cfl = numerics.cfl;
    laws.dry = material.dry_depth;
    laws.steep = numerics.slope_correction != SlopeCorrection::none;
    laws.wall = numerics.boundary == Boundary::wall;
    laws.gaps_are_open = numerics.nodata == NodataPolicy::stop;
    laws.manning = material.manning;
    laws.density = material.fluid_density;
    laws.viscosity = material.fluid_viscosity;
    laws.velocity_shape = material.velocity_shape;
    return laws;
}

}  // namespace

StructuredFlow::StructuredFlow(const Raster& bed, const StructuredMaterial& material, const Numerics& numerics,
                               int threads)
    : grid_(bed.grid),
      numerics_(numerics),
      pool_(threads),
      nodes_(bed),
      laws_(laws_of(material, numerics)),
      state_(nodes_, laws_),
      maxima_(nodes_.bed.size()) {}

void StructuredFlow::add_walls(const Raster& walls) {
    nodes_.mark_walls(walls);
    structured::set_ground(state_, nodes_, laws_);
}

void StructuredFlow::lower_bed(const Raster& depth) {
    nodes_.lower_bed(depth);
    structured::set_ground(state_, nodes_, laws_);
}

void StructuredFlow::add_particles(const ParticleSet& particles) {
    const double inverse = 1 / grid_.cell_size, inverse_area = 1 / grid_.cell_area();
    std::vector<FluidSource> sources;
    sources.reserve(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles[Field::x][p] * inverse, y = particles[Field::y][p] * inverse;
        const double depth = particles[Field::volume][p] * inverse_area;
        if (!(x >= 0 && y >= 0 && x < static_cast<double>(grid_.columns) && y < static_cast<double>(grid_.rows))) {
            state_.volume_left += particles[Field::volume][p];
            continue;
        }
        sources.push_back({nodes_.index(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)), depth,
                           depth * particles[Field::u][p], depth * particles[Field::v][p]});
    }
    state_.volume_left += structured::receive(sources, state_, laws_) * grid_.cell_area();
    see_present();
}

double StructuredFlow::stable_step() {
    const double still = laws_.cfl * grid_.cell_size / (2 * std::sqrt(laws_.gravity * numerics_.minimum_depth));
    return std::min(structured::stable_step(state_, nodes_, laws_, {}, pool_), still);
}

StepFigures StructuredFlow::advance(double dt_limit) {
    const double dt = std::min(dt_limit, stable_step());
    const double into_gaps = state_.volume_into_gaps;
    const structured::FluidReport report = structured::advance(state_, nodes_, laws_, {}, dt, pool_);
    time_ += dt;
    ++steps_;
    StepFigures figures = observe();
    figures.dt = dt;
    figures.non_finite = report.non_finite;
    figures.no_data = state_.volume_into_gaps > into_gaps ? 1 : 0;
    return figures;
}

double StructuredFlow::volume() {
    return structured::fluid_volume(state_, nodes_, pool_);
}

std::size_t StructuredFlow::bytes_per_node() const noexcept {
    constexpr std::size_t k_values = 9;  // present, stage and next of depth and two discharges
    return (1 + k_values) * sizeof(double) + 1 + (laws_.steep ? sizeof(double) : 0) + Maxima::k_bytes;
}

double StructuredFlow::speed(std::size_t cell) const {
    const double h = state_.now.depth[cell];
    if (h < laws_.dry) return 0;
    const double u = state_.now.qx[cell] / h, v = state_.now.qy[cell] / h;
    double climb = 0;
    if (laws_.steep) {
        const auto up = static_cast<std::size_t>(nodes_.stride());
        climb = (u * (nodes_.bed[cell + 1] - nodes_.bed[cell - 1]) +
                 v * (nodes_.bed[cell + up] - nodes_.bed[cell - up])) /
                (2 * grid_.cell_size);
    }
    return std::sqrt(u * u + v * v + climb * climb);
}

void StructuredFlow::see_present() {
    observe();
}

StepFigures StructuredFlow::observe() {
    std::vector<StepFigures> tiles(state_.tiles.size());
    const double dx = grid_.cell_size, area = grid_.cell_area();
    pool_.for_each(tiles.size(), [&](std::size_t t) {
        StepFigures& f = tiles[t];
        const NodeRange range(state_.tiles[t], state_.grid, nodes_);
        range.for_each(nodes_.stride(), [&](std::size_t cell, std::int64_t i, std::int64_t j) {
            const double depth = state_.now.depth[cell];
            if (!(depth >= laws_.dry) || state_.cell_kind[cell] != k_fluid_cell) return;
            const double fast = speed(cell), volume = depth * area;
            f.kinetic += 0.5 * volume * fast * fast;
            if (fast > moving_speed_) f.moving += volume;
            if (depth < numerics_.minimum_depth) return;
            ++f.covered;
            f.max_depth = std::max(f.max_depth, depth);
            f.max_speed = std::max(f.max_speed, fast);
            const double x = (static_cast<double>(i - k_ghost) + 0.5) * dx - origin_.x;
            const double y = (static_cast<double>(j - k_ghost) + 0.5) * dx - origin_.y;
            f.front_distance = std::max(f.front_distance, x * x + y * y);
            maxima_.see(cell, depth, fast, time_);
        });
    });
    StepFigures sum;
    for (const StepFigures& f : tiles) {
        sum.kinetic += f.kinetic;
        sum.moving += f.moving;
        sum.covered += f.covered;
        sum.max_depth = std::max(sum.max_depth, f.max_depth);
        sum.max_speed = std::max(sum.max_speed, f.max_speed);
        sum.front_distance = std::max(sum.front_distance, f.front_distance);
    }
    sum.front_distance = std::sqrt(sum.front_distance);
    sum.volume = volume();
    return sum;
}

StructuredFlow::Snapshot StructuredFlow::snapshot() const {
    Snapshot shot{Raster(grid_, k_no_data), Raster(grid_, k_no_data)};
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const std::size_t cell = nodes_.index(column, grid_.rows - 1 - row);
            if (state_.now.depth[cell] < numerics_.minimum_depth) continue;
            shot.depth.at(row, column) = state_.now.depth[cell];
            shot.speed.at(row, column) = speed(cell);
        }
    }
    return shot;
}

Raster StructuredFlow::to_raster(const ZeroArray<double>& padded, double shift) const {
    Raster raster(grid_, k_no_data);
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const double value = padded[nodes_.index(column, grid_.rows - 1 - row)];
            if (value != 0) raster.at(row, column) = value - shift;
        }
    }
    return raster;
}

}  // namespace frana
