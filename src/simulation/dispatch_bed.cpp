// SPDX-License-Identifier: Apache-2.0
#include "simulation/dispatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "mpm/bed_exchange.h"
#include "mpm/vector/kernels.h"
#include "params/keys/laws.h"
#include "physics/friction_voellmy.h"
#include "physics/laws.h"

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
    find_held_nodes<Slope>(range, update, SummedFriction<NoExcess>{NoExcess{}, states, friction.yields}, nodes);
}

template <class Slope>
NodeReport update_uniform(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction, BedState*,
                          double time, NodeGrid& nodes, Maxima& maxima) {
    return update_nodes<Slope>(range, update, UniformFriction{friction.voellmy}, time, nodes, maxima);
}

template <class Slope>
NodeReport update_summed(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction,
                         BedState* states, double time, NodeGrid& nodes, Maxima& maxima) {
    const auto update_by = [&](const auto& law) {
        return update_nodes<Slope>(range, update, law, time, nodes, maxima);
    };
    if (friction.excess.speed_after)
        return update_by(SummedFriction<ExcessLaw>{friction.excess, states, friction.yields});
    return update_by(SummedFriction<NoExcess>{NoExcess{}, states, friction.yields});
}

// The same by the fast kernels, where they compute a tile.
NodeReport fast_update_uniform(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction,
                               BedState* states, double time, NodeGrid& nodes, Maxima& maxima) {
    if (!four_at_a_time(range, nodes))
        return update_uniform<Curved<NormalSlope>>(range, update, friction, states, time, nodes, maxima);
    return vector_node_kernels()->uniform(range, update, UniformFriction{friction.voellmy}, time, nodes, maxima);
}

NodeReport fast_update_summed(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction,
                              BedState* states, double time, NodeGrid& nodes, Maxima& maxima) {
    if (friction.excess.speed_after || !four_at_a_time(range, nodes))
        return update_summed<Curved<NormalSlope>>(range, update, friction, states, time, nodes, maxima);
    return vector_node_kernels()->summed(range, update, {NoExcess{}, states, friction.yields}, time, nodes, maxima);
}

template <class Slope>
void choose_slope(bool summed, bool curved, Stages& stages) {
    if constexpr (Slope::metric && !Slope::curved) {
        if (curved) return choose_slope<Curved<Slope>>(summed, curved, stages);
    }
    if (summed) stages.fill_bed_states = fill_bed_states<Slope>;
    stages.find_held_nodes = summed ? rest_summed<Slope> : rest_uniform<Slope>;
    stages.update_nodes = summed ? update_summed<Slope> : update_uniform<Slope>;
}

// Returns the law of a word, or none.
template <class List>
auto exchange_law(const std::string& word, const Entrainment& entrainment, double density) {
    typename List::template Chosen<NoExchange> chosen;
    List::for_each([&]<class Law>() {
        if (word == Law::word) chosen = Law::build(all_values<List>(entrainment), density);
    });
    return chosen;
}

template <bool Metric>
decltype(BedExchange::at_nodes) exchange_stage(const Entrainment& entrainment, double density) {
    return [density, erosions = exchange_law<ErosionLaws>(entrainment.erosion, entrainment, density),
            depositions = exchange_law<DepositionLaws>(entrainment.deposition ? "on" : "off", entrainment, density),
            detrainments = exchange_law<DetrainmentLaws>(entrainment.detrainment ? "on" : "off", entrainment, density)](
               const NodeRange& range, double dt, double least_depth, const BedState* states, const NodeGrid& nodes,
               ErodibleBed* beds) {
        std::visit(
            [&](const auto& erosion, const auto& deposition) {
                exchange_at_nodes<Metric>(range, erosion, deposition, density, dt, least_depth, states, nodes, beds);
            },
            erosions, depositions);
        if (const auto* const forest = std::get_if<ForestDetrainment>(&detrainments))
            detrain_at_nodes<Metric>(range, *forest, dt, least_depth, nodes, beds);
    };
}

// Whether a law has an effect: some without their parameter have none and are omitted.
template <class Law, class Builder>
bool has_effect(const Builder& scene) {
    if constexpr (requires { Law::acts(scene); }) return Law::acts(scene);
    return true;
}

