// SPDX-License-Identifier: Apache-2.0
#include "models/structured/coupling/release.h"

#include <vector>

#include "models/structured/fluid/fluid_step.h"
#include "models/structured/solid/cubic_stencil.h"

namespace frana::structured {

Released release_fluid(SolidState& solid, const NodeGrid& grid, const FluidLaws& laws, FluidState& fluid) {
    ParticleSet& particles = solid.particles;
    const double inverse_area = 1 / (grid.cell_size() * grid.cell_size());
    std::vector<FluidSource> sources;
    Released released;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        double& volume = particles[Field::released][p];
        if (!(volume > 0)) continue;
        if (particles[Field::cohesion_ratio][p] == 0)
            volume = particles[Field::confined][p];  // all of it, including what rounding left
        const CubicStencil stencil(particles[Field::x][p], particles[Field::y][p], grid, solid.nodes);
        (stencil.any ? released.inside : released.outside) += volume;
        for (std::size_t b = 0; stencil.any && b < 4; ++b) {
            for (std::size_t a = 0; a < 4; ++a) {
                const double w = stencil.weight[b][a] * inverse_area;
                if (!(w > 0)) continue;
                const std::size_t cell = stencil.first + b * static_cast<std::size_t>(grid.stride()) + a;
                const double depth = w * volume;
                sources.push_back({cell, depth, depth * particles[Field::u][p], depth * particles[Field::v][p]});
            }
        }
        particles[Field::confined][p] -= volume;
        volume = 0;
    }
    const double refused = receive(sources, fluid, grid, laws) / inverse_area;
    released.inside -= refused;
    released.outside += refused;
    return released;
}

}  // namespace frana::structured
