// SPDX-License-Identifier: Apache-2.0
#include "simulation/flow.h"

#include <cmath>
#include <limits>

#include "mpm/stable_step.h"
#include "simulation/dispatch.h"
#include "simulation/dispatch_bed.h"

namespace frana {
namespace {

ParticleSet with_fields(const ParticleSet& seeds, FieldMask fields) {
    ParticleSet particles(fields);
    particles.resize(seeds.size());
    for (std::size_t p = 0; p < seeds.size(); ++p) {
        ParticleRow row = seeds.row(p);
        if (!seeds.mask().has(Field::q_xx))
            get(row, Field::q_xx) = get(row, Field::q_yy) = get(row, Field::area);
        particles.set_row(p, row);
    }
    return particles;
}

TileGrid tile_grid(const NodeGrid& nodes) {
    return {nodes.columns(), nodes.rows(), k_ghost, nodes.cell_size()};
}

voellmy_bingham::State initial_state(const Raster& bed, ParticleSet particles) {
    NodeGrid nodes(bed);
    TileOrder order(tile_grid(nodes));
    return voellmy_bingham::State(std::move(particles), std::move(nodes), std::move(order));
}

ZeroArray<BedLayer> bed_layers(const Entrainment& entrainment, const MaterialZones& zones,
                               const NodeGrid& nodes) {
    ZeroArray<BedLayer> layers(nodes.bed.size());
    if (entrainment.erosion == ErosionLaw::none) return layers;
    std::vector<double> depths;
    if (zones.erodible_depth) depths = node_values(*zones.erodible_depth, entrainment.erodible_depth, nodes);
    for (std::size_t i = 0; i < layers.size(); ++i)
        layers[i].erodible = depths.empty() ? entrainment.erodible_depth : depths[i];
    return layers;
}

}  // namespace

Flow::Flow(const Raster& bed, const ParticleSet& particles, const Material& material,
           const Numerics& numerics, int threads, std::optional<TiltedGravity> tilt,
           const MaterialZones& zones, const Entrainment& entrainment)
    : grid_(bed.grid),
      numerics_(numerics),
      pool_(threads),
      stages_(choose_stages(material, zones, entrainment, numerics)),
      state_(initial_state(bed, with_fields(particles, stages_.fields))),
      laws_(make_laws(material, zones, entrainment, numerics, state_.nodes,
                      tilt ? tilt->normal : numerics.gravity)),
      maxima_(state_.nodes.sums.size()) {
    // Without references the levels stay zero: the pressure is then measured against nothing.
    if (numerics.scheme == Scheme::standard) state_.nodes.allocate_levels();
    laws_.resample.width = state_.nodes.width();
    laws_.resample.height = state_.nodes.height();
    laws_.resample.minimum_depth = 1e-3 * bed.grid.cell_size;
    if (laws_.friction.summed) state_.bed_states = ZeroArray<BedState>(state_.nodes.sums.size());
    if (entrainment.active()) state_.bed_layers = bed_layers(entrainment, zones, state_.nodes);
    if (tilt) {
        laws_.gravity_x = tilt->along_x;
        laws_.gravity_y = tilt->along_y;
    }
    laws_.origin = centroid();
    voellmy_bingham::prepare(state_, laws_, pool_);
}

voellmy_bingham::StepReport Flow::advance(double dt_limit) {
    particle_steps_ += static_cast<std::int64_t>(state_.particles.size());
    ++steps_;
    return voellmy_bingham::step(state_, laws_, stages_, dt_limit, maxima_, pool_);
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

double Flow::volume() const {
    double sum = 0;
    const double* v = state_.particles[Field::volume];
    for (std::size_t p = 0; p < state_.particles.size(); ++p) sum += v[p];
    return sum;
}

Point Flow::centroid() const {
    Point sum;
    const ParticleSet& particles = state_.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        sum.x += particles[Field::volume][p] * particles[Field::x][p];
        sum.y += particles[Field::volume][p] * particles[Field::y][p];
    }
    const double total = volume();
    return total > 0 ? Point{sum.x / total, sum.y / total} : sum;
}

double Flow::stable_step() const {
    return frana::stable_step(grid_.cell_size, laws_.cfl, state_.wave_speed, laws_.gravity,
                              state_.diffusivity);
}

Flow::NodalFields Flow::nodal_fields() {
    gather_on_nodes(state_, laws_, stages_, pool_);
    NodalFields fields{Raster(grid_), Raster(grid_), Raster(grid_)};
    const double inverse_area = 1 / grid_.cell_area();
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const std::size_t node = state_.nodes.index(column, grid_.rows - 1 - row);
            const NodeSums& s = state_.nodes.sums[node];
            if (!(s.mass > 0)) continue;
            const double support = stages_.references ? state_.nodes.levels[node].support : 0;
            const double depth = shown_depth(s.mass, s.area, support, inverse_area);
            fields.depth.at(row, column) = depth;
            fields.momentum_x.at(row, column) = depth * s.px / s.mass;
            fields.momentum_y.at(row, column) = depth * s.py / s.mass;
        }
    }
    return fields;
}

Flow::Snapshot Flow::snapshot() {
    const NodalFields fields = nodal_fields();
    Snapshot shot{Raster(grid_, k_no_data), Raster(grid_, k_no_data)};
    const std::vector<double>& bed = state_.nodes.bed;
    const bool metric = numerics_.slope_correction != SlopeCorrection::none;
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const std::size_t c = shot.depth.index(row, column);
            const double depth = fields.depth.values[c];
            if (depth < laws_.minimum_depth) continue;
            const double u = fields.momentum_x.values[c] / depth, v = fields.momentum_y.values[c] / depth;
            double climb = 0;
            if (metric) {
                const std::int64_t j = grid_.rows - 1 - row;
                const NodeGrid& n = state_.nodes;
                climb = (u * (bed[n.index(column + 1, j)] - bed[n.index(column - 1, j)]) +
                         v * (bed[n.index(column, j + 1)] - bed[n.index(column, j - 1)])) /
                        (2 * grid_.cell_size);
            }
            shot.depth.values[c] = depth;
            shot.speed.values[c] = std::sqrt(u * u + v * v + climb * climb);
        }
    }
    return shot;
}

void Flow::see_present() {
    const Snapshot shot = snapshot();
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const double depth = shot.depth.at(row, column);
            if (std::isnan(depth)) continue;
            maxima_.see(state_.nodes.index(column, grid_.rows - 1 - row), depth, shot.speed.at(row, column),
                        state_.time);
        }
    }
}

Raster Flow::layer_depth(double BedLayer::*depth) const {
    Raster raster(grid_, k_no_data);
    if (state_.bed_layers.size() == 0) return raster;
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const double value = state_.bed_layers[state_.nodes.index(column, grid_.rows - 1 - row)].*depth;
            if (value > 0) raster.at(row, column) = value;
        }
    }
    return raster;
}

Raster Flow::eroded_depth() const {
    return layer_depth(&BedLayer::eroded);
}

Raster Flow::deposited_depth() const {
    return layer_depth(&BedLayer::deposited);
}

Raster Flow::to_raster(const ZeroArray<double>& padded, double shift) const {
    Raster raster(grid_, k_no_data);
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const double value = padded[state_.nodes.index(column, grid_.rows - 1 - row)];
            if (value != 0) raster.at(row, column) = value - shift;
        }
    }
    return raster;
}

}  // namespace frana
