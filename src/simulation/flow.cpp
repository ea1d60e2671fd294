// SPDX-License-Identifier: Apache-2.0
#include "simulation/flow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/separate_flows.h"
#include "core/reached_raster.h"
#include "mpm/ground_walls.h"
#include "mpm/shape.h"
#include "mpm/shown_depth.h"
#include "mpm/update_nodes.h"
#include "params/keys/laws.h"
#include "params/keys/result_rasters.h"
#include "simulation/dispatch.h"
#include "simulation/recorder.h"
#include "simulation/release.h"
#include "simulation/run_warnings.h"
#include "simulation/scene.h"

namespace frana {
namespace {

// The cells on top of walls of the ground that hold only what the splines carry over the face, each with the cell
// before it: the flow there never was as high as the wall and came first, and beside the top nothing on its level is
// wet.
std::vector<std::pair<std::size_t, std::size_t>> tops_not_reached(const NodeGrid& nodes, const Maxima& maxima) {
    const std::int64_t stride = nodes.stride();
    const std::array<std::int64_t, 8> around{1, stride + 1, stride, stride - 1, -1, -stride - 1, -stride, 1 - stride};
    const auto beside = [](std::size_t node, std::int64_t step) { return node + static_cast<std::size_t>(step); };
    const auto before = [&](std::size_t top) -> std::optional<std::size_t> {
        for (const std::int64_t step : around) {
            const std::size_t n = beside(top, step);
            const auto number = static_cast<std::int64_t>(n);
            if (maxima.depth[n] > 0 && !nodes.is_ghost(number % stride, number / stride) &&
                maxima.arrival_plus_1[n] <= maxima.arrival_plus_1[top] && is_wall_ahead(nodes, n, -step) &&
                nodes.bed[top] - nodes.bed[n] > maxima.depth[n])
                return n;
        }
        return std::nullopt;
    };
    std::vector<std::pair<std::size_t, std::size_t>> tops;
    nodes.for_each_covered_run([&](std::int64_t j, std::int64_t i0, std::int64_t i1) {
        for (std::size_t top = nodes.index(i0, j); top < nodes.index(i1, j); ++top) {
            const auto below = maxima.depth[top] > 0 ? before(top) : std::nullopt;
            if (below && std::none_of(around.begin(), around.end(), [&](std::int64_t step) {
                    const std::size_t n = beside(top, step);
                    return maxima.depth[n] > 0 && !is_wall_ahead(nodes, n, -step) && !before(n);
                }))
                tops.emplace_back(top, *below);
        }
    });
    return tops;
}

// Appends seeds; fields that they lack get their initial values.
void append(const ParticleSet& seeds, const PorePressure& pores, ParticleSet& particles) {
    const std::size_t before = particles.size();
    particles.resize(before + seeds.size());
    for (std::size_t p = 0; p < seeds.size(); ++p) {
        ParticleRow row = seeds.row(p);
        if (!seeds.mask().has(Field::q_xx)) get(row, Field::q_xx) = get(row, Field::q_yy) = get(row, Field::area);
        if (!seeds.mask().has(Field::pore_pressure)) get(row, Field::pore_pressure) = pores.initial.ratio;
        if (!seeds.mask().has(Field::solid_fraction)) get(row, Field::solid_fraction) = pores.initial.solid_fraction;
        particles.set_row(before + p, row);
    }
}

// Returns the frame at a place inside, as node_frame.
BedFrame frame_at(const NodeGrid& nodes, double x, double y) {
    const Stencil<QuadraticSplineShape> stencil(x, y, nodes.scale());
    const Interpolated bed = interpolate(stencil, nodes.bed.data(), nodes.stride());
    const double follows = nodes.levels.size() != 0 ? 1 - nodes.levels[nodes.scale().node_of(x, y)].ponding : 1;
    return BedFrame::of({follows * bed.dx, follows * bed.dy});
}

// Converts the velocities of particles from `first` on from map view to those along the bed.
void velocities_along_bed(const NodeGrid& nodes, std::size_t first, ParticleSet& particles) {
    const double *x = particles[Field::x], *y = particles[Field::y];
    double *u = particles[Field::u], *v = particles[Field::v];
    for (std::size_t p = first; p < particles.size(); ++p) {
        if (!nodes.bounds().contains(x[p], y[p])) continue;
        nodes.cover_round({x[p], y[p]});  // particles may enter where no flow was
        const Point w = frame_at(nodes, x[p], y[p]).along_bed(u[p], v[p]);
        u[p] = w.x;
        v[p] = w.y;
    }
}

ParticleSet with_fields(const ParticleSet& seeds, const PorePressure& pores, FieldMask fields) {
    ParticleSet particles(fields);
    append(seeds, pores, particles);
    return particles;
}

// Material that enters where there is already some increases the depth: particles near the new ones reduce their area
// until together they claim no more than the available area. Reads NodeForces area.
void shrink_neighbours(const ParticleSet& appended, const NodeGrid& nodes, ParticleSet& particles) {
    const NodeScale grid = nodes.scale();
    std::vector<std::size_t> near;
    for (std::size_t p = 0; p < appended.size(); ++p) {
        for (int b = -1; b <= 1; ++b) {
            for (int a = -1; a <= 1; ++a) {
                const double x = appended[Field::x][p] + a * grid.dx, y = appended[Field::y][p] + b * grid.dx;
                if (nodes.bounds().contains(x, y)) near.push_back(grid.node_of(x, y));
            }
        }
    }
    const NodeForces* const claims = nodes.forces();
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles[Field::x][p], y = particles[Field::y][p];
        if (!std::binary_search(near.begin(), near.end(), grid.node_of(x, y))) continue;
        const Stencil<QuadraticSplineShape> s(x, y, grid);
        double claimed = 0;
        for (int b = 0; b < 3; ++b) {
            for (int a = 0; a < 3; ++a)
                claimed += s.wx[a] * s.wy[b] * claims[s.first + static_cast<std::size_t>(b * nodes.stride() + a)].area;
        }
        claimed *= grid.inverse_dx * grid.inverse_dx;
        if (claimed > 1) particles[Field::area][p] /= claimed;
    }
}

TileGrid tile_grid(const GridSpec& grid) {
    return {grid.columns, grid.rows, k_ghost, grid.cell_size, grid.origin_column, grid.origin_row};
}

voellmy_bingham::State initial_state(const Ground& ground, ParticleSet particles) {
    NodeGrid nodes(ground);
    TileOrder order(tile_grid(ground.terrain.grid));
    return voellmy_bingham::State(std::move(particles), std::move(nodes), std::move(order));
}

}  // namespace

