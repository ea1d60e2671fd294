// SPDX-License-Identifier: Apache-2.0
#include "params/keys/scene_spec.h"

#include <filesystem>
#include <limits>

#include "params/grammar/value_text.h"
#include "params/keys/laws.h"

namespace frana {

Transfer transfer_of(const Numerics& numerics) {
    if (numerics.transfer != Transfer::automatic) return numerics.transfer;
    return numerics.scheme == Scheme::paper ? Transfer::pic : Transfer::apic;
}

SlopeCorrection slope_correction(const Numerics& numerics) {
    if (numerics.slope_correction != SlopeCorrection::automatic) return numerics.slope_correction;
    return numerics.scheme == Scheme::paper ? SlopeCorrection::none : SlopeCorrection::normal;
}

bool well_balanced(const Numerics& numerics) {
    return numerics.well_balanced.value_or(numerics.scheme != Scheme::paper);
}

bool reads_friction_table(const std::string& key) {
    return key.starts_with("material.table-") || key == "material.friction-table" || key == "material.forest" ||
           key == "material.return-period" || key == "material.altitude-limits";
}

bool curvature(const Numerics& numerics) {
    return slope_correction(numerics) != SlopeCorrection::none && numerics.curvature.value_or(true);
}

bool can_fly(const Numerics& numerics) {
    return curvature(numerics) && numerics.scheme == Scheme::standard && transfer_of(numerics) == Transfer::apic;
}

bool flight(const Numerics& numerics) {
    return can_fly(numerics) && numerics.flight.value_or(true);
}

double courant_number(const Numerics& numerics, const Material& material) {
    const bool sweeps = numerics.scheme == Scheme::finite_volume || material.model == "structured";
    return numerics.cfl.value_or(sweeps ? k_courant_of_sweeps : default_courant(numerics.scheme != Scheme::paper));
}

double frame_interval(const SceneSpec& scene) {
    if (!scene.output.frames && !scene.output.animation) return 0;
    return scene.time.frame_interval.value_or(std::numeric_limits<double>::infinity());
}

std::string scene_name(const SceneSpec& scene) {
    const std::filesystem::path file = scene.file;
    const std::string folder = file.parent_path().filename().string();
    std::string name = trimmed(file.stem() == "scene" && !folder.empty() ? folder : file.stem().string());
    // The name must have the same meaning in a scene file.
    for (char& c : name)
        if (c == '#' || static_cast<unsigned char>(c) < 0x20) c = '_';
    return name.empty() ? "scene" : name;
}

std::string output_directory(const SceneSpec& scene) {
    if (scene.output.directory) return *scene.output.directory;
    return (std::filesystem::path(scene.file).parent_path() / "results" / scene_name(scene)).string();
}

double observed_threshold(const SceneSpec& scene) {
    return scene.observed.threshold.value_or(scene.output.trace_threshold);
}

double hazard_minimum_depth(const SceneSpec& scene) {
    return scene.hazard.minimum_depth.value_or(scene.output.trace_threshold);
}

}  // namespace frana
