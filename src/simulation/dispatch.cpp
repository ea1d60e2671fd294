// SPDX-License-Identifier: Apache-2.0
#include "simulation/dispatch.h"

#include <algorithm>

#include "mpm/bed_exchange.h"
#include "mpm/particles_to_nodes.h"
#include "mpm/pressure.h"
#include "mpm/vector/kernels.h"
#include "mpm/vector/stress_kernels.h"
#include "physics/law.h"

namespace frana {

using namespace voellmy_bingham;

namespace {

// Film: thinner than this times numerics.minimum-depth, and than this many metres. Half of the particles on real
// slopes.
constexpr double k_film = 10, k_thickest_film = 0.1;
// Of fewer particles per cell none can be spared.
constexpr int k_least_seeded_of_film = 4;

template <class Stress>
const Stress& law_of(const PlaneStressLaw& stress) {
    if constexpr (Stress::active) {
        return *stress.law.target<Stress>();
    } else {
        static constexpr NoStress none;
        return none;
    }
}

// Calls visit.operator()<Stress>() for the type of the law.
void visit_stress(const PlaneStressLaw& stress, const auto& visit) {
    if (!stress.law) return visit.template operator()<NoStress>();
    StressLaws::for_each([&]<class Law>() {
        if (stress.law.target<Law>() != nullptr) visit.template operator()<Law>();
    });
}

template <class Shape, class Transfer, class Stress, bool Relaxed>
ParticleReport nodes_to_particles_stage(const ParticleTile& tile, const ParticleUpdate& update,
                                        const PlaneStressLaw& stress, const NodeGrid& nodes, ParticleSet& particles) {
    return nodes_to_particles<Shape, Transfer, Stress, Relaxed>(tile, update, law_of<Stress>(stress), nodes, particles);
}

// 18 of nodes_to_particles (physics/stress_laws.h), 4 of each of the other particle stages.
template <class Shape, bool Relaxed, class Transfer>
void choose_transfer(const PlaneStressLaw& stress, Stages& stages) {
    stages.particles_to_nodes = stages.references ? particles_to_nodes<Shape, Transfer::affine, true>
                                                  : particles_to_nodes<Shape, Transfer::affine, false>;
    visit_stress(stress, [&]<class Stress>() {
        stages.nodes_to_particles = nodes_to_particles_stage<Shape, Transfer, Stress, Relaxed>;
    });
    if (Transfer::affine) stages.fields = stages.fields | k_affine_fields;
}

template <class Shape, bool Relaxed>
void choose_scheme(Transfer transfer, const PlaneStressLaw& stress, Stages& stages) {
    stages.pressure_to_nodes =
        stress.law ? pressure_to_nodes<Shape, Relaxed, true> : pressure_to_nodes<Shape, Relaxed, false>;
    stages.exchange_with_particles = exchange_with_particles<Shape>;
    if (Relaxed) stages.fields = stages.fields | FieldMask{Field::compression};
    if (stress.law) stages.fields = stages.fields | k_stress_fields;
    switch (transfer) {
        case Transfer::pic:
        case Transfer::flip:
            return choose_transfer<Shape, Relaxed, PicTransfer>(stress, stages);
        case Transfer::automatic:  // resolved before
        case Transfer::apic:
            return choose_transfer<Shape, Relaxed, ApicTransfer>(stress, stages);
    }
}

template <class Stress>
ParticleReport fast_nodes_to_particles_stage(const ParticleTile& tile, const ParticleUpdate& update,
                                             const PlaneStressLaw& stress, const NodeGrid& nodes,
                                             ParticleSet& particles) {
    return vector_kernels()->nodes_to_particles.of<Stress>()(tile, update, law_of<Stress>(stress), nodes, particles);
}

// Selects the default scheme's kernels over particles for this processor.
void use_vector_kernels(const VectorKernels& kernels, const PlaneStressLaw& stress, Stages& stages) {
    stages.particles_to_nodes = stages.references ? kernels.particles_and_levels_to_nodes : kernels.particles_to_nodes;
    stages.pressure_to_nodes = stress.law ? kernels.pressure_and_stress_to_nodes : kernels.pressure_to_nodes;
    visit_stress(stress, [&]<class Stress>() { stages.nodes_to_particles = fast_nodes_to_particles_stage<Stress>; });
}

}  // namespace

Stages choose_stages(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
                     const Numerics& numerics, Kernels kernels) {
    Stages stages;
    stages.fields = k_basic_fields;
    stages.follows_bed = curvature(numerics);
    const PlaneStressLaw stress = make_stress(material, numerics.gravity);
    const Transfer transfer = transfer_of(numerics);
    if (numerics.scheme == Scheme::paper) {
        choose_scheme<HatShape, false>(transfer, stress, stages);
    } else {
        stages.references = well_balanced(numerics);
        stages.leapfrog = true;
        choose_scheme<QuadraticSplineShape, true>(transfer, stress, stages);
        // APIC takes from the particles in a step what no linear velocity about a node holds. Shorter steps would take
        // it more often: they take a part, so that the same is taken in the same time.
        if (transfer == Transfer::apic)
            stages.kept = std::max(0.0, 1 - courant_number(numerics, material) / default_courant(true));
        stages.resamples = transfer == Transfer::apic;  // the particles' shape follows the affine velocity
        if (stages.resamples) stages.fields = stages.fields | k_shape_fields;
        stages.flies = flight(numerics);
        if (stages.flies) stages.fields = stages.fields | FieldMask{Field::flown};
    }
    if (transfer == Transfer::flip) stages.kept = 1;
    const bool summed = sums_friction(material, zones, entrainment);
    choose_node_stages(numerics, summed, stages);
    choose_pore_pressure(material, numerics, stages);
    const VectorKernels* fast = kernels == Kernels::fastest ? vector_kernels() : nullptr;
    if (fast && numerics.scheme == Scheme::standard && transfer == Transfer::apic) {
        use_vector_kernels(*fast, stress, stages);
        if (stages.references) use_fast_node_stages(numerics, summed, stages);
    }
    return stages;
}

Laws make_laws(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
               const Numerics& numerics, NodeGrid& nodes, double gravity) {
    Laws laws;
    laws.gravity = gravity;
    laws.stress = make_stress(material, gravity);
    laws.step.cfl = courant_number(numerics, material);
    laws.step.by_wave = numerics.scheme == Scheme::standard;
    laws.minimum_depth = numerics.minimum_depth;
    laws.wall = numerics.boundary == Boundary::wall;
    laws.friction = make_friction(material, zones, entrainment, nodes, gravity);
    laws.exchange = make_exchange(entrainment, material, numerics);
    laws.jumps = {gravity,
                  laws.wall,
                  std::atan(tangent_of(numerics.flight_angle)),
                  0.5 * numerics.flight_drag * k_air_density / material.density,
                  laws.friction.coefficient,
                  numerics.flight_clearance,
                  numerics.minimum_depth};
    laws.resample.cell_size = nodes.cell_size();
    // Splitting later loses a tenth of the accuracy on dry fronts, merging earlier some of it behind bores
    // (share/doc/numerics.md, "Speed").
    const int seeded = numerics.particles_per_cell;
    laws.resample.flow.split_below = (3 * seeded + 1) / 2;
    laws.resample.flow.most = std::max(4, (5 * seeded + 1) / 2);  // the four parts of a split particle do not merge
    laws.resample.film.split_below = seeded / 2;
    laws.resample.film.most = 3 * seeded / 4;
    laws.resample.tail.split_below = 3 * seeded / 4;
    laws.resample.tail.most = seeded;
    if (seeded >= k_least_seeded_of_film)
        laws.resample.film_depth = std::min(k_film * numerics.minimum_depth, k_thickest_film);
    return laws;
}

}  // namespace frana
