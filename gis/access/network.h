// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace frana::gis {

/// Allows inputs to be read over the network (URLs, /vsicurl/, databases, map services). Must be called before anything
/// is opened; otherwise GDAL's network drivers and file systems are removed. A scene cannot call it: the user who
/// starts the program decides.
void allow_network();
[[nodiscard]] bool network_allowed();

/// Returns the remedy for a path that is not on this machine; none if it is, or if the network is allowed.
[[nodiscard]] std::optional<std::string> network_remedy(const std::string& path);

/// Removes access to the network; GdalSession calls it once unless it was allowed.
void disable_network();

}  // namespace frana::gis
