// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/crs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/files.h"

namespace frana::gis {
namespace {

using test::error_of;

TEST(Crs, ReadsWhatUsersWrite) {
    for (const char* text : {"EPSG:32632", "+proj=utm +zone=32 +datum=WGS84", "EPSG:3003"}) {
        const std::string wkt = crs_from_user(text, "scene.ini: terrain.crs");
        EXPECT_TRUE(is_projected_in_metres(wkt)) << text;
        EXPECT_EQ(crs_from_user(wkt, ""), wkt) << "its own WKT must come back";
    }
}

TEST(Crs, RefusesInvalidTextNamingTheKeyAndARemedy) {
    for (const char* text : {"UTM 32", "EPSG:1", "", "32632x", "/etc/hostname"}) {
        const Error error = error_of([&] { (void)crs_from_user(text, "scene.ini: terrain.crs"); });
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_EQ(error.problems().front().where, "scene.ini: terrain.crs");
        EXPECT_NE(error.problems().front().remedy.find("EPSG:"), std::string::npos);
    }
}

TEST(Crs, NamesForMessages) {
    EXPECT_EQ(crs_name(crs_from_user("EPSG:32632", "")), "EPSG:32632 (WGS 84 / UTM zone 32N)");
    EXPECT_EQ(crs_name(""), "local");
}

TEST(Crs, OnlyMetresEastAndNorthMakeSquareCells) {
    EXPECT_TRUE(is_projected_in_metres(crs_from_user("EPSG:31287", "")));  // axes north, east: only the order differs
    EXPECT_FALSE(is_projected_in_metres(crs_from_user("EPSG:4326", "")));
    EXPECT_FALSE(is_projected_in_metres(crs_from_user("EPSG:2927", "")));  // US survey feet
    EXPECT_FALSE(is_projected_in_metres(crs_from_user("EPSG:2053", "")));  // axes west and south
    EXPECT_FALSE(is_projected_in_metres(""));
    // Around the poles both axes follow meridians.
    for (const char* polar : {"EPSG:3413", "EPSG:3031", "EPSG:5041", "EPSG:32661", "EPSG:32761"})
        EXPECT_TRUE(is_projected_in_metres(crs_from_user(polar, ""))) << polar;
    EXPECT_TRUE(is_projected_in_metres(crs_from_user("EPSG:25832+5783", "")));  // with heights
}

TEST(Crs, HeightsAreSeparate) {
    const std::string compound = crs_from_user("EPSG:2927+6360", "");  // heights in US survey feet
    EXPECT_NEAR(vertical_metres_per_unit(compound), 1200.0 / 3937.0, 1e-12);
    EXPECT_EQ(vertical_metres_per_unit(crs_from_user("EPSG:2927", "")), 0);
    EXPECT_EQ(crs_name(horizontal_crs(compound)).substr(0, 9), "EPSG:2927");
}

TEST(Crs, UtmZones) {
    EXPECT_EQ(crs_name(utm_crs_for(9.38, 46)).substr(0, 10), "EPSG:32632");
    EXPECT_EQ(crs_name(utm_crs_for(-70.5, -33.4)).substr(0, 10), "EPSG:32719");
    EXPECT_EQ(crs_name(utm_crs_for(-180, 10)).substr(0, 10), "EPSG:32601");
    EXPECT_EQ(crs_name(utm_crs_for(180, 10)).substr(0, 10), "EPSG:32660");
    EXPECT_EQ(crs_name(utm_crs_for(180.5, -10)).substr(0, 10), "EPSG:32701");
}

TEST(Crs, TrueNorthIsWestOfGridNorthEastOfTheCentralMeridian) {
    const std::string utm = crs_from_user("EPSG:32632", "");
    // First term of the series, (longitude - 9) sin(latitude); the next is below 1e-6 degrees here.
    const double expected = -(9.38 - 9) * std::sin(46 * std::numbers::pi / 180);
    EXPECT_NEAR(meridian_convergence_deg(utm, {529424.272, 5094117.682}), expected, 1e-5);
    EXPECT_NEAR(meridian_convergence_deg(utm, {470575.728, 5094117.682}), -expected, 1e-5);
    // South of the equator the sign is reversed.
    EXPECT_GT(meridian_convergence_deg(crs_from_user("EPSG:32732", ""), {529424.272, 4905882.318}), 0.27);
    EXPECT_EQ(meridian_convergence_deg("", {1, 2}), 0);
}

}  // namespace
}  // namespace frana::gis