Flow::Flow(const Ground& ground, const ParticleSet& particles, const Material& material, const Numerics& numerics,
           int threads, std::optional<TiltedGravity> tilt, const MaterialZones& zones, const Entrainment& entrainment,
           Kernels kernels)
    : grid_(ground.terrain.grid),
      numerics_(numerics),
      pool_(threads),
      stages_(choose_stages(material, zones, entrainment, numerics, kernels)),
      state_(initial_state(ground, with_fields(particles, pore_pressure_of(material), stages_.fields))),
      laws_(make_laws(material, zones, entrainment, numerics, state_.nodes, tilt ? tilt->normal : numerics.gravity)),
      maxima_(state_.nodes.size()) {
    // Without references the levels remain zero, and the pressure is relative to zero.
    if (numerics.scheme == Scheme::standard) state_.nodes.allocate_levels();
    laws_.resample.edges = state_.nodes.bounds();
    laws_.resample.minimum_depth = 1e-3 * grid_.cell_size;
    if (laws_.friction.summed) state_.bed_states = ZeroArray<BedState>(state_.nodes.size());
    if (stages_.pore_pressure_to_nodes != nullptr) state_.pore_sums = ZeroArray<double>(state_.nodes.size());
    if (stages_.flies) state_.flights = Flights(state_.nodes.size());
    if (entrainment.active()) {
        set_erodible_beds(entrainment, zones, state_.nodes, state_.erodible_beds);
        state_.nodes.bed_changes = true;
    }
    if (tilt) {
        laws_.gravity_x = tilt->along_x;
        laws_.gravity_y = tilt->along_y;
    }
    laws_.origin = centroid();
    voellmy_bingham::prepare(state_, laws_, pool_);
    if (stages_.follows_bed) velocities_along_bed(state_.nodes, 0, state_.particles);
}

void Flow::add_walls(const Raster& walls) {
    state_.nodes.mark_walls(walls);
    laws_.resample.marks = state_.nodes.solid();
    laws_.resample.wall_mark = NodeGrid::k_wall;
}

