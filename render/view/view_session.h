// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/map/colour_scale.h"
#include "render/view/view3d.h"
#include "render/view/view_ground.h"
#include "render/view/view_scene.h"

namespace frana::render {

/// The terrain of a view with its mesh, shared by the rasters of one series.
struct ViewPlace {
    explicit ViewPlace(const ViewSpec& spec);

    const Raster *terrain, *extent;  ///< its input
    double exaggeration;
    ViewGround ground;
    std::unique_ptr<ViewScene> scene;  ///< present once its picture's size is known
};

/// A view without its raster: terrain, camera, lines and texts made once, to receive one raster after another.
class ViewSession {
  public:
    /// `for_frames`: rasters other than the spec's will follow, each with its own subtitle. `place` is used if it fits,
    /// else replaced; until the session has drawn its last picture no other may use it.
    ViewSession(const ViewSpec& spec, bool for_frames, std::shared_ptr<ViewPlace>& place);
    ~ViewSession();

    /// Draws the view with a raster and dots (none if null) and a subtitle; the latter only if the session was made for
    /// frames.
    [[nodiscard]] Page draw(const Raster* layer, const Dots* dots, const std::string& subtitle);

    /// See ViewAnimator::fly; the spec's texts must still exist.
    void fly(double fraction);

    [[nodiscard]] const ViewLayout& layout() const noexcept;
    [[nodiscard]] const ColourScale& scale() const noexcept;

  private:
    class Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace frana::render
