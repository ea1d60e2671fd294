// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "analysis/energy_line.h"
#include "analysis/trace.h"
#include "params/keys/laws.h"
#include "simulation/run_check.h"
#include "simulation/stepped_run.h"

namespace frana::bench {
namespace {

double speed_limit(const Setup& setup, double fastest) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const double z : setup.bed.values)
        if (!std::isnan(z)) lowest = std::min(lowest, z);
    const GridSpec& grid = setup.bed.grid;
    double drop = 0, deepest = 0;
    const ParticleSet& seeds = setup.seeds;
    for (std::size_t p = 0; p < seeds.size(); ++p) {
        const auto column = static_cast<std::int64_t>(seeds[Field::x][p] / grid.cell_size);
        const auto row = grid.rows - 1 - static_cast<std::int64_t>(seeds[Field::y][p] / grid.cell_size);
        const double depth = seeds[Field::volume][p] / seeds[Field::area][p];
        deepest = std::max(deepest, depth);
        const double z = setup.bed.at(row, column);
        if (!std::isnan(z)) drop = std::max(drop, z + depth - lowest);
    }
    return speed_bound(k_gravity, drop, deepest, fastest);
}

std::int64_t count_non_finite(const ParticleSet& particles) {
    std::int64_t count = 0;
    for (std::size_t f = 0; f < k_fields; ++f) {
        const double* values = particles[static_cast<Field>(f)];
        if (values == nullptr) continue;
        for (std::size_t p = 0; p < particles.size(); ++p) count += std::isfinite(values[p]) ? 0 : 1;
    }
    return count;
}

// Greatest speed along x or y in map view [m/s]: of waves through cells, of material that particles move.
double fastest_in_map(const Model& model, double minimum_depth) {
    const bool particles = model.particle_set() != nullptr;
    double fastest = 0;
    model.for_each_active_state([&](std::size_t, const NodeState& state) {
        if (!(state.volume_depth >= minimum_depth)) return;
        const double speed = std::max(std::abs(state.moved_x), std::abs(state.moved_y)) / state.volume_depth;
        fastest = std::max(fastest, speed + (particles ? 0 : std::sqrt(k_gravity * state.volume_depth)));
    });
    return fastest;
}

// How far the maxima are above the energy line, of the fall.
double above_line(const Setup& setup, const Model& model) {
    const ParticleSet& seeds = setup.seeds;
    const GridSpec& grid = setup.bed.grid;
    Raster source(grid, k_no_data);
    for (std::size_t p = 0; p < seeds.size(); ++p) {
        const Cell at = cell_of(grid, {seeds[Field::x][p], seeds[Field::y][p]});
        const double u = seeds[Field::u][p], v = seeds[Field::v][p];
        const double head = seeds[Field::volume][p] / seeds[Field::area][p] + (u * u + v * v) / (2 * k_gravity);
        const double before = source.at(at.row, at.column), here = setup.bed.at(at.row, at.column) + head;
        source.at(at.row, at.column) = std::isnan(before) ? here : std::max(before, here);
    }
    const Raster depth = model.to_raster(model.maxima().depth), speed = model.to_raster(model.maxima().speed);
    const std::optional<Raster>& zones = setup.zones.friction_coefficient;
    const double uniform = setup.structured ? 0 : friction_coefficient_of(setup.material).value_or(0);
    return energy_line_excess({setup.bed, source, depth, speed,
                               [&](std::size_t cell) { return zones ? zones->values[cell] : uniform; }, k_gravity,
                               model.pressure_factor() * maximum(depth)})
        .of_fall;
}

bool walled_in(const Setup& setup) {
    const bool gaps =
        std::any_of(setup.bed.values.begin(), setup.bed.values.end(), [](double z) { return std::isnan(z); });
    return setup.numerics.boundary == Boundary::wall && (!gaps || setup.numerics.nodata == NodataPolicy::wall);
}

}  // namespace

double Figure::used() const noexcept {
    if (value <= 0) return 0;
    return limit > 0 && !std::isnan(value) ? value / limit : std::numeric_limits<double>::infinity();
}

Soundness watch(TimedFlow& run, const Setup& setup, double end) {
    Soundness s;
    const Model& model = run.model();
    const double volume = model.volume();
    double fastest = 0;
    for (std::size_t p = 0; p < setup.seeds.size(); ++p)
        fastest = std::max(fastest, std::hypot(setup.seeds[Field::u][p], setup.seeds[Field::v][p]));
    const double limit = speed_limit(setup, fastest);
    const bool closed = walled_in(setup);
    double fastest_now = fastest_in_map(model, setup.numerics.minimum_depth), way = 0;
    EnergyWatch energy;
    run.advance_to(end, [&](const StepStatistics& step) {
        const BedBudget bed = model.bed_budget();
        const double left = closed ? 0 : model.volume_left();
        s.volume_error =
            std::max(s.volume_error, std::abs(model.volume() + left + bed.deposited - bed.eroded - volume) / volume);
        s.speed_ratio = std::max({s.speed_ratio, step.fastest / limit, step.max_speed / limit});
        way += fastest_now * step.dt / setup.bed.grid.cell_size;
        fastest_now = fastest_in_map(model, setup.numerics.minimum_depth);
        s.last_speed = step.volume > 0 ? std::sqrt(2 * step.kinetic / step.volume) : 0;
        energy.add(step);
    });
    s.courant = way / static_cast<double>(std::max<std::int64_t>(1, model.steps()));
    s.energy_rise = energy.error().value_or(0);
    run.model().end();
    run.model().record_present();
    s.above_line = above_line(setup, model);
    s.non_finite = run.non_finite() + count_non_finite(run.particles());
    s.particles = run.peak_particles();
    s.steps = model.steps();
    s.wall_seconds = run.seconds();
    return s;
}

Raster mirrored(Raster raster, bool swaps_west) {
    const auto columns = static_cast<std::ptrdiff_t>(raster.grid.columns);
    std::vector<double> values(raster.values.begin(), raster.values.end());
    if (swaps_west)
        for (auto row = values.begin(); row != values.end(); row += columns) std::reverse(row, row + columns);
    else
        for (std::ptrdiff_t i = 0, j = static_cast<std::ptrdiff_t>(values.size()) - columns; i < j;
             i += columns, j -= columns)
            std::swap_ranges(values.begin() + i, values.begin() + i + columns, values.begin() + j);
    std::copy(values.begin(), values.end(), raster.values.begin());
    return raster;
}

Setup mirrored(Setup setup, bool swaps_west) {
    const GridSpec& grid = setup.bed.grid;
    const double side = grid.cell_size * static_cast<double>(swaps_west ? grid.columns : grid.rows);
    double *const place = setup.seeds[swaps_west ? Field::x : Field::y],
                  *const speed = setup.seeds[swaps_west ? Field::u : Field::v];
    for (std::size_t p = 0; p < setup.seeds.size(); ++p) {
        place[p] = side - place[p];
        speed[p] = -speed[p];
    }
    setup.bed = mirrored(std::move(setup.bed), swaps_west);
    for (const ZoneRaster& zone : k_zone_rasters)
        if (auto& raster = setup.zones.*zone.raster) raster = mirrored(std::move(*raster), swaps_west);
    return setup;
}

double elsewhere(const Raster& depth, const Raster& other) {
    double apart = 0, all = 0;
    for (std::size_t c = 0; c < depth.values.size(); ++c) {
        apart += std::abs(depth.values[c] - other.values[c]);
        all += depth.values[c] + other.values[c];
    }
    return all > 0 ? apart / all : 0;
}

}  // namespace frana::bench
