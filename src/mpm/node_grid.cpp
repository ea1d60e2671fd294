// SPDX-License-Identifier: Apache-2.0
#include "mpm/node_grid.h"

#include <algorithm>
#include <cmath>

namespace frana {
namespace {

// Cells without terrain still lie in the stencils of their neighbours: they take the mean of the neighbours
// that have an elevation, ring by ring, twice. Nothing farther away is ever read.
void extend_into_gaps(std::vector<double>& bed, std::int64_t stride, std::int64_t rows) {
    for (int ring = 0; ring < 2; ++ring) {
        const std::vector<double> before = bed;
        for (std::int64_t j = 0; j < rows; ++j) {
            for (std::int64_t i = 0; i < stride; ++i) {
                const auto here = static_cast<std::size_t>(j * stride + i);
                if (!std::isnan(before[here])) continue;
                double sum = 0;
                int n = 0;
                for (std::int64_t b = std::max<std::int64_t>(j - 1, 0); b <= std::min(j + 1, rows - 1); ++b) {
                    for (std::int64_t a = std::max<std::int64_t>(i - 1, 0); a <= std::min(i + 1, stride - 1); ++a) {
                        const double z = before[static_cast<std::size_t>(b * stride + a)];
                        if (std::isnan(z)) continue;
                        sum += z;
                        ++n;
                    }
                }
                if (n > 0) bed[here] = sum / n;
            }
        }
    }
    for (double& z : bed) {
        if (std::isnan(z)) z = 0;
    }
}

}  // namespace

Ground::Ground(const Raster& bed) : terrain(bed), datum(std::numeric_limits<double>::infinity()) {
    for (const double z : bed.values) {
        if (!std::isnan(z)) datum = std::min(datum, z);
    }
    if (!std::isfinite(datum)) datum = 0;
}

NodeGrid::NodeGrid(const Ground& ground)
    // One element more than nodes: the fast kernels read rows of three nodes four at a time.
    : bed(static_cast<std::size_t>(
          (ground.terrain.grid.columns + 2 * k_ghost) * (ground.terrain.grid.rows + 2 * k_ghost) + 1)),
      columns_(ground.terrain.grid.columns),
      rows_(ground.terrain.grid.rows),
      origin_column_(ground.terrain.grid.origin_column),
      origin_row_(ground.terrain.grid.origin_row),
      cell_size_(ground.terrain.grid.cell_size),
      datum_(ground.datum),
      bounds_(ground.terrain.grid.local_bounds()) {
    const Raster& terrain = ground.terrain;
    const bool gaps = std::any_of(terrain.values.begin(), terrain.values.end(), [](double z) { return std::isnan(z); });
    if (gaps) solid_.assign(bed.size(), 0);
    for (std::int64_t j = 0; j < rows_; ++j) {
        for (std::int64_t i = 0; i < columns_; ++i) {
            const double z = terrain.at(rows_ - 1 - j, i);
            bed[index(i, j)] = z - datum_;
            if (std::isnan(z)) solid_[index(i, j)] = k_gap;
        }
    }
    extend_beyond_edges();
    if (gaps) extend_into_gaps(bed, stride(), padded_rows());
    records = ZeroArray<NodeRecord>(bed.size());
}

// Beyond the edge the terrain goes on with the slope it has there.
void NodeGrid::extend_beyond_edges() {
    const auto extrapolate = [&](std::size_t ghost, std::size_t edge, std::size_t inner, double steps) {
        const double slope = std::isnan(bed[inner]) ? 0 : bed[edge] - bed[inner];
        bed[ghost] = bed[edge] + steps * slope;
    };
    const std::int64_t in_x = std::min<std::int64_t>(1, columns_ - 1), in_y = std::min<std::int64_t>(1, rows_ - 1);
    for (std::int64_t j = 0; j < rows_; ++j) {
        for (std::int64_t k = 1; k <= k_ghost; ++k) {
            const auto steps = static_cast<double>(k);
            extrapolate(index(-k, j), index(0, j), index(in_x, j), steps);
            extrapolate(index(columns_ - 1 + k, j), index(columns_ - 1, j), index(columns_ - 1 - in_x, j), steps);
        }
    }
    for (std::int64_t i = -k_ghost; i < columns_ + k_ghost; ++i) {
        for (std::int64_t k = 1; k <= k_ghost; ++k) {
            const auto steps = static_cast<double>(k);
            extrapolate(index(i, -k), index(i, 0), index(i, in_y), steps);
            extrapolate(index(i, rows_ - 1 + k), index(i, rows_ - 1), index(i, rows_ - 1 - in_y), steps);
        }
    }
}

void NodeGrid::mark_walls(const Raster& walls) {
    if (solid_.empty()) solid_.assign(bed.size(), 0);
    for (std::int64_t j = 0; j < rows_; ++j) {
        for (std::int64_t i = 0; i < columns_; ++i) {
            if (walls.at(rows_ - 1 - j, i) == 1) solid_[index(i, j)] = k_wall;
        }
    }
}

void NodeGrid::lower_bed(const Raster& depth) {
    bed_changes = true;
    for (std::int64_t j = 0; j < rows_; ++j) {
        for (std::int64_t i = 0; i < columns_; ++i) {
            const double d = depth.at(rows_ - 1 - j, i);
            if (!std::isnan(d)) bed[index(i, j)] -= d;
        }
    }
    extend_beyond_edges();
}

}  // namespace frana
