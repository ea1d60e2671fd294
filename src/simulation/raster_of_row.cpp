// SPDX-License-Identifier: Apache-2.0
#include "simulation/raster_of_row.h"

#include <map>
#include <string>

namespace frana {

const Raster* raster_of_row(const RunResult& result, const ResultRaster& row) {
    static const std::map<std::string, Raster RunResult::*> k_members{{"max_depth", &RunResult::max_depth},
                                                                      {"max_velocity", &RunResult::max_velocity},
                                                                      {"final_depth", &RunResult::final_depth},
                                                                      {"arrival_time", &RunResult::arrival_time},
                                                                      {"max_pressure", &RunResult::max_pressure},
                                                                      {"release", &RunResult::release},
                                                                      {"bed", &RunResult::bed},
                                                                      {"max_flux", &RunResult::max_flux},
                                                                      {"max_head", &RunResult::max_head},
                                                                      {"eroded_depth", &RunResult::eroded_depth},
                                                                      {"deposited_depth", &RunResult::deposited_depth},
                                                                      {"jump_height", &RunResult::jump_height}};
    if (const auto member = k_members.find(row.name); member != k_members.end()) {
        const Raster& raster = result.*member->second;
        return raster.values.empty() ? nullptr : &raster;
    }
    for (const NamedRaster& raster : result.more)
        if (raster.name == row.name) return &raster.values;
    return nullptr;
}

}  // namespace frana
