// SPDX-License-Identifier: Apache-2.0
#include "render/map2d.h"

#include "render/map_page.h"

namespace frana::render {

Image draw_map(const MapSpec& spec, MapLayout* layout) {
    const MapPage page(spec, false);
    if (layout != nullptr) *layout = page.layout();
    return page.draw(spec.layer, "");
}

}  // namespace frana::render
