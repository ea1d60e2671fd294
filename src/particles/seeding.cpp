// SPDX-License-Identifier: Apache-2.0
#include "particles/seeding.h"

#include "particles/lattice_cover.h"

namespace frana {
namespace {

// Fraction of a lattice cell's area: at the edge of the material at rest a smaller particle is ejected by the surface
// slope at its only node.
constexpr double k_sliver = 1e-5;
// Fraction of the filled volume: an outline with more than this in slivers consists of little else, like that of a
// line.
constexpr double k_spread = 1e-4;

}  // namespace

void spread_slivers(std::size_t first, double spacing, ParticleSet& particles) {
    const auto is_sliver = [&](std::size_t p) { return particles[Field::area][p] < k_sliver * spacing * spacing; };
    struct Sums {
        double area = 0, volume = 0;
    } slivers, rest;
    for (std::size_t p = first; p < particles.size(); ++p) {
        Sums& of = is_sliver(p) ? slivers : rest;
        of.area += particles[Field::area][p];
        of.volume += particles[Field::volume][p];
    }
    if (slivers.area == 0 || slivers.area > k_spread * rest.area || slivers.volume > k_spread * rest.volume) return;
    std::size_t kept = first;
    for (std::size_t p = first; p < particles.size(); ++p) {
        if (is_sliver(p)) continue;
        ParticleRow row = particles.row(p);
        get(row, Field::area) *= 1 + slivers.area / rest.area;
        get(row, Field::volume) *= 1 + slivers.volume / rest.volume;
        particles.set_row(kept++, row);
    }
    particles.resize(kept);
}

double fill_outline(const MultiPolygon& outline, double spacing, const std::function<double(Point)>& thickness,
                    ParticleSet& particles) {
    LatticeCover cover(outline, spacing);
    const std::size_t first = particles.size();
    double volume = 0;
    for (std::int64_t row = cover.first_row(); row <= cover.last_row(); ++row) {
        for (const Covered& cell : cover.row(row)) {
            if (!(cell.area > 1e-9 * spacing * spacing)) continue;
            const Point centre{cell.moment_x / cell.area, cell.moment_y / cell.area};
            const double depth = thickness(centre);
            if (!(depth > 0)) continue;
            ParticleRow particle = ParticleSet::initial_row();
            get(particle, Field::x) = centre.x;
            get(particle, Field::y) = centre.y;
            get(particle, Field::area) = cell.area;
            get(particle, Field::volume) = depth * get(particle, Field::area);
            volume += get(particle, Field::volume);
            particles.push_back(particle);
        }
    }
    spread_slivers(first, spacing, particles);
    return volume;
}

}  // namespace frana