void Flow::add_particles(const ParticleSet& particles) {
    if (particles.size() == 0) return;
    const std::size_t before = state_.particles.size();
    append(particles, laws_.friction.pore_pressure, state_.particles);
    if (stages_.follows_bed) velocities_along_bed(state_.nodes, before, state_.particles);
    voellmy_bingham::prepare(state_, laws_, pool_);
    gather();
    shrink_neighbours(particles, state_.nodes, state_.particles);
    voellmy_bingham::prepare(state_, laws_, pool_);  // greater depth gives a greater wave speed
}

voellmy_bingham::StepReport Flow::advance(double dt_limit) {
    particle_steps_ += static_cast<std::int64_t>(state_.particles.size());
    ++steps_;
    return voellmy_bingham::step(state_, laws_, stages_, dt_limit, maxima_, pool_);
}

Point Flow::map_velocity(std::size_t p) const {
    const ParticleSet& particles = state_.particles;
    const double x = particles[Field::x][p], y = particles[Field::y][p];
    const double u = particles[Field::u][p], v = particles[Field::v][p];
    if (!stages_.follows_bed || !state_.nodes.bounds().contains(x, y)) return {u, v};
    return frame_at(state_.nodes, x, y).in_map(u, v);
}

void Flow::record_gathered_velocities() {
    if (state_.gathered.size() == 0) state_.gathered = ZeroArray<Point>(state_.nodes.size());
}

StepStatistics Flow::step(double dt_limit) {
    const voellmy_bingham::StepReport report = advance(dt_limit);
    StepStatistics f;
    f.dt = report.dt;
    f.volume = report.particles.volume + report.aloft;
    f.max_depth = report.nodes.max_depth;
    f.max_speed = report.nodes.max_speed;
    f.fastest = report.particles.speeds.flow;
    f.kinetic = report.particles.kinetic + report.aloft_kinetic;
    f.energy = report.nodes.energy;
    f.energy_moving = report.nodes.kinetic;
    f.energy_levelled = report.nodes.levelled;
    f.energy_sloping = report.nodes.sloping;
    f.energy_volume = report.nodes.volume;
    f.energy_dissipated = report.nodes.dissipated;
    f.moving = report.nodes.moving + report.aloft;
    if (report.nodes.volume > 0) f.thin_fraction = std::min(1.0, report.nodes.thin / report.nodes.volume);
    f.covered = report.nodes.covered;
    f.unsupported = report.nodes.unsupported;
    f.non_finite = report.particles.non_finite;
    f.clamped = report.particles.clamped;
    f.no_data = report.particles.no_data;
    // The particles know one origin; of several they find the nearest here.
    double farthest = report.particles.front_squared;
    if (!origins_.single()) {
        farthest = 0;
        const double *const x = state_.particles[Field::x], *const y = state_.particles[Field::y];
        for (std::size_t p = 0; p < state_.particles.size(); ++p)
            farthest = std::max(farthest, origins_.squared_distance({x[p], y[p]}));
    }
    f.front_distance = std::sqrt(farthest);
    return f;
}

void Flow::synchronise() {
    voellmy_bingham::synchronise(state_, laws_, stages_, maxima_, pool_);
}

void Flow::advance_to(double time) {
    while (state_.time < time) {
        const double left = time - state_.time;
        const double before = state_.time;
        advance(left);
        if (state_.time == before || time - state_.time < 1e-12 * time) state_.time = time;
    }
    synchronise();
}

std::size_t Flow::bytes_per_node() const noexcept {
    const std::size_t level = state_.nodes.levels.size() != 0 ? sizeof(NodeLevel) : 0;
    const std::size_t solid = state_.nodes.any_solid() ? 1 : 0;
    const std::size_t laws = (state_.bed_states.size() != 0 ? sizeof(BedState) : 0) +
                             (state_.pore_sums.size() != 0 ? sizeof(double) : 0) +
                             (state_.erodible_beds.size() != 0 ? sizeof(ErodibleBed) : 0) +
                             laws_.friction.node_values.size() * sizeof(double);
    return sizeof(double) + sizeof(NodeRecord) + level + solid + sizeof(std::uint8_t) + Maxima::k_bytes + laws;
}

double Flow::momentum() const {
    const ParticleSet& p = state_.particles;
    const double *const u = p[Field::u], *const v = p[Field::v], *const volume = p[Field::volume];
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += volume[i] * std::sqrt(u[i] * u[i] + v[i] * v[i]);
    return sum + state_.flights.momentum();
}

