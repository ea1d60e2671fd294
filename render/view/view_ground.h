// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "render/canvas/image.h"
#include "render/map/legend.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"
#include "render/vtk/functions.h"

namespace frana::render {

/// A placed perspective camera.
struct PlacedCamera {
    ScenePoint position, target;
    double opening_deg = 30;  ///< of the picture's height

    /// Returns the position of a point in the picture: right and up from its middle, in half heights of the picture.
    [[nodiscard]] Point project(const ScenePoint& point) const;
};

/// Returns the default camera of a flow: from beyond its front, uphill along its path and slightly from the side.
/// `flow` are points of its surface; with fewer than two the view is to the north.
Camera find_camera(std::span<const ScenePoint> flow);

/// Places a camera so that all points just fit a picture of this width over height, with a margin, then moves it closer
/// by its zoom. Needs at least one point.
PlacedCamera place_camera(const Camera& camera, std::span<const ScenePoint> points, double aspect);

/// The part of the terrain in a view, reduced to the visible resolution, in the scene's coordinates.
class ViewGround {
  public:
    /// Around the data of `layer` (null: everything). `background` replaces the relief. Throws Error(input) if there is
    /// no terrain.
    ViewGround(const Raster& terrain, const Raster* layer, double exaggeration, const Background& background = {});

    [[nodiscard]] const Raster& heights() const noexcept { return heights_; }  ///< map coordinates, metres
    [[nodiscard]] double exaggeration() const noexcept { return exaggeration_; }
    /// Returns a map point on the ground, or `above` metres over it (before exaggeration).
    [[nodiscard]] ScenePoint scene(Point map, double above) const;
    /// Returns whether there is ground between two points of the scene.
    [[nodiscard]] bool hides(const ScenePoint& eye, const ScenePoint& point) const;
    /// The lowest and highest ground in the scene.
    [[nodiscard]] double lowest() const noexcept { return lowest_; }
    [[nodiscard]] double highest() const noexcept { return highest_; }

    /// Returns points of the raster's surface, at most about `most` of them; of the ground if there is no raster.
    [[nodiscard]] std::vector<ScenePoint> sample(const Raster* layer, std::int64_t most) const;

    /// Returns the colours to drape over the ground, north up: relief, and over it the raster's classes, slightly
    /// shaded so that the ground's shape remains visible.
    [[nodiscard]] Image colours(const Raster* layer, const ColourScale& scale) const;

  private:
    Raster heights_;
    double exaggeration_ = 1;
    Point origin_;     ///< of the scene, in map coordinates
    double base_ = 0;  ///< height of the scene's origin [m]
    double lowest_ = 0, highest_ = 0;
    Image relief_;  ///< colours of the bare ground
};

}  // namespace frana::render
