// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/fluid_run.h"

#include <chrono>

namespace frana::bench {
namespace {

structured::FluidLaws plain_laws(double dry_depth) {
    structured::FluidLaws laws;
    laws.gravity = k_gravity;
    laws.dry = dry_depth;
    laws.steep = false;
    laws.wall = true;
    return laws;
}

}  // namespace

FluidRun::FluidRun(const Raster& bed, double dry_depth, const std::function<ExactState(Point)>& at)
    : grid_(bed.grid), nodes_(bed), laws_(plain_laws(dry_depth)), state_(nodes_, laws_) {
    std::vector<structured::FluidSource> sources;
    for (std::int64_t j = 0; j < nodes_.rows(); ++j) {
        for (std::int64_t i = 0; i < nodes_.columns(); ++i) {
            const ExactState s = at(
                {(static_cast<double>(i) + 0.5) * grid_.cell_size, (static_cast<double>(j) + 0.5) * grid_.cell_size});
            if (s.depth > 0) sources.push_back({nodes_.index(i, j), s.depth, s.qx, s.qy});
        }
    }
    structured::receive(sources, state_, nodes_, laws_);
}

void FluidRun::advance(double time) {
    const auto begin = std::chrono::steady_clock::now();
    const structured::FluidReport report = structured::advance(state_, nodes_, laws_, {}, time, pool_);
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    steps_ += report.steps;
    non_finite_ += report.non_finite;
}

Flow::NodalFields FluidRun::fields() const {
    Flow::NodalFields fields{Raster(grid_), Raster(grid_), Raster(grid_)};
    for (std::int64_t row = 0; row < grid_.rows; ++row) {
        for (std::int64_t column = 0; column < grid_.columns; ++column) {
            const std::size_t cell = nodes_.index(column, grid_.rows - 1 - row);
            fields.depth.at(row, column) = state_.now.depth[cell];
            fields.momentum_x.at(row, column) = state_.now.qx[cell];
            fields.momentum_y.at(row, column) = state_.now.qy[cell];
        }
    }
    return fields;
}

CaseStatistics FluidRun::compare(const std::function<ExactState(Point)>& exact,
                                 const std::function<bool(Point)>& inside) const {
    CaseStatistics statistics = compare_fields(fields(), exact, inside);
    statistics.particles = grid_.cell_count();
    statistics.steps = steps_;
    statistics.wall_seconds = seconds_;
    if (non_finite_ > 0) statistics.error = "values became non-finite";
    return statistics;
}

}  // namespace frana::bench
