// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/styles.h"

#include <gtest/gtest.h>

#include <limits>

#include <filesystem>

#include "support/files.h"

namespace frana::gis {
namespace {

using test::Folder;

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
    return n;
}

TEST(ClassStops, SpanThePalette) {
    const Palette& depth = palette("depth");
    const std::vector<ColourStop> stops = class_stops(depth, {0, 2, 4, 6}, "m");
    ASSERT_EQ(stops.size(), 3U);
    EXPECT_EQ(stops[0].value, 2);
    EXPECT_EQ(stops[0].colour, depth.anchors.front());
    EXPECT_EQ(stops[2].colour, depth.anchors.back());
    EXPECT_EQ(stops[1].label, "2 \u2013 4 m");
    EXPECT_TRUE(class_stops(depth, {1}, "m").empty());
    EXPECT_EQ(class_stops(depth, {0, 1}, "m").size(), 1U);
}

TEST(ClassStops, TheLastClassMayBeOpen) {
    const Folder folder;
    const std::vector<ColourStop> stops =
        class_stops(palette("depth"), {0, 0.5, 2, std::numeric_limits<double>::infinity()}, "m");
    ASSERT_EQ(stops.size(), 3U);
    EXPECT_EQ(stops[2].label, "> 2 m");
    write_styles(folder.file("a.tif"), stops, "m", StyleKind::classed, "Maximum depth");
    const std::string qml = test::text_in(folder.file("a.qml")), sld = test::text_in(folder.file("a.sld"));
    EXPECT_NE(qml.find("classificationMax=\"2\""), std::string::npos) << qml;
    EXPECT_EQ(count(qml, "\"inf\""), 1U);
    EXPECT_NE(sld.find("<Title>Maximum depth [m]</Title>"), std::string::npos) << sld;
}

TEST(ClassStops, NumbersAreThoseOfTheLanguage) {
    const std::vector<ColourStop> stops = class_stops(
        palette("depth"), {0.5, 1.5, std::numeric_limits<double>::infinity()}, "m", Words(Language::german), true);
    ASSERT_EQ(stops.size(), 3U);
    EXPECT_EQ(stops[0].label, "0,5");
    EXPECT_EQ(stops[1].label, "0,5 \u2013 1,5 m");
    EXPECT_EQ(stops[2].label, "> 1,5 m");
}

TEST(WriteStyles, BothFilesContainEveryClassAndItsColour) {
    const Folder folder;
    const std::vector<ColourStop> stops{{2, {255, 0, 16}, "0 - 2 m"}, {4, {0, 0, 255}, "a < b & \"c\""}};
    write_styles(folder.file("max_depth.tif"), stops, "m", StyleKind::classed);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"max_depth.qml", "max_depth.sld"}));
    const std::string qml = test::text_in(folder.file("max_depth.qml")),
                      sld = test::text_in(folder.file("max_depth.sld"));
    EXPECT_EQ(count(qml, "<item "), 2U);
    EXPECT_NE(qml.find("colorRampType=\"DISCRETE\""), std::string::npos);
    EXPECT_NE(qml.find("value=\"2\" color=\"#ff0010\""), std::string::npos);
    EXPECT_NE(qml.find("value=\"inf\" color=\"#0000ff\""), std::string::npos) << "nothing above the last class is lost";
    EXPECT_NE(qml.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
    EXPECT_EQ(count(sld, "<ColorMapEntry "), 2U);
    EXPECT_NE(sld.find("type=\"intervals\""), std::string::npos);
    EXPECT_NE(sld.find("<Name>max_depth</Name>"), std::string::npos);
}

TEST(WriteStyles, ExactClassesKeepTheirValues) {
    const Folder folder;
    write_styles(folder.file("c.tif"), {{1, {0, 1, 2}, "hit"}, {3, {4, 5, 6}, "miss"}}, "", StyleKind::exact);
    const std::string qml = test::text_in(folder.file("c.qml"));
    EXPECT_NE(qml.find("EXACT"), std::string::npos);
    EXPECT_NE(qml.find("value=\"3\" color=\"#040506\""), std::string::npos);
    EXPECT_NE(test::text_in(folder.file("c.sld")).find("quantity=\"3\""), std::string::npos);
}

TEST(WriteStyles, AMissingFolderIsAnErrorOfTheEnvironment) {
    const Folder folder;
    EXPECT_EQ(test::error_of([&] { write_styles(folder.file("no/a.tif"), {}, "m", StyleKind::ramp); }).kind(),
              ErrorKind::environment);
}

}  // namespace
}  // namespace frana::gis
