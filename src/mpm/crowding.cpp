// SPDX-License-Identifier: Apache-2.0
#include "mpm/crowding.h"

#include <algorithm>
#include <limits>

#include "mpm/particle_update.h"
#include "mpm/shape.h"

namespace frana {
namespace {

// What lies on the cells of the nodes that appended particles touch.
class Columns {
  public:
    struct Column {
        double fraction = 0;  // claimed of the cell
        double volume = 0;    // [m3]
        double weight = 0;    // of such nodes in a stencil
    };

    Columns(const NodeScale& grid, const ParticleSet& particles, std::size_t first)
        : grid_(grid), particles_(particles) {
        constexpr double k_reach = 1.5;  // of a stencil [cells]
        for (std::size_t p = first; p < particles.size(); ++p) {
            const double x = particles[Field::x][p], y = particles[Field::y][p], reach = 2 * k_reach * grid.dx;
            near_.west = std::min(near_.west, x - reach);
            near_.east = std::max(near_.east, x + reach);
            near_.south = std::min(near_.south, y - reach);
            near_.north = std::max(near_.north, y + reach);
            const auto s = stencil_of(p);
            for (int b = 0; b < 3; ++b)
                for (int a = 0; a < 3; ++a) nodes_.push_back(s.first + static_cast<std::size_t>(b * grid.stride + a));
        }
        std::sort(nodes_.begin(), nodes_.end());
        nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
        columns_.resize(nodes_.size());
    }

    // Whether a particle may touch one of the nodes.
    [[nodiscard]] bool is_near(std::size_t p) const noexcept {
        return near_.contains(particles_[Field::x][p], particles_[Field::y][p]);
    }
    void clear() { std::fill(columns_.begin(), columns_.end(), Column{}); }
    // Returns whether the particle touches one of the nodes.
    bool add(std::size_t p) {
        const double fraction = particles_[Field::area][p] * grid_.inverse_dx * grid_.inverse_dx,
                     volume = particles_[Field::volume][p];
        bool any = false;
        visit(p, [&](std::size_t i, double weight) {
            columns_[i].fraction += weight * fraction;
            columns_[i].volume += weight * volume;
            any = true;
        });
        return any;
    }
    // The mean at a particle; of the fraction what exceeds a full cell, plus 1.
    [[nodiscard]] Column at(std::size_t p) const {
        Column mean{1, 0, 0};
        visit(p, [&](std::size_t i, double weight) {
            mean.fraction += weight * std::max(0.0, columns_[i].fraction - 1);
            mean.volume += weight * columns_[i].volume;
            mean.weight += weight;
        });
        mean.volume /= mean.weight;
        return mean;
    }

  private:
    [[nodiscard]] Stencil<QuadraticSplineShape> stencil_of(std::size_t p) const {
        return {particles_[Field::x][p], particles_[Field::y][p], grid_};
    }
    template <class Visit>
    void visit(std::size_t p, const Visit& each) const {
        const auto s = stencil_of(p);
        for (int b = 0; b < 3; ++b) {  // the three nodes of a row follow each other
            const std::size_t row = s.first + static_cast<std::size_t>(b * grid_.stride);
            for (auto n = std::lower_bound(nodes_.begin(), nodes_.end(), row); n != nodes_.end() && *n < row + 3; ++n)
                each(static_cast<std::size_t>(n - nodes_.begin()), s.wx[*n - row] * s.wy[b]);
        }
    }

    static constexpr double k_far = std::numeric_limits<double>::infinity();
    const NodeScale& grid_;
    const ParticleSet& particles_;
    Bounds near_{k_far, k_far, -k_far, -k_far};
    std::vector<std::size_t> nodes_;  // ascending
    std::vector<Column> columns_;
};

}  // namespace

std::vector<std::size_t> fit_appended(const NodeGrid& nodes, const TileOrder& order, std::size_t first,
                                      ParticleSet& particles) {
    std::vector<std::size_t> changed;
    if (first == particles.size()) return changed;
    const NodeScale grid = nodes.scale();
    Columns columns(grid, particles, first);
    std::vector<std::size_t> near;  // the appended at the end
    for (const ParticleTile& tile : order.tiles())
        for (std::size_t p = tile.begin; p < tile.end; ++p)
            if (columns.is_near(p) && columns.add(p)) near.push_back(p);
    for (std::size_t p = first; p < particles.size(); ++p) {
        columns.add(p);
        near.push_back(p);
    }
    double* const area = particles[Field::area];
    const auto least = [&](std::size_t p, const Columns::Column& column) {
        return particles[Field::volume][p] * grid.dx * grid.dx / column.volume;
    };
    for (std::size_t p = first; p < particles.size(); ++p) {
        const Columns::Column column = columns.at(p);
        if (column.fraction > 1) area[p] = std::min(area[p], least(p, column));
    }
    columns.clear();
    for (const std::size_t p : near) columns.add(p);
    for (const std::size_t p : near) {
        const Columns::Column column = columns.at(p);
        const double bound = least(p, column) / k_max_depth_ratio;
        if (!(column.fraction > 1 && area[p] > bound)) continue;
        area[p] = std::max(area[p] / column.fraction, bound);
        changed.push_back(p);
    }
    return changed;
}

}  // namespace frana
