// SPDX-License-Identifier: Apache-2.0
#include "render/view/view3d.h"

#include "render/view/view_session.h"

namespace frana::render {

Page ViewSeries::draw(const ViewSpec& spec, ViewLayout* layout) {
    ViewSession session(spec, false, place_);
    if (layout != nullptr) *layout = session.layout();
    return session.draw(spec.layer, spec.dots, "");
}

Page view_page(const ViewSpec& spec, ViewLayout* layout) {
    return ViewSeries().draw(spec, layout);
}

Image draw_view(const ViewSpec& spec, ViewLayout* layout) {
    return view_page(spec, layout).paint();
}

}  // namespace frana::render
