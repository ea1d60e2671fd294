// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/colour.h"

namespace frana::render {

/// A point of a scene: metres to the east, to the north and upwards (exaggerated) from the scene's origin.
struct ScenePoint {
    double x = 0, y = 0, z = 0;
};

/// Triangles on a page, later ones over earlier ones.
struct Triangles {
    std::vector<float> corners;          ///< x to the right, y upwards [px], of three corners each
    std::vector<std::uint32_t> colours;  ///< of each corner: red, green, blue, opacity from the lowest byte up
};

/// A rectangle of a page whose pixels are wanted; left and bottom from the page's lower left corner.
struct PixelWindow {
    int left = 0, bottom = 0, width = 0, height = 0;
};

/// Polygons in space of one colour.
struct SceneSurface {
    std::vector<ScenePoint> points;
    std::vector<std::int64_t> corners;  ///< numbers of points, `sides` for each polygon
    int sides = 3;
    Rgb colour{255, 255, 255};
    std::vector<float> texture_places;  ///< u and v of each point in the texture, 0 to 1; empty: without texture
};

/// Surfaces in perspective with lines and dots. Used by one thread at a time. Throws ModuleFailure.
class TerrainScene {
  public:
    TerrainScene() = default;
    virtual ~TerrainScene() = default;
    TerrainScene(const TerrainScene&) = delete;
    TerrainScene& operator=(const TerrainScene&) = delete;

    /// Starts another picture of the surfaces: its size, no lines and dots yet.
    virtual void start(int width, int height) = 0;
    virtual void set_camera(const ScenePoint& position, const ScenePoint& target, double opening_deg) = 0;
    virtual void set_sky(bool sky) = 0;
    /// Three bytes for each texel, from the south-western corner eastwards, then northwards.
    virtual void set_texture(int columns, int rows, const std::vector<std::uint8_t>& rgb) = 0;
    /// Moves the points of the first surface.
    virtual void move_points(const std::vector<ScenePoint>& points) = 0;
    virtual void add_line(const std::vector<ScenePoint>& points, double width_px, Rgb colour) = 0;
    /// Replaces the dots.
    virtual void set_dots(const std::vector<ScenePoint>& places, const std::vector<Rgb>& colours, double width_px) = 0;
    /// Returns three bytes a pixel, row by row from the top.
    [[nodiscard]] virtual std::vector<std::uint8_t> draw() = 0;
};

/// All that frana takes from VTK and OSMesa, as functions of the module `vtk`: the files of this folder are linked to
/// it alone, and of frana they use only types that headers define completely. They throw ModuleFailure (call_module).
struct VtkFunctions {
    /// Returns the pixels of a window from the top: red, green, blue, multiplied by the opacity that follows.
    std::vector<std::uint8_t> (*draw_triangles)(const Triangles& triangles, const PixelWindow& window);
    /// The first surface has the texture.
    std::unique_ptr<TerrainScene> (*terrain_scene)(const std::vector<SceneSurface>& surfaces, int width, int height);
};

}  // namespace frana::render
