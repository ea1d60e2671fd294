// SPDX-License-Identifier: Apache-2.0
#include "particles/resample.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace frana {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// Returns the squared extents of a particle as a symmetric matrix.
Matrix2d shape_of(double xx, double xy, double yy) {
    return (Matrix2d() << xx, xy, xy, yy).finished();
}

Matrix2d shape_of(const ParticleRow& r) {
    return shape_of(get(r, Field::q_xx), get(r, Field::q_xy), get(r, Field::q_yy));
}

void set_shape(ParticleRow& r, const Matrix2d& q) {
    get(r, Field::q_xx) = q(0, 0);
    get(r, Field::q_xy) = q(0, 1);
    get(r, Field::q_yy) = q(1, 1);
}

// In closed form: it is needed for every particle.
double largest_eigenvalue(const Matrix2d& q) {
    const double half = 0.5 * (q(0, 0) - q(1, 1));
    return 0.5 * q.trace() + std::sqrt(half * half + q(0, 1) * q(0, 1));
}

// Whether both axes are equally long, except for rounding.
bool is_round(const Matrix2d& q) {
    const double mean = 0.5 * q.trace();
    return largest_eigenvalue(q) - mean < 1e-9 * mean;
}

// Unit vector of the largest eigenvalue.
Vector2d long_axis(const Matrix2d& q) {
    const double angle = 0.5 * std::atan2(2 * q(0, 1), q(0, 0) - q(1, 1));
    return {std::cos(angle), std::sin(angle)};
}

// n^T Q n
double squared_extent(const Matrix2d& q, const Vector2d& n) {
    return n.x() * n.x() * q(0, 0) + 2 * n.x() * n.y() * q(0, 1) + n.y() * n.y() * q(1, 1);
}

// Properties of a particle that merging needs.
struct Outline {
    Vector2d place;
    double volume;
    Matrix2d shape;

    explicit Outline(const ParticleRow& r)
        : place(get(r, Field::x), get(r, Field::y)), volume(get(r, Field::volume)), shape(shape_of(r)) {}
    Outline(const ParticleSet& particles, std::size_t p)
        : place(particles[Field::x][p], particles[Field::y][p]),
          volume(particles[Field::volume][p]),
          shape(shape_of(particles[Field::q_xx][p], particles[Field::q_xy][p], particles[Field::q_yy][p])) {}
};

// Returns the shape of two particles merged. The covariance of a uniform box of extents Q is Q / 12.
Matrix2d merged_shape(const Outline& a, const Outline& b) {
    const double wa = a.volume / (a.volume + b.volume), wb = 1 - wa;
    const Vector2d apart = a.place - b.place;
    return wa * a.shape + wb * b.shape + (12 * wa * wb * apart) * apart.transpose();
}

// Returns two particles merged.
ParticleRow merged(const ParticleRow& a, const ParticleRow& b) {
    ParticleRow r = a;
    const double va = get(a, Field::volume), vb = get(b, Field::volume), volume = va + vb;
    const double wa = va / volume, wb = vb / volume;
    for (const Field f : {Field::x, Field::y, Field::u, Field::v, Field::c_xx, Field::c_xy, Field::c_yx, Field::c_yy,
                          Field::compression, Field::s_xx, Field::s_xy, Field::s_yy, Field::flown}) {
        get(r, f) = wa * get(a, f) + wb * get(b, f);
    }
    get(r, Field::volume) = volume;
    get(r, Field::area) = get(a, Field::area) + get(b, Field::area);
    set_shape(r, merged_shape(Outline(a), Outline(b)));
    return r;
}

// The changes of a tile: indices, within the tile, of the particles removed, ascending, and the particles added.
struct TileChange {
    std::vector<std::size_t> removed;
    std::vector<ParticleRow> added;
    ResampleCounts counts;
};

