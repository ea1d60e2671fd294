// SPDX-License-Identifier: Apache-2.0
#include "checkpoint_states.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "app/store/checkpoint_file.h"
#include "physics/laws.h"
#include "simulation/simulation.h"

namespace frana::fuzz {
namespace {

constexpr int k_steps = 4;

// 80 m x 60 m that fall east to a flat, 50 m2 of release.
Scene small_scene() {
    Scene scene;
    scene.grid = {0, 60, 2, 40, 30, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < scene.grid.rows; ++r) {
        for (std::int64_t c = 0; c < scene.grid.columns; ++c)
            scene.terrain.at(r, c) = 100 + 0.5 * std::max(0.0, 50 - scene.grid.cell_centre(r, c).x);
    }
    scene.release = {{{{{{10, 20}, {18, 20}, {18, 28}, {10, 28}}, {}}}, 2}};
    scene.material.of<CoulombFriction>().friction_coefficient = 0.3;
    scene.material.of<TurbulentFriction>().turbulence = 400;
    scene.time.end = 5;
    scene.time.frame_interval = 1;
    return scene;
}

Scene eventful_scene() {
    Scene scene = small_scene();
    scene.terrain_contains_release = true;
    scene.release.push_back({{{{{30, 30}, {34, 30}, {34, 34}, {30, 34}}, {}}}, 1});
    scene.release[1].start = 3;
    scene.inflows = {{{{20, 40}, {20, 46}}, {{0, 5, 2}, {4, 8, 3}}, std::nullopt}};
    scene.entrainment.erosion = "shear-stress";
    scene.entrainment.erodible_depth = 0.5;
    scene.entrainment.deposition = true;
    scene.entrainment.of<ShearStressDeposition>().deposition_rate = 0.01;
    scene.entrainment.of<ShearStressDeposition>().deposition_shear = 1000;
    scene.material.of<CoulombFriction>().pore_pressure_ratio = 0.3;
    scene.material.of<CoulombFriction>().pore_fluid_density = 500;
    scene.material.of<CoulombFriction>().hydraulic_diffusivity = 0.1;
    scene.material.of<CoulombFriction>().solid_fraction = 0.59;
    scene.material.of<CoulombFriction>().critical_solid_fraction = 0.6;
    scene.material.of<CoulombFriction>().compressibility = 1e-5;
    scene.recording.gauges = {{"a", {30, 24}}};
    scene.recording.sections = {{"s", {{40, 10}, {40, 50}}}};
    scene.recording.interval = 0.5;
    scene.recording.intensity = true;
    scene.time.stop_momentum = 0.01;
    return scene;
}

Scene published_scheme() {
    Scene scene = small_scene();
    scene.numerics.scheme = Scheme::paper;
    scene.numerics.well_balanced = false;
    scene.numerics.slope_correction = SlopeCorrection::none;
    scene.material.of<BinghamStress>().viscosity = 500;
    scene.material.of<BinghamStress>().yield_stress = 100;
    scene.numerics.transfer = Transfer::flip;
    return scene;
}

Scene structured_scene(bool solids) {
    Scene scene = small_scene();
    StructuredMaterial& material = scene.structured.emplace();
    material.solids = solids;
    material.confined_fraction = 0.7;
    material.cohesion = 2000;
    material.friction = 0.6;
    material.bed_friction = 0.2;
    material.young_modulus = 2e5;
    material.bulk_modulus = 4e5;
    return scene;
}

SaveState from_bytes(const Bytes& bytes) {
    return [&bytes](StateWriter& writer) { writer.bytes(bytes.data(), bytes.size()); };
}

SavedRun saved(Scene scene) {
    SavedRun made{std::move(scene), {}};
    RunOptions options;
    options.stop_requested = [&] { return !made.state.empty(); };
    options.after_step = [&](const Progress& now, const SaveState& save) {
        if (now.step != k_steps) return;
        StateWriter writer([&](const void* data, std::size_t count) {
            const auto* const begin = static_cast<const std::uint8_t*>(data);
            made.state.insert(made.state.end(), begin, begin + count);
        });
        save(writer);
    };
    run(made.scene, options);
    return made;
}

Bytes whole_file() {
    namespace fs = std::filesystem;
    const fs::path path = fs::temp_directory_path() / ("frana_fuzz_" + std::to_string(::getpid()) + ".frana");
    const SavedRun& run = *saved_run('v');
    app::write_checkpoint(path.string(),
                          {app::checkpoint_build(),
                           "terrain.dtm = dtm.asc\n",
                           k_steps,
                           0.5,
                           5,
                           1,
                           {0, 1},
                           {"a line", "another"},
                           OriginCell{1, 2},
                           {{"depth_0000.tif", 3, 4}}},
                          from_bytes(run.state));
    Bytes bytes;
    {
        std::ifstream file(path, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    fs::remove(path);
    return bytes;
}

}  // namespace

const SavedRun* saved_run(char kind) {
    static const std::map<char, SavedRun> k_runs{{'v', saved(eventful_scene())},
                                                 {'p', saved(published_scheme())},
                                                 {'s', saved(structured_scene(true))},
                                                 {'w', saved(structured_scene(false))}};
    const auto found = k_runs.find(kind);
    return found == k_runs.end() ? nullptr : &found->second;
}

const Bytes& checkpoint_file() {
    static const Bytes k_file = whole_file();
    return k_file;
}

}  // namespace frana::fuzz
