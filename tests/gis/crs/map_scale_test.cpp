// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/crs_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gis/crs/crs.h"

namespace frana::gis {
namespace {

MapScale scale_of(const char* crs, Point map) {
    return map_scale(crs_from_user(crs, ""), map);
}

// 100 m lines measured in degrees of 1e-15 relative precision: 1e-7 at worst.
constexpr double k_rounding = 2e-7;

TEST(MapScale, IsTheProjectionsOwnWhereItIsKnown) {
    // UTM's central meridian, by definition.
    EXPECT_NEAR(scale_of("EPSG:32632", {500000, 5094000}).least, 0.9996, k_rounding);
    EXPECT_NEAR(scale_of("EPSG:32632", {500000, 5094000}).greatest, 0.9996, k_rounding);
    // The universal polar stereographic's pole, by definition.
    EXPECT_NEAR(scale_of("EPSG:5041", {2000100, 2000100}).least, 0.994, 1e-6);
    EXPECT_EQ(map_scale("", {1, 2}).error(), 0);
}

TEST(MapScale, WebMercatorIsLargeByOneOverTheCosine) {
    // x and y of 9 E 46 N. On the sphere that the projection assumes the scale is 1 / cos(latitude); on the
    // ellipsoid it is a / N along the parallel and a / M along the meridian of that.
    const double latitude = 46 * std::numbers::pi / 180, e2 = 0.00669437999014;
    const double w2 = 1 - e2 * std::pow(std::sin(latitude), 2);
    const double along_parallel = std::sqrt(w2) / std::cos(latitude);
    const double along_meridian = std::pow(w2, 1.5) / (1 - e2) / std::cos(latitude);
    const MapScale scale = scale_of("EPSG:3857", {1001875.417, 5780349.220});
    EXPECT_NEAR(scale.least, along_parallel, 1e-6);
    EXPECT_NEAR(scale.greatest, along_meridian, 1e-6);
    EXPECT_GT(scale.error(), 0.44);
}

}  // namespace
}  // namespace frana::gis
