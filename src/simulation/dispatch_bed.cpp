// SPDX-License-Identifier: Apache-2.0
#include "simulation/dispatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "mpm/bed_exchange.h"
#include "mpm/vector/kernels.h"
#include "params/keys/laws.h"
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
    const NoExcess none;
    find_held_nodes<Slope>(range, update, SummedFriction<NoExcess>{none, states, friction.yields}, nodes);
}

template <class Slope>
NodeReport update_uniform(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction, BedState*,
                          double time, NodeGrid& nodes, Maxima& maxima) {
    return update_nodes<Slope>(range, update, UniformFriction{friction.voellmy}, time, nodes, maxima);
}

template <class Slope>
NodeReport update_summed(const NodeRange& range, const NodeUpdate& update, const BedFriction& friction,
                         BedState* states, double time, NodeGrid& nodes, Maxima& maxima) {
    return std::visit(
        [&](const auto& excess) {
            return update_nodes<Slope>(range, update,
                                       SummedFriction<std::decay_t<decltype(excess)>>{excess, states, friction.yields},
                                       time, nodes, maxima);
        },
        friction.excess);
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
    if (!std::holds_alternative<NoExcess>(friction.excess) || !four_at_a_time(range, nodes))
        return update_summed<Curved<NormalSlope>>(range, update, friction, states, time, nodes, maxima);
    const NoExcess none;
    return vector_node_kernels()->summed(range, update, {none, states, friction.yields}, time, nodes, maxima);
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

template <bool Metric>
void exchange_stage(const NodeRange& range, const BedExchange& laws, double dt, double least_depth,
                    const BedState* states, const NodeGrid& nodes, ErodibleBed* beds) {
    std::visit(
        [&](const auto& erosion, const auto& deposition) {
            exchange_at_nodes<Metric>(range, erosion, deposition, laws.density, dt, least_depth, states, nodes, beds);
        },
        laws.erosion, laws.deposition);
    if (const auto* const forest = std::get_if<ForestDetrainment>(&laws.detrainment))
        detrain_at_nodes<Metric>(range, *forest, dt, least_depth, nodes, beds);
}

// Sets the law of a word.
template <class List, class Chosen>
void set_exchange(const std::string& word, const Entrainment& entrainment, double density, Chosen& chosen) {
    List::for_each([&]<class Law>() {
        if (word == Law::word) chosen = Law::build(all_values<List>(entrainment), density);
    });
}

// Whether a law has an effect: some without their parameter have none and are omitted.
template <class Law, class Builder>
bool has_effect(const Builder& scene) {
    if constexpr (requires { Law::acts(scene); }) {
        return Law::acts(scene);
    } else {
        return true;
    }
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
        nodes_.fill_with_ground([&nodes = nodes_, &from = *raster, uniform, values](const NodeGrid::Block& block) {
            for (std::int64_t j = block.j0 - k_ghost; j < block.j1 - k_ghost; ++j)
                for (std::int64_t i = block.i0 - k_ghost; i < block.i1 - k_ghost; ++i)
                    values[nodes.index(i, j)] = node_value(from, uniform, i, j);
        });
        return {uniform, values};
    }
    template <class Law>
    void add(const Law& law) {
        if constexpr (requires { law.speed_after(BedState{}, 0, 0.0, 0.0); }) {
            friction_.excess = law;
            friction_.yields = true;
        } else {
            friction_.yields |= law.yields();
        }
        friction_.sweeps.emplace_back([law](const NodeRange& range, const NodeGrid& nodes, BedState* states) {
            add_friction(range, law, nodes, states);
        });
    }
    template <class... Laws>
    void add(const std::variant<Laws...>& one) {
        std::visit([this](const auto& law) { add(law); }, one);
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
    return !only_voellmy || by_place || material.of<CoulombFriction>().pore_pressure(material.density).active() ||
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
    const PorePressure law = material.of<CoulombFriction>().pore_pressure(material.density);
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

void choose_exchange(const Entrainment& entrainment, const Numerics& numerics, Stages& stages) {
    if (!entrainment.active()) return;
    stages.exchange_at_nodes =
        slope_correction(numerics) == SlopeCorrection::none ? exchange_stage<false> : exchange_stage<true>;
}

BedFriction make_friction(const Material& material, const MaterialZones& zones, const Entrainment& entrainment,
                          NodeGrid& nodes, double gravity) {
    BedFriction friction;
    if (sums_friction(material, zones, entrainment))
        friction = FrictionBuilder(material, zones, nodes, gravity).build();
    const std::vector<std::string> terms = bed_friction_terms(material);
    const auto has = [&](const char* word) { return std::find(terms.begin(), terms.end(), word) != terms.end(); };
    if (has(CoulombFriction::word))
        friction.voellmy.friction_coefficient = material.of<CoulombFriction>().bed_friction_coefficient();
    if (has(TurbulentFriction::word))
        friction.voellmy.inverse_turbulence = material.of<TurbulentFriction>().inverse_turbulence();
    if (!friction.summed) friction.coefficient = {friction.voellmy.friction_coefficient};
    friction.pore_pressure = material.of<CoulombFriction>().pore_pressure(material.density);
    return friction;
}

BedExchange make_exchange(const Entrainment& entrainment, const Material& material) {
    BedExchange laws;
    const double density = laws.density = material.density;
    const PorePressure pores = material.of<CoulombFriction>().pore_pressure(density);
    const double at_rest = pores.dissipates() ? pores.hydrostatic : pores.initial.ratio;
    laws.bed = {entrainment.of<MechanicalErosion>().bed_pore_pressure_ratio.value_or(at_rest),
                pores.initial.solid_fraction};
    set_exchange<ErosionLaws>(entrainment.erosion, entrainment, density, laws.erosion);
    set_exchange<DepositionLaws>(entrainment.deposition ? "on" : "off", entrainment, density, laws.deposition);
    set_exchange<DetrainmentLaws>(entrainment.detrainment ? "on" : "off", entrainment, density, laws.detrainment);
    return laws;
}

// `beds` stays where it is, though a saved state may replace its content.
void set_erodible_beds(const Entrainment& entrainment, const MaterialZones& zones, NodeGrid& nodes,
                       ZeroArray<ErodibleBed>& beds) {
    beds = ZeroArray<ErodibleBed>(nodes.bed.size());
    const auto fill = [&](double ErodibleBed::*value, const std::optional<Raster>& zones_of, double uniform) {
        const Raster* const raster = zones_of ? &*zones_of : nullptr;
        nodes.fill_with_ground([&nodes, &beds, value, raster, uniform](const NodeGrid::Block& block) {
            for (std::int64_t j = block.j0 - k_ghost; j < block.j1 - k_ghost; ++j)
                for (std::int64_t i = block.i0 - k_ghost; i < block.i1 - k_ghost; ++i)
                    beds[nodes.index(i, j)].*value = raster == nullptr ? uniform : node_value(*raster, uniform, i, j);
        });
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