class TileResampler {
  public:
    TileResampler(const ResampleLimits& limits, const TileGrid& grid, const ParticleSet& particles,
                  const ParticleTile& tile, const std::uint8_t* tail)
        : limits_(limits), grid_(grid), particles_(particles), begin_(tile.begin), size_(tile.end - tile.begin) {
        const double *x = particles_[Field::x] + begin_, *y = particles_[Field::y] + begin_;
        const double *volume = particles_[Field::volume] + begin_, *area = particles_[Field::area] + begin_;
        std::array<double, k_cells> volumes{}, areas{};
        cells_.resize(size_);
        for (std::size_t p = 0; p < size_; ++p) {
            const std::size_t cell = cell_of(x[p], y[p]);
            cells_[p] = static_cast<std::uint8_t>(cell);
            ++counts_[cell];
            volumes[cell] += volume[p];
            areas[cell] += area[p];
        }
        wanted_.fill(&limits_.flow);
        if (tail != nullptr) {
            for (std::size_t p = 0; p < size_; ++p)
                if (tail[padded_node(x[p], y[p])] != 0) wanted_[cells_[p]] = &limits_.tail;
        }
        for (std::size_t cell = 0; cell < k_cells; ++cell)
            if (volumes[cell] < limits_.film_depth * areas[cell]) wanted_[cell] = &limits_.film;
    }

    TileChange operator()() {
        split();
        for (std::size_t cell = 0; cell < k_cells; ++cell) {
            if (counts_[cell] > wanted(cell).most) {
                merge();
                break;
            }
        }
        std::sort(change_.removed.begin(), change_.removed.end());
        return std::move(change_);
    }

  private:
    static constexpr std::size_t k_cells = k_tile * k_tile;
    static_assert(k_cells <= 256);
    static constexpr double k_merged_away = std::numeric_limits<double>::infinity();

    // Cell within the tile, for particles of the tile.
    [[nodiscard]] std::size_t cell_of(double x, double y) const {
        const auto i = static_cast<std::uint64_t>(grid_.node_x(x));
        const auto j = static_cast<std::uint64_t>(grid_.node_y(y));
        return static_cast<std::size_t>((j % k_tile) * k_tile + i % k_tile);
    }
    [[nodiscard]] const CellParticles& wanted(std::size_t cell) const { return *wanted_[cell]; }
    [[nodiscard]] std::int64_t padded_node(double x, double y) const {
        const std::int64_t i = grid_.node_x(x) - grid_.before_x(), j = grid_.node_y(y) - grid_.before_y();
        return j * (grid_.columns + 2 * grid_.ghost) + i;
    }
    [[nodiscard]] bool in_wall(double x, double y) const {
        return limits_.marks != nullptr && limits_.marks[padded_node(x, y)] == limits_.wall_mark;
    }
    // Indices continue from the particles of the tile to those added.
    [[nodiscard]] Outline outline(std::size_t i) const {
        return i < size_ ? Outline(particles_, begin_ + i) : Outline(change_.added[i - size_]);
    }
    [[nodiscard]] ParticleRow row(std::size_t i) const {
        return i < size_ ? particles_.row(begin_ + i) : change_.added[i - size_];
    }

    void split() {
        const double *q_xx = particles_[Field::q_xx] + begin_, *q_xy = particles_[Field::q_xy] + begin_;
        const double* q_yy = particles_[Field::q_yy] + begin_;
        const double *volume = particles_[Field::volume] + begin_, *area = particles_[Field::area] + begin_;
        for (std::size_t p = 0; p < size_; ++p) {
            const std::size_t cell = cells_[p];
            if (counts_[cell] >= wanted(cell).split_below) continue;
            const double limit = wanted(cell).split_extent * limits_.cell_size;
            if (!(largest_eigenvalue(shape_of(q_xx[p], q_xy[p], q_yy[p])) > limit * limit)) continue;
            if (volume[p] > limits_.minimum_depth * area[p]) split_one(p);
        }
    }

    void split_one(std::size_t p) {
        const ParticleRow r = row(p);
        const Matrix2d q = shape_of(r);
        std::vector<ParticleRow> parts;
        if (is_round(q)) {
            // As long as wide: split into four quarters, so that no axis is preferred.
            for (const ParticleRow& half : halves(r, Vector2d::UnitX()))
                for (const ParticleRow& quarter : halves(half, Vector2d::UnitY())) parts.push_back(quarter);
        } else {
            parts = halves(r, long_axis(q));
        }
        const auto fits = [&](const ParticleRow& part) {
            const double x = get(part, Field::x), y = get(part, Field::y);
            const Bounds& edges = limits_.edges;
            return x > edges.west && x < edges.east && y > edges.south && y < edges.north && !in_wall(x, y);
        };
        if (!std::all_of(parts.begin(), parts.end(), fits)) return;
        change_.added.insert(change_.added.end(), parts.begin(), parts.end());
        change_.removed.push_back(p);
        ++change_.counts.split;
    }

