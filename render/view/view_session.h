// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/canvas/image.h"
#include "render/map/legend.h"
#include "render/view/view3d.h"
#include "render/view/view_ground.h"
#include "render/vtk/functions.h"

namespace frana::render {

/// The terrain of a view, shared by the rasters of one series.
struct ViewPlace {
    explicit ViewPlace(const ViewSpec& spec);

    const Raster *terrain, *extent;  ///< its input
    double exaggeration;
    ViewGround ground;
    /// Drawn by VTK: a mesh with a texture, walls where the terrain is cut off, lines on it.
    std::unique_ptr<TerrainScene> scene;
};

/// A view without its raster: terrain, camera, lines and texts made once, to receive one raster after another.
class ViewSession {
  public:
    /// `for_frames`: rasters other than the spec's will follow, each with its own subtitle. `place` is used if it fits,
    /// else replaced; until the session has drawn its last picture no other may use it.
    ViewSession(const ViewSpec& spec, bool for_frames, std::shared_ptr<ViewPlace>& place);

    /// Draws the view with a raster and dots (none if null) and a subtitle; the latter only if the session was made for
    /// frames. Throws Error(environment) if VTK or OpenGL fails.
    [[nodiscard]] Page draw(const Raster* layer, const Dots* dots, const std::string& subtitle);

    [[nodiscard]] const ViewLayout& layout() const noexcept { return layout_; }
    [[nodiscard]] const ColourScale& scale() const noexcept { return scale_; }

  private:
    void raise_over_ground(const std::vector<ScenePoint>& flow, double aspect);
    void arrange(const ViewSpec& spec, bool for_frames, bool nothing_to_show);
    void note_flow(const std::vector<ScenePoint>& flow, const PlacedCamera& camera);
    void put_dots(const Dots& dots);
    /// Lines over the ground, following it closely.
    void add_outlines(const ViewSpec& spec);
    void add_line(const Polyline& ring, bool is_ring, const Outline& outline, double width, const Raster* thickness);

    std::shared_ptr<ViewPlace> place_;
    const ViewGround& ground_;
    ColourScale scale_;
    double metres_per_pixel_ = 1;  ///< in the middle of the flow
    ViewLayout layout_;
    std::shared_ptr<const Overlay> above_;
    Point subtitle_at_;
    bool raise_by_value_;
};

}  // namespace frana::render
