// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace frana::gis {

/// Lets inputs be read over the network (URLs, /vsicurl/, databases, map services). To be called before
/// anything is opened; without it GDAL's drivers and file systems that go there are taken away. A scene
/// cannot call it: whoever starts the program decides.
void allow_network();
[[nodiscard]] bool network_allowed();

/// What to do about a path that names something not on this machine; none where it is here, or the network
/// allowed.
[[nodiscard]] std::optional<std::string> network_remedy(const std::string& path);

/// Takes away what reaches the network; GdalSession does so once, where it was not allowed.
void disable_network();

}  // namespace frana::gis
