// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/crs_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "gis/crs/crs.h"
#include "support/files.h"
#include "support/problems.h"

namespace frana::gis {
namespace {

using test::error_of;

struct Case {
    const char* from;
    const char* to;
    Point start, end;
    double accuracy_m;
};

// The ends were computed with GDAL's gdaltransform (GDAL 3.6.2, PROJ 9.1.1), a separate program, and cs2cs agrees to
// its last digit: echo X Y | gdaltransform -s_srs FROM -t_srs TO -output_xy
// 1 cm is the accuracy needed for a map. The accuracies are those stated by projinfo -s FROM -t TO --summary.
constexpr double k_metres = 0.01;
constexpr double k_degree_rounding = 1e-7;

class Known : public testing::TestWithParam<Case> {};

TEST_P(Known, AgreesWithGdaltransform) {
    const Case& c = GetParam();
    const CrsTransform transform(crs_from_user(c.from, ""), crs_from_user(c.to, ""),
                                 Bounds{c.start.x, c.start.y, c.start.x, c.start.y});
    const Point end = transform(c.start);
    const double tolerance = std::string(c.to) == "EPSG:4326" ? k_degree_rounding : k_metres;
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
        // Degrees: longitude first although EPSG:4326 has latitude first.
        Case{"EPSG:4326", "EPSG:32632", {9.38, 46.0}, {529424.272046, 5094117.681870}, 0},
        Case{"EPSG:32632", "EPSG:4326", {529421, 5094042}, {9.37995308172, 45.99931899255}, 0},
        Case{"EPSG:4326", "EPSG:32719", {-70.5, -33.4}, {360505.619897, 6303362.288123}, 0},
        // Gauss-Boaga on the datum Monte Mario; a missed shift would be off by some 100 m.
        Case{"EPSG:3003", "EPSG:32632", {1529430, 5094000}, {529401.483581, 5093978.921519}, 4},
        Case{"EPSG:32632", "EPSG:3003", {529421.3, 5094001.7}, {1529449.817497, 5094022.778938}, 4},
        // Axes north, east in the register; easting first in files. In Tyrol PROJ also offers an operation meant for
        // Styria, one metre off here and listed as more accurate.
        Case{"EPSG:31287", "EPSG:32632", {300000, 380000}, {727461.323950, 5244210.718594}, 1.5},
        Case{"EPSG:31287", "EPSG:4326", {300000, 380000}, {12.0095696273656, 47.3118301646198}, 1.5},
        Case{"EPSG:31468", "EPSG:25832", {4450000, 5260000}, {675949.022964, 5260768.369819}, 0.9},
        Case{"EPSG:4326", "EPSG:3003", {9.38, 46}, {1529452.790083, 5094138.762985}, 4},
        Case{"EPSG:4326", "EPSG:31287", {12, 47.3}, {299254.155483, 378697.782914}, 1.5},
        Case{"EPSG:31287", "EPSG:32633", {300000, 380000}, {273985.103042, 5244154.998277}, 1.5},
        // Switzerland: LV95, an oblique Mercator on Bessel's ellipsoid.
        Case{"EPSG:4326", "EPSG:2056", {8.5, 46.5}, {2681473.380674, 1150404.762623}, 1},
        Case{"EPSG:2056", "EPSG:4326", {2700000, 1160000}, {8.743385954502, 46.583792507132}, 1},
        Case{"EPSG:2056", "EPSG:32632", {2700000, 1160000}, {480339.793026, 5158946.150496}, 1},
        // Washington State Plane, US survey feet: north, south, and south again on NAD83(HARN). International
        // feet would be off by some 2 mm per kilometre, 0.8 m here.
        Case{"EPSG:2285", "EPSG:32610", {1300000, 200000}, {559331.163911, 5265468.930821}, 4},
        Case{"EPSG:2286", "EPSG:32610", {1200000, 400000}, {557914.387000, 5140641.779232}, 4},
        Case{"EPSG:2927", "EPSG:32610", {1200000, 400000}, {557913.263360, 5140642.392890}, 1},
        // South of the equator; New Zealand's own system.
        Case{"EPSG:4326", "EPSG:32759", {170.2, -43.5}, {435324.423991, 5183347.802122}, 0},
        Case{"EPSG:2193", "EPSG:32759", {1400000, 5170000}, {461435.044303, 5172872.161195}, 1},
        // Polar stereographic: Greenland and Svalbard, Antarctica, and the north pole's grid in both orders.
        Case{"EPSG:4326", "EPSG:3413", {16, 78.5}, {1093094.660701, -605912.264521}, 0},
        Case{"EPSG:3413", "EPSG:32633", {1096000, -610000}, {520123.947487, 8709709.380810}, 0},
        Case{"EPSG:4326", "EPSG:3031", {166, -77.5}, {329824.327857, -1322853.125587}, 0},
        Case{"EPSG:4326", "EPSG:5041", {16, 85}, {2153104.806630, 1466060.085938}, 0},
        Case{"EPSG:4326", "EPSG:32661", {16, 85}, {2153104.806630, 1466060.085938}, 0},
        // From one UTM zone far into the next.
        Case{"EPSG:32632", "EPSG:32633", {760000, 5100000}, {295448.898866, 5097909.447941}, 0},
        Case{"EPSG:32633", "EPSG:32632", {260000, 5100000}, {724490.276766, 5099415.182418}, 0},
        // Both sides of the antimeridian in one zone (Taveuni, Fiji), and from its zone to the next.
        Case{"EPSG:4326", "EPSG:32660", {-179.95, -16.5}, {825630.287576, -1826707.139290}, 0},
        Case{"EPSG:4326", "EPSG:32701", {179.95, -16.5}, {174369.712424, 8173292.860710}, 0},
        Case{"EPSG:32701", "EPSG:4326", {180000, 8170000}, {-179.997775630926, -16.530488949672}, 0},
        Case{"EPSG:32760", "EPSG:32701", {820000, 8170000}, {179524.749165, 8169992.913257}, 0},
        Case{"EPSG:27700", "EPSG:32630", {400000, 300000}, {567634.387562, 5827997.991440}, 2},
        Case{"EPSG:2053", "EPSG:32735", {100000, 2900000}, {599851.847833, 7101160.833643}, 1}));

TEST(CrsTransform, EqualCrssLeaveCoordinatesToTheLastBit) {
    const std::string utm = crs_from_user("EPSG:32632", "");
    for (const char* other : {"EPSG:32632", "EPSG:25832"}) {  // WGS 84 and ETRS89: the same ground
        const CrsTransform transform(utm, crs_from_user(other, ""), Bounds{529000, 5094000, 530000, 5095000});
        EXPECT_TRUE(transform.is_identity());
        EXPECT_EQ(transform(Point{529421.123456789, 5094042.1}).x, 529421.123456789);
    }
    EXPECT_TRUE(CrsTransform("", utm).is_identity());
    EXPECT_EQ(CrsTransform("", utm).info().operation, "none");
    EXPECT_FALSE(
        CrsTransform(utm, crs_from_user("EPSG:32633", ""), Bounds{529000, 5094000, 530000, 5095000}).is_identity());
}

TEST(CrsTransform, ReportsAMissingBetterGrid) {
    // Debian does not contain OSTN15: the Helmert operation remains, 2 m instead of centimetres.
    const CrsTransform transform(crs_from_user("EPSG:27700", ""), crs_from_user("EPSG:4326", ""),
                                 Bounds{400000, 300000, 401000, 301000});
    EXPECT_TRUE(transform.info().needs_missing_grid);
    EXPECT_EQ(transform.info().accuracy_m, 2);
    EXPECT_NE(transform.info().missing_grid.find("OSTN15"), std::string::npos) << transform.info().missing_grid;
    EXPECT_LT(transform.info().missing_accuracy_m, 2);
}

TEST(CrsTransform, AnAreaAcrossTheAntimeridianIsASmallOne) {
    // For an area around the whole Earth, PROJ's choice for Fiji 1986 would not be Fiji's.
    const CrsTransform transform(crs_from_user("EPSG:4720", ""), crs_from_user("EPSG:32760", ""),
                                 Bounds{179.9, -16.6, 180.1, -16.4});
    const CrsTransform west(crs_from_user("EPSG:4720", ""), crs_from_user("EPSG:32760", ""),
                            Bounds{179.7, -16.6, 179.9, -16.4});
    EXPECT_EQ(transform.info().operation, west.info().operation);
    EXPECT_EQ(transform.source_turn(), 360);
    EXPECT_EQ(CrsTransform(crs_from_user("EPSG:32632", ""), crs_from_user("EPSG:32633", "")).source_turn(), 0);
}

TEST(CrsTransform, PointsBeyondTheProjectionAreRefusedOrMarked) {
    const CrsTransform transform(crs_from_user("EPSG:4326", ""), crs_from_user("EPSG:32632", ""));
    const Error error = error_of([&] { (void)transform(Point{529421, 5094042}); });
    EXPECT_TRUE(has_problem(error.problems(), "", "529421, 5094042"));
    std::vector<double> x{9.38, 529421}, y{46, 5094042};
    EXPECT_FALSE(transform.apply(x, y, false));
    EXPECT_NEAR(x[0], 529424.272, k_metres);
    EXPECT_TRUE(std::isnan(x[1]) && std::isnan(y[1]));
}

TEST(CrsTransform, BoundsFollowCurvedEdges) {
    const CrsTransform transform(crs_from_user("EPSG:4326", ""), crs_from_user("EPSG:32632", ""));
    const Bounds b = transform.around({8, 46, 10, 47});
    // The southern edge is curved towards the central meridian: its lowest point is there, not at a corner.
    EXPECT_NEAR(b.south, transform(Point{9, 46}).y, 1.0);
    EXPECT_LT(b.south, transform(Point{8, 46}).y - 100);
}

}  // namespace
}  // namespace frana::gis
