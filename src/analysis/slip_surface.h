// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry.h"
#include "core/raster.h"

namespace frana {

/// Shape of a slip surface fitted to a perimeter.
enum class SlipShape {
    ellipsoid,   ///< every section through the centroid is a quarter of an ellipse to either side
    base_level,  ///< constant curvature: the sloping local base level
};

/// A slip surface that meets the ground all along a perimeter (elevations in metres).
///
///     z(x, y) = m(x, y) - D f(x, y),     thickness = max(0, ground - z)
///
/// m  membrane spanned over the perimeter: the mean of its four neighbours in every cell inside, the ground
///    outside; on a plane slope it is the plane. D greatest depth below it [m]. f in [0, 1], 0 on the perimeter:
///    - ellipsoid: f = sqrt(1 - r^2), r the distance from the centroid relative to that of the perimeter in the same
///      direction. On a plane slope with an ellipse of semi-axes a, b this is half an ellipsoid of volume
///      2/3 pi a b D, the geometry of the IAEG Commission on Landslides (1990, Bull. IAEG 41, 13-16);
///    - base level: in every cell the mean of the four neighbours plus a constant, which makes z the sloping local
///      base level (Jaboyedoff et al. 2004, in Landslides: Evaluation and Stabilization, Balkema, 191-198) attached
///      to the perimeter; it needs no centre.
class SlipSurface {
  public:
    /// An ellipsoid if the perimeter is star-shaped about its centroid, else base level. Throws Error(input) if the
    /// perimeter contains no cell's centre or is on ground without data.
    SlipSurface(const Raster& ground, const MultiPolygon& perimeter);

    [[nodiscard]] SlipShape shape() const noexcept { return shape_; }
    /// Returns the vertical thickness above the surface for a greatest depth D [m]; 0 outside.
    [[nodiscard]] Raster thickness(double depth) const;
    /// Returns the volume above the surface for a greatest depth D, summed by cells [m3].
    [[nodiscard]] double volume(double depth) const;
    /// Returns the depth D that gives a volume [m3], summed by cells, to 1e-9.
    [[nodiscard]] double depth_for(double volume) const;

  private:
    Raster above_membrane_;  ///< ground minus membrane [m]; 0 outside
    Raster form_;            ///< f
    SlipShape shape_;
};

/// Returns whether every point of an outline is visible from its centroid: one part, no holes, star-shaped.
bool visible_from_centroid(const MultiPolygon& outline);

/// Returns the centroid of the area.
Point centroid(const MultiPolygon& outline);

}  // namespace frana
