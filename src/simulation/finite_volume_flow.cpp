// SPDX-License-Identifier: Apache-2.0
#include "simulation/finite_volume_flow.h"

#include <algorithm>
#include <cmath>

#include "simulation/dispatch.h"
#include "simulation/plane_stress.h"
#include "simulation/run_warnings.h"
#include "simulation/scene.h"

namespace frana {
namespace {

constexpr double k_film = 0.01;  // of the minimum depth: depth that does not move

NodeGrid walled_nodes(const Ground& ground, const std::optional<Raster>& walls) {
    NodeGrid nodes(ground);
    if (walls) nodes.mark_walls(*walls);
    return nodes;
}

finite_volume::Laws laws_of(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
                            const Numerics& numerics, NodeGrid& nodes, const std::optional<TiltedGravity>& tilt) {
    finite_volume::Laws laws;
    voellmy_bingham::Laws shared =
        make_laws(material, zones, entrainment, numerics, nodes, tilt ? tilt->normal : numerics.gravity);
    laws.values.cell_size = nodes.cell_size();
    laws.values.gravity = shared.gravity;
    if (tilt) {
        laws.values.gravity_x = tilt->along_x;
        laws.values.gravity_y = tilt->along_y;
    }
    laws.values.minimum_depth = numerics.minimum_depth;
    laws.values.dry = k_film * numerics.minimum_depth;
    laws.values.wave_factor = shared.stress.wave_factor;
    laws.values.weight_of_bed = slope_correction(numerics) == SlopeCorrection::surface;
    laws.cfl = shared.step.cfl;
    laws.along_bed = slope_correction(numerics) != SlopeCorrection::none;
    laws.curved = curvature(numerics);
    laws.wall = shared.wall;
    laws.gap_is_wall = numerics.nodata != NodataPolicy::stop;
    laws.flies = numerics.flight.value_or(true) && !tilt;
    laws.jumps = shared.jumps;
    laws.friction = std::move(shared.friction);
    laws.stress = shared.stress;
    laws.exchange = shared.exchange;
    return laws;
}

}  // namespace

FiniteVolumeFlow::FiniteVolumeFlow(const Ground& ground, const std::optional<Raster>& walls,
                                   const ParticleSet& released, const Material& material, const Numerics& numerics,
                                   int threads, const MaterialZones& zones, const Entrainment& entrainment,
                                   std::optional<TiltedGravity> tilt)
    : grid_(ground.terrain.grid),
      pool_(threads),
      nodes_(walled_nodes(ground, walls)),
      state_(nodes_),
      laws_(laws_of(material, zones, entrainment, numerics, state_.nodes, tilt)),
      maxima_(state_.nodes.size()) {
    if (laws_.friction.summed) state_.bed_states = ZeroArray<BedState>(state_.nodes.size());
    if (laws_.stress.law)
        for (ZeroArray<double>* force : {&state_.force_x, &state_.force_y})
            *force = ZeroArray<double>(state_.nodes.size());
    const PorePressure& pores = laws_.friction.pore_pressure;
    if (pores.active()) state_.carried[0] = ZeroArray<double>(state_.nodes.size());
    if (pores.active() && pores.dilates()) state_.carried[1] = ZeroArray<double>(state_.nodes.size());
    if (entrainment.active()) {
        set_erodible_beds(entrainment, zones, state_.nodes, state_.erodible_beds);
        state_.nodes.bed_changes = true;
    }
    add_particles(released);
    record_present();
}

void FiniteVolumeFlow::add_particles(const ParticleSet& particles) {
    if (particles.size() == 0) return;
    std::vector<std::int64_t> tiles = state_.wet;
    const NodeScale scale = state_.nodes.scale();
    const double *const x = particles[Field::x], *const y = particles[Field::y], *const u = particles[Field::u],
                        *const v = particles[Field::v], *const volume = particles[Field::volume];
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!state_.nodes.bounds().contains(x[p], y[p])) {
            state_.volume_left += volume[p];
            continue;
        }
        PorePressure::State pores = laws_.friction.pore_pressure.initial;
        if (particles.mask().has(Field::pore_pressure)) pores.ratio = particles[Field::pore_pressure][p];
        tiles.push_back(finite_volume::add_to_cell(state_, laws_, whole_below(x[p] * scale.inverse_dx) + scale.origin_x,
                                                   whole_below(y[p] * scale.inverse_dx) + scale.origin_y,
                                                   volume[p] / state_.cell_area(), {u[p], v[p]}, pores));
    }
    finite_volume::settle(state_, laws_, std::move(tiles));
}

