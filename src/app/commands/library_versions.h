// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::app {

/// Returns one line for each library that can change a result or a file: "GDAL 3.6.2".
std::string library_versions();

}  // namespace frana::app
