// SPDX-License-Identifier: Apache-2.0
#include "particles/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace frana {
namespace {

// The squared extents of a particle, a symmetric matrix [m2].
struct Shape {
    double xx, xy, yy;

    [[nodiscard]] double half_trace() const { return 0.5 * (xx + yy); }
    // In closed form: it is needed for every particle.
    [[nodiscard]] double largest_eigenvalue() const {
        const double half = 0.5 * (xx - yy);
        return half_trace() + std::sqrt(half * half + xy * xy);
    }
    // Whether both axes are equally long, except for rounding.
    [[nodiscard]] bool is_round() const { return largest_eigenvalue() - half_trace() < 1e-9 * half_trace(); }
    // Unit vector of the largest eigenvalue.
    [[nodiscard]] Point long_axis() const {
        const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
        return {std::cos(angle), std::sin(angle)};
    }
    // n^T Q n
    [[nodiscard]] double squared_extent(Point n) const { return n.x * n.x * xx + 2 * n.x * n.y * xy + n.y * n.y * yy; }
};

void set_shape(ParticleRow& r, const Shape& q) {
    get(r, Field::q_xx) = q.xx;
    get(r, Field::q_xy) = q.xy;
    get(r, Field::q_yy) = q.yy;
}

// Properties of a particle that merging needs.
struct Outline {
    double x, y, volume;
    Shape shape;

