// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Writes result.qgz into a result's folder, from the files that are in it: outlines, maps, frames as temporal layers
/// and the terrain, grouped and with their styles, under the run's title. Throws Error(environment).
void publish_project(const std::string& folder, const std::string& title);

/// Writes frames/NAME.qml and .sld, the style that all frames of a quantity share; nothing without frames. Throws
/// Error(environment).
void publish_frame_styles(const std::string& folder);

}  // namespace frana::app