void FiniteVolumeFlow::lower_bed(const Raster& depth) {
    state_.nodes.lower_bed(depth);
    finite_volume::renew_ground(state_, laws_);
    finite_volume::settle(state_, laws_, state_.wet);
}

// Adds half of the energies of the present state: those of a step are in its middle, as those of the particles.
void FiniteVolumeFlow::add_half_of_energies(StepStatistics& f) const {
    finite_volume::TileRecord sum{};
    for (const std::int64_t tile : state_.wet) {
        const finite_volume::TileRecord& r = state_.records[static_cast<std::size_t>(tile)];
        sum.depth += r.depth;
        sum.kinetic += r.kinetic;
        sum.energy += r.energy;
        sum.levelled += r.levelled;
        sum.sloping += r.sloping;
    }
    const double half = 0.5 * state_.cell_area();
    f.energy_volume += half * sum.depth;
    f.energy_moving += half * sum.kinetic;
    f.energy += half * sum.energy;
    f.energy_levelled += half * sum.levelled;
    f.energy_sloping += half * sum.sloping;
    f.kinetic = 2 * half * sum.kinetic;
}

StepStatistics FiniteVolumeFlow::step(double dt_limit) {
    StepStatistics f;
    f.energy = 0;
    add_half_of_energies(f);
    const finite_volume::StepReport report = finite_volume::step(state_, laws_, dt_limit, &maxima_, pool_);
    add_half_of_energies(f);
    f.energy_dissipated = report.dissipated;
    f.dt = report.dt;
    f.max_speed = f.fastest = report.max_speed;
    f.moving = report.moving;
    f.unsupported = report.unsupported;
    f.non_finite = report.not_finite;
    f.no_data = report.no_data;
    for (const std::int64_t tile : state_.wet) {
        const finite_volume::TileRecord& r = state_.records[static_cast<std::size_t>(tile)];
        f.volume += r.depth * state_.cell_area();
        f.thin_fraction += r.thin * state_.cell_area();
        f.covered += r.covered;
        f.max_depth = std::max(f.max_depth, r.deepest);
    }
    f.thin_fraction = f.volume > 0 ? f.thin_fraction / f.volume : 0;
    f.front_distance = farthest_front();
    return f;
}

// Tiles in order of how far they can be: most are not looked at.
double FiniteVolumeFlow::farthest_front() const {
    struct Far {
        double most;
        std::int64_t tile;
    };
    std::vector<Far> tiles;
    const double half_diagonal = std::sqrt(0.5) * static_cast<double>(k_tile) * grid_.cell_size;
    for (const std::int64_t tile : state_.wet) {
        if (state_.records[static_cast<std::size_t>(tile)].covered == 0) continue;
        const NodeRange range(tile, state_.tiles, state_.nodes);
        const Point a = state_.nodes.middle(range.i0, range.j0), b = state_.nodes.middle(range.i1 - 1, range.j1 - 1);
        tiles.push_back(
            {std::sqrt(origins_.squared_distance({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)})) + half_diagonal, tile});
    }
    std::sort(tiles.begin(), tiles.end(), [](const Far& a, const Far& b) { return a.most > b.most; });
    double farthest = 0;
    for (const Far& far : tiles) {
        if (far.most * far.most < farthest) break;
        NodeRange(far.tile, state_.tiles, state_.nodes)
            .for_each(state_.nodes.stride(), [&](std::size_t k, std::int64_t i, std::int64_t j) {
                if (state_.depth[k] >= laws_.values.minimum_depth)
                    farthest = std::max(farthest, origins_.squared_distance(state_.nodes.middle(i, j)));
            });
    }
    return std::sqrt(farthest);
}

