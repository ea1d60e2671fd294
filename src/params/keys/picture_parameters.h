// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "params/keys/parameter.h"

namespace frana {

/// Returns the file formats of maps, which are the endings of their files: "png", "pdf", "svg", "tif".
const std::vector<std::string>& picture_formats();

/// Adds the keys of [output] for the appearance of maps, views and charts.
void add_pictures(std::vector<Parameter>& list);

}  // namespace frana
