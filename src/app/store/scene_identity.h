// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare.h"

namespace frana::app {

/// Returns the provenance in every raster: PROGRAM, VERSION, SCENE, SCENE_HASH, DEPTH (gis::k_depth_item),
/// TIFFTAG_SOFTWARE.
std::map<std::string, std::string> provenance(const Prepared& prepared);

/// Returns the scene as in the result's scene.ini: its paths are relative to the result's folder, so that both can be
/// moved.
std::string echoed_scene(const Prepared& prepared);
/// The same of a scene that is in a folder of the result.
std::string echoed_scene(const SceneSpec& scene, const std::string& folder);
/// As the first, with the names of the files alone.
std::string echoed_scene_without_places(const Prepared& prepared);

/// Returns a scene whose files are named relative to a folder.
SceneSpec seen_from(SceneSpec scene, const std::string& folder);
/// Returns a scene with the names of its files alone: the same wherever they and the result are.
SceneSpec without_places(SceneSpec scene);

/// Returns everything that determines a run, one fact per line: every resolved key except those for the times of
/// checkpoints, the working grid, and a checksum of the data read from each file (Prepared::files). Two runs with the
/// same identity have the same bits.
std::string scene_identity(const Prepared& prepared);

/// The key of data_identity in summary.json.
inline constexpr const char* k_data_key = "file_checksums";

/// Returns the part of it not given by the scene's keys: the grid and the data read from files. Stored in summary.json.
std::vector<std::string> data_identity(const Prepared& prepared);
/// Returns the whole identity of a complete result: from its scene.ini and its summary.json; none if an older frana
/// wrote them.
std::optional<std::string> result_identity(const std::string& result_folder);

/// Returns the differences between two identities as text: "time.end is 20 here and was 10", at most a few.
std::vector<std::string> identity_differences(const std::string& here, const std::string& then);

/// Returns a fingerprint of everything that determines a run's numbers: terrain, release, material, numerics, time.
std::string numbers_fingerprint(const SceneSpec& scene);

/// Default place of the result of `frana converge`: beside the scene's own result.
std::string convergence_directory(const std::string& result_directory);

/// File in a study's folder that contains its values.
inline constexpr const char* k_convergence_file = "convergence.json";
/// File in a study's folder that contains its sentences.
inline constexpr const char* k_error_estimate_file = "error_estimate.txt";

/// Stores the sentences about a scene's error for later runs of it. Throws Error(environment).
void write_error_estimate(const std::string& folder, const SceneSpec& scene, const std::string& sentences);
/// Returns the sentences, if `frana converge` has written them for exactly this scene beside its result.
std::optional<std::string> read_error_estimate(const std::string& result_directory, const SceneSpec& scene);

}  // namespace frana::app
