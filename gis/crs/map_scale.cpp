// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/map_scale.h"

#include <geodesic.h>

#include <algorithm>
#include <cmath>

#include "gis/access/remembered_reads.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {
namespace {

// Long compared with the rounding of degrees, short compared with the curvature of any map.
constexpr double k_baseline = 100;  // [m]
constexpr double k_wgs84_a = 6378137, k_wgs84_f = 1 / 298.257223563;

}  // namespace

double MapScale::error() const noexcept {
    return std::max(std::abs(least - 1), std::abs(greatest - 1));
}

MapScale map_scale(const std::string& wkt, Point map) {
    return remembered(
        "map_scale",
        [&]() -> MapScale {
            if (wkt.empty()) return {};
            const CrsTransform to_degrees(wkt, "OGC:CRS84", Bounds{map.x, map.y, map.x, map.y});
            geod_geodesic ellipsoid;
            geod_init(&ellipsoid, k_wgs84_a, k_wgs84_f);
            MapScale scale{HUGE_VAL, 0};
            for (const Point half : {Point{0.5, 0}, Point{0, 0.5}, Point{M_SQRT1_2 / 2, M_SQRT1_2 / 2},
                                     Point{M_SQRT1_2 / 2, -M_SQRT1_2 / 2}}) {
                const Point a = to_degrees({map.x - k_baseline * half.x, map.y - k_baseline * half.y});
                const Point b = to_degrees({map.x + k_baseline * half.x, map.y + k_baseline * half.y});
                double ground = 0;
                geod_inverse(&ellipsoid, a.y, a.x, b.y, b.x, &ground, nullptr, nullptr);
                scale.least = std::min(scale.least, k_baseline / ground);
                scale.greatest = std::max(scale.greatest, k_baseline / ground);
            }
            return scale;
        },
        wkt, map);
}

}  // namespace frana::gis
