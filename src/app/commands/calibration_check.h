// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/text/run_log.h"
#include "core/json.h"
#include "params/keys/scene_spec.h"

namespace frana::app {

/// Returns where a calibration's result goes without --out: beside that of its first scene.
std::string calibration_directory(const SceneSpec& scene);

/// `frana check` of a calibration: with `print`, prints events, keys, members and forecasts to stdout; returns the
/// document of --json. Throws Error(input).
Json check_calibration(const std::string& path, const std::optional<std::string>& out, int threads, bool print,
                       RunLog& log);

}  // namespace frana::app
