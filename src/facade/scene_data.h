// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "facade/frana.h"

namespace frana::facade {

struct Scene::Data {
    Grid grid;
    Values elevations;
    std::vector<std::pair<std::string, std::string>> keys;  ///< in the order of their last setting
    std::map<std::string, Values> by_place;                 ///< keys of [zones]
    Values walls;
    std::vector<Release> release;
    std::vector<Inflow> inflows;
    std::vector<Gauge> gauges;
    std::vector<CrossSection> sections;
};

}  // namespace frana::facade
