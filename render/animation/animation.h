// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/raster.h"
#include "render/canvas/image.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"

namespace frana::render {

/// Draws many rasters on the same map: page, window, relief, legend and colour scale are made once, so that a frame
/// costs little and all frames agree.
class MapAnimator {
  public:
    /// The colour scale follows from the base's classes or maximum, else from its raster, ideally the maximum over
    /// time; so does the window. Rasters and texts are copied or drawn here: `base` may be destroyed afterwards. Throws
    /// as draw_map, and Error(input) if nothing defines the scale.
    explicit MapAnimator(const MapSpec& base);
    ~MapAnimator();
    MapAnimator(MapAnimator&&) noexcept;
    MapAnimator& operator=(MapAnimator&&) noexcept;

    /// Draws the map with this raster instead of the base's, and this subtitle, whose parts are separated by line ends:
    /// the last ones are left out where there is no room.
    Image frame(const Raster& layer, const std::string& subtitle);
    /// Draws the map with these particles and no raster.
    Image frame(const Dots& dots, const std::string& subtitle);

  private:
    class Page;
    std::unique_ptr<Page> page_;
};

/// The same for a perspective view: terrain, camera, legend and colour scale are made once. The surface is raised by
/// each frame's own raster if the base's `thickness` is its `layer`, otherwise always by the base's thickness.
class ViewAnimator {
  public:
    explicit ViewAnimator(const ViewSpec& base);
    ~ViewAnimator();
    ViewAnimator(ViewAnimator&&) noexcept;
    ViewAnimator& operator=(ViewAnimator&&) noexcept;

    Image frame(const Raster& layer, const std::string& subtitle);
    Image frame(const Dots& dots, const std::string& subtitle);

  private:
    class Session;
    std::unique_ptr<Session> session_;
};

}  // namespace frana::render
