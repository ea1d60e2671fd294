// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/map/colour_scale.h"
#include "render/view/view3d.h"
#include "render/view/view_ground.h"
#include "render/view/view_scene.h"

namespace frana::render {

/// The terrain of a view with its mesh, which layers of one series share.
struct ViewPlace {
    explicit ViewPlace(const ViewSpec& spec);

    const Raster *terrain, *extent;  ///< what it was made for
    double exaggeration;
    ViewGround ground;
    std::unique_ptr<ViewScene> scene;  ///< once its picture's size is known
};

/// A view without its layer: terrain, camera, lines and texts made once, ready for one layer after the other.
class ViewSession {
  public:
    /// `for_frames`: other layers than the spec's will come, each with a subtitle of its own. `place` is
    /// taken where it fits, else made and put there; until the stage has drawn its last picture no other may use it.
    ViewSession(const ViewSpec& spec, bool for_frames, std::shared_ptr<ViewPlace>& place);
    ~ViewSession();

    /// The view with a layer and dots (none if null) and a subtitle; the latter only where the stage was made for
    /// frames.
    [[nodiscard]] Image draw(const Raster* layer, const Dots* dots, const std::string& subtitle);

    /// See ViewAnimator::fly; the spec's texts must still be there.
    void fly(double fraction);

    [[nodiscard]] const ViewLayout& layout() const noexcept;
    [[nodiscard]] const ColourScale& scale() const noexcept;

  private:
    class Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace frana::render
