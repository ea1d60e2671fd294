// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/raster.h"
#include "render/canvas/image.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"

namespace frana::render {

/// Draws many rasters on the same map (MapSpec) or in the same view (ViewSpec): page, window or camera, ground, legend
/// and colour scale are made once, so that a frame costs little and all frames agree. A view's surface is raised by
/// each frame's own raster if the base's `thickness` is its `layer`, otherwise always by the base's thickness.
template <class Spec>
class Animator {
  public:
    /// The colour scale follows from the base's classes, else from its raster, ideally the maximum over
    /// time; so does the window. Rasters and texts are copied or drawn here: `base` may be destroyed afterwards. Throws
    /// as map_page and view_page, and Error(input) if nothing defines the scale.
    explicit Animator(const Spec& base);
    ~Animator();
    Animator(Animator&&) noexcept;
    Animator& operator=(Animator&&) noexcept;

    /// Draws the page with this raster instead of the base's, and this subtitle, whose parts are separated by line
    /// ends: the last ones are left out where there is no room.
    Image frame(const Raster& layer, const std::string& subtitle);
    /// Draws the page with these particles and no raster.
    Image frame(const Dots& dots, const std::string& subtitle);

  private:
    struct Session;
    std::unique_ptr<Session> session_;
};

using MapAnimator = Animator<MapSpec>;
using ViewAnimator = Animator<ViewSpec>;

}  // namespace frana::render
