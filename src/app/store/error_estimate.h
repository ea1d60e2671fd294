// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "params/keys/scene_spec.h"

namespace frana::app {

/// What makes two runs the same as far as numbers go: a fingerprint of terrain, release, material, numerics,
/// time.
std::string numbers_fingerprint(const SceneSpec& scene);

/// Where `frana converge` puts its result unless told otherwise: beside the scene's own result.
std::string convergence_directory(const std::string& result_directory);

/// The file of a study's folder that keeps its sentences.
inline constexpr const char* k_error_estimate_file = "error_estimate.txt";

/// Keeps the sentences about a scene's error for later runs of it. Throws Error(environment).
void write_error_estimate(const std::string& folder, const SceneSpec& scene, const std::string& sentences);
/// The sentences, if `frana converge` has left them for this very scene beside its result.
std::optional<std::string> read_error_estimate(const std::string& result_directory, const SceneSpec& scene);

}  // namespace frana::app
