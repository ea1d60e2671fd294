// SPDX-License-Identifier: Apache-2.0
#include "simulation/structured_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/reached_raster.h"
#include "models/structured/solid/column_state.h"
#include "mpm/ground_slope.h"
#include "params/keys/result_rasters.h"
#include "simulation/run_warnings.h"
#include "simulation/scene.h"
#include "simulation/structured_laws.h"

namespace frana {
namespace {

using structured::FluidSource;

NodeGrid walled(const Ground& ground, const std::optional<Raster>& walls) {
    NodeGrid nodes(ground);
    if (walls) nodes.mark_walls(*walls);
    return nodes;
}

double thickest(const ParticleSet& columns) {
    double thickness = 0;
    for (std::size_t p = 0; p < columns.size(); ++p)
        thickness = std::max(thickness, columns[Field::volume][p] / columns[Field::area][p]);
    return thickness;
}

// Converts columns of full thickness to particles of solids with their confined fluid.
ParticleSet solids_of(const ParticleSet& columns, const StructuredMaterial& material, const GridSpec& grid,
                      FieldMask fields) {
    const auto of_place = [&](Point local) { return material_at(material, grid, local); };
    return structured::assign_material(structured::split_phases(columns, of_place, material.dry_depth), fields,
                                       of_place);
}

structured::State initial_state(NodeGrid nodes, const structured::Laws& laws, const StructuredMaterial& material,
                                const GridSpec& grid, const ParticleSet& released) {
    if (!material.solids) return {std::move(nodes), laws, ParticleSet(), {}, true};
    const auto stages = structured::choose_solid_stages(can_fracture(material), has_fluid(material), material.pores);
    return {std::move(nodes), laws, solids_of(released, material, grid, stages.fields), stages, has_fluid(material)};
}

}  // namespace

StructuredFlow::StructuredFlow(const Ground& ground, const std::optional<Raster>& walls,
                               const StructuredMaterial& material, const Numerics& numerics,
                               const ParticleSet& released, int threads)
    : grid_(ground.terrain.grid),
      numerics_(numerics),
      material_(material),
      pool_(threads),
      laws_(structured_laws(material, numerics, grid_, thickest(released))),
      state_(initial_state(walled(ground, walls), laws_, material, grid_, released)),
      tiles_(tiles_on(state_.grid)),
      maxima_(state_.grid.bed.size()),
      pressure_(state_.grid.bed.size()) {
    lay_soil();
    add_rain_maps();
    receive(released, true);
    receive_lying();
    structured::prepare(state_, laws_, pool_);
    record_present();
}

void StructuredFlow::lower_bed(const Raster& depth) {
    state_.grid.lower_bed(depth);
    if (state_.fluid) structured::set_ground(*state_.fluid, laws_.fluid);
}

void StructuredFlow::add(const Arrivals::Arrived& arrived) {
    add_release(arrived.failed);
    ParticleSet inflow;
    for (std::size_t p = arrived.failed.size(); p < arrived.particles.size(); ++p)
        inflow.push_back(arrived.particles.row(p));
    add_fluid(inflow);
}

void StructuredFlow::add_fluid(const ParticleSet& particles) {
    receive(particles, false);
    record_present();
}

void StructuredFlow::add_release(const ParticleSet& columns) {
    if (columns.size() == 0) return;
    if (material_.solids) {
        const ParticleSet solids = solids_of(columns, material_, grid_, state_.stages.fields);
        structured::add_solids(state_, solids);
        structured::prepare(state_, laws_, pool_);
    }
    receive(columns, true);
    record_present();
}

// Free fluid on the ground at the start.
void StructuredFlow::receive_lying() {
    if (!material_.initial_fluid) return;
    const Raster& depth = *material_.initial_fluid;
    std::vector<FluidSource> sources;
    depth.values.for_each_stored([&](std::size_t cell, double h) {
        const auto row = static_cast<std::int64_t>(cell) / grid_.columns,
                   column = static_cast<std::int64_t>(cell) % grid_.columns;
        if (h > 0) sources.push_back({state_.grid.index(column, grid_.rows - 1 - row), h, 0, 0});
    });
    for (const FluidSource& source : sources) entered_.free += source.depth * grid_.cell_area();
    take(sources);
}

// Rain by place, by cell.
void StructuredFlow::add_rain_maps() {
    if (!state_.fluid) return;
    for (const RainMap& map : material_.rain_maps) {
        ZeroArray<double> intensity(state_.grid.size());
        for (std::int64_t row = 0; row < grid_.rows; ++row)
            for (std::int64_t column = 0; column < grid_.columns; ++column)
                if (const double here = map.intensity.at(row, column); here > 0)
                    intensity[state_.grid.index(column, grid_.rows - 1 - row)] = here;
        state_.fluid->rain_maps.push_back({map.from, map.until, std::move(intensity)});
    }
}

// The soil under the fluid, by cell where any of its values is.
void StructuredFlow::lay_soil() {
    if (!material_.soil || !state_.fluid) return;
    structured::FluidState& fluid = *state_.fluid;
    fluid.infiltrated = ZeroArray<double>(state_.grid.size());
    fluid.soil = *material_.soil;
    if (material_.soil_zones.empty()) return;
    fluid.soils = ZeroArray<GreenAmpt>(state_.grid.size());
    for (std::int64_t row = 0; row < grid_.rows; ++row)
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            GreenAmpt here = *material_.soil;
            for (const SoilZone& zone : material_.soil_zones) here.*zone.value = zone.raster.at(row, column);
            const bool is_tight = std::isnan(here.conductivity + here.suction + here.deficit);
            fluid.soils[state_.grid.index(column, grid_.rows - 1 - row)] = is_tight ? GreenAmpt{} : here;
        }
}

