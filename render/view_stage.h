// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/colour_scale.h"
#include "render/view3d.h"

namespace frana::render {

/// A view without its layer: terrain, camera, lines and texts made once, ready for one layer after the other.
class ViewStage {
  public:
    /// `for_frames`: other layers than the specification's will come, each with a subtitle of its own.
    ViewStage(const ViewSpec& spec, bool for_frames);
    ~ViewStage();

    /// The view with a layer (none if null) and a subtitle; the latter only where the stage was made for
    /// frames.
    [[nodiscard]] Image draw(const Raster* layer, const std::string& subtitle);

    /// See ViewAnimator::fly; the specification's texts must still be there.
    void fly(double share);

    [[nodiscard]] const ViewLayout& layout() const noexcept;
    [[nodiscard]] const ColourScale& scale() const noexcept;

  private:
    class Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace frana::render
