// SPDX-License-Identifier: Apache-2.0
#include "app/input/layer_choice.h"

#include "gis/crs/crs.h"

namespace frana::app {

gis::LayerChoice layer_choice(const SceneReading& reading, const LayerSpec& spec, const std::string& key) {
    return {spec.name.value_or(""), spec.filter.value_or(""),
            spec.crs ? gis::crs_from_user(*spec.crs, reading.where(key + "-crs")) : ""};
}

}  // namespace frana::app
