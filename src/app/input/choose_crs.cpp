// SPDX-License-Identifier: Apache-2.0
#include "app/input/choose_crs.h"

#include "app/text/number_text.h"
#include "gis/crs/crs.h"
#include "gis/crs/map_scale.h"

namespace frana::app {
namespace {

// Lengths wrong by 1 % make areas and volumes wrong by 2 %, as much as a survey's error. UTM stays within 0.1 %.
constexpr double k_largest_scale_error = 0.01;

Point centre_of(const Bounds& bounds) {
    return {(bounds.west + bounds.east) / 2, (bounds.south + bounds.north) / 2};
}

Sentence scale_of(const gis::MapScale& scale) {
    const Sentence least = numeral(number_text(scale.least, 5));
    if (scale.greatest - scale.least < 1e-4) return least;
    return worded("{1} to {2} by direction", {least, numeral(number_text(scale.greatest, 5))});
}

/// Returns the working CRS named by terrain.crs, which must measure the ground in metres at the DTM.
std::string requested_crs(const SceneReading& reading, const gis::RasterInfo& dtm) {
    const std::string where = reading.where("terrain.crs"), requested = reading.scene.terrain.crs;
    const std::string crs = gis::crs_from_user(requested, where);
    if (!gis::is_projected_in_metres(crs)) {
        throw Error(ErrorKind::input,
                    Problem{"is not a projected system in metres with axes east and north", where, requested,
                            "a projected CRS in metres, such as a UTM zone", "Choose another, or remove the key"});
    }
    std::string horizontal = gis::horizontal_crs(crs);
    if (dtm.crs_wkt.empty()) return horizontal;
    const Point centre = centre_of(dtm.bounds);
    const gis::CrsTransform to_working(dtm.crs_wkt, horizontal, Bounds{centre.x, centre.y, centre.x, centre.y});
    const gis::MapScale scale = gis::map_scale(horizontal, to_working(centre));
    if (scale.error() > k_largest_scale_error) {
        throw Error(ErrorKind::input, Problem{"lengths in this system are not lengths on the ground", where,
                                              requested + " with a scale of " + scale_of(scale).text() + " at the DTM",
                                              "a scale within 1 % of 1", "Choose a UTM zone, or remove the key"});
    }
    return horizontal;
}

/// Without a CRS coordinates must be in metres.
void check_local(const SceneReading& reading, const gis::RasterInfo& dtm) {
    if (dtm.crs_wkt.empty() || gis::is_projected_in_metres(dtm.crs_wkt)) return;
    throw Error(ErrorKind::input,
                Problem{"the DTM's coordinates are not in metres, so they cannot be used as they are",
                        reading.where("terrain.crs"), "local", "", "Remove the key: frana then chooses a UTM zone"});
}

std::string automatic_crs(const gis::RasterInfo& dtm, RunLog& log) {
    const Point centre = centre_of(dtm.bounds);
    if (gis::is_projected_in_metres(dtm.crs_wkt)) {
        std::string own = gis::horizontal_crs(dtm.crs_wkt);
        const gis::MapScale scale = gis::map_scale(own, centre);
        if (scale.error() <= k_largest_scale_error) return own;
        log.warn(
            worded("DTM: lengths in {1} are not lengths on the ground (scale {2}); the run is computed in the UTM zone "
                   "instead",
                   {dtm.crs_label, scale_of(scale)}));
    }
    const Point degrees = gis::to_longitude_latitude(dtm.crs_wkt, centre);
    return gis::utm_crs_for(degrees.x, degrees.y);
}

}  // namespace

std::string choose_working_crs(const SceneReading& reading, const gis::RasterInfo& dtm, RunLog& log) {
    const std::string& requested = reading.scene.terrain.crs;
    if (requested == "local") {
        check_local(reading, dtm);
        return {};
    }
    Problems problems;
    std::string crs;
    try {
        if (requested != "auto") crs = requested_crs(reading, dtm);
    } catch (const Error& error) {
        problems.add(error);
    }
    if (dtm.crs_wkt.empty()) {
        problems.add({"has no coordinate reference system", reading.where("terrain.dtm"), dtm.path, "",
                      "State it with terrain.dtm-crs = EPSG:..., or set terrain.crs = local to take its coordinates, "
                      "and the perimeter's, as plain metres"});
    }
    problems.throw_if_any();
    return crs.empty() ? automatic_crs(dtm, log) : crs;
}

}  // namespace frana::app