// Sets a value of every node, where its ground is read.
// @param value returns its place by node
void fill_nodes(NodeGrid& nodes, const Raster* raster, double uniform, const auto& value) {
    nodes.fill_with_ground([&nodes, raster, uniform, value](const NodeGrid::Block& block) {
        for (std::int64_t j = block.j0 - k_ghost; j < block.j1 - k_ghost; ++j)
            for (std::int64_t i = block.i0 - k_ghost; i < block.i1 - k_ghost; ++i)
                value(nodes.index(i, j)) = raster == nullptr ? uniform : node_value(*raster, uniform, i, j);
    });
}

// Converts the laws of a material to sweeps over the nodes. Laws read its public part.
class FrictionBuilder {
  public:
    FrictionBuilder(const Material& m, const MaterialZones& z, NodeGrid& nodes, double g)
        : material(values_of(m)), zones(z), gravity(g), words_(bed_friction_terms(m)), nodes_(nodes) {}

    const MaterialValues material;
    const MaterialZones& zones;
    const double gravity;  ///< [m/s2]
    NodeValue friction_coefficient() { return value(zones.friction_coefficient, material.bed_friction_coefficient()); }
    NodeValue turbulence() {
        return value(zones.turbulence, material.turbulence.value_or(std::numeric_limits<double>::infinity()));
    }
    NodeValue cohesion() { return value(zones.cohesion, material.cohesion.value_or(0)); }

    BedFriction build() {
        for (const std::string& word : words_)
            BedLaws::for_each([&]<class Law>() {
                if (word != Law::word || !has_effect<Law>(*this)) return;
                add(Law::build(*this));
                if (Law::row().resists_with_friction) friction_.coefficient = friction_coefficient();
            });
        friction_.summed = true;
        return std::move(friction_);
    }

  private:
    NodeValue value(const std::optional<Raster>& raster, double uniform) {
        if (!raster) return {uniform};
        double* const values = friction_.node_values.emplace_back(nodes_.bed.size()).data();
        fill_nodes(nodes_, &*raster, uniform, [values](std::size_t node) -> double& { return values[node]; });
        return {uniform, values};
    }
    void add(const auto& law) {
        if constexpr (requires { law.speed_after(BedState{}, 0, 0.0, 0.0); }) {
            friction_.excess.speed_after = [law](const BedState& bed, std::size_t node, double left, double dt) {
                return law.speed_after(bed, node, left, dt);
            };
            friction_.yields = true;
        } else {
            friction_.yields |= law.yields();
        }
        friction_.sweeps.emplace_back([law](const NodeRange& range, const NodeGrid& nodes, BedState* states) {
            add_friction(range, law, nodes, states);
        });
    }

    std::vector<std::string> words_;  ///< of the material's laws
    NodeGrid& nodes_;
    BedFriction friction_;
};

}  // namespace

bool acts(const std::string& word, const Material& material, const MaterialZones& zones) {
    struct {
        MaterialValues material;
        const MaterialZones& zones;
    } const scene{values_of(material), zones};
    bool effect = false;
    BedLaws::for_each([&]<class Law>() { effect |= word == Law::word && has_effect<Law>(scene); });
    return effect;
}

bool sums_friction(const Material& material, const MaterialZones& zones, const Entrainment& entrainment) {
    const std::vector<std::string> terms = bed_friction_terms(material);
    const bool only_voellmy = std::all_of(terms.begin(), terms.end(), [](const std::string& word) {
        return word == CoulombFriction::word || word == TurbulentFriction::word;
    });
    const bool by_place =
        std::any_of(std::begin(k_zone_rasters), std::end(k_zone_rasters),
                    [&](const ZoneRaster& zone) { return zone.of_bed_friction && (zones.*zone.raster).has_value(); });
    return !only_voellmy || by_place || pore_pressure_of(material).active() ||
           material.of<CoulombFriction>().surface_pressure > 0 || entrainment.active();
}

void choose_node_stages(const Numerics& numerics, bool summed, Stages& stages) {
    switch (slope_correction(numerics)) {
        case SlopeCorrection::automatic:  // resolved
        case SlopeCorrection::none:
            return choose_slope<GentleSlope>(summed, false, stages);
        case SlopeCorrection::surface:
            return choose_slope<SurfaceSlope>(summed, curvature(numerics), stages);
        case SlopeCorrection::normal:
            return choose_slope<NormalSlope>(summed, curvature(numerics), stages);
    }
}

