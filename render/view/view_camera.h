// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

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

}  // namespace frana::render
