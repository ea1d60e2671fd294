// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/friction_table.h"
#include "app/input/prepare_release.h"
#include "app/input/prepare_terrain.h"
#include "app/input/survey_input.h"
#include "app/input/used_file.h"
#include "simulation/scene.h"

namespace frana::app {

/// Everything read from files, checked and on the working grid.
struct Prepared {
    Scene scene;
    SceneSpec spec;        ///< as written, for the echo
    TerrainInput ground;   ///< its raster has moved into the scene
    ReleaseInput release;  ///< its areas have moved into the scene
    std::optional<gis::PolygonLayer> scar;
    std::shared_ptr<const FrictionByPlace> friction;  ///< after a friction table; null without one
    ExtraInput extra;                                 ///< its recording has moved into the scene
    std::vector<UsedFile> files;                      ///< all files read
    double convergence_deg = 0;                       ///< true north from grid north at the grid's centre, clockwise
    std::map<std::string, std::string> resolved;      ///< values chosen by frana for keys not given
    /// Identity of the data for --resume, if numerics.accuracy has chosen another grid than the scene's own; else
    /// empty.
    std::vector<std::string> identity;
    /// Folder of the result, absolute, from which its scene.ini names the inputs; empty: by absolute paths.
    std::string result_folder{};
    std::map<std::string, std::string> tags{};  ///< more metadata of its rasters, as those of a study have
};

/// Reads a scene's files. Throws Error(input) with every problem found in keys and files.
/// @param found what is known of the scene before; with what is found here it becomes the scene's, unless this throws
Prepared prepare(const SceneReading& reading, Findings found);
Prepared prepare(const SceneReading& reading, RunLog& log);

/// The same if the result's place may not be usable (check_result_directory()): that is reported together with all
/// other problems, and alone it is an Error(environment).
Prepared prepare(const SceneReading& reading, const std::optional<Problem>& place, Findings found);

/// Returns "material.density = 2000 kg/m3" for each key that the scene uses, whose default decides a number on the map,
/// and that the user left alone.
std::vector<std::string> left_at_default(const Prepared& prepared);

}  // namespace frana::app
