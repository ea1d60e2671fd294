// SPDX-License-Identifier: Apache-2.0
#include "simulation/dispatch_bed.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mpm/bed_exchange.h"
#include "physics/friction_chezy.h"
#include "physics/friction_cohesion.h"
#include "physics/friction_coulomb.h"
#include "physics/friction_manning.h"
#include "physics/friction_obrien_julien.h"
#include "physics/friction_ramms_yield.h"
#include "physics/friction_turbulence.h"

namespace frana {

using namespace voellmy_bingham;

namespace {

template <class Slope>
void rest_uniform(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction, BedState*,
                  NodeGrid& nodes) {
    find_held_nodes<Slope>(range, update, UniformFriction{friction.voellmy}, nodes);
}

template <class Slope>
void rest_summed(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction, BedState* states,
                 NodeGrid& nodes) {
    const NoExcess none;
    find_held_nodes<Slope>(range, update, SummedFriction<NoExcess>{none, states, friction.yields}, nodes);
}

template <class Slope>
NodeReport update_uniform(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction, BedState*,
                          double time, NodeGrid& nodes, Maxima& maxima) {
    return update_nodes<Slope>(
        range, update, UniformFriction{friction.voellmy}, nodes,
        [&](std::size_t node, double depth, double speed) { maxima.update(node, depth, speed, time); });
}

template <class Slope, class Excess>
NodeReport update_summed(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction,
                         BedState* states, double time, NodeGrid& nodes, Maxima& maxima) {
    Excess excess = std::get<Excess>(friction.excess);
    if constexpr (requires { excess.effective_fraction; }) excess.effective_fraction = update.effective_fraction;
    return update_nodes<Slope>(
        range, update, SummedFriction<Excess>{excess, states, friction.yields}, nodes,
        [&](std::size_t node, double depth, double speed) { maxima.update(node, depth, speed, time); });
}

// 5 slopes uniform; 5 slopes x 4 excess laws = 20 summed.
template <class Slope>
void choose_summed(const Material& material, Stages& stages) {
    stages.fill_bed_states = fill_bed_states<Slope>;
    stages.find_held_nodes = rest_summed<Slope>;
    if (material.has("herschel-bulkley") || (material.has("bingham") && material.exact_yield_ratio)) {
        stages.update_nodes = update_summed<Slope, HerschelBulkleyExcess>;
    } else if (material.has("bingham")) {
        stages.update_nodes = update_summed<Slope, BinghamQuadraticExcess>;
    } else if (material.has("pouliquen-forterre")) {
        stages.update_nodes = update_summed<Slope, PouliquenForterreExcess>;
    } else {
        stages.update_nodes = update_summed<Slope, NoExcess>;
    }
}

template <class Slope>
void choose_slope(const Material& material, bool summed, bool curved, Stages& stages) {
    if constexpr (Slope::metric && !Slope::curved) {
        if (curved) return choose_slope<Curved<Slope>>(material, summed, curved, stages);
    }
    if (summed) return choose_summed<Slope>(material, stages);
    stages.find_held_nodes = rest_uniform<Slope>;
    stages.update_nodes = update_uniform<Slope>;
}

template <class Law>
Law law_of(const BedExchange& laws) {
    if constexpr (std::is_same_v<Law, ShearStressErosion>) {
        return laws.shear_stress;
    } else if constexpr (std::is_same_v<Law, GrowthErosion>) {
        return laws.growth;
    } else if constexpr (std::is_same_v<Law, MechanicalErosion>) {
        return laws.mechanical;
    } else if constexpr (std::is_same_v<Law, ShearStressDeposition>) {
        return laws.deposition;
    } else {
        return NoExchange{};
    }
}

template <bool Metric, class Erosion, class Deposition>
void exchange_stage(const NodeRange& range, const BedExchange& laws, double dt, double least_depth,
                    const BedState* states, const NodeGrid& nodes, ErodibleBed* beds) {
    exchange_at_nodes<Metric>(range, law_of<Erosion>(laws), law_of<Deposition>(laws), laws.density, dt, least_depth,
                              states, nodes, beds);
}

// 2 metrics x 4 laws of erosion x 2 of deposition = 16.
template <bool Metric, class Erosion>
void choose_deposition(bool deposition, Stages& stages) {
    stages.exchange_at_nodes = deposition ? exchange_stage<Metric, Erosion, ShearStressDeposition>
                                          : exchange_stage<Metric, Erosion, NoExchange>;
}

template <bool Metric>
void choose_erosion(const Entrainment& entrainment, Stages& stages) {
    const bool deposition = entrainment.deposition;
    if (!entrainment.erodes()) return choose_deposition<Metric, NoExchange>(deposition, stages);
    if (entrainment.erosion == "shear-stress") return choose_deposition<Metric, ShearStressErosion>(deposition, stages);
    if (entrainment.erosion == "growth") return choose_deposition<Metric, GrowthErosion>(deposition, stages);
    if (entrainment.erosion == "mechanical") return choose_deposition<Metric, MechanicalErosion>(deposition, stages);
    throw std::out_of_range("no law of erosion " + entrainment.erosion);
}

// Converts the laws of a material to sweeps over the nodes.
class FrictionBuilder {
  public:
    FrictionBuilder(const Material& material, const MaterialZones& zones, NodeGrid& nodes, double gravity)
        : material_(material), zones_(zones), nodes_(nodes), gravity_(gravity) {}

