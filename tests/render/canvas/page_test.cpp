// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/page.h"

#include <gtest/gtest.h>

#include <memory>
#include <regex>
#include <set>

#include "core/error.h"
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
    page.put(std::make_shared<const Image>(30, 20, Rgb{10, 20, 250}), 60, 2);
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

Image painted(Sheet& sheet, int width, int height) {
    Page page(width, height);
    page.put(sheet.take());
    return page.paint();
}

TEST(Page, BoxesCoverTheirPixelsExactly) {
    Sheet sheet(60, 40);
    sheet.fill(PageBox{0, 0, 60, 40}, {10, 20, 30});
    sheet.fill(PageBox{10, 5, 20, 12}, {200, 100, 50});
    sheet.fill(PageBox{30.5, 5, 40, 12}, {255, 255, 255});
    const Image page = painted(sheet, 60, 40);
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 29; ++column) {
            const bool inside = column >= 10 && column < 20 && row >= 5 && row < 12;
            ASSERT_EQ(page.colour(column, row), inside ? (Rgb{200, 100, 50}) : (Rgb{10, 20, 30}))
                << column << ", " << row;
        }
    EXPECT_NEAR(page.colour(30, 8).r, (10 + 255) / 2, 2) << "half covered, half inked";
}

TEST(Page, LinesHaveTheirWidthAndDashesTheirGaps) {
    const std::vector<Point> line{{10, 20.3}, {90, 20.3}};
    Sheet sheet(100, 40);
    sheet.line(line, {4, {0, 0, 0}});
    double width = 0;
    const Image solid = painted(sheet, 100, 40);
    for (int row = 0; row < 40; ++row) width += (255 - solid.colour(50, row).r) / 255.0;
    EXPECT_NEAR(width, 4, 0.05);  // coverage is counted in parts of a byte
    sheet.line(line, {4, {0, 0, 0}, 1, {10, 10}});
    const Image broken = painted(sheet, 100, 40);
    EXPECT_EQ(broken.colour(15, 20).r, 0);
    EXPECT_EQ(broken.colour(25, 20).r, 255);
    EXPECT_EQ(broken.colour(35, 20).r, 0);
}

TEST(Page, TranslucentInkMixesWithThePage) {
    Sheet sheet(10, 10);
    sheet.fill(PageBox{0, 0, 10, 10}, {200, 200, 200});
    sheet.fill(PageBox{0, 0, 10, 10}, {0, 0, 0}, 0.5);
    EXPECT_NEAR(painted(sheet, 10, 10).colour(5, 5).r, 100, 2);  // two roundings to bytes
}

// What is put on all pages of a film is drawn once, over nothing: rounded twice, else the same.
TEST(Page, KeptPixelsAreThoseOfTheDrawing) {
    const auto page = [](bool keep) {
        Sheet sheet(200, 100);
        sheet.fill(PageBox{20, 10, 150.5, 60}, {200, 30, 60}, 0.4);
        sheet.text("Depth", {10, 80}, {20}, Across::left, Upright::baseline);
        Page all(200, 100);
        all.put(std::make_shared<const Image>(120, 90, Rgb{10, 160, 250}), 40, 5);
        all.put(sheet.take(keep));
        return all.paint();
    };
    const Image once = page(false), kept = page(true);
    for (std::size_t i = 0; i < once.rgb.size(); ++i) ASSERT_NEAR(once.rgb[i], kept.rgb[i], 2) << i;
}

TEST(Page, PicturesKeepTheirPixelsAndShrinkToTheirMean) {
    Image stripes(80, 80);
    for (int row = 0; row < 80; ++row)
        for (int column = 0; column < 80; column += 2)
            for (int k = 0; k < 3; ++k) stripes.pixel(column, row)[k] = 0;
    const auto picture = std::make_shared<const Image>(stripes);
    Page page(100, 100);
    page.put(picture, 10, 10);
    EXPECT_EQ(page.paint().colour(10, 10), (Rgb{0, 0, 0}));
    EXPECT_EQ(page.paint().colour(11, 10), (Rgb{255, 255, 255}));
    Page small(100, 100);
    small.put(picture, 10, 10, 0.25);
    for (int column = 13; column < 27; ++column) EXPECT_NEAR(small.paint().colour(column, 20).r, 127, 20) << column;
    EXPECT_EQ(small.paint().colour(31, 20), (Rgb{255, 255, 255}));
}

TEST(Page, SizesThatCairoCannotDrawAreRefused) {
    EXPECT_THROW(static_cast<void>(Page(100000, 10).paint()), Error);
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
