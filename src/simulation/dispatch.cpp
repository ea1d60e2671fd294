// SPDX-License-Identifier: Apache-2.0
#include "simulation/dispatch.h"

#include <cmath>

#include "mpm/particles_to_nodes.h"
#include "mpm/pressure.h"
#include "mpm/vector/kernels.h"

namespace frana {

using namespace voellmy_bingham;

namespace {

template <class Slope>
NodeReport update_nodes_stage(const NodeRange& range, const NodeUpdate& update,
                              const VoellmyFriction& friction, double time, NodeGrid& nodes, Maxima& maxima) {
    return update_nodes<Slope>(
        range, update, friction, nodes,
        [&](std::size_t node, double depth, double speed) { maxima.see(node, depth, speed, time); });
}

template <class Slope>
void choose_slope(Stages& stages) {
    stages.hold_nodes = hold_nodes<Slope>;
    stages.update_nodes = update_nodes_stage<Slope>;
}

template <class Shape, class Transfer, bool Stress, bool Relaxed>
ParticleReport nodes_to_particles_stage(const ParticleTile& tile, const ParticleUpdate& update,
                                        const BinghamStress& stress, const NodeGrid& nodes,
                                        ParticleSet& particles) {
    if constexpr (Stress) {
        return nodes_to_particles<Shape, Transfer, BinghamStress, Relaxed>(tile, update, stress, nodes,
                                                                           particles);
    } else {
        return nodes_to_particles<Shape, Transfer, NoStress, Relaxed>(tile, update, NoStress{}, nodes,
                                                                      particles);
    }
}

// 2 schemes x 3 transfers x 2 stresses = 12 of nodes_to_particles, 4 of each of the other particle stages.
template <class Shape, bool Relaxed, class Transfer>
void choose_transfer(bool stress, Stages& stages) {
    stages.particles_to_nodes = stages.references ? particles_to_nodes<Shape, Transfer::affine, true>
                                                  : particles_to_nodes<Shape, Transfer::affine, false>;
    stages.nodes_to_particles = stress ? nodes_to_particles_stage<Shape, Transfer, true, Relaxed>
                                       : nodes_to_particles_stage<Shape, Transfer, false, Relaxed>;
    if (Transfer::affine) stages.fields = stages.fields | k_affine_fields;
}

template <class Shape, bool Relaxed>
void choose_scheme(Transfer transfer, bool stress, Stages& stages) {
    stages.pressure_to_nodes =
        stress ? pressure_to_nodes<Shape, Relaxed, true> : pressure_to_nodes<Shape, Relaxed, false>;
    if (Relaxed) stages.fields = stages.fields | FieldMask{Field::compression};
    if (stress) stages.fields = stages.fields | k_stress_fields;
    switch (transfer) {
        case Transfer::pic:
            return choose_transfer<Shape, Relaxed, PicTransfer>(stress, stages);
        case Transfer::flip:
            return choose_transfer<Shape, Relaxed, FlipTransfer>(stress, stages);
        case Transfer::apic:
            return choose_transfer<Shape, Relaxed, ApicTransfer>(stress, stages);
    }
}

// The default scheme's sweeps over particles, for what this processor can do.
void use_vector_kernels(const VectorKernels& kernels, bool stress, Stages& stages) {
    stages.particles_to_nodes =
        stages.references ? kernels.particles_and_levels_to_nodes : kernels.particles_to_nodes;
    stages.pressure_to_nodes = stress ? kernels.pressure_and_stress_to_nodes : kernels.pressure_to_nodes;
    stages.nodes_to_particles = stress ? kernels.nodes_to_particles_with_stress : kernels.nodes_to_particles;
}

bool has_stress(const Material& material) {
    return material.viscosity > 0 || material.yield_stress > 0;
}

Transfer transfer_of(const Numerics& numerics) {
    return numerics.transfer.value_or(numerics.scheme == Scheme::paper ? Transfer::pic : Transfer::apic);
}

}  // namespace

Stages choose_stages(const Material& material, const Numerics& numerics, Kernels kernels) {
    Stages stages;
    stages.fields = k_basic_fields;
    const Transfer transfer = transfer_of(numerics);
    if (numerics.scheme == Scheme::paper) {
        choose_scheme<HatShape, false>(transfer, has_stress(material), stages);
    } else {
        stages.references = numerics.well_balanced;
        stages.leapfrog = true;
        choose_scheme<QuadraticSplineShape, true>(transfer, has_stress(material), stages);
        stages.resamples = transfer == Transfer::apic;  // the particles' shape follows the affine velocity
        if (stages.resamples) stages.fields = stages.fields | k_shape_fields;
    }
    const VectorKernels* fast = kernels == Kernels::fastest ? vector_kernels() : nullptr;
    if (fast && numerics.scheme == Scheme::standard && transfer == Transfer::apic) {
        use_vector_kernels(*fast, has_stress(material), stages);
    }
    switch (numerics.slope_correction) {
        case SlopeCorrection::none:
            choose_slope<GentleSlope>(stages);
            break;
        case SlopeCorrection::surface:
            choose_slope<SurfaceSlope>(stages);
            break;
        case SlopeCorrection::normal:
            choose_slope<NormalSlope>(stages);
            break;
    }
    return stages;
}

Laws make_laws(const Material& material, const Numerics& numerics, double cell_size) {
    Laws laws;
    laws.gravity = numerics.gravity;
    laws.cfl = numerics.cfl;
    laws.minimum_depth = numerics.minimum_depth;
    laws.wall = numerics.boundary == Boundary::wall;
    laws.friction.friction_coefficient = material.friction_coefficient;
    laws.friction.inverse_turbulence = std::isfinite(material.turbulence) ? 1 / material.turbulence : 0;
    laws.friction.pressure_over_density = material.surface_pressure / material.density;
    laws.stress.viscosity_over_density = material.viscosity / material.density;
    laws.stress.yield_over_density = material.yield_stress / material.density;
    laws.stress.regularisation = material.yield_regularisation;
    laws.stress.exact_ratio = material.exact_yield_ratio;
    laws.resample.cell_size = cell_size;
    laws.resample.split_below = (3 * numerics.particles_per_cell + 1) / 2;
    laws.resample.max_per_cell = 3 * numerics.particles_per_cell;
    return laws;
}

std::vector<std::string> list_terms(const Material& material, const Numerics& numerics) {
    std::vector<std::string> terms{"hydrostatic pressure", "bed slope"};
    if (numerics.slope_correction == SlopeCorrection::normal) terms.push_back("slope correction: normal");
    if (numerics.slope_correction == SlopeCorrection::surface) terms.push_back("slope correction: surface");
    if (material.friction_coefficient > 0) terms.push_back("Coulomb bed friction");
    if (std::isfinite(material.turbulence)) terms.push_back("turbulent bed friction");
    if (material.surface_pressure > 0 && material.friction_coefficient > 0)
        terms.push_back("surface pressure");
    if (material.viscosity > 0) terms.push_back("in-plane viscosity");
    if (material.yield_stress > 0) terms.push_back("in-plane yield stress");
    static constexpr const char* k_transfers[] = {"PIC", "FLIP", "APIC"};
    const char* transfer = k_transfers[static_cast<int>(transfer_of(numerics))];
    if (numerics.scheme == Scheme::paper) {
        terms.push_back(std::string("bilinear shape functions, ") + transfer);
    } else {
        terms.push_back(std::string("quadratic B-splines, ") + transfer);
        if (numerics.well_balanced) terms.push_back("reference level per node");
        terms.push_back("area relaxation");
        terms.push_back("compressive artificial viscosity");
        if (transfer_of(numerics) == Transfer::apic) terms.push_back("splitting and merging");
    }
    return terms;
}

}  // namespace frana
