// SPDX-License-Identifier: Apache-2.0
#include "bench/set_up/setup.h"

#include <algorithm>
#include <cmath>

#include "mpm/boundary.h"
#include "mpm/shape.h"

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
    material.friction_coefficient = 0;
    return material;
}

Material dry_friction(double angle_deg) {
    Material material = water();
    material.friction_coefficient = std::tan(angle_deg * k_degree);
    return material;
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
    return scheme == Scheme::paper ? "paper" : "default";
}

SchemeBed::SchemeBed(const Raster& bed, Scheme scheme, Boundary boundary)
    : nodes_(bed), hats_(scheme == Scheme::paper) {
    if (boundary == Boundary::wall) mirror_bed(nodes_);
}

double SchemeBed::operator()(Point local) const {
    return hats_ ? interpolated<HatShape>(nodes_, local) : interpolated<QuadraticSplineShape>(nodes_, local);
}

TimedFlow::TimedFlow(const Setup& setup, int threads) {
    const auto begin = std::chrono::steady_clock::now();
    flow_.emplace(setup.bed, setup.seeds, setup.material, setup.numerics, threads, setup.tilt);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    peak_ = static_cast<std::int64_t>(flow_->particles().size());
}

void TimedFlow::advance_to(double end, const std::function<void(const voellmy_bingham::StepReport&)>& after_step) {
    // A last step shorter than this would only be rounding.
    while (flow_->time() < end * (1 - 1e-12) && non_finite_ == 0 && !flow_->empty()) {
        const double before = flow_->time();
        const auto begin = std::chrono::steady_clock::now();
        const voellmy_bingham::StepReport report = flow_->advance(end - before);
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        peak_ = std::max(peak_, static_cast<std::int64_t>(flow_->particles().size()));
        non_finite_ += report.particles.non_finite;
        if (!(flow_->time() > before))
            ++non_finite_;  // a step that does not advance time results from a non-finite
                            // value
        if (after_step) after_step(report);
    }
    flow_->synchronise();
}

}  // namespace frana::bench
