// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "params/keys/scene_spec.h"

namespace frana::app {

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
