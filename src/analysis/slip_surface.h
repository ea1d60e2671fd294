// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/geometry.h"
#include "core/raster.h"

namespace frana {

/// Form of a slip surface that is fitted to a perimeter.
enum class SlipShape {
    ellipsoid,   ///< every section through the centroid is a quarter of an ellipse to either side
    base_level,  ///< constant curvature: the sloping local base level
};

/// A slip surface that meets the ground all along a perimeter (elevations in metres).
///
///     z(x, y) = m(x, y) - D f(x, y),     thickness = max(0, ground - z)
///
/// m  membrane spanned over the perimeter: the mean of its four neighbours in every cell inside, the ground
///    outside; on a plane slope it is the plane. D greatest depth under it [m]. f in [0, 1], 0 on the perimeter:
///    - ellipsoid: f = sqrt(1 - r^2), r the distance from the centroid over that of the perimeter in the same
///      direction. On a plane slope with an ellipse of semi-axes a, b this is half an ellipsoid of volume
///      2/3 pi a b D, the geometry of the IAEG Commission on Landslides (1990, Bull. IAEG 41, 13-16);
///    - base level: in every cell the mean of the four neighbours plus a constant, which makes z the sloping local
///      base level (Jaboyedoff et al. 2004, in Landslides: Evaluation and Stabilization, Balkema, 191-198) hung
///      from the perimeter; it needs no centre.
class SlipSurface {
  public:
    /// @param shape none: ellipsoid where the whole perimeter can be seen from its centroid, else base level
    /// Throws Error(input) where the perimeter holds no cell's centre or lies on ground without data, and for an
    /// ellipsoid that was asked for but cannot be.
    SlipSurface(const Raster& ground, const MultiPolygon& perimeter, std::optional<SlipShape> shape);

    [[nodiscard]] SlipShape shape() const noexcept { return shape_; }
    /// Vertical thickness above the surface for a greatest depth D [m]; 0 outside.
    [[nodiscard]] Raster thickness(double depth) const;
    /// Volume above the surface for a greatest depth D, cell by cell [m3].
    [[nodiscard]] double volume(double depth) const;
    /// The depth D that gives a volume [m3], cell by cell, to a thousand-millionth.
    [[nodiscard]] double depth_for(double volume) const;

  private:
    Raster above_membrane_;  ///< ground less membrane [m]; 0 outside
    Raster form_;            ///< f
    SlipShape shape_ = SlipShape::base_level;
};

/// Whether every point of an outline can be seen from its centroid: one part, no holes, star-shaped.
bool visible_from_centroid(const MultiPolygon& outline);

/// Centroid of the area.
Point centroid(const MultiPolygon& outline);

}  // namespace frana
