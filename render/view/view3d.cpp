// SPDX-License-Identifier: Apache-2.0
#include "render/view/view3d.h"

#include "render/view/view_session.h"

namespace frana::render {

Image ViewSeries::draw(const ViewSpec& spec, ViewLayout* layout) {
    ViewSession stage(spec, false, place_);
    if (layout != nullptr) *layout = stage.layout();
    return stage.draw(spec.layer, spec.dots, "");
}

Image draw_view(const ViewSpec& spec, ViewLayout* layout) {
    return ViewSeries().draw(spec, layout);
}

}  // namespace frana::render
