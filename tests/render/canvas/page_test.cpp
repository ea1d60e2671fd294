// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/page.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "render/map/map2d.h"
#include "scenes.h"

namespace frana::render {
namespace {

Page small_page() {
    Sheet sheet(200, 100);
    sheet.fill(PageBox{100, 10, 150, 60}, {200, 30, 60});
    sheet.line(std::vector<Point>{{10, 80}, {190, 80}}, {4, {0, 90, 0}, 1, {20, 10}});
    TextStyle style{20};
    style.halo_px = 2;
    sheet.text("Depth <5> m\u00b2", {10, 50}, style, Across::left, Upright::baseline);
    Page page(200, 100);
    page.put(Image(30, 20, {10, 20, 250}), 60, 2);
    page.put(sheet.take());
    return page;
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
    return n;
}

TEST(Page, PartsAreWhereTheyWerePut) {
    const Page part = small_page();
    Page whole(500, 300);
    whole.put(part, 250, 120);
    const Image alone = part.paint(), inside = whole.paint();
    ASSERT_EQ(inside.width, 500);
    EXPECT_EQ(alone.colour(75, 10), (Rgb{10, 20, 250}));
    EXPECT_EQ(alone.colour(120, 30), (Rgb{200, 30, 60}));
    EXPECT_EQ(alone.colour(15, 80), (Rgb{0, 90, 0}));
    for (int row = 0; row < 100; ++row)
        for (int column = 0; column < 200; ++column)
            ASSERT_EQ(alone.colour(column, row), inside.colour(250 + column, 120 + row)) << column << ", " << row;
    EXPECT_EQ(inside.colour(75, 10), (Rgb{255, 255, 255}));
}

TEST(Page, PdfHasItsSizeAndTheSameBytesEveryTime) {
    const std::string pdf = page_pdf(small_page(), 100, "A title");
    EXPECT_EQ(pdf.rfind("%PDF-1.4", 0), 0U);
    EXPECT_NE(pdf.find("/MediaBox [ 0 0 144 72 ]"), std::string::npos);  // 200 x 100 pixels at 72 / 100 points
    EXPECT_NE(pdf.find("(A title)"), std::string::npos);
    EXPECT_EQ(pdf.find("CreationDate"), std::string::npos);
    EXPECT_EQ(pdf, page_pdf(small_page(), 100, "A title"));
}

TEST(Page, SvgHasTextsLinesAndPictures) {
    const std::string svg = page_svg(small_page(), 100, "A & B");
    EXPECT_NE(svg.find("width=\"50.8mm\""), std::string::npos);  // two inches
    EXPECT_NE(svg.find("<title>A &amp; B</title>"), std::string::npos);
    EXPECT_EQ(count(svg, ">Depth &lt;5&gt; m\u00b2</text>"), 1U);
    EXPECT_LE(count(svg, "<symbol"), 12U) << "the letters' shapes, each once";
    EXPECT_GE(count(svg, "<use "), 10U);
    EXPECT_EQ(count(svg, "width=\"30\" height=\"20\" xlink:href=\"data:image/png;base64,iVBORw0KGgo"), 1U);
    EXPECT_NE(svg.find("matrix(1,0,0,1,60,2)"), std::string::npos) << "where the picture is";
    EXPECT_NE(svg.find("stroke-dasharray:20,10;"), std::string::npos);
    EXPECT_EQ(count(svg, "<svg"), count(svg, "</svg>"));
    EXPECT_EQ(svg, page_svg(small_page(), 100, "A & B"));
}

std::set<std::string> ids_of(const std::string& svg) {
    std::set<std::string> ids;
    const std::regex id(" id=\"([^\"]+)\""), use("(?:\"|url\\()#([^\")]+)");
    for (std::sregex_iterator one(svg.begin(), svg.end(), id), end; one != end; ++one)
        EXPECT_TRUE(ids.insert((*one)[1]).second) << (*one)[1];
    for (std::sregex_iterator one(svg.begin(), svg.end(), use), end; one != end; ++one)
        EXPECT_TRUE(ids.contains((*one)[1])) << (*one)[1];
    return ids;
}

// Drawings stand side by side in one HTML page, where an id names the first element that has it.
TEST(Page, SvgsShareNoIds) {
    Sheet sheet(200, 100);
    sheet.text("Other", {10, 50}, {20}, Across::left, Upright::baseline);
    Page other(200, 100);
    other.put(sheet.take());
    const std::set<std::string> first = ids_of(page_svg(small_page(), 0, "")), second = ids_of(page_svg(other, 0, ""));
    EXPECT_GT(first.size(), 10U);
    EXPECT_GT(second.size(), 4U);
    for (const std::string& id : second) EXPECT_FALSE(first.contains(id)) << id;
}

// A map's lines and texts are drawn as such, whatever its relief costs.
TEST(Page, OfAMapHasEveryTextOfItsPicture) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapLayout layout;
    const Page page = map_page(test::full_map(ground, layer, 800, 600), &layout);
    const std::string svg = page_svg(page, 150, "");
    for (const TextBox& text : layout.texts) EXPECT_NE(svg.find(text.text + "</text>"), std::string::npos) << text.text;
    EXPECT_GT(count(svg, "<path style=\"fill:none;"), 20U) << "contour lines";
}

}  // namespace
}  // namespace frana::render
