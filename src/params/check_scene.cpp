// SPDX-License-Identifier: Apache-2.0
#include "params/check_scene.h"

#include "core/json.h"
#include "params/check_laws.h"

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

}  // namespace

void check_scene(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems) {
    check_required(scene, given, file, problems);
    check_laws(scene, given, file, problems);
    check_numerics(scene.numerics, file, problems);
    check_frames(scene, file, problems);
}

}  // namespace frana
