// SPDX-License-Identifier: Apache-2.0
#include "particles/resample.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace frana {
namespace {

// A symmetric 2x2 matrix.
struct Symmetric {
    double xx, xy, yy;

    [[nodiscard]] double largest() const {
        const double mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy);
        return mean + std::sqrt(half * half + xy * xy);
    }
    // Unit vector of the largest eigenvalue.
    [[nodiscard]] Point axis() const {
        const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
        return {std::cos(angle), std::sin(angle)};
    }
};

Symmetric shape_of(const ParticleRow& r) {
    return {get(r, Field::q_xx), get(r, Field::q_xy), get(r, Field::q_yy)};
}

void set_shape(ParticleRow& r, Symmetric q) {
    get(r, Field::q_xx) = q.xx;
    get(r, Field::q_xy) = q.xy;
    get(r, Field::q_yy) = q.yy;
}

// Extent along the longer axis [m].
double extent(const ParticleRow& r) {
    return std::sqrt(shape_of(r).largest());
}

// Two particles as one. The covariance of a uniform box of extents Q is Q / 12.
ParticleRow merged(const ParticleRow& a, const ParticleRow& b) {
    ParticleRow r = a;
    const double va = get(a, Field::volume), vb = get(b, Field::volume), volume = va + vb;
    const double wa = va / volume, wb = vb / volume;
    for (const Field f : {Field::x, Field::y, Field::u, Field::v, Field::c_xx, Field::c_xy, Field::c_yx,
                          Field::c_yy, Field::compression, Field::s_xx, Field::s_xy, Field::s_yy}) {
        get(r, f) = wa * get(a, f) + wb * get(b, f);
    }
    get(r, Field::volume) = volume;
    get(r, Field::area) = get(a, Field::area) + get(b, Field::area);
    const double dx = get(a, Field::x) - get(b, Field::x), dy = get(a, Field::y) - get(b, Field::y);
    const Symmetric qa = shape_of(a), qb = shape_of(b);
    const double apart = 12 * wa * wb;
    set_shape(r, {wa * qa.xx + wb * qb.xx + apart * dx * dx, wa * qa.xy + wb * qb.xy + apart * dx * dy,
                  wa * qa.yy + wb * qb.yy + apart * dy * dy});
    return r;
}

class TileResampler {
  public:
    TileResampler(const ResampleLimits& limits, const TileGrid& grid) : limits_(limits), grid_(grid) {}

    // Whether anything must be done, without copying a particle.
    [[nodiscard]] bool needed(const ParticleSet& particles, const ParticleTile& tile) {
        count_cells(particles[Field::x], particles[Field::y], tile.begin, tile.end);
        const double limit = limits_.split_extent * limits_.cell_size;
        for (std::size_t p = tile.begin; p < tile.end; ++p) {
            const int in_cell = counts_[cell_of(particles[Field::x][p], particles[Field::y][p])];
            if (in_cell > limits_.max_per_cell) return true;
            if (in_cell >= limits_.split_below) continue;
            const Symmetric q{particles[Field::q_xx][p], particles[Field::q_xy][p],
                              particles[Field::q_yy][p]};
            if (q.largest() > limit * limit &&
                particles[Field::volume][p] > limits_.minimum_depth * particles[Field::area][p]) {
                return true;
            }
        }
        return false;
    }

    std::vector<ParticleRow> operator()(const ParticleSet& particles, const ParticleTile& tile,
                                        ResampleCounts& counts) {
        std::vector<ParticleRow> rows;
        rows.reserve(2 * (tile.end - tile.begin));
        for (std::size_t p = tile.begin; p < tile.end; ++p) rows.push_back(particles.row(p));
        split(rows, counts);
        merge(rows, counts);
        return rows;
    }

  private:
    // Cell within the tile; halves that fall just outside count for the nearest cell of the tile.
    [[nodiscard]] std::size_t cell_of(double x, double y) const {
        const auto i = static_cast<std::int64_t>(x / grid_.cell_size) + grid_.ghost;
        const auto j = static_cast<std::int64_t>(y / grid_.cell_size) + grid_.ghost;
        return static_cast<std::size_t>((j % k_tile) * k_tile + i % k_tile);
    }
    void count_cells(const double* x, const double* y, std::size_t begin, std::size_t end) {
        counts_.assign(static_cast<std::size_t>(k_tile * k_tile), 0);
        for (std::size_t p = begin; p < end; ++p) ++counts_[cell_of(x[p], y[p])];
    }

