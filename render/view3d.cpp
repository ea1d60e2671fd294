// SPDX-License-Identifier: Apache-2.0
#include "render/view3d.h"

#include "render/view_stage.h"

namespace frana::render {

Image draw_view(const ViewSpec& spec, ViewLayout* layout) {
    ViewStage stage(spec, false);
    if (layout != nullptr) *layout = stage.layout();
    return stage.draw(spec.layer, "");
}

}  // namespace frana::render