// Adds particles' fluid: of released columns the fraction that is free from the start, else all.
void StructuredFlow::receive(const ParticleSet& particles, bool columns) {
    const double inverse_area = 1 / grid_.cell_area();
    std::vector<FluidSource> sources;
    sources.reserve(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Point place{particles[Field::x][p], particles[Field::y][p]};
        const structured::SolidMaterial solid = material_at(material_, grid_, place);
        const double volume = particles[Field::volume][p];
        if (columns) {
            released_mass_ += volume * whole_density(material_, solid);
            released_volume_ += volume;
        }
        const double fraction = columns && material_.solids ? solid.free() : 1;
        if (columns && material_.solids) {
            entered_.solids += volume * solid.solid_fraction;
            entered_.confined += volume * solid.confined_fluid();
        }
        entered_.free += fraction * volume;
        if (!state_.fluid || !(fraction > 0)) continue;
        if (!state_.grid.bounds().contains(place.x, place.y)) {
            state_.fluid->now.volume_left += fraction * volume;
            continue;
        }
        const double depth = fraction * volume * inverse_area;
        sources.push_back({state_.grid.scale().node_of(place.x, place.y), depth, depth * particles[Field::u][p],
                           depth * particles[Field::v][p]});
    }
    if (state_.fluid) take(sources);
}

void StructuredFlow::take(const std::vector<FluidSource>& sources) {
    state_.fluid->now.volume_left += structured::receive(sources, *state_.fluid, laws_.fluid) * grid_.cell_area();
}

double StructuredFlow::density() const {
    return released_volume_ > 0 ? released_mass_ / released_volume_ : material_.fluid_density;
}

// The longest step when almost nothing moves.
double StructuredFlow::still_step() const {
    const double wave = std::sqrt(numerics_.gravity * numerics_.minimum_depth);
    return laws_.fluid.cfl * grid_.cell_size / (2 * wave);
}

double StructuredFlow::stable_step() {
    return std::min(structured::stable_step(state_, laws_, pool_), still_step());
}

StepStatistics StructuredFlow::step(double dt_limit) {
    const double into_gaps = state_.fluid ? state_.fluid->volume_into_gaps : 0;
    const structured::StepReport report = structured::step(state_, laws_, std::min(dt_limit, still_step()), pool_);
    ++steps_;
    particle_steps_ += particle_count() * report.substeps;
    StepStatistics statistics = observe();
    statistics.dt = report.dt;
    statistics.kinetic += report.kinetic / density();
    statistics.non_finite = report.fluid.non_finite + report.solids.non_finite;
    statistics.clamped = report.solids.clamped;
    statistics.fastest = std::sqrt(report.solids.speed2);
    statistics.no_data = report.no_data + (state_.fluid && state_.fluid->volume_into_gaps > into_gaps ? 1 : 0);
    return statistics;
}

double StructuredFlow::volume() const {
    double sum = state_.fluid ? structured::fluid_volume(*state_.fluid) : 0;
    if (!state_.solid) return sum;
    const ParticleSet& particles = state_.solid->particles;
    const double *solids = particles[Field::volume], *confined = particles[Field::confined];
    for (std::size_t p = 0; p < particles.size(); ++p) sum += solids[p] + (confined != nullptr ? confined[p] : 0);
    return sum;
}