    void split(std::vector<ParticleRow>& rows, ResampleCounts& counts) {
        const double limit = limits_.split_extent * limits_.cell_size;
        counts_.assign(static_cast<std::size_t>(k_tile * k_tile), 0);
        for (const ParticleRow& r : rows) ++counts_[cell_of(get(r, Field::x), get(r, Field::y))];
        const std::size_t before = rows.size();
        for (std::size_t p = 0; p < before; ++p) {
            ParticleRow& r = rows[p];
            if (extent(r) <= limit || get(r, Field::volume) <= limits_.minimum_depth * get(r, Field::area))
                continue;
            // Counted before any of this pass's splits, so that the outcome does not depend on the particles' order.
            const int in_cell = counts_[cell_of(get(r, Field::x), get(r, Field::y))];
            if (in_cell >= limits_.split_below) continue;
            const Point axis = shape_of(r).axis();
            // Halves go at most half a cell away, which the sort's drift budget has room for.
            const double quarter = std::min(0.25 * extent(r), k_split_reach * limits_.cell_size),
                         ox = quarter * axis.x, oy = quarter * axis.y;
            const double x = get(r, Field::x), y = get(r, Field::y);
            const auto inside = [&](double a, double b) {
                return a > 0 && a < limits_.width && b > 0 && b < limits_.height;
            };
            if (!inside(x + ox, y + oy) || !inside(x - ox, y - oy)) continue;
            const double du = get(r, Field::c_xx) * ox + get(r, Field::c_xy) * oy;
            const double dv = get(r, Field::c_yx) * ox + get(r, Field::c_yy) * oy;
            get(r, Field::volume) *= 0.5;
            get(r, Field::area) *= 0.5;
            // Half the extent along the axis, the same across it.
            const Symmetric q = shape_of(r);
            const double along = 0.75 * q.largest();
            set_shape(r, {q.xx - along * axis.x * axis.x, q.xy - along * axis.x * axis.y,
                          q.yy - along * axis.y * axis.y});
            ParticleRow other = r;
            get(r, Field::x) = x - ox;
            get(r, Field::y) = y - oy;
            get(r, Field::u) -= du;
            get(r, Field::v) -= dv;
            get(other, Field::x) = x + ox;
            get(other, Field::y) = y + oy;
            get(other, Field::u) += du;
            get(other, Field::v) += dv;
            rows.push_back(other);
            ++counts.split;
        }
    }

    void merge(std::vector<ParticleRow>& rows, ResampleCounts& counts) {
        std::vector<std::vector<std::size_t>> cells(static_cast<std::size_t>(k_tile * k_tile));
        for (std::size_t p = 0; p < rows.size(); ++p) {
            cells[cell_of(get(rows[p], Field::x), get(rows[p], Field::y))].push_back(p);
        }
        std::vector<std::uint8_t> gone(rows.size(), 0);
        const double limit = limits_.merge_extent * limits_.cell_size;
        for (auto& cell : cells) {
            while (static_cast<int>(cell.size()) > limits_.max_per_cell) {
                // The pair whose union is shortest: it blurs least.
                double best = limit;
                std::size_t best_a = 0, best_b = 0;
                for (std::size_t a = 0; a < cell.size(); ++a) {
                    for (std::size_t b = a + 1; b < cell.size(); ++b) {
                        const double length = extent(merged(rows[cell[a]], rows[cell[b]]));
                        if (length < best) {
                            best = length;
                            best_a = a;
                            best_b = b;
                        }
                    }
                }
                if (best_b == 0) break;
                rows[cell[best_a]] = merged(rows[cell[best_a]], rows[cell[best_b]]);
                gone[cell[best_b]] = 1;
                cell.erase(cell.begin() + static_cast<std::ptrdiff_t>(best_b));
                ++counts.merged;
            }
        }
        std::size_t kept = 0;
        for (std::size_t p = 0; p < rows.size(); ++p) {
            if (gone[p]) continue;
            if (kept != p) rows[kept] = rows[p];
            ++kept;
        }
        rows.resize(kept);
    }

    const ResampleLimits& limits_;
    const TileGrid& grid_;
    std::vector<int> counts_;
};

}  // namespace

ResampleCounts resample(ParticleSet& particles, TileOrder& order, const ResampleLimits& limits,
                        ThreadPool& pool) {
    const auto& tiles = order.tiles();
    std::vector<std::vector<ParticleRow>> changed(tiles.size());
    std::vector<std::uint8_t> needs(tiles.size(), 0);
    std::vector<ResampleCounts> counts(tiles.size());
    pool.for_each(tiles.size(), [&](std::size_t t) {
        TileResampler tile(limits, order.grid());
        needs[t] = tile.needed(particles, tiles[t]);
        if (needs[t]) changed[t] = tile(particles, tiles[t], counts[t]);
    });
    ResampleCounts total;
    for (const ResampleCounts& c : counts) {
        total.split += c.split;
        total.merged += c.merged;
    }
    if (total.split == 0 && total.merged == 0) return total;

    std::vector<std::size_t> sizes(tiles.size()), begins(tiles.size());
    std::size_t n = 0;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        sizes[t] = needs[t] ? changed[t].size() : tiles[t].end - tiles[t].begin;
        begins[t] = n;
        n += sizes[t];
    }
    ParticleSet next(particles.mask());
    next.resize(n);
    pool.for_each(tiles.size(), [&](std::size_t t) {
        if (needs[t]) {
            for (std::size_t i = 0; i < sizes[t]; ++i) next.set_row(begins[t] + i, changed[t][i]);
        } else {
            next.copy_range(particles, tiles[t].begin, tiles[t].end, begins[t]);
        }
    });
    particles = std::move(next);
    order.set_counts(sizes);
    return total;
}

}  // namespace frana
