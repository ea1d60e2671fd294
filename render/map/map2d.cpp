// SPDX-License-Identifier: Apache-2.0
#include "render/map/map2d.h"

#include "render/map/map_page.h"

namespace frana::render {

Page MapSeries::draw(const MapSpec& spec, MapLayout* layout) {
    const MapPage map(spec, false, ground_);
    if (layout != nullptr) *layout = map.layout();
    return map.draw(spec.layer, spec.dots, "");
}

Page map_page(const MapSpec& spec, MapLayout* layout) {
    return MapSeries().draw(spec, layout);
}

Image draw_map(const MapSpec& spec, MapLayout* layout) {
    return map_page(spec, layout).paint();
}

}  // namespace frana::render
