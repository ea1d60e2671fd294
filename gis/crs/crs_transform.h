// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/geometry.h"
#include "core/grid_spec.h"

namespace frana::gis {

/// Metres on the map per metre on the ellipsoid, the least and the greatest over all directions at one place.
struct MapScale {
    double least = 1, greatest = 1;

    /// Relative error of lengths on the map.
    [[nodiscard]] double error() const noexcept;
};

/// Returns the scale of a projected CRS in metres at a place in its coordinates; 1 for "" (local). Measured with
/// geodesics (Karney 2013, doi 10.1007/s00190-012-0578-z) along four directions. Throws Error(input) if the projection
/// has no inverse.
MapScale map_scale(const std::string& wkt, Point map);

/// The operation applied between two CRSs, for the log and the check of inputs.
struct TransformInfo {
    std::string operation;            ///< PROJ's name for it; "none" if coordinates are unchanged
    double accuracy_m = 0;            ///< stated accuracy [m]; below 0: unknown
    bool needs_missing_grid = false;  ///< a more accurate operation exists, but its grid file is not installed
    std::string missing_grid;         ///< that file's name, if PROJ knows it
    double missing_accuracy_m = -1;   ///< stated accuracy with that file [m]; below 0: unknown
};

/// Transforms coordinates from one CRS to another, x to the east (longitude) and y to the north (latitude) on both
/// sides whatever the authority's axis order; heights are unchanged. One operation is used for the whole area, PROJ's
/// best with the installed grids, so that no seam crosses a scene.
class CrsTransform {
  public:
    /// `area_of_interest` is in coordinates of `from_wkt`; without it the operation is chosen for the CRSs' whole
    /// common area. With an empty WKT on either side, or CRSs that agree to 1 mm, coordinates are unchanged. Throws
    /// Error(input) if there is no operation between the two.
    CrsTransform(const std::string& from_wkt, const std::string& to_wkt,
                 std::optional<Bounds> area_of_interest = std::nullopt);
    ~CrsTransform();
    CrsTransform(CrsTransform&&) noexcept;
    CrsTransform& operator=(CrsTransform&&) noexcept;

    /// Throws Error(input) naming the point if it cannot be transformed.
    [[nodiscard]] Point operator()(Point from) const;
    /// The inverse; throws likewise.
    [[nodiscard]] Point inverse(Point to) const;
    /// In place; a point that cannot be transformed becomes NaN. Returns whether all were transformed.
    bool apply(std::span<double> x, std::span<double> y, bool backwards) const;

    /// Returns the smallest rectangle around a transformed one, with 21 points along each edge.
    [[nodiscard]] Bounds around(const Bounds& from) const;

    [[nodiscard]] const TransformInfo& info() const noexcept;
    [[nodiscard]] bool is_identity() const noexcept;
    /// A full turn of longitude in units of the source CRS (360); 0 where that is not geographic.
    [[nodiscard]] double source_turn() const noexcept;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace frana::gis
