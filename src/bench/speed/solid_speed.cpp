// SPDX-License-Identifier: Apache-2.0
#include "bench/speed/solid_speed.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>

#include "bench/set_up/solid_block.h"

namespace frana::bench {
namespace {

SolidBlock wet_block(double particles) {
    SolidBlock block(3);
    block.material.solid_fraction = 0.5;
    block.material.grain_density = 2400;
    block.material.cohesion = 2e4;
    block.material.bed_friction = std::tan(12 * M_PI / 180);
    block.laws.solid.elastic = structured::Elasticity::from_young_and_bulk(12e6, 23e6);
    const std::int64_t side = std::llround(std::sqrt(particles));
    block.fill(60, 60, side, side, [](Point) { return Seed{8, 5, 0}; });
    return block;
}

Raster uneven_slope(double particles) {
    const auto side = static_cast<std::int64_t>(std::sqrt(particles) / 3);
    const GridSpec grid = plain_grid(side + 80, side + 40, 3);
    return sample_raster(
        grid, [&](Point p) { return 0.4 * (grid.east() - p.x) + 2 * std::sin(0.02 * p.x) * std::sin(0.03 * p.y); });
}

}  // namespace

std::vector<SpeedRow> measure_solids(double particles, int threads, int steps) {
    std::vector<SpeedRow> rows;
    std::optional<structured::State> first;
    for (const int n : std::set<int>{1, threads}) {
        ThreadPool pool(n);
        SolidBlock block = wet_block(particles);
        structured::State state = block.start(uneven_slope(particles), pool, true);
        structured::step(state, block.laws, 1e9, pool);  // warm
        const auto begin = std::chrono::steady_clock::now();
        SpeedRow row;
        for (int i = 0; i < steps; ++i) row.steps += structured::step(state, block.laws, 1e9, pool).substeps;
        row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        row.case_name = "solids";
        row.particles = static_cast<std::int64_t>(state.solid->particles.size());
        row.threads = n;
        row.particle_steps_per_second = static_cast<double>(row.steps * row.particles) / row.seconds;
        row.bytes_per_particle = static_cast<double>(state.solid->particles.bytes_per_particle() +
                                                     structured::PairWork::count * sizeof(double));
        const ZeroArray<double>& depth = state.solid->nodes.depth;
        row.same_bits =
            !first || std::memcmp(first->solid->nodes.depth.data(), depth.data(), depth.size() * sizeof(double)) == 0;
        if (!first) first = std::move(state);
        rows.push_back(row);
    }
    return rows;
}

}  // namespace frana::bench
