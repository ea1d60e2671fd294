// SPDX-License-Identifier: Apache-2.0
#include "models/structured/coupling/release.h"

#include <vector>

#include "models/structured/fluid/fluid_step.h"
#include "models/structured/solid/cubic_stencil.h"

namespace frana::structured {

namespace {

/// Sixteen from each particle: all at once would be as much memory as the particles.
constexpr std::size_t k_most_sources = 16'384;

}  // namespace

Released release_fluid(SolidState& solid, const NodeGrid& grid, const FluidLaws& laws, FluidState& fluid) {
    ParticleSet& particles = solid.particles;
    const double inverse_area = 1 / (grid.cell_size() * grid.cell_size());
    std::vector<FluidSource> sources;
    Released released;
    double refused = 0;  // [m], over a cell
    const auto pass_on = [&] {
        refused += receive(sources, fluid, laws);
        sources.clear();
    };
    for (std::size_t p = 0; p < particles.size(); ++p) {
        double& volume = particles[Field::released][p];
        if (particles[Field::cohesion_ratio][p] == 0)
            volume = particles[Field::confined][p];  // all of it, including what rounding left
        if (!(volume > 0)) continue;
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
        if (sources.size() > k_most_sources) pass_on();
    }
    pass_on();
    released.inside -= refused / inverse_area;
    released.outside += refused / inverse_area;
    return released;
}

}  // namespace frana::structured