double StructuredFlow::volume_left() const noexcept {
    const double fluid = state_.fluid ? state_.fluid->now.volume_left : 0;
    const double solid = state_.solid ? state_.solid->left.solids + state_.solid->left.confined : 0;
    return fluid + solid + state_.released_outside;
}

BedBudget StructuredFlow::bed_budget() const noexcept {
    if (!state_.fluid) return {};
    return {0, 0, state_.fluid->volume_rained(), state_.fluid->volume_infiltrated};
}

void StructuredFlow::add_to(RunResult& result) const {
    warn_of_walls(state_.walls, "material.model = voellmy-bingham, numerics.scheme = finite-volume", result);
    result.phases = phase_budget();
}

std::optional<PhaseBudget> StructuredFlow::phase_budget() const {
    if (!state_.solid) return std::nullopt;
    PhaseBudget budget;
    budget.entered = entered_;
    budget.released = state_.released + state_.released_outside;
    budget.left = {state_.solid->left.solids, state_.solid->left.confined, state_.released_outside};
    const ParticleSet& p = state_.solid->particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        budget.inside.solids += p[Field::volume][i];
        if (p[Field::confined] != nullptr) budget.inside.confined += p[Field::confined][i];
        if (p[Field::cohesion_ratio] != nullptr)
            budget.cohesion_left += p[Field::volume][i] * p[Field::cohesion_ratio][i];
    }
    if (budget.inside.solids > 0) budget.cohesion_left /= budget.inside.solids;
    if (!state_.fluid) return budget;
    budget.inside.free = structured::fluid_volume(*state_.fluid);
    budget.left.free += state_.fluid->now.volume_left + state_.fluid->volume_infiltrated;
    budget.entered.free += state_.fluid->volume_rained();
    double weight = 0, sum = 0;
    for_each_active_node([&](std::size_t cell) {
        const double h = fluid_depth(cell), least = numerics_.minimum_depth;
        const structured::SolidNodes& nodes = state_.solid->nodes;
        if (!(h >= least && nodes.depth[cell] >= least)) return;
        const Point fluid = state_.fluid->velocity(cell);
        const double du = fluid.x - nodes.u[cell], dv = fluid.y - nodes.v[cell];
        weight += h;
        sum += h * (du * du + dv * dv);
    });
    if (weight > 0) budget.rms_apart = std::sqrt(sum / weight);
    return budget;
}

std::int64_t StructuredFlow::particle_count() const noexcept {
    return state_.solid ? static_cast<std::int64_t>(state_.solid->particles.size()) : 0;
}

std::size_t StructuredFlow::bytes_per_particle() const noexcept {
    return state_.solid ? state_.solid->particles.bytes_per_particle() : 0;
}

std::size_t StructuredFlow::bytes_per_node() const noexcept {
    constexpr std::size_t k_fluid_values = 21;                 // of finite_volume::State
    constexpr std::size_t k_solid_values = 7;                  // fields of the solids that act on the fluid
    std::size_t bytes = 2 * sizeof(double) + Maxima::k_bytes;  // bed and pressure, and the maxima
    if (state_.fluid) {
        const structured::FluidState& fluid = *state_.fluid;
        bytes += k_fluid_values * sizeof(double) + (fluid.infiltrated.size() != 0 ? sizeof(double) : 0) +
                 (fluid.soils.size() != 0 ? sizeof(GreenAmpt) : 0) + fluid.rain_maps.size() * sizeof(double) +
                 (fluid.now.bed_states.size() != 0 ? sizeof(BedState) + sizeof(NodeRecord) : 0);
    }
    if (state_.solid)
        bytes += sizeof(structured::SolidSums) + sizeof(structured::NodePush) + k_solid_values * sizeof(double) +
                 (state_.fluid ? sizeof(structured::CouplingSums) + 2 * sizeof(double) : 0);
    return bytes;
}

void StructuredFlow::record_present() {
    observe();
}