    // Returns the two halves of a particle along an axis (a unit vector).
    [[nodiscard]] std::vector<ParticleRow> halves(ParticleRow r, const Vector2d& axis) const {
        const Matrix2d q = shape_of(r);
        const double length2 = squared_extent(q, axis);
        // Halves move at most half a cell, for which the drift budget of the sort has room.
        const double quarter = std::min(0.25 * std::sqrt(length2), k_split_reach * limits_.cell_size);
        const Vector2d offset = quarter * axis;
        const Matrix2d gradient = (Matrix2d() << get(r, Field::c_xx), get(r, Field::c_xy),  //
                                   get(r, Field::c_yx), get(r, Field::c_yy))
                                      .finished();
        const Vector2d change = gradient * offset;
        get(r, Field::volume) *= 0.5;
        get(r, Field::area) *= 0.5;
        // Half the extent along the axis, the same across it.
        set_shape(r, q - (0.75 * length2 * axis) * axis.transpose());
        std::vector<ParticleRow> both;
        for (const double side : {-1.0, 1.0}) {
            ParticleRow half = r;
            get(half, Field::x) += side * offset.x();
            get(half, Field::y) += side * offset.y();
            get(half, Field::u) += side * change.x();
            get(half, Field::v) += side * change.y();
            both.push_back(half);
        }
        return both;
    }

    // Comparing all pairs for each merge costs the cube of the number: where release areas overlap, neighbours along a
    // curve through the cell merge first, all at once.
    template <class Drop>
    void thin_out(std::vector<std::size_t>& cell, std::size_t most, double limit, std::vector<std::uint8_t>& dropped,
                  const Drop& drop) {
        constexpr std::size_t k_crowd = 8;  // times the allowed number
        while (cell.size() > k_crowd * most) {
            std::vector<std::pair<std::uint32_t, std::size_t>> along;
            for (const std::size_t i : cell) along.emplace_back(place_on_curve(outline(i).place), i);
            std::sort(along.begin(), along.end());
            const std::size_t before = cell.size();
            cell.clear();
            for (std::size_t k = 0; k < along.size(); ++k) {
                const std::size_t one = along[k].second;
                if (k + 1 == along.size()) {
                    cell.push_back(one);
                    break;
                }
                const std::size_t other = along[k + 1].second;
                if (largest_eigenvalue(merged_shape(outline(one), outline(other))) >= limit * limit) {
                    cell.push_back(one);
                    continue;
                }
                drop(one);
                drop(other);
                cell.push_back(size_ + change_.added.size());
                change_.added.push_back(merged(row(one), row(other)));
                dropped.push_back(0);
                ++change_.counts.merged;
                ++k;
            }
            if (cell.size() == before) return;
        }
    }

    // Returns the position of a point on Morton's curve through its cell.
    [[nodiscard]] std::uint32_t place_on_curve(const Vector2d& place) const {
        constexpr std::uint32_t k_bits = 10;
        const auto within = [&](double at) {
            const double cells = at / limits_.cell_size;
            return static_cast<std::uint32_t>((cells - std::floor(cells)) * ((1U << k_bits) - 1));
        };
        const std::uint32_t column = within(place.x()), line = within(place.y());
        std::uint32_t code = 0;
        for (std::uint32_t bit = 0; bit < k_bits; ++bit)
            code |= ((column >> bit & 1U) << (2 * bit)) | ((line >> bit & 1U) << (2 * bit + 1));
        return code;
    }

