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

/// The ground in perspective, drawn by the module of VTK: a mesh with a texture, walls where the terrain is cut off,
/// lines on it.
class ViewScene {
  public:
    ViewScene(const ViewGround& ground, int width, int height);

    /// Starts another view of the same ground: its camera and size, no lines yet.
    void start(const PlacedCamera& camera, int width, int height);
    void set_camera(const PlacedCamera& camera);
    /// Sets a blue sky, or plain white.
    void set_sky(bool sky);
    /// Sets the colours of the ground, as returned by ViewGround::colours.
    void set_colours(const std::vector<std::uint8_t>& colours);
    /// Raises the surface by a thickness where it has values; null: the bare ground.
    void set_thickness(const Raster* thickness);
    void add_line(const std::vector<ScenePoint>& points, double width_px, Rgb colour);

    /// Replaces the particles; `width` in pixels.
    void set_dots(const std::vector<ScenePoint>& places, const std::vector<Rgb>& colours, double width_px);

    /// Throws Error(environment) if VTK or OpenGL fails.
    [[nodiscard]] Image draw();

  private:
    const ViewGround& ground_;
    int width_, height_;
    std::unique_ptr<TerrainScene> scene_;
};

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

    [[nodiscard]] const ViewLayout& layout() const noexcept;
    [[nodiscard]] const ColourScale& scale() const noexcept;

  private:
    class Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace frana::render
