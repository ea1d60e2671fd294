// SPDX-License-Identifier: Apache-2.0
#include "params/keys/main_keys.h"

#include <algorithm>
#include <string_view>

namespace frana {
namespace {

constexpr std::string_view k_main_keys[] = {
    "terrain.dtm",
    "terrain.crs",
    "terrain.cell-size",
    "terrain.vertical-unit",
    "terrain.nodata-policy",
    "release.perimeter",
    "release.thickness",
    "release.thickness-direction",
    "release.dtm-contains-release",
    "material.preset",
    "material.friction-angle",
    "material.turbulence",
    "material.density",
    "numerics.accuracy",
    "time.end",
    "time.frame-interval",
    "output.title",
    "output.trace-threshold",
    "hazard.scheme",
    "observed.perimeter",
};

}  // namespace

bool is_main_key(const std::string& name) {
    return std::find(std::begin(k_main_keys), std::end(k_main_keys), name) != std::end(k_main_keys);
}

}  // namespace frana