    void merge() {
        // Members of the cells that contain too many, in their order; none of them splits (ResampleLimits).
        std::array<std::vector<std::size_t>, k_cells> cells;
        for (std::size_t p = 0; p < size_; ++p) {
            const std::size_t cell = cells_[p];
            if (counts_[cell] > wanted(cell).most) cells[cell].push_back(p);
        }

        std::vector<std::uint8_t> dropped(change_.added.size(), 0);
        const auto drop = [&](std::size_t i) {
            if (i < size_) {
                change_.removed.push_back(i);
            } else {
                dropped[i - size_] = 1;
            }
        };
        std::vector<Outline> outlines;
        std::vector<double> least;
        for (std::size_t at = 0; at < k_cells; ++at) {
            std::vector<std::size_t>& cell = cells[at];
            const double limit = wanted(at).merge_extent * limits_.cell_size;
            const auto most = static_cast<std::size_t>(wanted(at).most);
            thin_out(cell, most, limit, dropped, drop);
            if (cell.size() <= most) continue;
            outlines.clear();
            for (const std::size_t i : cell) outlines.push_back(outline(i));
            // Half the trace of each pair merged: the least that its longest squared extent can be. Of particles that
            // were merged away: infinite.
            const std::size_t n = cell.size();
            least.assign(n * n, k_merged_away);
            const auto compare = [&](std::size_t a, std::size_t b) {
                least[a * n + b] = 0.5 * merged_shape(outlines[a], outlines[b]).trace();
            };
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = a + 1; b < n; ++b) compare(a, b);
            for (std::size_t left = n; left > most; --left) {
                // The pair whose union is shortest: it smooths least.
                double best = limit * limit;
                std::size_t best_a = 0, best_b = 0;
                for (std::size_t a = 0; a < n; ++a) {
                    for (std::size_t b = a + 1; b < n; ++b) {
                        if (least[a * n + b] >= best) continue;
                        const double length2 = largest_eigenvalue(merged_shape(outlines[a], outlines[b]));
                        if (length2 < best) {
                            best = length2;
                            best_a = a;
                            best_b = b;
                        }
                    }
                }
                if (best_b == 0) break;
                const ParticleRow both = merged(row(cell[best_a]), row(cell[best_b]));
                drop(cell[best_a]);
                drop(cell[best_b]);
                cell[best_a] = size_ + change_.added.size();
                outlines[best_a] = Outline(both);
                change_.added.push_back(both);
                dropped.push_back(0);
                ++change_.counts.merged;
                for (std::size_t k = 0; k < n; ++k) {
                    double &first = least[std::min(best_a, k) * n + std::max(best_a, k)],
                           &second = least[std::min(best_b, k) * n + std::max(best_b, k)];
                    second = k_merged_away;
                    if (k != best_a && first < k_merged_away) compare(std::min(best_a, k), std::max(best_a, k));
                }
            }
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < change_.added.size(); ++i) {
            if (dropped[i] == 0) change_.added[kept++] = change_.added[i];
        }
        change_.added.resize(kept);
    }

    const ResampleLimits& limits_;
    const TileGrid& grid_;
    const ParticleSet& particles_;
    const std::size_t begin_, size_;
    // Of each cell before anything changes: halves may land in a neighbouring tile, and the result must not depend on
    // the position of tiles. Those landing in a cell count in the next pass.
    std::array<int, k_cells> counts_{};
    std::vector<std::uint8_t> cells_;  // of each particle
    std::array<const CellParticles*, k_cells> wanted_{};
    TileChange change_;
};

}  // namespace

ResampleCounts resample(ParticleSet& particles, TileOrder& order, const ResampleLimits& limits,
                        const std::vector<std::uint8_t>& left_alone, const std::uint8_t* tail, ThreadPool& pool) {
    const auto& tiles = order.tiles();
    std::vector<TileChange> changes(tiles.size());
    pool.for_each(tiles.size(), [&](std::size_t t) {
        if (!left_alone.empty() && left_alone[t] != 0) return;
        changes[t] = TileResampler(limits, order.grid(), particles, tiles[t], tail)();
    });
    ResampleCounts total;
    std::vector<std::size_t> sizes(tiles.size()), begins(tiles.size());
    std::size_t n = 0;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        total.split += changes[t].counts.split;
        total.merged += changes[t].counts.merged;
        sizes[t] = tiles[t].end - tiles[t].begin - changes[t].removed.size() + changes[t].added.size();
        begins[t] = n;
        n += sizes[t];
    }
    if (total.split == 0 && total.merged == 0) return total;

    particles.rebuild(
        n, tiles.size(),
        [&](Field field, const double* from, double* to, std::size_t t) {
            double* next = to + begins[t];
            std::size_t p = tiles[t].begin;
            for (const std::size_t removed : changes[t].removed) {
                next = std::copy(from + p, from + tiles[t].begin + removed, next);
                p = tiles[t].begin + removed + 1;
            }
            next = std::copy(from + p, from + tiles[t].end, next);
            for (const ParticleRow& row : changes[t].added) *next++ = get(row, field);
        },
        pool);
    order.set_counts(sizes);
    return total;
}

}  // namespace frana
