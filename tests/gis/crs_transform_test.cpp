// SPDX-License-Identifier: Apache-2.0
#include "gis/crs_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "files.h"
#include "gis/crs.h"

namespace frana::gis {
namespace {

using test::error_of;

struct Case {
    const char* from;
    const char* to;
    Point start, end;
    double accuracy_m;
};

// The ends were computed with GDAL's gdaltransform, a program of its own; 1 cm is what a map needs.
constexpr double k_metres = 0.01;
constexpr double k_degrees = 1e-7;

class Known : public testing::TestWithParam<Case> {};

TEST_P(Known, AgreesWithGdaltransform) {
    const Case& c = GetParam();
    const CrsTransform transform(crs_from_user(c.from, ""), crs_from_user(c.to, ""),
                                 Bounds{c.start.x, c.start.y, c.start.x, c.start.y});
    const Point end = transform(c.start);
    const double tolerance = std::string(c.to) == "EPSG:4326" ? k_degrees : k_metres;
    EXPECT_NEAR(end.x, c.end.x, tolerance);
    EXPECT_NEAR(end.y, c.end.y, tolerance);
    const Point back = transform.inverse(end);
    EXPECT_NEAR(back.x, c.start.x, k_metres);
    EXPECT_NEAR(back.y, c.start.y, k_metres);
    EXPECT_EQ(transform.info().accuracy_m, c.accuracy_m);
    EXPECT_FALSE(transform.info().operation.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Places, Known,
    testing::Values(
        // Degrees: longitude first although EPSG:4326 says latitude first.
        Case{"EPSG:4326", "EPSG:32632", {9.38, 46.0}, {529424.272046, 5094117.681870}, 0},
        Case{"EPSG:32632", "EPSG:4326", {529421, 5094042}, {9.37995308172, 45.99931899255}, 0},
        Case{"EPSG:4326", "EPSG:32719", {-70.5, -33.4}, {360505.619897, 6303362.288123}, 0},
        // Gauss-Boaga on the datum Monte Mario; a missed shift would be off by some 100 m.
        Case{"EPSG:3003", "EPSG:32632", {1529430, 5094000}, {529401.483581, 5093978.921519}, 4},
        Case{"EPSG:32632", "EPSG:3003", {529421.3, 5094001.7}, {1529449.817497, 5094022.778938}, 4},
        // Axes north, east in the register; easting first in files. In Tyrol PROJ also knows an operation
        // meant for Styria, one metre off here and said to be more accurate.
        Case{"EPSG:31287", "EPSG:32632", {300000, 380000}, {727461.323950, 5244210.718594}, 1.5},
        Case{"EPSG:31287", "EPSG:4326", {300000, 380000}, {12.0095696273656, 47.3118301646198}, 1.5},
        Case{"EPSG:31468", "EPSG:25832", {4450000, 5260000}, {675949.022964, 5260768.369819}, 0.9}));

TEST(CrsTransform, EqualCrssLeaveCoordinatesToTheLastBit) {
    const std::string utm = crs_from_user("EPSG:32632", "");
    for (const char* other : {"EPSG:32632", "EPSG:25832"}) {  // WGS 84 and ETRS89: the same ground
        const CrsTransform transform(utm, crs_from_user(other, ""), Bounds{529000, 5094000, 530000, 5095000});
        EXPECT_TRUE(transform.is_identity());
        EXPECT_EQ(transform(Point{529421.123456789, 5094042.1}).x, 529421.123456789);
    }
    EXPECT_TRUE(CrsTransform("", utm).is_identity());
    EXPECT_EQ(CrsTransform("", utm).info().operation, "none");
    EXPECT_FALSE(CrsTransform(utm, crs_from_user("EPSG:32633", ""), Bounds{529000, 5094000, 530000, 5095000})
                     .is_identity());
}

TEST(CrsTransform, SaysWhenABetterGridIsMissing) {
    // Debian ships no OSTN15: the Helmert operation remains, 2 m instead of centimetres.
    const CrsTransform transform(crs_from_user("EPSG:27700", ""), crs_from_user("EPSG:4326", ""),
                                 Bounds{400000, 300000, 401000, 301000});
    EXPECT_TRUE(transform.info().needs_missing_grid);
    EXPECT_EQ(transform.info().accuracy_m, 2);
}

TEST(CrsTransform, PointsBeyondTheProjectionAreRefusedOrMarked) {
    const CrsTransform transform(crs_from_user("EPSG:4326", ""), crs_from_user("EPSG:32632", ""));
    const Error error = error_of([&] { (void)transform(Point{529421, 5094042}); });
    EXPECT_NE(std::string(error.what()).find("529421, 5094042"), std::string::npos);
    std::vector<double> x{9.38, 529421}, y{46, 5094042};
    EXPECT_FALSE(transform.apply(x, y, false));
    EXPECT_NEAR(x[0], 529424.272, k_metres);
    EXPECT_TRUE(std::isnan(x[1]) && std::isnan(y[1]));
}

TEST(CrsTransform, BoundsFollowBentEdges) {
    const CrsTransform transform(crs_from_user("EPSG:4326", ""), crs_from_user("EPSG:32632", ""));
    const Bounds b = transform.around({8, 46, 10, 47});
    // The southern edge sags towards the central meridian: its lowest point is there, not at a corner.
    EXPECT_NEAR(b.south, transform(Point{9, 46}).y, 1.0);
    EXPECT_LT(b.south, transform(Point{8, 46}).y - 100);
}

}  // namespace
}  // namespace frana::gis