StepStatistics StructuredFlow::observe() {
    const std::vector<std::int64_t> tiles = shown_tiles();
    std::vector<StepStatistics> statistics(tiles.size());
    const double area = grid_.cell_area();
    const double fluid_fraction = material_.fluid_density / density();
    pool_.for_each(tiles.size(), [&](std::size_t t) {
        StepStatistics& f = statistics[t];
        NodeRange(tiles[t], tiles_, state_.grid)
            .for_each(state_.grid.stride(), [&](std::size_t cell, std::int64_t i, std::int64_t j) {
                const double depth = inside(i, j) ? fluid_depth(cell) + coupled_depth(cell) : 0;
                if (depth < numerics_.minimum_depth) f.thin_fraction += depth * area;
                if (!(depth >= laws_.fluid.dry)) return;
                const double fluid_fast = fluid_speed(cell), solid_fast = solid_speed(cell);
                const double fast = std::max(fluid_fast, solid_fast);
                f.kinetic += 0.5 * fluid_fraction * fluid_depth(cell) * area * fluid_fast * fluid_fast;
                if (fast > moving_speed_) f.moving += depth * area;
                if (depth < numerics_.minimum_depth) return;
                ++f.covered;
                f.max_depth = std::max(f.max_depth, depth);
                f.max_speed = std::max(f.max_speed, fast);
                const Point here = state_.grid.middle(i, j);
                f.front_distance = std::max(f.front_distance, origins_.squared_distance(here));
                maxima_.update<double>(cell, 1, true, depth, fast, state_.time);
                pressure_[cell] = std::max(pressure_[cell], dynamic_pressure(cell, fluid_fast, solid_fast));
            });
    });
    StepStatistics sum;
    for (const StepStatistics& f : statistics) {
        sum.kinetic += f.kinetic;
        sum.moving += f.moving;
        sum.thin_fraction += f.thin_fraction;
        sum.covered += f.covered;
        sum.max_depth = std::max(sum.max_depth, f.max_depth);
        sum.max_speed = std::max(sum.max_speed, f.max_speed);
        sum.front_distance = std::max(sum.front_distance, f.front_distance);
    }
    sum.front_distance = std::sqrt(sum.front_distance);
    sum.volume = volume();
    sum.thin_fraction = sum.volume > 0 ? std::min(1.0, sum.thin_fraction / sum.volume) : 0;
    return sum;
}

// Tiles in which something may move: those of the fluid and of the solids.
std::vector<std::int64_t> StructuredFlow::shown_tiles() const {
    std::vector<std::int64_t> shown;
    if (state_.fluid) shown = state_.fluid->now.wet;
    if (state_.solid) {
        const std::vector<std::int64_t>& solid = state_.solid->nodes.tiles;
        shown.insert(shown.end(), solid.begin(), solid.end());
        make_ascending(shown);
    }
    return shown;
}
}  // namespace frana

// Rasters of a structured flow's cells and particles.

