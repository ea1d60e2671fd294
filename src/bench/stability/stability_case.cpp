// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/stability_case.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/run_check.h"

namespace frana::bench {
namespace {

constexpr double k_heap_radius = 15, k_heap_deep = 3;
constexpr Point k_heap_middle{30, 40};

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

}  // namespace

Soundness watch(TimedFlow& run, const Setup& setup, double end) {
    Soundness s;
    const double volume = run.flow().volume();
    double fastest = 0;
    for (std::size_t p = 0; p < setup.seeds.size(); ++p)
        fastest = std::max(fastest, std::hypot(setup.seeds[Field::u][p], setup.seeds[Field::v][p]));
    const double limit = speed_limit(setup, fastest);
    run.advance_to(end, [&](const voellmy_bingham::StepReport& report) {
        s.speed_ratio = std::max({s.speed_ratio, report.particles.speed / limit, report.nodes.max_speed / limit});
        s.volume_error =
            std::max(s.volume_error, std::abs(run.flow().volume() + run.flow().volume_left() - volume) / volume);
        s.clamped += report.particles.clamped;
    });
    s.non_finite = run.non_finite() + count_non_finite(run.flow().particles());
    s.particles = run.peak_particles();
    s.steps = run.flow().steps();
    s.wall_seconds = run.seconds();
    return s;
}

void DepthAgreement::compare(TimedFlow& run) {
    const Raster depth = run.flow().nodal_fields().depth;
    if (!first_) first_ = depth;
    for (std::size_t c = 0; c < depth.values.size(); ++c)
        greatest_ = std::max(greatest_, std::abs(depth.values[c] - first_->values[c]));
}

void merge(Soundness& into, const Soundness& other) {
    into.non_finite += other.non_finite;
    into.volume_error = std::max(into.volume_error, other.volume_error);
    into.speed_ratio = std::max(into.speed_ratio, other.speed_ratio);
    into.clamped += other.clamped;
    into.particles = std::max(into.particles, other.particles);
    into.steps += other.steps;
    into.wall_seconds += other.wall_seconds;
}

double usual_slope(Point place) {
    return place.x < 80 ? 0.5 * (80 - place.x) : 0;
}

double usual_cap(Point place) {
    const double x = place.x - k_heap_middle.x, y = place.y - k_heap_middle.y;
    return k_heap_deep * (1 - (x * x + y * y) / (k_heap_radius * k_heap_radius));
}

Setup usual_slide_on(double cell_size, const std::function<double(Point)>& bed) {
    Setup setup;
    setup.bed = sample_raster(plain_grid(std::llround(160 / cell_size), std::llround(80 / cell_size), cell_size), bed);
    setup.seeds = fill_lattice(setup.bed.grid, 2, 0, [](Point p) { return Seed{usual_cap(p)}; });
    setup.material = dry_friction(15);
    setup.material.density = 2000;
    setup.material.turbulence = 500;
    setup.numerics = numerics_of(Scheme::standard, SlopeCorrection::normal, Boundary::open);
    return setup;
}

Setup usual_slide() {
    return usual_slide_on(2, usual_slope);
}

}  // namespace frana::bench
