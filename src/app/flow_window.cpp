// SPDX-License-Identifier: Apache-2.0
#include "app/flow_window.h"

#include <algorithm>
#include <cmath>

#include "app/layer_choice.h"
#include "gis/elevation_sample.h"

namespace frana::app {
namespace {

constexpr double k_caution = 0.8;          // of the friction: the front runs ahead of the mass it belongs to
constexpr double k_least_friction = 0.01;  // with less, the energy line bounds nothing
constexpr int k_samples = 400;             // along each side of what is looked at

Bounds united(const Bounds& a, const Bounds& b) {
    return {std::min(a.west, b.west), std::min(a.south, b.south), std::max(a.east, b.east),
            std::max(a.north, b.north)};
}

Bounds widened(const Bounds& b, double by) {
    return {b.west - by, b.south - by, b.east + by, b.north + by};
}

bool holds(const Bounds& outer, const Bounds& inner) {
    return outer.west < inner.west && outer.south < inner.south && outer.east > inner.east &&
           outer.north > inner.north;
}

double distance(const Bounds& box, Point p) {
    return std::hypot(std::max({box.west - p.x, 0.0, p.x - box.east}),
                      std::max({box.south - p.y, 0.0, p.y - box.north}));
}

/// A vector file's extent; none where it cannot be read: that is reported where it is used.
std::optional<Bounds> extent(const SceneReading& reading, const std::optional<std::string>& file,
                             const LayerSpec& layer, const std::string& key, const std::string& crs) {
    if (!file) return std::nullopt;
    try {
        return gis::read_polygons(*file, crs, reading.where(key), layer_choice(reading, layer, key)).bounds;
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::optional<Bounds> release_extent(const SceneReading& reading, const std::string& crs) {
    const ReleaseSpec& release = reading.scene.release;
    if (release.perimeter)
        return extent(reading, release.perimeter, release.perimeter_layer, "release.perimeter", crs);
    if (!release.thickness || release.thickness->kind != ThicknessSpec::Kind::raster) return std::nullopt;
    try {
        const gis::RasterInfo file =
            gis::inspect_raster(release.thickness->raster, reading.where("release.thickness"));
        return gis::CrsTransform(crs.empty() ? "" : file.crs_wkt, crs, file.bounds).around(file.bounds);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Height of the mass over the ground [m]; where a file gives it, more than any landslide's.
double thickness_bound(const ReleaseSpec& release) {
    const bool number = release.thickness && release.thickness->kind == ThicknessSpec::Kind::number;
    return number ? release.thickness->metres : 100;
}

}  // namespace

std::optional<Bounds> flow_window(const SceneReading& reading, const gis::RasterInfo& dtm,
                                  const std::string& working_crs) {
    const SceneSpec& scene = reading.scene;
    if (!scene.material.friction_angle && !scene.material.friction_coefficient) return std::nullopt;
    const double friction = k_caution * friction_coefficient(scene.material);
    const std::optional<Bounds> release = release_extent(reading, working_crs);
    if (!release || friction < k_least_friction) return std::nullopt;

    const auto sample = [&](const Bounds& window) {
        return gis::sample_elevations(dtm, working_crs, window, k_samples, scene.terrain.vertical_unit,
                                      scene.terrain.nodata_value);
    };
    double top = -HUGE_VAL;
    for (const gis::ElevationSample& s : sample(*release)) top = std::max(top, s.elevation);
    if (!std::isfinite(top)) return std::nullopt;  // the release lies outside the DTM: reported later
    top += thickness_bound(scene.release);

    const gis::CrsTransform to_working(working_crs.empty() ? "" : dtm.crs_wkt, working_crs, dtm.bounds);
    const Bounds whole = to_working.around(dtm.bounds);
    Bounds needed = *release;
    if (const auto scar =
            extent(reading, scene.scar.perimeter, scene.scar.perimeter_layer, "scar.perimeter", working_crs))
        needed = united(needed, *scar);
    Bounds window = widened(needed, std::max(needed.width(), needed.height()));
    // Looks farther until what can be reached lies within what was looked at.
    for (;;) {
        const double step = std::max(window.width(), window.height()) / k_samples;
        Bounds reached = needed;
        for (const gis::ElevationSample& s : sample(window)) {
            if (s.elevation <= top - friction * distance(*release, s.place))
                reached = united(reached, {s.place.x, s.place.y, s.place.x, s.place.y});
        }
        reached = widened(reached, 2 * step);
        if (holds(window, reached) || holds(window, whole)) return reached;
        window = widened(window, std::max(window.width(), window.height()) / 2);
    }
}

}  // namespace frana::app