void use_fast_node_stages(const Numerics& numerics, bool summed, Stages& stages) {
    stages.fast_nodes = vector_node_kernels();
    if (!curvature(numerics) || slope_correction(numerics) != SlopeCorrection::normal) return;
    stages.update_nodes = summed ? fast_update_summed : fast_update_uniform;
}

void choose_pore_pressure(const Material& material, const Numerics& numerics, Stages& stages) {
    const PorePressure law = pore_pressure_of(material);
    if (!law.active()) return;
    stages.fields = stages.fields | FieldMask{Field::pore_pressure};
    if (law.dilates()) stages.fields = stages.fields | FieldMask{Field::solid_fraction};
    const bool metric = slope_correction(numerics) != SlopeCorrection::none;
    if (numerics.scheme == Scheme::paper)
        stages.pore_pressure_to_nodes =
            metric ? pore_pressure_to_nodes<HatShape, true> : pore_pressure_to_nodes<HatShape, false>;
    else
        stages.pore_pressure_to_nodes = metric ? pore_pressure_to_nodes<QuadraticSplineShape, true>
                                               : pore_pressure_to_nodes<QuadraticSplineShape, false>;
}

BedFriction make_friction(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
                          NodeGrid& nodes, double gravity) {
    BedFriction friction;
    if (sums_friction(material, zones, entrainment))
        friction = FrictionBuilder(material, zones, nodes, gravity).build();
    const std::vector<std::string> terms = bed_friction_terms(material);
    const auto has = [&](const char* word) { return std::find(terms.begin(), terms.end(), word) != terms.end(); };
    if (has(CoulombFriction::word))
        friction.voellmy.friction_coefficient = friction_coefficient_of(material).value_or(0);
    if (has(TurbulentFriction::word))
        friction.voellmy.inverse_turbulence = material.of<TurbulentFriction>().inverse_turbulence();
    if (!friction.summed) friction.coefficient = {friction.voellmy.friction_coefficient};
    friction.pore_pressure = pore_pressure_of(material);
    return friction;
}

BedExchange make_exchange(const Entrainment& entrainment, const Material& material, const Numerics& numerics) {
    BedExchange laws;
    const double density = laws.density = material.density;
    const PorePressure pores = pore_pressure_of(material);
    const double at_rest = pores.dissipates() ? pores.hydrostatic : pores.initial.ratio;
    laws.bed = {entrainment.of<MechanicalErosion>().bed_pore_pressure_ratio.value_or(at_rest),
                pores.initial.solid_fraction};
    if (entrainment.active())
        laws.at_nodes = slope_correction(numerics) == SlopeCorrection::none
                            ? exchange_stage<false>(entrainment, density)
                            : exchange_stage<true>(entrainment, density);
    return laws;
}

PlaneStressLaw make_stress(const Material& material, double gravity) {
    PlaneStressLaw stress;
    const std::string word = in_plane_stress(material);
    const MaterialValues values = values_of(material);
    StressLaws::for_each([&]<class Law>() {
        if (word != Law::word || !has_effect<Law>(values)) return;
        const Law law = Law::build(values, gravity);
        stress = {law, law.wave_factor()};
    });
    return stress;
}

// `beds` stays where it is, though a saved state may replace its content.
void set_erodible_beds(const Entrainment& entrainment, const MaterialZones& zones, NodeGrid& nodes,
                       ZeroArray<ErodibleBed>& beds) {
    beds = ZeroArray<ErodibleBed>(nodes.bed.size());
    const auto fill = [&](double ErodibleBed::*value, const std::optional<Raster>& zones_of, double uniform) {
        fill_nodes(nodes, zones_of ? &*zones_of : nullptr, uniform,
                   [&beds, value](std::size_t node) -> double& { return beds[node].*value; });
    };
    if (entrainment.erodes())
        fill(&ErodibleBed::erodible, zones.erodible_depth, entrainment.erodible_depth.value_or(0));
    if (entrainment.detrainment)
        fill(&ErodibleBed::forest, zones.detrainment_coefficient,
             entrainment.of<ForestDetrainment>().detrainment_coefficient.value_or(0));
}

double node_value(const Raster& raster, double uniform, std::int64_t i, std::int64_t j) {
    const GridSpec& grid = raster.grid;
    const double here = raster.at(grid.rows - 1 - std::clamp<std::int64_t>(j, 0, grid.rows - 1),
                                  std::clamp<std::int64_t>(i, 0, grid.columns - 1));
    return std::isnan(here) ? uniform : here;
}

}  // namespace frana