    BedFriction build() {
        for (const std::string& law : material_.bed_friction)
            if (acts(law, material_, zones_)) add(law);
        friction_.summed = true;
        return std::move(friction_);
    }

  private:
    NodeValue value(const std::optional<Raster>& raster, double uniform) {
        if (!raster) return {uniform};
        double* const values = friction_.node_values.emplace_back(nodes_.bed.size()).data();
        nodes_.fill_with_ground([&nodes = nodes_, &from = *raster, uniform, values](const NodeGrid::Block& block) {
            for (std::int64_t j = block.j0 - k_ghost; j < block.j1 - k_ghost; ++j)
                for (std::int64_t i = block.i0 - k_ghost; i < block.i1 - k_ghost; ++i)
                    values[nodes.index(i, j)] = node_value(from, uniform, i, j);
        });
        return {uniform, values};
    }
    NodeValue coefficient() { return value(zones_.friction_coefficient, material_.friction_coefficient); }
    // `yields`: the law holds material at rest.
    template <class Law>
    void sweep(const Law& law, bool yields) {
        friction_.yields |= yields;
        friction_.sweeps.emplace_back([law](const NodeRange& range, const NodeUpdate& update, const NodeGrid& nodes,
                                            BedState* states) { add_friction(range, update, law, nodes, states); });
    }
    template <class Law>
    void excess(const Law& law) {
        std::get<Law>(friction_.excess) = law;
        sweep(law, true);
    }
    void add(const std::string& law);

