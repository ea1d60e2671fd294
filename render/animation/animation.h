// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/raster.h"
#include "render/canvas/image.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"

namespace frana::render {

/// Draws many layers on one and the same map: page, window, relief, legend and colour scale are made once, so
/// that a frame costs little and all frames agree.
class MapAnimator {
  public:
    /// The colour scale comes from the base's classes or maximum, else from its layer, which is best the
    /// maximum over time; so does the window. Rasters and texts are copied or drawn here: nothing of `base`
    /// is kept. Throws as draw_map, and Error(input) when there is nothing to fix the scale with.
    explicit MapAnimator(const MapSpec& base);
    ~MapAnimator();
    MapAnimator(MapAnimator&&) noexcept;
    MapAnimator& operator=(MapAnimator&&) noexcept;

    /// The map with this layer in place of the base's, and this subtitle.
    Image frame(const Raster& layer, const std::string& subtitle);
    /// The map with these particles and no layer.
    Image frame(const Dots& dots, const std::string& subtitle);

  private:
    class Page;
    std::unique_ptr<Page> page_;
};

/// The same for a view in perspective: terrain, camera, legend and colour scale are made once. The surface is
/// raised by each frame's own layer where the base's `thickness` is its `layer`, otherwise always by the
/// base's thickness.
class ViewAnimator {
  public:
    explicit ViewAnimator(const ViewSpec& base);
    ~ViewAnimator();
    ViewAnimator(ViewAnimator&&) noexcept;
    ViewAnimator& operator=(ViewAnimator&&) noexcept;

    Image frame(const Raster& layer, const std::string& subtitle);
    Image frame(const Dots& dots, const std::string& subtitle);

    /// Brings the camera to its place on a flight along the flow, from the highest part of the base's layer (0) to
    /// the lowest (1), close to the ground and turning slowly.
    void fly(double fraction);

  private:
    class Session;
    std::unique_ptr<Session> session_;
};

}  // namespace frana::render
