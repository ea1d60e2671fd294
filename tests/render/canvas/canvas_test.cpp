// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/canvas.h"

#include <gtest/gtest.h>

#include <array>

#include "core/error.h"

namespace frana::render {
namespace {

/// Returns a pixel of the page; null outside the overlay.
const std::uint8_t* at(const OverlayImage& layer, int column, int row) {
    static constexpr std::uint8_t k_nothing[4]{};
    const int x = column - layer.left, y = row - layer.top;
    if (x < 0 || y < 0 || x >= layer.width || y >= layer.height) return k_nothing;
    return layer.rgba.data() + 4 * (y * layer.width + x);
}

TEST(Canvas, BoxesCoverTheirPixelsExactly) {
    Canvas canvas(60, 40);
    canvas.fill(PageBox{10, 5, 20, 12}, {200, 100, 50});
    const OverlayImage layer = canvas.draw();
    for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 60; ++column) {
            const bool inside = column >= 10 && column < 20 && row >= 5 && row < 12;
            ASSERT_EQ(at(layer, column, row)[3], inside ? 255 : 0) << column << ", " << row;
            if (inside) {
                EXPECT_EQ(at(layer, column, row)[0], 200);
                EXPECT_EQ(at(layer, column, row)[2], 50);
            }
        }
    }
}

TEST(Canvas, LaterShapesCoverEarlierOnes) {
    Canvas canvas(30, 30);
    canvas.fill(PageBox{0, 0, 30, 30}, {10, 20, 30});
    canvas.fill(PageBox{10, 10, 20, 20}, {200, 210, 220});
    const OverlayImage layer = canvas.draw();
    EXPECT_EQ(at(layer, 15, 15)[0], 200);
    EXPECT_EQ(at(layer, 5, 5)[0], 10);
}

TEST(Canvas, HalfCoveredPixelsAreHalfInked) {
    Canvas canvas(20, 20);
    canvas.fill(PageBox{2.5, 2, 10, 10}, {0, 0, 0});
    // Eight samples, one in each eighth of the pixel: half of them are in the right half.
    EXPECT_NEAR(at(canvas.draw(), 2, 5)[3], 127.5, 1);
}

TEST(Canvas, LinesHaveTheirWidthAndDashesTheirGaps) {
    Canvas canvas(100, 40);
    const std::array<Point, 2> line{{{10, 20}, {90, 20}}};
    canvas.line(line, {4, {0, 0, 0}, 1, {}});
    OverlayImage layer = canvas.draw();
    double width = 0;
    for (int row = 0; row < 40; ++row) width += at(layer, 50, row)[3] / 255.0;
    EXPECT_NEAR(width, 4, 0.05);  // coverage is counted in eighths and bytes

    Canvas broken(100, 40);
    broken.line(line, {4, {0, 0, 0}, 1, {10, 10}});
    layer = broken.draw();
    EXPECT_EQ(at(layer, 15, 20)[3], 255);
    EXPECT_EQ(at(layer, 25, 20)[3], 0);
    EXPECT_EQ(at(layer, 35, 20)[3], 255);
}

TEST(Canvas, TranslucentInkMixesWithThePage) {
    Canvas canvas(10, 10);
    canvas.fill(PageBox{0, 0, 10, 10}, {0, 0, 0}, 0.5);
    Image page(10, 10, {200, 200, 200});
    compose(page, canvas.draw());
    EXPECT_NEAR(page.colour(5, 5).r, 100, 2);  // two roundings to bytes
}

TEST(Canvas, NothingDrawnIsTransparent) {
    const OverlayImage layer = Canvas(16, 16).draw();
    for (const std::uint8_t byte : layer.rgba) ASSERT_EQ(byte, 0);
}

TEST(Canvas, SizesBeyondOpenGlAreRefused) {
    Canvas canvas(100000, 10);
    canvas.fill(PageBox{0, 0, 100000, 10}, {0, 0, 0});
    try {
        static_cast<void>(canvas.draw());
        FAIL() << "was drawn";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
    }
}

}  // namespace
}  // namespace frana::render