double Flow::volume() const {
    double sum = 0;
    const double* v = state_.particles[Field::volume];
    for (std::size_t p = 0; p < state_.particles.size(); ++p) sum += v[p];
    return sum + state_.flights.volume();
}

Point Flow::centroid() const {
    Point sum;
    const ParticleSet& particles = state_.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        sum.x += particles[Field::volume][p] * particles[Field::x][p];
        sum.y += particles[Field::volume][p] * particles[Field::y][p];
    }
    const double total = volume() - state_.flights.volume();
    return total > 0 ? Point{sum.x / total, sum.y / total} : sum;
}

double Flow::stable_step() {
    return frana::stable_step(grid_.cell_size, laws_.step, state_.speeds, laws_.gravity, state_.diffusivity);
}

template <class Visit>
void Flow::for_each_reached_cell(const Visit& visit) const {
    for (const std::int64_t tile : state_.order.node_tiles()) {
        const NodeRange range(tile, state_.order.grid(), state_.nodes);
        range.for_each(state_.nodes.stride(), [&](std::size_t node, std::int64_t i, std::int64_t j) {
            const std::int64_t column = i - k_ghost, row = grid_.rows - 1 - (j - k_ghost);
            if (column >= 0 && column < grid_.columns && row >= 0 && row < grid_.rows) visit(row, column, node);
        });
    }
}

void Flow::gather() {
    gather_on_nodes(state_, laws_, stages_, maxima_, pool_);
}

Flow::NodalFields Flow::nodal_fields() {
    gather();
    NodalFields fields{reached_raster(grid_, 0), reached_raster(grid_, 0), reached_raster(grid_, 0)};
    const double inverse_area = 1 / grid_.cell_area();
    for_each_reached_cell([&](std::int64_t row, std::int64_t column, std::size_t node) {
        const NodeForces& s = state_.nodes.forces()[node];
        if (!(s.mass > 0)) return;
        const double support = stages_.references ? state_.nodes.levels[node].support : 0;
        const double depth = shown_depth(s.mass, s.area, support, s.crowding, inverse_area);
        double u = s.px / s.mass, v = s.py / s.mass;
        if (stages_.follows_bed) {
            const auto n = static_cast<std::int64_t>(node), stride = state_.nodes.stride();
            const Point in_map = node_frame(state_.nodes, node, n % stride, n / stride).in_map(u, v);
            u = in_map.x;
            v = in_map.y;
        }
        fields.depth.at(row, column) = depth;
        fields.momentum_x.at(row, column) = depth * u;
        fields.momentum_y.at(row, column) = depth * v;
    });
    return fields;
}

double Flow::speed_along_bed(std::size_t node, Point v) const {
    if (!metric()) return std::hypot(v.x, v.y);
    const auto n = static_cast<std::int64_t>(node), stride = state_.nodes.stride();
    if (!stages_.follows_bed) {
        const Point slope = node_slope(state_.nodes, node, n % stride, n / stride);
        return AlongBed{slope.x, slope.y}.speed(v);
    }
    const BedFrame frame = node_frame(state_.nodes, node, n % stride, n / stride);
    return AlongBed{frame.slope_x, frame.slope_y}.speed(v);
}

Flow::Snapshot Flow::snapshot() {
    const NodalFields fields = nodal_fields();
    Snapshot shot{reached_raster(grid_, k_no_data), reached_raster(grid_, k_no_data)};
    for_each_reached_cell([&](std::int64_t row, std::int64_t column, std::size_t node) {
        const std::size_t c = shot.depth.index(row, column);
        const double depth = fields.depth.values[c];
        if (depth < laws_.minimum_depth) return;
        const double u = fields.momentum_x.values[c] / depth, v = fields.momentum_y.values[c] / depth;
        shot.depth.values[c] = depth;
        shot.speed.values[c] = speed_along_bed(node, {u, v});
    });
    if (!ended_) return shot;
    const auto cell = [&](std::size_t node) {
        const auto n = static_cast<std::int64_t>(node), stride = state_.nodes.stride();
        return shot.depth.index(grid_.rows - 1 - (n / stride - k_ghost), n % stride - k_ghost);
    };
    std::vector<std::pair<std::size_t, double>> moved;
    for (const auto& [top, below] : tops_not_reached(state_.nodes, maxima_)) {
        if (!(shot.depth.values[cell(top)] > 0)) continue;
        shot.depth.values[cell(top)] = shot.speed.values[cell(top)] = k_no_data;
        moved.emplace_back(cell(below), state_.nodes.forces()[top].mass);
    }
    hold_volume(shot.depth, moved);
    return shot;
}

