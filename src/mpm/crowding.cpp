// SPDX-License-Identifier: Apache-2.0
#include "mpm/crowding.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mpm/shape.h"

namespace frana {
namespace {

// What newcomers claim of the cells around them, and their volume, by node.
class Newcomers {
  public:
    struct Sum {
        double fraction = 0;  // of the cell
        double volume = 0;    // [m3]
    };

    Newcomers(const NodeScale& grid, const ParticleSet& particles, std::size_t first) : grid_(grid) {
        const double inverse_area = grid.inverse_dx * grid.inverse_dx;
        std::vector<std::pair<std::size_t, Sum>> each;
        for (std::size_t p = first; p < particles.size(); ++p) {
            const double fraction = particles[Field::area][p] * inverse_area, volume = particles[Field::volume][p];
            for_nodes(stencil_of(particles, p), [&](std::size_t node, double weight) {
                each.push_back({node, {weight * fraction, weight * volume}});
            });
        }
        std::stable_sort(each.begin(), each.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [node, one] : each) {
            if (nodes_.empty() || nodes_.back() != node) {
                nodes_.push_back(node);
                sums_.emplace_back();
            }
            sums_.back().fraction += one.fraction;
            sums_.back().volume += one.volume;
        }
    }

    [[nodiscard]] Stencil<QuadraticSplineShape> stencil_of(const ParticleSet& particles, std::size_t p) const {
        return {particles[Field::x][p], particles[Field::y][p], grid_};
    }
    // At a place; 0 where none of them is near.
    [[nodiscard]] Sum at(const Stencil<QuadraticSplineShape>& s) const {
        Sum sum;
        for (int b = 0; b < 3; ++b) {  // the three nodes of a row follow each other
            const std::size_t row = s.first + static_cast<std::size_t>(b * grid_.stride);
            for (auto i =
                     static_cast<std::size_t>(std::lower_bound(nodes_.begin(), nodes_.end(), row) - nodes_.begin());
                 i < nodes_.size() && nodes_[i] < row + 3; ++i) {
                const double weight = s.wx[nodes_[i] - row] * s.wy[b];
                sum.fraction += weight * sums_[i].fraction;
                sum.volume += weight * sums_[i].volume;
            }
        }
        return sum;
    }
    // What lies there without them.
    [[nodiscard]] Sum before(const Stencil<QuadraticSplineShape>& s, const NodeMotion* nodes) const {
        Sum sum;
        for_nodes(s, [&](std::size_t node, double weight) {
            sum.fraction += weight * nodes[node].fraction;
            sum.volume += weight * nodes[node].mass;
        });
        return sum;
    }

  private:
    template <class Visit>
    void for_nodes(const Stencil<QuadraticSplineShape>& s, const Visit& visit) const {
        for (int b = 0; b < 3; ++b)
            for (int a = 0; a < 3; ++a)
                visit(s.first + static_cast<std::size_t>(b * grid_.stride + a), s.wx[a] * s.wy[b]);
    }

    const NodeScale& grid_;
    std::vector<std::size_t> nodes_;  // ascending
    std::vector<Sum> sums_;
};

}  // namespace

std::vector<std::size_t> make_room(const NodeGrid& nodes, const TileOrder& order, std::size_t first,
                                   ParticleSet& particles) {
    const NodeScale grid = nodes.scale();
    const NodeMotion* const motion = nodes.motion();
    const double *const x = particles[Field::x], *const y = particles[Field::y], *const volume = particles[Field::volume];
    double* const area = particles[Field::area];
    {
        const Newcomers wide(grid, particles, first);
        for (std::size_t p = first; p < particles.size(); ++p) {
            const auto s = wide.stencil_of(particles, p);
            const Newcomers::Sum added = wide.at(s), before = wide.before(s, motion);
            if (before.fraction + added.fraction > 1)
                area[p] = std::min(area[p], volume[p] * grid.dx * grid.dx / (before.volume + added.volume));
        }
    }
    const Newcomers newcomers(grid, particles, first);
    std::vector<std::size_t> changed;
    const auto fit = [&](std::size_t p) {
        const auto s = newcomers.stencil_of(particles, p);
        const Newcomers::Sum added = newcomers.at(s);
        if (!(added.fraction > 0)) return;
        const double all = added.fraction + newcomers.before(s, motion).fraction;
        if (!(all > 1)) return;
        area[p] /= all;
        changed.push_back(p);
    };
    // Between particles whose stencils share a node are at most three cells along either axis.
    const double reach = 3 * grid.dx;
    std::vector<std::int64_t> near;
    for (std::size_t p = first; p < particles.size(); ++p)
        for (int b = -1; b <= 1; ++b)
            for (int a = -1; a <= 1; ++a) near.push_back(order.tile_of(x[p] + a * reach, y[p] + b * reach));
    std::sort(near.begin(), near.end());
    for (const ParticleTile& tile : order.tiles()) {
        if (!std::binary_search(near.begin(), near.end(), tile.tile)) continue;
        for (std::size_t p = tile.begin; p < tile.end; ++p) fit(p);
    }
    for (std::size_t p = first; p < particles.size(); ++p) fit(p);
    return changed;
}

}  // namespace frana