namespace frana {
namespace {

// Returns the volume-weighted mean over the particles of each cell; NaN where there is none.
template <class Value>
Raster mean_by_cell(const ParticleSet& particles, const GridSpec& grid, const Value& value) {
    Raster sum = reached_raster(grid, k_no_data), weight = reached_raster(grid, 0);
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
        c.depth = fluid_depth(cell);
        const Point u = c.depth > 0 ? state_.fluid->velocity(cell) : Point{};
        c.qx = c.depth * u.x;
        c.qy = c.depth * u.y;
    }
    if (state_.solid) {
        const structured::SolidNodes& nodes = state_.solid->nodes;
        c.depth += nodes.depth[cell];
        c.qx += nodes.depth[cell] * nodes.u[cell];
        c.qy += nodes.depth[cell] * nodes.v[cell];
    }
    return c;
}

double StructuredFlow::fluid_speed(std::size_t cell) const {
    const double h = fluid_depth(cell);
    if (!(h > laws_.fluid.dry)) return 0;
    const double qx = state_.fluid->now.qx[cell], qy = state_.fluid->now.qy[cell];
    return std::sqrt(qx * qx + qy * qy) / h;
}

double StructuredFlow::solid_speed(std::size_t cell) const {
    if (!state_.solid || !(state_.solid->nodes.depth[cell] >= laws_.fluid.dry)) return 0;
    const double u = state_.solid->nodes.u[cell], v = state_.solid->nodes.v[cell];
    const Point slope = laws_.fluid.steep ? ground_slope(state_.grid, cell) : Point{};
    return speed_along_bed(u, v, slope.x * u + slope.y * v);
}

double StructuredFlow::dynamic_pressure(std::size_t cell, double fluid, double solid) const {
    double most = material_.fluid_density * fluid * fluid;
    if (solid > 0) {
        const structured::SolidSums& sums = state_.solid->nodes.sums[cell];
        most = std::max(most, sums.mass / (sums.solids + sums.confined) * solid * solid);
    }
    return most / 1000;
}

Raster StructuredFlow::max_pressure(const Raster& max_velocity) const {
    Raster pressure = reached_raster(grid_, k_no_data);
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

void StructuredFlow::states(std::span<const std::size_t> cells, NodeState* states) const {
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const Column here = column(cells[k]);
        NodeState& state = states[k] = {};
        if (!(here.depth > 0)) continue;
        state.depth = state.volume_depth = here.depth;
        state.moved_x = here.qx;
        state.moved_y = here.qy;
        state.u = state.moved_x / state.depth;
        state.v = state.moved_y / state.depth;
        state.speed = speed(cells[k]);
    }
}

// A wet cell with a value that is not finite or beside ground without elevation. If all values are finite, the fluid
// was too fast to be computed further: returns its fastest cell.
std::optional<Point> StructuredFlow::cell_with(RunProblem::Kind kind) const {
    if (!state_.fluid) return std::nullopt;
    const finite_volume::State& now = state_.fluid->now;
    const auto stride = static_cast<std::size_t>(state_.grid.stride());
    std::optional<std::size_t> found;
    double greatest = 0;
    for_each_active_node([&](std::size_t cell) {
        if (kind == RunProblem::Kind::no_data) {
            if (found || !(now.depth[cell] > 0)) return;
            for (const std::size_t near : {cell - 1, cell + 1, cell - stride, cell + stride})
                if (state_.grid.is_gap(near)) found = cell;
            return;
        }
        const bool finite = std::isfinite(now.depth[cell] + now.qx[cell] + now.qy[cell]);
        const double speed = !finite               ? std::numeric_limits<double>::infinity()
                             : now.depth[cell] > 0 ? std::hypot(now.qx[cell], now.qy[cell]) / now.depth[cell]
                                                   : 0;
        if (!(speed > greatest)) return;
        greatest = speed;
        found = cell;
    });
    if (!found) return std::nullopt;
    const auto index = static_cast<std::int64_t>(*found);
    return state_.grid.middle(index % state_.grid.stride(), index / state_.grid.stride());
}

Model::Snapshot StructuredFlow::snapshot() {
    const auto shown = [&](std::size_t cell) { return column(cell).depth >= numerics_.minimum_depth; };
    return {raster_of([&](std::size_t cell) { return shown(cell) ? column(cell).depth : k_no_data; }),
            raster_of([&](std::size_t cell) { return shown(cell) ? speed(cell) : k_no_data; })};
}

std::vector<NamedRaster> StructuredFlow::more_rasters() const {
    const double least = numerics_.minimum_depth;
    std::vector<NamedRaster> rasters;
    const auto add = [&](const char* name, Raster raster) { rasters.push_back({name, std::move(raster)}); };
    if (state_.fluid)
        add("fluid_velocity",
            raster_of([&](std::size_t cell) { return fluid_depth(cell) >= least ? fluid_speed(cell) : k_no_data; }));
    if (state_.fluid && state_.fluid->infiltrated.size() > 0)
        add("infiltrated_depth", to_raster(state_.fluid->infiltrated));
    if (!state_.solid) return rasters;
    const structured::SolidNodes& nodes = state_.solid->nodes;
    const auto solid_depth = [&](std::size_t cell) { return nodes.sums[cell].solids / grid_.cell_area(); };
    const auto where_solid = [&](std::size_t cell, double value) {
        return solid_depth(cell) >= least ? value : k_no_data;
    };
    add(RasterName::solid_depth, raster_of([&](std::size_t cell) { return where_solid(cell, solid_depth(cell)); }));
    add("solid_velocity", raster_of([&](std::size_t cell) { return where_solid(cell, solid_speed(cell)); }));
    const ParticleSet& particles = state_.solid->particles;
    if (particles[Field::cohesion_ratio] != nullptr)
        add(RasterName::cohesion_ratio,
            mean_by_cell(particles, grid_, [&](std::size_t p) { return particles[Field::cohesion_ratio][p]; }));
    if (particles[Field::e_xx] != nullptr)
        add(RasterName::strain,
            mean_by_cell(particles, grid_, [&](std::size_t p) { return greatest_strain(particles, p); }));
    if (!state_.fluid) return rasters;
    add("fluid_depth",
        raster_of([&](std::size_t cell) { return fluid_depth(cell) >= least ? fluid_depth(cell) : k_no_data; }));
    add("solid_fraction", raster_of([&](std::size_t cell) {
            return column(cell).depth >= least ? solid_depth(cell) / column(cell).depth : k_no_data;
        }));
    if (particles[Field::confined] != nullptr) {
        const double *left = particles[Field::confined], *start = particles[Field::confined_start];
        Raster lost = reached_raster(grid_, k_no_data);
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

}  // namespace frana