// The particles' own depths and their crowding tell the level of a lake exactly, but the volume of a channel a few
// cells wide, of a pit or of what stands behind a dam only to a tenth. A patch of cells that touch gets the volume that
// they have, and what lies at the walls beside it, if the two differ by more than a hundredth.
void Flow::hold_volume(Raster& depth, const std::vector<std::pair<std::size_t, double>>& beside) const {
    constexpr double k_same = 0.01;
    const SeparateFlows patches(reached_raster(grid_, 0), depth, {});
    std::vector<double> shown(patches.count()), held(patches.count());
    const auto visit = [&](const auto& work) {
        for_each_reached_cell([&](std::int64_t row, std::int64_t column, std::size_t node) {
            const std::size_t cell = depth.index(row, column);
            if (depth.values[cell] > 0)
                work(patches.flow_of(cell), depth.values[cell], state_.nodes.forces()[node].mass);
        });
    };
    visit([&](std::size_t patch, double here, double volume) {
        shown[patch] += here * grid_.cell_area();
        held[patch] += volume;
    });
    for (const auto& [cell, volume] : beside)
        if (depth.values[cell] > 0) held[patches.flow_of(cell)] += volume;
    visit([&](std::size_t patch, double& here, double) {
        if (std::abs(held[patch] - shown[patch]) > k_same * held[patch]) here *= held[patch] / shown[patch];
    });
}

void Flow::record_present() {
    const Snapshot shot = snapshot();
    for_each_reached_cell([&](std::int64_t row, std::int64_t column, std::size_t node) {
        const double depth = shot.depth.at(row, column);
        if (!std::isnan(depth)) maxima_.update<double>(node, 1, true, depth, shot.speed.at(row, column), state_.time);
    });
    if (!ended_) return;
    for (const auto& [top, below] : tops_not_reached(state_.nodes, maxima_))
        for (ZeroArray<double>* const of : {&maxima_.depth, &maxima_.speed, &maxima_.arrival_plus_1}) (*of)[top] = 0;
}

Raster Flow::jump_height() const {
    return to_raster(state_.flights.heights());
}

std::vector<NamedRaster> Flow::low_flights() const {
    const Maxima& low = state_.flights.low();
    const Raster depth = to_raster(low.depth), velocity = to_raster(low.speed);
    std::vector<NamedRaster> rasters{{RasterName::max_depth, depth},
                                     {RasterName::max_velocity, velocity},
                                     {RasterName::max_pressure, max_pressure(velocity)},
                                     {RasterName::arrival_time, to_raster(low.arrival_plus_1, 1)}};
    for (const Peak& peak : peaks()) {
        Raster& raster = rasters.emplace_back(NamedRaster{peak.name, depth}).values;
        depth.values.for_each_stored([&](std::size_t cell, double deep) {
            raster.values[cell] = peak.of(deep, velocity.values[cell], laws_.gravity);
        });
    }
    return rasters;
}

void Flow::states(std::span<const std::size_t> nodes, NodeState* states) const {
    const double cell_area = grid_.cell_area();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::size_t node = nodes[k];
        const NodeMotion& motion = state_.nodes.motion()[node];
        NodeState& state = states[k] = {};
        if (!(motion.mass > 0)) continue;
        state.depth = shown_depth(state_.nodes, node);
        state.volume_depth = motion.mass / cell_area;
        state.moved_x = state.volume_depth * motion.u;
        state.moved_y = state.volume_depth * motion.v;
        if (state_.gathered.size() == 0) continue;
        const Point gathered = state_.gathered[node];
        state.u = gathered.x;
        state.v = gathered.y;
        state.speed = speed_along_bed(node, gathered);
    }
}

void Flow::add_to(RunResult& result) const {
    warn_of_walls(state_.walls, "numerics.scheme = finite-volume", result);
    if (state_.erodible_beds.size() != 0) add_exchange(state_.erodible_beds, state_.exchanged, result);
    const JumpStatistics& jumps = state_.flights.statistics();
    if (jumps.volume > 0) {
        result.jumps = {jumps.volume,
                        jumps.highest,
                        jumps.longest,
                        jumps.way / jumps.volume,
                        grid_.map_from_local(jumps.from),
                        grid_.map_from_local(jumps.to)};
        result.add(RasterName::jump_height, jump_height());
        result.low_flights = low_flights();
    }
}

}  // namespace frana
