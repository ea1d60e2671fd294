// SPDX-License-Identifier: Apache-2.0
#include "bench/set_up/setup.h"

#include <algorithm>
#include <cmath>

#include "mpm/boundary.h"
#include "mpm/shape.h"
#include "physics/friction_coulomb.h"
#include "physics/friction_turbulence.h"
#include "physics/stress_bingham.h"
#include "simulation/finite_volume_flow.h"
#include "simulation/structured_flow.h"

namespace frana::bench {
namespace {

// SplitMix64 (Steele, Lea, Flood 2014): returns a number in [-1/2, 1/2).
double next_centred(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1p-53 - 0.5;
}

}  // namespace

GridSpec plain_grid(std::int64_t columns, std::int64_t rows, double cell_size) {
    GridSpec grid;
    grid.cell_size = cell_size;
    grid.columns = columns;
    grid.rows = rows;
    grid.north = cell_size * static_cast<double>(rows);
    return grid;
}

Raster sample_raster(const GridSpec& grid, const std::function<double(Point)>& z) {
    Raster raster(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            raster.at(row, column) = z(grid.local_from_map(grid.cell_centre(row, column)));
        }
    }
    return raster;
}

ParticleSet fill_lattice(const GridSpec& grid, int per_side, double jitter, const std::function<Seed(Point)>& state) {
    const double spacing = grid.cell_size / per_side;
    ParticleSet particles;
    std::uint64_t random = 2024;
    for (std::int64_t j = 0; j < grid.rows * per_side; ++j) {
        for (std::int64_t i = 0; i < grid.columns * per_side; ++i) {
            Point place{(static_cast<double>(i) + 0.5) * spacing, (static_cast<double>(j) + 0.5) * spacing};
            if (jitter > 0) {
                place.x += jitter * spacing * next_centred(random);
                place.y += jitter * spacing * next_centred(random);
            }
            const Seed seed = state(place);
            if (!(seed.depth > 0)) continue;
            ParticleRow particle = ParticleSet::initial_row();
            get(particle, Field::x) = place.x;
            get(particle, Field::y) = place.y;
            get(particle, Field::u) = seed.u;
            get(particle, Field::v) = seed.v;
            get(particle, Field::area) = spacing * spacing;
            get(particle, Field::volume) = seed.depth * spacing * spacing;
            particles.push_back(particle);
        }
    }
    return particles;
}

namespace {

template <class Shape>
double interpolated(const NodeGrid& nodes, Point local) {
    const Stencil<Shape> stencil(local.x, local.y, nodes.scale());
    return interpolate(stencil, nodes.bed.data(), nodes.stride()).value + nodes.datum();
}

}  // namespace

Material water() {
    Material material;
    material.density = 1000;
    material.of<CoulombFriction>().friction_coefficient = 0;
    return material;
}

Material dry_friction(double angle_deg) {
    Material material = water();
    material.of<CoulombFriction>().friction_coefficient = std::tan(angle_deg * k_degree);
    return material;
}

Material voellmy(double angle_deg, double turbulence) {
    Material material = dry_friction(angle_deg);
    material.of<TurbulentFriction>().turbulence = turbulence;
    return material;
}

void set_bingham(Material& material, double viscosity, double yield_stress) {
    material.of<BinghamStress>().viscosity = viscosity;
    material.of<BinghamStress>().yield_stress = yield_stress;
}

Numerics numerics_of(Scheme scheme, SlopeCorrection slope, Boundary boundary) {
    Numerics numerics;
    numerics.scheme = scheme;
    numerics.slope_correction = scheme == Scheme::paper ? SlopeCorrection::none : slope;
    numerics.boundary = boundary;
    numerics.gravity = k_gravity;
    return numerics;
}

const char* name_of(Scheme scheme) {
    return std::find_if(std::begin(frana::k_schemes), std::end(frana::k_schemes),
                        [&](const auto& row) { return row.second == scheme; })
        ->first;
}

SchemeBed::SchemeBed(const Raster& bed, Scheme scheme, Boundary boundary) : nodes_(bed), scheme_(scheme) {
    if (boundary == Boundary::wall) mirror_bed(nodes_);
}

