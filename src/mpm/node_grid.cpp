// SPDX-License-Identifier: Apache-2.0
#include "mpm/node_grid.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

#include "core/error.h"

namespace frana {

/// Bed elevations of a block of nodes, side by side.
struct NodeGrid::Beds {
    double* values;
    std::int64_t stride;
    Block region;

    [[nodiscard]] double& at(std::int64_t i, std::int64_t j) const {
        return values[(j - region.j0) * stride + i - region.i0];
    }
    [[nodiscard]] bool contains(std::int64_t i, std::int64_t j) const {
        return i >= region.i0 && i < region.i1 && j >= region.j0 && j < region.j1;
    }
};

/// Terrain that is read on demand, in square blocks.
struct NodeGrid::Demand {
    static constexpr std::int64_t k_side = CellValues::k_side;  // [nodes]

    const Raster& terrain;
    double* bed;
    std::uint8_t* solid;
    std::int64_t across, down;
    std::vector<std::uint8_t> covered{};  // by block
    bool mirrors = false;
    double lowest = std::numeric_limits<double>::infinity();
    std::vector<std::function<void(const Block&)>> fills{};
    std::exception_ptr failure{};
    std::mutex taking{};

    [[nodiscard]] std::uint8_t& is_covered(std::int64_t a, std::int64_t b) {
        return covered[static_cast<std::size_t>(b * across + a)];
    }
};

namespace {

// A node's bed depends on terrain at most this many nodes away: two rings into a gap, and the slope beyond an edge.
constexpr std::int64_t k_margin = 4;

// Cells without terrain still are in the stencils of their neighbours: they get the mean of the neighbours that have an
// elevation, ring by ring, twice. Nothing farther away is ever read.
void extend_into_gaps(double* bed, std::int64_t stride, std::int64_t columns, std::int64_t rows) {
    const auto index = [stride](std::int64_t i, std::int64_t j) { return static_cast<std::size_t>(j * stride + i); };
    for (int ring = 0; ring < 2; ++ring) {
        const std::vector<double> before(bed, bed + rows * stride);
        for (std::int64_t j = 0; j < rows; ++j) {
            for (std::int64_t i = 0; i < columns; ++i) {
                if (!std::isnan(before[index(i, j)])) continue;
                double sum = 0;
                int n = 0;
                for (std::int64_t b = std::max<std::int64_t>(j - 1, 0); b <= std::min(j + 1, rows - 1); ++b) {
                    for (std::int64_t a = std::max<std::int64_t>(i - 1, 0); a <= std::min(i + 1, columns - 1); ++a) {
                        const double z = before[index(a, b)];
                        if (std::isnan(z)) continue;
                        sum += z;
                        ++n;
                    }
                }
                if (n > 0) bed[index(i, j)] = sum / n;
            }
        }
    }
    std::replace_if(
        bed, bed + rows * stride, [](double z) { return std::isnan(z); }, 0.0);
}

}  // namespace

Ground::Ground(const Raster& bed) : terrain(bed), datum(std::numeric_limits<double>::infinity()) {
    bed.values.for_each_stored([&](std::size_t, double z) {
        if (!std::isnan(z)) datum = std::min(datum, z);
    });
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
    records = ZeroArray<NodeRecord>(bed.size());
    if (terrain.values.is_tiled()) {
        solid_ = ZeroArray<std::uint8_t>(bed.size());  // gaps are known only after all terrain was read
        const auto blocks = [](std::int64_t nodes) { return (nodes + Demand::k_side - 1) / Demand::k_side; };
        demand_.reset(new Demand{terrain, bed.data(), solid_.data(), blocks(stride()), blocks(padded_rows())});
        demand_->covered.resize(static_cast<std::size_t>(demand_->across * demand_->down));
        return;
    }
    const auto& all = terrain.values.dense();
    if (std::any_of(all.begin(), all.end(), [](double z) { return std::isnan(z); }))
        solid_ = ZeroArray<std::uint8_t>(bed.size());
    fill(terrain, all_beds());
    if (!any_solid()) return;
    for (std::int64_t j = 0; j < rows_; ++j)
        for (std::int64_t i = 0; i < columns_; ++i)
            if (std::isnan(terrain.at(rows_ - 1 - j, i))) solid_[index(i, j)] = k_gap;
}

NodeGrid::NodeGrid(NodeGrid&&) noexcept = default;
NodeGrid& NodeGrid::operator=(NodeGrid&&) noexcept = default;
NodeGrid::~NodeGrid() = default;

NodeGrid::Beds NodeGrid::all_beds() const {
    return {const_cast<double*>(bed.data()), stride(), {0, stride(), 0, padded_rows()}};
}

// Elevations of a region, correct except for k_margin nodes along its sides inside the grid.
void NodeGrid::fill(const Raster& terrain, const Beds& beds) const {
    bool gaps = false;
    for (std::int64_t j = std::max(beds.region.j0, k_ghost); j < std::min(beds.region.j1, rows_ + k_ghost); ++j) {
        for (std::int64_t i = std::max(beds.region.i0, k_ghost); i < std::min(beds.region.i1, columns_ + k_ghost);
             ++i) {
            const double z = terrain.at(rows_ - 1 - (j - k_ghost), i - k_ghost);
            beds.at(i, j) = z - datum_;
            gaps = gaps || std::isnan(z);
        }
    }
    extend_beyond_edges(beds);
    if (gaps)
        extend_into_gaps(beds.values, beds.stride, beds.region.i1 - beds.region.i0, beds.region.j1 - beds.region.j0);
}

// Reads one block; the lock is held.
void NodeGrid::read_block(std::int64_t a, std::int64_t b) const {
    Demand& d = *demand_;
    const Block wanted{a * Demand::k_side, std::min((a + 1) * Demand::k_side, stride()), b * Demand::k_side,
                       std::min((b + 1) * Demand::k_side, padded_rows())};
    const Block region{std::max<std::int64_t>(wanted.i0 - k_margin, 0), std::min(wanted.i1 + k_margin, stride()),
                       std::max<std::int64_t>(wanted.j0 - k_margin, 0), std::min(wanted.j1 + k_margin, padded_rows())};
    std::vector<double> values(static_cast<std::size_t>((region.i1 - region.i0) * (region.j1 - region.j0)));
    const Beds beds{values.data(), region.i1 - region.i0, region};
    fill(d.terrain, beds);
    for (std::int64_t j = wanted.j0; j < wanted.j1; ++j) {
        for (std::int64_t i = wanted.i0; i < wanted.i1; ++i) {
            const std::int64_t node = j * stride() + i, row = rows_ - 1 - (j - k_ghost), column = i - k_ghost;
            d.bed[node] = beds.at(i, j);
            if (d.mirrors && i >= k_ghost - 1 && j >= k_ghost - 1 && i <= columns_ + k_ghost && j <= rows_ + k_ghost)
                d.bed[node] = beds.at(std::clamp(i, k_ghost, columns_ + k_ghost - 1),
                                      std::clamp(j, k_ghost, rows_ + k_ghost - 1));
            if (row < 0 || row >= rows_ || column < 0 || column >= columns_) continue;
            const double z = d.terrain.at(row, column);
            if (!std::isnan(z)) d.lowest = std::min(d.lowest, z);
            if (std::isnan(z) && d.solid[node] == 0) d.solid[node] = k_gap;
        }
    }
    for (const auto& fill : d.fills) fill(wanted);
}

void NodeGrid::cover(const Block& block) const noexcept {
    if (!demand_) return;
    Demand& d = *demand_;
    const std::int64_t a0 = std::max<std::int64_t>(block.i0, 0) / Demand::k_side,
                       a1 = std::min((block.i1 + Demand::k_side - 1) / Demand::k_side, d.across),
                       b0 = std::max<std::int64_t>(block.j0, 0) / Demand::k_side,
                       b1 = std::min((block.j1 + Demand::k_side - 1) / Demand::k_side, d.down);
    for (std::int64_t b = b0; b < b1; ++b) {
        for (std::int64_t a = a0; a < a1; ++a) {
            if (std::atomic_ref(d.is_covered(a, b)).load(std::memory_order_acquire) != 0) continue;
            const std::lock_guard lock(d.taking);
            if (d.is_covered(a, b) != 0) continue;
            try {
                read_block(a, b);
                std::atomic_ref(d.is_covered(a, b)).store(1, std::memory_order_release);
            } catch (...) {
                if (!d.failure) d.failure = std::current_exception();
            }
        }
    }
}

bool NodeGrid::covers(std::int64_t i, std::int64_t j) const noexcept {
    return !demand_ || demand_->is_covered((i + k_ghost) / Demand::k_side, (j + k_ghost) / Demand::k_side) != 0;
}

void NodeGrid::mirror_edges_when_read() noexcept {
    if (demand_) demand_->mirrors = true;
}

void NodeGrid::fill_with_ground(std::function<void(const Block&)> fill) {
    for_each_covered_block(fill);
    if (demand_) demand_->fills.push_back(std::move(fill));
}

void NodeGrid::cover_round(Point place) const noexcept {
    if (!demand_) return;
    const NodeScale grid = scale();
    const auto i = static_cast<std::int64_t>(std::floor(place.x * grid.inverse_dx)) + grid.origin_x,
               j = static_cast<std::int64_t>(std::floor(place.y * grid.inverse_dx)) + grid.origin_y;
    cover({i - 2, i + 3, j - 2, j + 3});
}

std::vector<std::uint64_t> NodeGrid::covered_blocks() const {
    std::vector<std::uint64_t> blocks;
    for (std::size_t block = 0; demand_ && block < demand_->covered.size(); ++block)
        if (demand_->covered[block] != 0) blocks.push_back(block);
    return blocks;
}

// FNV-1a over elevations.
std::uint64_t NodeGrid::ground_checksum() const {
    std::uint64_t sum = 0xcbf29ce484222325;
    if (!demand_) return sum;
    for_each_covered_block([&](const Block& b) {
        for (std::int64_t j = b.j0; j < b.j1; ++j) {
            for (std::int64_t i = b.i0; i < b.i1; ++i) {
                sum ^= std::bit_cast<std::uint64_t>(bed[static_cast<std::size_t>(j * stride() + i)]);
                sum *= 0x100000001b3;
            }
        }
    });
    return sum;
}

void NodeGrid::cover_again(const std::vector<std::uint64_t>& blocks, std::uint64_t checksum) {
    if (!demand_) return;
    const auto refuse = [](const char* what) {
        throw Error(ErrorKind::input, Problem{what, "checkpoint", "", "", "Run the scene from its start"});
    };
    std::fill(demand_->covered.begin(), demand_->covered.end(), std::uint8_t{0});
    for (const std::uint64_t block : blocks) {
        if (block >= demand_->covered.size()) refuse("the saved state does not fit this program and scene");
        const std::int64_t a = static_cast<std::int64_t>(block) % demand_->across * Demand::k_side,
                           b = static_cast<std::int64_t>(block) / demand_->across * Demand::k_side;
        cover({a, a + 1, b, b + 1});
    }
    require_ground();
    if (checksum != 0 && checksum != ground_checksum())
        refuse("the ground under the flow is not what it was when the run was saved: the DTM has changed");
}

void NodeGrid::keep_place() {
    if (demand_) demand_->bed = bed.data();
}

bool NodeGrid::lacks_ground() const noexcept {
    return demand_ && demand_->failure;
}

void NodeGrid::require_ground() const {
    if (lacks_ground()) std::rethrow_exception(std::exchange(demand_->failure, nullptr));
}

double NodeGrid::lowest() const noexcept {
    return demand_ ? demand_->lowest : std::numeric_limits<double>::infinity();
}

void NodeGrid::for_each_covered_block(const std::function<void(const Block&)>& visit) const {
    if (!demand_) return visit({0, stride(), 0, padded_rows()});
    for (std::int64_t b = 0; b < demand_->down; ++b) {
        for (std::int64_t a = 0; a < demand_->across; ++a) {
            if (demand_->is_covered(a, b) == 0) continue;
            visit({a * Demand::k_side, std::min((a + 1) * Demand::k_side, stride()), b * Demand::k_side,
                   std::min((b + 1) * Demand::k_side, padded_rows())});
        }
    }
}

// Extrapolates the terrain beyond its edges with the slope at the edge.
void NodeGrid::extend_beyond_edges(const Beds& beds) const {
    const auto extrapolate = [&](std::int64_t i, std::int64_t j, std::int64_t a, std::int64_t b, std::int64_t c,
                                 std::int64_t d, std::int64_t steps) {
        if (!beds.contains(i, j) || !beds.contains(a, b) || !beds.contains(c, d)) return;
        const double edge = beds.at(a, b), inner = beds.at(c, d);
        const double slope = std::isnan(inner) ? 0 : edge - inner;
        beds.at(i, j) = edge + static_cast<double>(steps) * slope;
    };
    const std::int64_t west = k_ghost, east = columns_ - 1 + k_ghost, south = k_ghost, north = rows_ - 1 + k_ghost;
    const std::int64_t in_x = std::min<std::int64_t>(1, columns_ - 1), in_y = std::min<std::int64_t>(1, rows_ - 1);
    for (std::int64_t j = std::max(beds.region.j0, south); j <= std::min(beds.region.j1 - 1, north); ++j) {
        for (std::int64_t k = 1; k <= k_ghost; ++k) {
            extrapolate(west - k, j, west, j, west + in_x, j, k);
            extrapolate(east + k, j, east, j, east - in_x, j, k);
        }
    }
    for (std::int64_t i = beds.region.i0; i < beds.region.i1; ++i) {
        for (std::int64_t k = 1; k <= k_ghost; ++k) {
            extrapolate(i, south - k, i, south, i, south + in_y, k);
            extrapolate(i, north + k, i, north, i, north - in_y, k);
        }
    }
}

void NodeGrid::mark_walls(const Raster& walls) {
    if (!any_solid()) solid_ = ZeroArray<std::uint8_t>(bed.size());
    walls.values.for_each_stored([&](std::size_t cell, double wall) {
        if (wall == 1) solid_[node_of_cell(cell)] = k_wall;
    });
}

void NodeGrid::lower_bed(const Raster& depth) {
    bed_changes = true;
    depth.values.for_each_stored([&](std::size_t cell, double d) {
        if (std::isnan(d)) return;
        const auto node = static_cast<std::int64_t>(node_of_cell(cell));
        cover({node % stride(), node % stride() + 1, node / stride(), node / stride() + 1});
        bed[static_cast<std::size_t>(node)] -= d;
    });
    if (demand_) {
        for_each_covered_block([&](const Block& b) {
            if (b.i0 < 2 * k_ghost || b.j0 < 2 * k_ghost || b.i1 > stride() - 2 * k_ghost ||
                b.j1 > padded_rows() - 2 * k_ghost)
                extend_beyond_edges({bed.data() + b.j0 * stride() + b.i0, stride(), b});
        });
    } else {
        extend_beyond_edges(all_beds());
    }
}

}  // namespace frana
