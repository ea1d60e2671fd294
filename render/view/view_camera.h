// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "render/view/view3d.h"

namespace frana::render {

/// A point of a scene: metres to the east, to the north and upwards (exaggerated) from the scene's origin.
struct ScenePoint {
    double x = 0, y = 0, z = 0;
};

/// A camera with perspective, placed.
struct PlacedCamera {
    ScenePoint position, target;
    double opening_deg = 30;  ///< of the picture's height

    /// Where a point appears: right and up from the picture's middle, half the picture's height being 1.
    [[nodiscard]] Point project(const ScenePoint& point) const;
};

/// From where to look at a flow: from before its front, uphill along its path and a little from the side.
/// `flow` are points of its surface; fewer than two give a view to the north.
Camera find_camera(std::span<const ScenePoint> flow);

/// Puts a camera so that all points just fit a picture of this width over height, with a margin, then closer
/// by its zoom. Needs at least one point.
PlacedCamera place_camera(const Camera& camera, std::span<const ScenePoint> points, double aspect);

}  // namespace frana::render