double SchemeBed::operator()(Point local) const {
    if (scheme_ == Scheme::finite_volume)  // one elevation in a cell
        return nodes_.bed[nodes_.scale().node_of(local.x, local.y)] + nodes_.datum();
    return scheme_ == Scheme::paper ? interpolated<HatShape>(nodes_, local)
                                    : interpolated<QuadraticSplineShape>(nodes_, local);
}

template <class Work>
void TimedFlow::time(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    const double cpu = frana::cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
    work();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    cpu_seconds_ += frana::cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
}

TimedFlow::TimedFlow(const Setup& s, int threads) {
    time([&] {
        if (s.structured) {
            model_ = std::make_unique<StructuredFlow>(s.bed, std::nullopt, *s.structured, s.numerics, s.seeds, threads);
        } else if (s.numerics.scheme == Scheme::finite_volume) {
            model_ = std::make_unique<FiniteVolumeFlow>(s.bed, std::nullopt, s.seeds, s.material, s.numerics, threads,
                                                        s.zones, s.entrainment, s.tilt);
        } else {
            auto flow =
                std::make_unique<Flow>(s.bed, s.seeds, s.material, s.numerics, threads, s.tilt, s.zones, s.entrainment);
            flow_ = flow.get();
            model_ = std::move(flow);
        }
    });
    peak_ = model_->particle_count();
}

void TimedFlow::advance_to(double end, const std::function<void(const StepStatistics&)>& after_step) {
    Model& model = *model_;
    // A last step shorter than this would only be rounding.
    while (model.time() < end * (1 - 1e-12) && non_finite_ == 0 && !model.empty()) {
        const double before = model.time();
        StepStatistics step;
        time([&] { step = model.step(end - before); });
        non_finite_ += step.non_finite;
        peak_ = std::max(peak_, model.particle_count());
        if (!(model.time() > before))
            ++non_finite_;  // a step that does not advance time results from a non-finite
                            // value
        if (after_step) after_step(step);
    }
    model.synchronise();
}

Flow::NodalFields TimedFlow::fields() {
    if (flow_ != nullptr) return flow_->nodal_fields();
    const GridSpec& grid = model_->grid();
    Flow::NodalFields fields{Raster(grid, 0), Raster(grid, 0), Raster(grid, 0)};
    const NodeGrid& nodes = model_->nodes();
    model_->for_each_active_state([&](std::size_t k, const NodeState& state) {
        const auto node = static_cast<std::int64_t>(k);
        const Cell cell = cell_of(grid, nodes.middle(node % nodes.stride(), node / nodes.stride()));
        fields.depth.at(cell.row, cell.column) = state.volume_depth;
        fields.momentum_x.at(cell.row, cell.column) = state.moved_x;
        fields.momentum_y.at(cell.row, cell.column) = state.moved_y;
    });
    return fields;
}

const ParticleSet& TimedFlow::particles() {
    if (flow_ != nullptr) return flow_->particles();
    cells_ = ParticleSet();
    const NodeGrid& nodes = model_->nodes();
    const double area = model_->grid().cell_area();
    model_->for_each_active_state([&](std::size_t k, const NodeState& state) {
        if (!(state.volume_depth > 0)) return;
        const auto node = static_cast<std::int64_t>(k);
        const Point middle = nodes.middle(node % nodes.stride(), node / nodes.stride());
        ParticleRow row = ParticleSet::initial_row();
        get(row, Field::x) = middle.x;
        get(row, Field::y) = middle.y;
        get(row, Field::u) = state.u;
        get(row, Field::v) = state.v;
        get(row, Field::area) = area;
        get(row, Field::volume) = state.volume_depth * area;
        cells_.push_back(row);
    });
    return cells_;
}

Point TimedFlow::velocity(std::size_t particle) const {
    return flow_ != nullptr ? flow_->map_velocity(particle)
                            : Point{cells_[Field::u][particle], cells_[Field::v][particle]};
}

}  // namespace frana::bench
