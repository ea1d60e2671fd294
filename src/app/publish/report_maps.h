// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/publish/report.h"

namespace frana::app {

/// A map of a report.
struct ReportMap {
    std::string name;  ///< "max_depth_3d"
    std::string file;
    std::string caption, alt;
};

/// Returns the maps that were drawn, the main one (greatest depth, if there is one) first.
std::vector<ReportMap> report_maps(const ReportInput& input, const ResultDirectory& directory);

}  // namespace frana::app