    const Material& material_;
    const MaterialZones& zones_;
    NodeGrid& nodes_;
    double gravity_;
    BedFriction friction_;
};

// Adds a law by its word in params/keys/laws.cpp.
void FrictionBuilder::add(const std::string& law) {
    const Material& m = material_;
    if (law == "coulomb") return sweep(CoulombFriction{coefficient(), 1, m.surface_pressure / m.density}, true);
    if (law == "turbulence") return sweep(TurbulentFriction{gravity_, value(zones_.turbulence, m.turbulence)}, false);
    if (law == "cohesion") return sweep(CohesiveFriction{m.density, value(zones_.cohesion, m.cohesion)}, true);
    if (law == "ramms-yield") return sweep(RammsYield{m.density, m.ramms_yield_stress, coefficient()}, true);
    if (law == "bingham" && !m.exact_yield_ratio)
        return excess(BinghamQuadraticExcess{m.density, m.yield_stress, m.viscosity});
    if (law == "bingham") return excess(HerschelBulkleyExcess{m.density, m.yield_stress, m.viscosity, 1});
    if (law == "herschel-bulkley")
        return excess(HerschelBulkleyExcess{m.density, m.yield_stress, m.consistency, m.flow_index});
    if (law == "obrien-julien")
        return sweep(
            OBrienJulienFriction{gravity_, m.density, m.yield_stress, m.viscosity, m.laminar_resistance, m.manning},
            m.yield_stress > 0);
    if (law == "manning") return sweep(ManningFriction{gravity_, m.manning}, false);
    if (law == "chezy") return sweep(ChezyFriction{gravity_, m.chezy}, false);
    if (law == "pouliquen-forterre")
        return excess(
            PouliquenForterreExcess{coefficient(), m.fast_friction_coefficient, m.friction_beta, m.friction_length});
    throw std::out_of_range("no law of bed friction " + law);
}

}  // namespace

bool acts(const std::string& law, const Material& material, const MaterialZones& zones) {
    if (law == "coulomb") return material.friction_coefficient > 0 || zones.friction_coefficient;
    if (law == "turbulence") return std::isfinite(material.turbulence) || zones.turbulence;
    return true;
}

bool sums_friction(const Material& material, const MaterialZones& zones, const Entrainment& entrainment) {
    const bool only_voellmy =
        std::all_of(material.bed_friction.begin(), material.bed_friction.end(),
                    [](const std::string& law) { return law == "coulomb" || law == "turbulence"; });
    const bool by_place =
        std::any_of(std::begin(k_zone_rasters), std::end(k_zone_rasters),
                    [&](const ZoneRaster& zone) { return zone.of_bed_friction && (zones.*zone.raster).has_value(); });
    return !only_voellmy || by_place || material.pore_pressure_ratio > 0 || material.surface_pressure > 0 ||
           entrainment.active();
}

void choose_node_stages(const Material& material, const Numerics& numerics, bool summed, Stages& stages) {
    switch (numerics.slope_correction) {
        case SlopeCorrection::none:
            return choose_slope<GentleSlope>(material, summed, numerics.curvature, stages);
        case SlopeCorrection::surface:
            return choose_slope<SurfaceSlope>(material, summed, numerics.curvature, stages);
        case SlopeCorrection::normal:
            return choose_slope<NormalSlope>(material, summed, numerics.curvature, stages);
    }
}

void choose_exchange(const Entrainment& entrainment, const Numerics& numerics, Stages& stages) {
    if (!entrainment.active()) return;
    if (numerics.slope_correction == SlopeCorrection::none) {
        choose_erosion<false>(entrainment, stages);
    } else {
        choose_erosion<true>(entrainment, stages);
    }
}

BedFriction make_friction(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
                          NodeGrid& nodes, double gravity) {
    BedFriction friction;
    if (sums_friction(material, zones, entrainment))
        friction = FrictionBuilder(material, zones, nodes, gravity).build();
    if (material.has("coulomb")) friction.voellmy.friction_coefficient = material.friction_coefficient;
    if (material.has("turbulence") && std::isfinite(material.turbulence))
        friction.voellmy.inverse_turbulence = 1 / material.turbulence;
    friction.pore_pressure = {material.pore_pressure_ratio, material.pore_dissipation_time};
    return friction;
}

BedExchange make_exchange(const Entrainment& entrainment, double density) {
    BedExchange laws;
    laws.density = density;
    laws.shear_stress = {entrainment.erosion_rate, entrainment.critical_shear, entrainment.potential_depth};
    laws.growth = {entrainment.growth_rate};
    laws.mechanical = {density, entrainment.bed_friction_coefficient, entrainment.bed_cohesion,
                       entrainment.bed_pore_pressure_ratio, entrainment.velocity_ratio};
    laws.deposition = {entrainment.deposition_rate, entrainment.deposition_shear};
    return laws;
}

double node_value(const Raster& raster, double uniform, std::int64_t i, std::int64_t j) {
    const GridSpec& grid = raster.grid;
    const double here = raster.at(grid.rows - 1 - std::clamp<std::int64_t>(j, 0, grid.rows - 1),
                                  std::clamp<std::int64_t>(i, 0, grid.columns - 1));
    return std::isnan(here) ? uniform : here;
}

}  // namespace frana