void FiniteVolumeFlow::advance_to(double time) {
    while (state_.time < time) {
        const double left = time - state_.time;
        step(left);
        if (time - state_.time < 1e-12 * time) state_.time = time;
    }
}

void FiniteVolumeFlow::record_present() {
    for (const std::int64_t tile : state_.wet)
        for_each_node_of(tile, [&](std::size_t k) {
            if (state_.depth[k] >= laws_.values.minimum_depth)
                maxima_.update<double>(k, 1, true, state_.depth[k], motion_of(k).speed, state_.time);
        });
}

double FiniteVolumeFlow::volume() const {
    double depth = 0;
    for (const std::int64_t tile : state_.wet) depth += state_.records[static_cast<std::size_t>(tile)].depth;
    return depth * state_.cell_area();
}

std::size_t FiniteVolumeFlow::bytes_per_node() const noexcept {
    constexpr std::size_t k_arrays = 21;  // the bed, Edges and those of finite_volume::State
    return (k_arrays + (state_.carried[0].size() != 0) + (state_.carried[1].size() != 0)) * sizeof(double) +
           Maxima::k_bytes + (laws_.friction.summed ? sizeof(BedState) + sizeof(NodeRecord) : 0) +
           (state_.erodible_beds.size() != 0 ? sizeof(ErodibleBed) : 0);
}

std::optional<Point> FiniteVolumeFlow::cell_with(RunProblem::Kind kind) const {
    std::optional<Point> found;
    for_each_active_node([&](std::size_t k) {
        const bool here = kind == RunProblem::Kind::no_data
                              ? state_.depth[k] > 0 && state_.nodes.is_gap(k)
                              : !std::isfinite(state_.depth[k] + state_.qx[k] + state_.qy[k]);
        const auto index = static_cast<std::int64_t>(k), stride = state_.nodes.stride();
        if (here && !found) found = state_.nodes.middle(index % stride, index / stride);
    });
    return found;
}

void FiniteVolumeFlow::states(std::span<const std::size_t> nodes, NodeState* states) const {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const double depth = state_.depth[nodes[n]];
        const finite_volume::CellMotion motion = motion_of(nodes[n]);
        states[n] = {depth, depth, motion.u, motion.v, motion.speed, depth * motion.u, depth * motion.v};
    }
}

Model::Snapshot FiniteVolumeFlow::snapshot() {
    const double least = laws_.values.minimum_depth;
    return {raster_of([&](std::size_t k) { return state_.depth[k] >= least ? state_.depth[k] : k_no_data; }),
            raster_of([&](std::size_t k) { return state_.depth[k] >= least ? motion_of(k).speed : k_no_data; })};
}

std::vector<NamedRaster> FiniteVolumeFlow::plane_stress(const Raster& depth, PointTable&) {
    return plane_stress_rasters(laws_.stress, density(), laws_.values.gravity, depth,
                                raster_of([&](std::size_t k) { return motion_of(k).u; }),
                                raster_of([&](std::size_t k) { return motion_of(k).v; }));
}

void FiniteVolumeFlow::add_to(RunResult& result) const {
    if (state_.erodible_beds.size() != 0) add_exchange(state_.erodible_beds, state_.exchanged, result);
    const JumpStatistics& jumps = state_.jumps;
    if (jumps.volume > 0)
        warn_of_jumps({jumps.volume, jumps.highest, jumps.longest, jumps.way / jumps.volume,
                       grid_.map_from_local(jumps.from), grid_.map_from_local(jumps.to)},
                      result);
}

}  // namespace frana
