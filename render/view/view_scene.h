// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "render/canvas/image.h"
#include "render/view/view_camera.h"
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

}  // namespace frana::render
