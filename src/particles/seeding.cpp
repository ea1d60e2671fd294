// SPDX-License-Identifier: Apache-2.0
#include "particles/seeding.h"

#include "particles/lattice_cover.h"

namespace frana {

double fill_outline(const MultiPolygon& outline, double spacing,
                    const std::function<double(Point)>& thickness, ParticleSet& particles) {
    LatticeCover cover(outline, spacing);
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
    return volume;
}

}  // namespace frana
