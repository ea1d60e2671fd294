// SPDX-License-Identifier: Apache-2.0
#include "bench/speed/law_costs.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <stdexcept>

#include "bench/set_up/setup.h"
#include "bench/speed/speed.h"
#include "params/keys/laws.h"

namespace frana::bench {
namespace {

struct Scenery {
    Material material;
    Numerics numerics;
    MaterialZones zones;
    Entrainment entrainment;
};

struct Variant {
    std::string name;
    std::function<void(Scenery&)> change;
};

// Each law of bed friction in addition to those of the plain scene, or replacing that which it excludes.
std::vector<Variant> laws_of_friction() {
    std::vector<Variant> list;
    const Law& coulomb = find_law(LawKind::bed_friction, CoulombFriction::word);
    for (const Law& law : laws()) {
        const std::vector<std::string> plain = bed_friction_terms(Material{});
        if (law.kind != LawKind::bed_friction || std::find(plain.begin(), plain.end(), law.word) != plain.end())
            continue;
        const bool instead =
            std::find_first_of(law.resists_alike.begin(), law.resists_alike.end(), coulomb.resists_alike.begin(),
                               coulomb.resists_alike.end()) != law.resists_alike.end();
        list.push_back({law.sentence, [word = law.word, instead](Scenery& s) {
                            s.material.bed_friction = {instead ? TurbulentFriction::word : "voellmy", word};
                        }});
    }
    return list;
}

std::vector<Variant> variants(const GridSpec& grid) {
    std::vector<Variant> list{{"plain: Voellmy", [](Scenery&) {}}};
    for (Variant& variant : laws_of_friction()) list.push_back(std::move(variant));
    const std::vector<Variant> others{
        {"pore pressure",
         [](Scenery& s) {
             s.material.pore_pressure_ratio = 0.3;
             s.material.pore_dissipation_time = 100;
         }},
        {"friction by zones",
         [grid](Scenery& s) { s.zones.friction_coefficient = Raster(grid, s.material.bed_friction_coefficient()); }},
        {"without curvature", [](Scenery& s) { s.numerics.curvature = false; }},
        {"in-plane Bingham", [](Scenery& s) { s.material.in_plane_stress = BinghamStress::word; }},
        {"earth pressure", [](Scenery& s) { s.material.in_plane_stress = EarthPressureStress::word; }},
        {"erosion and deposition", [](Scenery& s) {
             s.entrainment.erosion = ShearStressErosion::word;
             s.entrainment.erodible_depth = 1;
             s.entrainment.deposition = true;
             s.entrainment.deposition_rate = 0.01;
             s.entrainment.deposition_shear = 1000;
         }}};
    list.insert(list.end(), others.begin(), others.end());
    return list;
}

}  // namespace

std::vector<LawCost> run_law_costs(double particles, std::int64_t steps) {
    const Setup setup = speed_sheet(particles, false);
    const std::vector<Variant> laws = variants(setup.bed.grid);
    std::vector<LawCost> costs(laws.size());
    for (int turn = 0; turn < 3; ++turn) {
        for (std::size_t i = 0; i < laws.size(); ++i) {
            Scenery scene{setup.material, setup.numerics, {}, {}};
            Material& m = scene.material;
            m.in_plane_stress = "none";
            m.cohesion = 200;
            m.ramms_yield_stress = 200;
            m.manning = 0.02;
            m.yield_stress = 200;
            m.consistency = m.viscosity = 20;
            m.flow_index = 0.5;
            m.fast_friction_angle = 22;
            m.friction_length = 1;
            m.internal_friction_angle = 35;
            give_needed_keys<BedLaws>(m);
            laws[i].change(scene);
            Flow flow(setup.bed, setup.seeds, m, scene.numerics, 1, {}, scene.zones, scene.entrainment);
            flow.advance(1e9);
            const std::int64_t before = flow.particle_steps();
            const std::clock_t begin = std::clock();  // processor time: other programs do not count
            double fastest = 0;
            for (std::int64_t step = 0; step < steps; ++step) fastest = flow.advance(1e9).particles.speeds.flow;
            const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
            if (!(fastest > 0)) throw std::logic_error(laws[i].name + ": its flow came to rest, which costs nothing");
            const double each = 1e9 * seconds / static_cast<double>(flow.particle_steps() - before);
            LawCost& cost = costs[i];
            cost.law = laws[i].name;
            cost.nanoseconds = turn == 0 ? each : std::min(cost.nanoseconds, each);
            cost.bytes_per_particle = static_cast<double>(flow.particles().bytes_per_particle());
        }
    }
    for (LawCost& cost : costs) cost.relative = cost.nanoseconds / costs[0].nanoseconds;
    return costs;
}

std::string law_costs_csv(const std::vector<LawCost>& costs) {
    std::string out = "law,nanoseconds_per_particle_step,relative_to_plain,bytes_per_particle\n";
    for (const LawCost& cost : costs) {
        char line[160];
        std::snprintf(line, sizeof line, "%s,%.4g,%.4g,%g\n", cost.law.c_str(), cost.nanoseconds, cost.relative,
                      cost.bytes_per_particle);
        out += line;
    }
    return out;
}

std::string law_costs_table(const std::vector<LawCost>& costs) {
    std::string out = "cost of a law, one thread:\n";
    for (const LawCost& cost : costs) {
        char line[160];
        std::snprintf(line, sizeof line, "%-28s %7.1f ns per particle-step  %5.2f times plain  %4.0f bytes\n",
                      cost.law.c_str(), cost.nanoseconds, cost.relative, cost.bytes_per_particle);
        out += line;
    }
    return out;
}

}  // namespace frana::bench
