// SPDX-License-Identifier: Apache-2.0
#include "params/check_scene.h"

#include <algorithm>

#include "core/json.h"
#include "params/value_text.h"

namespace frana {
namespace {

void check_required(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                    Problems& problems) {
    const auto missing = [&](const std::string& name) { return given.count(name) == 0; };
    if (missing("terrain.dtm"))
        problems.add(
            {"is missing", file + ": terrain.dtm", "", "", "Name the digital terrain model, a raster file"});
    if (missing("release.thickness")) {
        problems.add({"is missing", file + ": release.thickness", "", "",
                      "Give metres, attribute:NAME, raster:FILE or difference:PRE,POST"});
    }
    const auto& thickness = scene.release.thickness;
    const bool outlined_by_raster = thickness && (thickness->kind == ThicknessSpec::Kind::raster ||
                                                  thickness->kind == ThicknessSpec::Kind::difference);
    if (missing("release.perimeter") && !outlined_by_raster)
        problems.add(
            {"is missing", file + ": release.perimeter", "", "", "Name the polygon layer of what fails"});
    if (missing("material.friction-angle") && missing("material.friction-coefficient")) {
        problems.add({"no bed friction is given", file + ": material.friction-angle", "", "",
                      "Set material.preset (see `frana materials`), material.friction-angle or "
                      "material.friction-coefficient; 0 is allowed, but must be said"});
    }
}

void check_numerics(const NumericsSpec& numerics, const std::string& file, Problems& problems) {
    const bool paper = numerics.scheme == "paper";
    const std::string own_shape = paper ? "bilinear" : "quadratic";
    if (numerics.shape != "auto" && numerics.shape != own_shape) {
        problems.add({"this shape with scheme " + numerics.scheme + " is not available in this version",
                      file + ": numerics.shape", numerics.shape, "auto, " + own_shape, "Remove the key"});
    }
    if (paper && numerics.well_balanced.value_or(false)) {
        problems.add({"still levels belong to scheme default, not to paper",
                      file + ": numerics.well-balanced", "on", "off with scheme paper",
                      "Remove the key or choose numerics.scheme = default"});
    }
}

void check_frames(const SceneSpec& scene, const std::string& file, Problems& problems) {
    constexpr double k_most_frames = 10000;
    const double interval = frame_interval(scene);
    if (interval > 0 && scene.time.end / interval > k_most_frames) {
        problems.add({"would make more than 10000 frames", file + ": time.frame-interval",
                      shortest_text(interval) + " s",
                      "at least " + shortest_text(scene.time.end / k_most_frames) +
                          " s for time.end = " + shortest_text(scene.time.end),
                      "Choose a longer interval"});
    }
}

void check_hazard(const HazardSpec& hazard, const std::string& file, Problems& problems) {
    const bool limits = !hazard.depth_limits.empty() || !hazard.velocity_limits.empty() ||
                        !hazard.flux_limits.empty() || !hazard.pressure_limits.empty();
    const bool custom = hazard.scheme == "custom";
    if (custom && !limits) {
        problems.add({"scheme custom needs limits", file + ": hazard.scheme", "custom", "",
                      "Set hazard.depth-limits, velocity-limits, flux-limits or pressure-limits"});
    }
    if (!custom && limits) {
        problems.add({"limits belong to scheme custom", file + ": hazard.scheme",
                      hazard.scheme.value_or("not given"), "custom",
                      "Set hazard.scheme = custom or remove them"});
    }
}

void check_output(const SceneSpec& scene, const std::string& file, Problems& problems) {
    const auto has = [&](const char* format) {
        const auto& list = scene.output.formats;
        return std::find(list.begin(), list.end(), format) != list.end();
    };
    if ((has("netcdf") || has("zarr")) && frame_interval(scene) == 0) {
        problems.add({"netcdf and zarr hold the frames, but the scene makes none", file + ": output.formats",
                      joined(scene.output.formats, ", "), "", "Set output.frames = on"});
    }
    if (has("ascii") && scene.output.names != "avaframe") {
        problems.add({"ascii is a format of the AvaFrame rasters", file + ": output.formats",
                      joined(scene.output.formats, ", "), "", "Set output.names = avaframe or remove ascii"});
    }
    if (scene.output.sample_interval && !scene.output.gauges && !scene.output.sections) {
        problems.add({"has nothing to sample", file + ": output.sample-interval",
                      shortest_text(*scene.output.sample_interval), "",
                      "Set output.gauges or output.cross-sections, or remove the key"});
    }
}

}  // namespace

void check_scene(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems) {
    check_required(scene, given, file, problems);
    check_numerics(scene.numerics, file, problems);
    check_frames(scene, file, problems);
    check_hazard(scene.hazard, file, problems);
    check_output(scene, file, problems);
}

}  // namespace frana
