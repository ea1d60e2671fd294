// SPDX-License-Identifier: Apache-2.0
#include "render/map/map2d.h"

#include "render/map/map_page.h"

namespace frana::render {

Image MapSeries::draw(const MapSpec& spec, MapLayout* layout) {
    const MapPage page(spec, false, ground_);
    if (layout != nullptr) *layout = page.layout();
    return page.draw(spec.layer, spec.dots, "");
}

Image draw_map(const MapSpec& spec, MapLayout* layout) {
    return MapSeries().draw(spec, layout);
}

}  // namespace frana::render
