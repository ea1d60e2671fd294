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

/// Polygons in space of one colour.
struct SceneSurface {
    std::vector<ScenePoint> points;
    std::vector<std::int64_t> corners;  ///< numbers of points, `sides` for each polygon
    int sides = 3;
    Rgb colour{255, 255, 255};
    /// Of each point in the texture, to the right and down from its upper left corner, 0 to 1; empty: without texture.
    std::vector<float> texture_places;
};

/// Surfaces in perspective, or from above, with lines and dots. Used by one thread at a time. Throws ModuleFailure.
class TerrainScene {
  public:
    TerrainScene() = default;
    virtual ~TerrainScene() = default;
    TerrainScene(const TerrainScene&) = delete;
    TerrainScene& operator=(const TerrainScene&) = delete;

    /// Starts another picture of the surfaces: its size, no lines and dots yet.
    virtual void start(int width, int height) = 0;
    virtual void set_camera(const ScenePoint& position, const ScenePoint& target, double opening_deg) = 0;
    /// Colours at the lower and the upper side of the picture where there is nothing.
    virtual void set_background(Rgb below, Rgb above) = 0;
    /// Three bytes for each texel, row by row from the top.
    virtual void set_texture(int columns, int rows, const std::vector<std::uint8_t>& rgb) = 0;
    /// Moves the points of the first surface.
    virtual void move_points(const std::vector<ScenePoint>& points) = 0;
    virtual void add_line(const std::vector<ScenePoint>& points, double width_px, Rgb colour) = 0;
    /// Replaces the dots.
    virtual void set_dots(const std::vector<ScenePoint>& places, const std::vector<Rgb>& colours, double width_px) = 0;
    /// Returns three bytes a pixel, row by row from the top: each the mean of `samples` (1 to 3) inside it, which
    /// smooths edges with the memory of one picture. A single one is in its middle.
    [[nodiscard]] virtual std::vector<std::uint8_t> draw(std::size_t samples) = 0;
};

/// All that frana takes from VTK and OSMesa, as functions of the module `vtk`: the files of this folder are linked to
/// it alone, and of frana they use only types that headers define completely. They throw ModuleFailure (call_module).
struct VtkFunctions {
    /// Returns lines along which values, row by row, are equal to one of the levels: x from the first column, y from
    /// the first row, z the level. Beside a value that is NaN x or y are NaN. Closed lines end where they begin.
    std::vector<std::vector<ScenePoint>> (*level_lines)(const std::vector<double>& values, int columns, int rows,
                                                        const std::vector<double>& levels);
    /// The first surface has the texture.
    std::unique_ptr<TerrainScene> (*terrain_scene)(const std::vector<SceneSurface>& surfaces);
};

}  // namespace frana::render
