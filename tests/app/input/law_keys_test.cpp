// SPDX-License-Identifier: Apache-2.0
// Every key that the table of laws says a law uses changes the result of a scene with that law.
#include <algorithm>
#include <cmath>
#include <map>

#include "app/input/prepare.h"
#include "app/input/share_directory.h"
#include "params/keys/laws.h"
#include "simulation/simulation.h"
#include "support/checked_scene.h"

namespace frana::test {
namespace {

/// Two values of each key, under which a flow of metres per second behaves differently.
const std::map<std::string, std::pair<std::string, std::string>> k_values{
    {"material.friction-angle", {"12", "16"}},
    {"material.friction-coefficient", {"0.2", "0.3"}},
    {"material.pore-pressure-ratio", {"0.2", "0.4"}},
    {"material.pore-dissipation-time", {"1", "5"}},
    {"material.hydraulic-diffusivity", {"0.1", "1"}},
    {"material.pore-fluid-density", {"200", "900"}},
    {"material.compressibility", {"1e-6", "1e-4"}},
    {"material.solid-fraction", {"0.5", "0.55"}},
    {"material.critical-solid-fraction", {"0.51", "0.54"}},
    {"material.surface-pressure", {"1000", "3000"}},
    {"material.turbulence", {"500", "1000"}},
    {"material.cohesion", {"500", "1000"}},
    {"material.ramms-yield-stress", {"500", "1000"}},
    {"material.yield-stress", {"500", "1000"}},
    {"material.viscosity", {"50", "200"}},
    {"material.consistency", {"50", "200"}},
    {"material.flow-index", {"0.5", "0.8"}},
    {"material.manning", {"0.05", "0.1"}},
    {"material.laminar-resistance", {"1000", "3000"}},
    {"material.chezy", {"15", "25"}},
    {"material.friction-beta", {"0.1", "0.3"}},
    {"material.fast-friction-angle", {"30", "35"}},
    {"material.friction-length", {"0.5", "1"}},
    {"material.crossover-speed", {"1", "4"}},
    {"material.internal-friction-angle", {"25", "35"}},
    {"entrainment.erosion-rate", {"0.01", "0.05"}},
    {"entrainment.critical-shear-stress", {"200", "800"}},
    {"entrainment.erosion-depth-per-stress", {"0.005", "0.02"}},
    {"entrainment.erodible-depth", {"0.01", "0.3"}},
    {"entrainment.growth-rate", {"0.001", "0.003"}},
    {"entrainment.bed-cohesion", {"0", "500"}},
    {"entrainment.bed-pore-pressure-ratio", {"0.1", "0.3"}},
    {"entrainment.bed-friction-angle", {"10", "14"}},
    {"entrainment.deposition-rate", {"0.02", "0.05"}},
    {"entrainment.deposition-shear-stress", {"20000", "40000"}},
    {"entrainment.detrainment-coefficient", {"200", "1000"}}};

class LawKeys : public TinyScene {
  protected:
    [[nodiscard]] RunResult result(const Sets& sets) const {
        app::RunLog log(true);
        const app::Prepared prepared = app::prepare(read_scene(path("scene.ini"), sets, app::share_directory()), log);
        RunOptions options;
        options.threads = 1;
        return run(prepared.scene, options);
    }
};

/// A scene with a law, in which a key of its row has an effect; the key itself is left to the caller.
Sets scene_with(const Law& law, const std::string& key) {
    Sets sets{law.selected_by(), "time.end=6", "time.stop-when-still=off"};
    sets[0].erase(std::remove(sets[0].begin(), sets[0].end(), ' '), sets[0].end());
    if (law.kind != LawKind::bed_friction) sets.emplace_back("material.bed-friction=coulomb");
    const bool rubs = law.kind != LawKind::bed_friction || law.reads_key("material.friction-coefficient");
    if (rubs && key != "material.friction-coefficient" && key != "material.friction-angle")
        sets.emplace_back("material.friction-coefficient=0.2");
    for (const std::string& needed : law.needs)
        if (needed != key) sets.push_back(needed + "=" + k_values.at(needed).first);
    // What the key acts on.
    static const std::map<std::string, Sets> k_with{
        {"material.pore-dissipation-time", {"material.pore-pressure-ratio=0.4"}},
        {"material.hydraulic-diffusivity", {"material.pore-pressure-ratio=0.4"}},
        {"material.pore-fluid-density", {"material.pore-dissipation-time=1"}},
        {"material.compressibility", {"material.solid-fraction=0.5", "material.critical-solid-fraction=0.51"}},
        {"material.solid-fraction", {"material.compressibility=1e-4", "material.critical-solid-fraction=0.51"}},
        {"material.critical-solid-fraction", {"material.compressibility=1e-4", "material.solid-fraction=0.5"}},
        {"material.laminar-resistance", {"material.viscosity=200"}},
        {"entrainment.critical-shear-stress", {"entrainment.erosion-depth-per-stress=0.005"}}};
    if (const auto with = k_with.find(key); with != k_with.end())
        sets.insert(sets.end(), with->second.begin(), with->second.end());
    return sets;
}

bool differ(const Raster& a, const Raster& b) {
    for (std::size_t i = 0; i < a.values.size(); ++i)
        if (std::isnan(a.values[i]) != std::isnan(b.values[i]) || a.values[i] < b.values[i] ||
            a.values[i] > b.values[i])
            return true;
    return false;
}

TEST_F(LawKeys, OfTheTableChangeTheResult) {
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n" + k_numbers_only);
    for (const Law& law : laws()) {
        std::vector<std::string> keys = law.needs;
        keys.insert(keys.end(), law.reads.begin(), law.reads.end());
        for (const std::string& key : keys) {
            ASSERT_EQ(k_values.count(key), 1U) << key;
            const auto with = [&](const std::string& value) {
                Sets sets = scene_with(law, key);
                sets.push_back(key + "=" + value);
                return result(sets);
            };
            const RunResult one = with(k_values.at(key).first), other = with(k_values.at(key).second);
            EXPECT_GT(one.steps, 3) << law.selected_by() << ", " << key;
            EXPECT_TRUE(differ(one.raster("max_velocity"), other.raster("max_velocity")) ||
                        differ(one.raster("final_depth"), other.raster("final_depth")))
                << law.selected_by() << ": " << key << " changes nothing";
        }
    }
}

}  // namespace
}  // namespace frana::test