    explicit Outline(const ParticleRow& r)
        : x(get(r, Field::x)),
          y(get(r, Field::y)),
          volume(get(r, Field::volume)),
          shape{get(r, Field::q_xx), get(r, Field::q_xy), get(r, Field::q_yy)} {}
    Outline(const ParticleSet& particles, std::size_t p)
        : x(particles[Field::x][p]),
          y(particles[Field::y][p]),
          volume(particles[Field::volume][p]),
          shape{particles[Field::q_xx][p], particles[Field::q_xy][p], particles[Field::q_yy][p]} {}
};

// Returns the shape of two particles merged. The covariance of a uniform box of extents Q is Q / 12.
inline Shape merged_shape(const Outline& a, const Outline& b) {
    const double wa = a.volume / (a.volume + b.volume), wb = 1 - wa;
    const double x = a.x - b.x, y = a.y - b.y, gain = 12 * wa * wb;
    return {wa * a.shape.xx + wb * b.shape.xx + gain * x * x, wa * a.shape.xy + wb * b.shape.xy + gain * x * y,
            wa * a.shape.yy + wb * b.shape.yy + gain * y * y};
}

// Returns two particles merged.
ParticleRow merged(const ParticleRow& a, const ParticleRow& b) {
    ParticleRow r = a;
    const double va = get(a, Field::volume), vb = get(b, Field::volume), volume = va + vb;
    const double wa = va / volume, wb = vb / volume;
    for (const Field f : {Field::x, Field::y, Field::u, Field::v, Field::c_xx, Field::c_xy, Field::c_yx, Field::c_yy,
                          Field::compression, Field::s_xx, Field::s_xy, Field::s_yy, Field::flown, Field::pore_pressure,
                          Field::solid_fraction}) {
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
    TileResampler(const ResampleLimits& limits, const TileOrder& order, const ParticleSet& particles, std::size_t tile,
                  const std::uint8_t* tail)
        : limits_(limits),
          grid_(order.grid()),
          particles_(particles),
          source_(order.source().data() + order.tiles()[tile].begin),
          cells_(order.cells().data() + order.tiles()[tile].begin),
          size_(order.tiles()[tile].end - order.tiles()[tile].begin) {
        const double *volume = particles_[Field::volume], *area = particles_[Field::area];
        std::array<double, k_cells> volumes{}, areas{};
        for (std::size_t p = 0; p < size_; ++p) {
            const std::size_t cell = cells_[p];
            ++counts_[cell];
            volumes[cell] += volume[source_[p]];
            areas[cell] += area[source_[p]];
        }
        const std::int64_t tiles_x = grid_.tiles_x(), number = order.tiles()[tile].tile;
        const std::int64_t west = number % tiles_x * k_tile - grid_.before_x(),
                           south = number / tiles_x * k_tile - grid_.before_y();
        for (std::size_t cell = 0; cell < k_cells; ++cell) {
            const auto at = static_cast<std::int64_t>(cell);
            const bool trails =
                tail != nullptr && counts_[cell] > 0 && tail[padded(west + at % k_tile, south + at / k_tile)] != 0;
            wanted_[cell] = volumes[cell] < limits_.film_depth * areas[cell] ? &limits_.film
                            : trails                                         ? &limits_.tail
                                                                             : &limits_.flow;
        }
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

    [[nodiscard]] const CellParticles& wanted(std::size_t cell) const { return *wanted_[cell]; }
    [[nodiscard]] std::int64_t padded(std::int64_t i, std::int64_t j) const {
        return j * (grid_.columns + 2 * grid_.ghost) + i;
    }
    [[nodiscard]] bool in_wall(double x, double y) const {
        if (limits_.marks == nullptr) return false;
        const NodeNumbers nodes(grid_);
        return limits_.marks[padded(nodes.x(x) - grid_.before_x(), nodes.y(y) - grid_.before_y())] == limits_.wall_mark;
    }
    // Indices continue from the particles of the tile to those added.
    [[nodiscard]] Outline outline(std::size_t i) const {
        return i < size_ ? Outline(particles_, source_[i]) : Outline(change_.added[i - size_]);
    }
    [[nodiscard]] ParticleRow row(std::size_t i) const {
        return i < size_ ? particles_.row(source_[i]) : change_.added[i - size_];
    }

    void split() {
        const double *q_xx = particles_[Field::q_xx], *q_xy = particles_[Field::q_xy], *q_yy = particles_[Field::q_yy];
        const double *volume = particles_[Field::volume], *area = particles_[Field::area];
        for (std::size_t i = 0; i < size_; ++i) {
            const std::size_t cell = cells_[i], p = source_[i];
            if (counts_[cell] >= wanted(cell).split_below) continue;
            const double limit = wanted(cell).split_extent * limits_.cell_size;
            if (!(Shape{q_xx[p], q_xy[p], q_yy[p]}.largest_eigenvalue() > limit * limit)) continue;
            if (volume[p] > limits_.minimum_depth * area[p]) split_one(i);
        }
    }

    void split_one(std::size_t p) {
        const ParticleRow r = row(p);
        const Shape q = Outline(r).shape;
        std::vector<ParticleRow> parts;
        if (q.is_round()) {
            // As long as wide: split into four quarters, so that no axis is preferred.
            for (const ParticleRow& half : halves(r, {1, 0}))
                for (const ParticleRow& quarter : halves(half, {0, 1})) parts.push_back(quarter);
        } else {
            parts = halves(r, q.long_axis());
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
    [[nodiscard]] std::vector<ParticleRow> halves(ParticleRow r, Point axis) const {
        const Shape q = Outline(r).shape;
        const double length2 = q.squared_extent(axis);
        // Halves move at most half a cell, for which the drift budget of the sort has room.
        const double quarter = std::min(0.25 * std::sqrt(length2), k_split_reach * limits_.cell_size);
        const Point offset{quarter * axis.x, quarter * axis.y};
        const Point change{get(r, Field::c_xx) * offset.x + get(r, Field::c_xy) * offset.y,
                           get(r, Field::c_yx) * offset.x + get(r, Field::c_yy) * offset.y};
        get(r, Field::volume) *= 0.5;
        get(r, Field::area) *= 0.5;
        // Half the extent along the axis, the same across it.
        const double lost = 0.75 * length2;
        set_shape(r, {q.xx - lost * axis.x * axis.x, q.xy - lost * axis.x * axis.y, q.yy - lost * axis.y * axis.y});
        std::vector<ParticleRow> both;
        for (const double side : {-1.0, 1.0}) {
            ParticleRow half = r;
            get(half, Field::x) += side * offset.x;
            get(half, Field::y) += side * offset.y;
            get(half, Field::u) += side * change.x;
            get(half, Field::v) += side * change.y;
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
            for (const std::size_t i : cell) along.emplace_back(place_on_curve(outline(i)), i);
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
                if (merged_shape(outline(one), outline(other)).largest_eigenvalue() >= limit * limit) {
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
    [[nodiscard]] std::uint32_t place_on_curve(const Outline& particle) const {
        constexpr std::uint32_t k_bits = 10;
        const auto within = [&](double at) {
            const double cells = at / limits_.cell_size;
            return static_cast<std::uint32_t>((cells - std::floor(cells)) * ((1U << k_bits) - 1));
        };
        const std::uint32_t column = within(particle.x), line = within(particle.y);
        std::uint32_t code = 0;
        for (std::uint32_t bit = 0; bit < k_bits; ++bit)
            code |= ((column >> bit & 1U) << (2 * bit)) | ((line >> bit & 1U) << (2 * bit + 1));
        return code;
    }

    /// Merges the pairs of a cell whose unions are shortest, until it has no more than `most` particles.
    template <class Drop>
    void join_shortest(std::vector<std::size_t>& cell, std::size_t most, double limit,
                       std::vector<std::uint8_t>& dropped, const Drop& drop) {
        std::vector<Outline>& outlines = outlines_;
        std::vector<double>& least = least_;
        outlines.clear();
        for (const std::size_t i : cell) outlines.push_back(outline(i));
        // Half the trace of each pair merged: the least that its longest squared extent can be. Of particles that
        // were merged away: infinite.
        const std::size_t n = cell.size();
        least.assign(n * n, k_merged_away);
        const auto compare = [&](std::size_t a, std::size_t b) {
            least[a * n + b] = merged_shape(outlines[a], outlines[b]).half_trace();
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
                    const double length2 = merged_shape(outlines[a], outlines[b]).largest_eigenvalue();
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

    void merge() {
        // Members of the cells that contain too many, cell after cell in their order; none of them splits
        // (ResampleLimits).
        std::array<std::size_t, k_cells + 1> ends{};
        for (std::size_t cell = 0; cell < k_cells; ++cell) {
            const int count = counts_[cell];
            ends[cell + 1] = ends[cell] + (count > wanted(cell).most ? static_cast<std::size_t>(count) : 0);
        }
        std::vector<std::size_t> members(ends.back());
        std::array<std::size_t, k_cells + 1> next = ends;
        for (std::size_t p = 0; p < size_; ++p) {
            const std::size_t cell = cells_[p];
            if (ends[cell] < ends[cell + 1]) members[next[cell]++] = p;
        }

        std::vector<std::uint8_t> dropped(change_.added.size(), 0);
        const auto drop = [&](std::size_t i) {
            if (i < size_) {
                change_.removed.push_back(i);
            } else {
                dropped[i - size_] = 1;
            }
        };
        std::vector<std::size_t> cell;
        for (std::size_t at = 0; at < k_cells; ++at) {
            if (ends[at] == ends[at + 1]) continue;
            cell.assign(members.data() + ends[at], members.data() + ends[at + 1]);
            const double limit = wanted(at).merge_extent * limits_.cell_size;
            const auto most = static_cast<std::size_t>(wanted(at).most);
            thin_out(cell, most, limit, dropped, drop);
            if (cell.size() <= most) continue;
            join_shortest(cell, most, limit, dropped, drop);
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < change_.added.size(); ++i) {
            if (dropped[i] == 0) change_.added[kept++] = change_.added[i];
        }
        change_.added.resize(kept);
    }

    std::vector<Outline> outlines_;  // of join_shortest
    std::vector<double> least_;
    const ResampleLimits& limits_;
    const TileGrid& grid_;
    const ParticleSet& particles_;
    const std::uint32_t* const source_;  // of each particle of the tile: its index, and its cell
    const std::uint8_t* const cells_;
    const std::size_t size_;
    // Of each cell before anything changes: halves may land in a neighbouring tile, and the result must not depend on
    // the position of tiles. Those landing in a cell count in the next pass.
    std::array<int, k_cells> counts_{};
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
        changes[t] = TileResampler(limits, order, particles, t, tail)();
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
    if (total.split == 0 && total.merged == 0) {
        order.apply(particles, pool);
        return total;
    }

    const std::uint32_t* const source = order.source().data();
    particles.rebuild(
        n, tiles.size(),
        [&](Field field, const double* from, double* to, std::size_t t) {
            double* next = to + begins[t];
            const std::uint32_t* place = source + tiles[t].begin;
            const std::uint32_t* const first = place;
            const auto copy_until = [&](const std::uint32_t* end) {
                for (; place != end; ++place) *next++ = from[*place];
            };
            for (const std::size_t removed : changes[t].removed) {
                copy_until(first + removed);
                ++place;
            }
            copy_until(source + tiles[t].end);
            for (const ParticleRow& row : changes[t].added) *next++ = get(row, field);
        },
        pool);
    order.set_counts(sizes);
    return total;
}

}  // namespace frana
