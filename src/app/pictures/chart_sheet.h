// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/pictures/map_source.h"
#include "render/chart/chart.h"

namespace frana::app {

/// Returns the page of a chart without its panels, with the texts that maps have. Below the title: `note`, then the
/// scenario. At the foot: the chart's file, sources and author of the data; organisation, author and date.
/// @param note about this chart; empty: none
render::Chart chart_sheet(const MapSource& source, const std::string& what, const std::string& note,
                          const std::string& file);

}  // namespace frana::app
