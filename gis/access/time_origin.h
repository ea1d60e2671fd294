// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::gis {

/// Times of frames begin at 2000-01-01 00:00 UTC: CF conventions and QGIS need a date, and a scene has none.
/// Returns "2000-01-01T00:01:30.500Z" for 90.5 s.
std::string date_text(double seconds);

}  // namespace frana::gis
