// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "params/keys/parameter.h"

namespace frana {

/// Returns the file formats of maps, which are the endings of their files: "png", "pdf", "svg", "tif".
const std::vector<std::string>& picture_formats();

/// Adds the keys of [output] for the appearance of maps, views and charts.
void add_pictures(std::vector<Parameter>& list);

/// Largest map [cells] whose rasters cover it all with output.extent = auto.
inline constexpr std::int64_t k_largest_whole_map = 1'000'000;

/// Adds the keys of [output] beyond maps, frames and animation: names, report, gauges, cross-sections, profiles.
void add_extra_output(std::vector<Parameter>& list);
/// Adds the keys of [hazard].
void add_hazard(std::vector<Parameter>& list);
/// Adds the keys of [scar] for surveyed data besides the outline.
void add_survey(std::vector<Parameter>& list);

}  // namespace frana
