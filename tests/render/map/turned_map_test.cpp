// SPDX-License-Identifier: Apache-2.0
// Maps turned on their page: where a place lies, where north is, what the coordinates beside the frame say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "render/map/legend.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"
#include "scenes.h"

namespace frana::render {
namespace {

constexpr double k_degree = std::numbers::pi / 180;

/// Two patches of cells in two classes: the first at row 50, column 60, the second 200 m further north.
Raster patches() {
    Raster raster(test::terrain().grid, k_no_data);
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column) {
            raster.at(48 + row, 58 + column) = 1;
            raster.at(28 + row, 58 + column) = 2;
        }
    return raster;
}

MapSpec map_of_patches(const Raster& ground, const Raster& layer) {
    MapSpec spec = test::full_map(ground, layer, 1400, 1100);
    spec.outlines.clear();
    spec.contours = false;
    spec.categories = {{1, "first", {200, 0, 0}}, {2, "second", {0, 0, 200}}};
    return spec;
}

/// Middle of the pixels of a colour inside the frame.
Point middle_of(const Image& picture, const PageBox& frame, Rgb colour) {
    double x = 0, y = 0, count = 0;
    for (int row = static_cast<int>(frame.top) + 3; row < frame.bottom - 3; ++row)
        for (int column = static_cast<int>(frame.left) + 3; column < frame.right - 3; ++column)
            if (test::shows(picture.colour(column, row), test::in_legend(colour))) {
                x += column + 0.5;
                y += row + 0.5;
                ++count;
            }
    EXPECT_GT(count, 100);
    return {x / count, y / count};
}

// North on the page is `deg` clockwise from straight up: 200 m northwards, the second patch lies so from the first.
TEST(TurnedMap, NorthIsWhereTheArrowPoints) {
    const Raster ground = test::terrain(), layer = patches();
    for (const double deg : {0.0, 30.0, -75.0, 90.0, 135.0, 180.0}) {
        MapSpec spec = map_of_patches(ground, layer);
        spec.turn = MapTurn(deg);
        MapLayout layout;
        const Image picture = draw_map(spec, &layout);
        const Point first = middle_of(picture, layout.map, {200, 0, 0}),
                    second = middle_of(picture, layout.map, {0, 0, 200});
        const double metre = layout.metres_per_pixel;
        // The middles of some hundred pixels are known to a pixel.
        EXPECT_NEAR((second.x - first.x) * metre, 200 * std::sin(deg * k_degree), metre) << deg;
        EXPECT_NEAR((first.y - second.y) * metre, 200 * std::cos(deg * k_degree), metre) << deg;
        EXPECT_NEAR(layout.north_arrow_deg, deg + spec.convergence_deg, 1e-12);
        // A place by the layout: page coordinates are metres to the right and upwards.
        const Point place = ground.grid.cell_centre(50, 60), page = layout.turn.page(place);
        EXPECT_NEAR(layout.map.left + (page.x - layout.window.west) / metre, first.x, 1) << deg;
        EXPECT_NEAR(layout.map.top + (layout.window.north - page.y) / metre, first.y, 1) << deg;
    }
}

// A wide frame, which is drawn in pieces.
MapFrame frame_at(double deg) {
    const MapTurn turn(deg);
    const Point middle = turn.page({527600, 5094500});
    return {0, 0, 1500, 300, {middle.x - 375, middle.y - 75, middle.x + 375, middle.y + 75}, turn};
}

constexpr Rgb k_usual{205, 205, 205}, k_dark{82, 82, 82};  // ground on which colours are the legend's; beside cells

// Values that rise evenly: the mean of the cells around a pixel is the value at its centre.
TEST(TurnedMap, EachPixelHasTheClassOfItsPlace) {
    const ColourScale scale({"depth", {0, 1, 2, 3, 4, 5, 6}, {}, nullptr, false, {}});
    for (const double cell_size : {0.31, 1.0, 7.3}) {  // smaller and larger than a pixel, half a metre
        Raster layer(GridSpec{527300, 5094330, cell_size, static_cast<std::int64_t>(600 / cell_size),
                              static_cast<std::int64_t>(300 / cell_size), ""},
                     k_no_data);
        const auto value = [&](Point at) { return (at.x - layer.grid.west) / 120; };
        for (std::int64_t row = 0; row < layer.grid.rows; ++row)
            for (std::int64_t column = 0; column < layer.grid.columns; ++column)
                layer.at(row, column) = value(layer.grid.cell_centre(row, column));
        for (const double deg : {0.0, 33.0, -90.0, 171.5}) {
            const MapFrame frame = frame_at(deg);
            Image face(frame.width, frame.height, k_usual);
            paint_cells(face, frame, layer, scale, 1);
            for (int row = 0; row < frame.height; ++row)
                for (int column = 0; column < frame.width; ++column) {
                    const Point at =
                        frame.turn.map({frame.window.west + (column + 0.5) / 2, frame.window.north - (row + 0.5) / 2});
                    const double x = std::min(at.x - layer.grid.west, layer.grid.east() - at.x),
                                 y = std::min(at.y - layer.grid.south(), layer.grid.north - at.y),
                                 inside = std::min(x, y), fraction = value(at) - std::floor(value(at));
                    const Rgb colour = face.colour(column, row);
                    if (inside < -1e-6) {
                        ASSERT_TRUE(colour == k_usual || colour == k_dark) << column << ", " << row << " at " << deg;
                    } else if (inside > cell_size && std::min(fraction, 1 - fraction) > 1e-6) {
                        ASSERT_EQ(colour, scale.find(value(at))->colour) << column << ", " << row << " at " << deg;
                    }
                }
        }
    }
}

// The rim of a slanting flow has steps of a pixel, not of a cell; its area stays.
TEST(TurnedMap, EdgesOfCellsAreSmooth) {
    const ColourScale scale({"depth", {0, 1, 2}, {}, nullptr, false, {}});
    Raster layer(GridSpec{527500, 5094600, 10, 20, 20, ""}, k_no_data);
    double area = 0;
    for (std::int64_t row = 0; row < 20; ++row)
        for (std::int64_t column = 0; column < 20; ++column)
            if (row + column > 12 && row + column < 30) {
                layer.at(row, column) = 1.5;
                area += 100;
            }
    const MapFrame frame{0, 0, 400, 400, {527500, 5094400, 527700, 5094600}, {}};
    Image face(400, 400, k_usual);
    paint_cells(face, frame, layer, scale, 1);
    const Rgb flow = scale.find(1.5)->colour;
    double pixels = 0;
    int longest = 0;
    for (int row = 40; row < 200; ++row) {
        int first = 0;
        while (first < 400 && face.colour(first, row) != flow) ++first;
        int above = 0;
        while (above < 400 && face.colour(above, row - 1) != flow) ++above;
        longest = std::max(longest, std::abs(first - above));
    }
    for (int row = 0; row < 400; ++row)
        for (int column = 0; column < 400; ++column) pixels += face.colour(column, row) == flow ? 1 : 0;
    EXPECT_LE(longest, 4) << "a cell has 20";
    EXPECT_NEAR(pixels / 4, area, 0.02 * area);
}

// Red grows to the east and green to the north, whatever the turn: what VTK draws lies where it belongs.
TEST(TurnedMap, TheGroundIsDrawnInItsPlace) {
    const Bounds box{527300, 5094300, 527900, 5094700};
    const auto ramp = [&](Point map) {
        return Rgb{static_cast<std::uint8_t>(std::lround(50 + (map.x - box.west) / 4)),
                   static_cast<std::uint8_t>(std::lround(50 + (map.y - box.south) / 4)), 9};
    };
    GroundTexture texture{box, Image(300, 200)};  // of two metres
    for (int row = 0; row < 200; ++row)
        for (int column = 0; column < 300; ++column) {
            const Rgb c = ramp({box.west + 2 * column + 1, box.north - 2 * row - 1});
            std::uint8_t* p = texture.image.pixel(column, row);
            p[0] = c.r, p[1] = c.g, p[2] = c.b;
        }
    for (const double deg : {0.0, 33.0, -90.0, 171.5}) {
        const MapFrame frame = frame_at(deg);
        const Image face = draw_ground(frame, texture);
        int on = 0, off = 0;
        for (int row = 0; row < frame.height; ++row)
            for (int column = 0; column < frame.width; ++column) {
                const Point at = frame.ground(column, row);
                const Rgb colour = face.colour(column, row);
                // Up to a pixel beside the texture's sides the pixel may be on either.
                const double in = std::min({at.x - box.west, box.east - at.x, at.y - box.south, box.north - at.y});
                if (in > 1) {
                    ASSERT_TRUE(test::near(colour, ramp(at), 1)) << column << ", " << row << " at " << deg;
                    ++on;
                } else if (in < -0.5) {
                    ASSERT_EQ(colour, k_no_terrain) << column << ", " << row << " at " << deg;
                    ++off;
                }
            }
        EXPECT_GT(on, 100000) << deg;
        EXPECT_GT(off, 1000) << deg;
    }
}

// At the resolution of the page a user's picture keeps its pixels: a scanned map stays legible.
TEST(TurnedMap, ABackgroundThatIsNotTurnedKeepsItsPixels) {
    const MapFrame frame = frame_at(0);
    GroundTexture texture{frame.window, Image(frame.width, frame.height)};
    for (std::size_t i = 0; i < texture.image.rgb.size(); ++i)
        texture.image.rgb[i] = static_cast<std::uint8_t>(i * 2654435761U >> 13);
    const Image face = draw_ground(frame, texture);
    int far = 0;
    for (std::size_t i = 0; i < face.rgb.size(); ++i) far += std::abs(face.rgb[i] - texture.image.rgb[i]) > 1;
    EXPECT_EQ(far, 0);
}

TEST(TurnedMap, TurnAndItsInverseAgree) {
    for (const double deg : {0.0, 17.0, -120.0}) {
        const MapTurn turn(deg);
        const Point map{527123.4, 5094567.8}, back = turn.map(turn.page(map));
        // Rounding of numbers of seven digits.
        EXPECT_NEAR(back.x, map.x, 1e-8);
        EXPECT_NEAR(back.y, map.y, 1e-8);
    }
    EXPECT_EQ(MapTurn(0).page({0.1, 5094567.8}).y, 5094567.8) << "not turned: the same bits";
}

// A strip towards N 60 E, 800 m by 40 m: its cells are to half a cell those of the strip, which at its ends turns the
// axis by 5 / 400, less than a degree; another half is that of whole degrees.
TEST(TurnedMap, TheLongerAxisOfAFlowLiesAlongThePage) {
    const Raster ground = test::terrain();
    Raster strip(ground.grid, k_no_data);
    const Point from{527200, 5094300};
    for (std::int64_t row = 0; row < strip.grid.rows; ++row)
        for (std::int64_t column = 0; column < strip.grid.columns; ++column) {
            const Point p = strip.grid.cell_centre(row, column);
            const double x = p.x - from.x, y = p.y - from.y;
            const double along = x * std::sin(60 * k_degree) + y * std::cos(60 * k_degree),
                         across = y * std::sin(60 * k_degree) - x * std::cos(60 * k_degree);
            if (along > 0 && along < 800 && std::fabs(across) < 20) strip.at(row, column) = 1;
        }
    MapSpec spec = map_of_patches(ground, strip);
    EXPECT_NEAR(turn_along_content(spec, false).deg, 30, 1.2);
    EXPECT_NEAR(turn_along_content(spec, true).deg, -60, 1.2);
    EXPECT_NEAR(turn_along_content(spec, std::nullopt).deg, 30, 1.2) << "a page may lie with the flow";
    // A strip to the north takes less room lying: 650 m by 200 m on a page wider than high.
    const Raster north = test::tongue();
    MapSpec of_north = map_of_patches(ground, north);
    of_north.categories.clear();
    MapLayout upright, lying;
    (void)draw_map(of_north, &upright);
    of_north.turn = turn_along_content(of_north, false);
    (void)draw_map(of_north, &lying);
    EXPECT_EQ(std::fabs(of_north.turn.deg), 90);
    EXPECT_LT(lying.metres_per_pixel, upright.metres_per_pixel);
}

// Turned by 90 degrees to the right, north is to the right: northings stand below, eastings beside the frame.
TEST(TurnedMap, CoordinatesBesideTheFrameAreThoseOfItsSides) {
    const Raster ground = test::terrain(), layer = patches();
    MapSpec spec = map_of_patches(ground, layer);
    spec.longitude_latitude = test::degrees_at;
    for (const double deg : {0.0, 20.0, 90.0, -110.0}) {
        spec.turn = MapTurn(deg);
        MapLayout layout;
        (void)draw_map(spec, &layout);
        const double metre = layout.metres_per_pixel;
        int below = 0, beside = 0, above = 0;
        for (const TextBox& text : layout.texts) {
            int thousands = 0, millions = 0, units = 0, degrees = 0, minutes = 0, seconds = 0;
            char side = 0;
            const Point centre{(text.box.left + text.box.right) / 2, (text.box.top + text.box.bottom) / 2};
            const auto ground_at = [&](double x, double y) {
                return layout.turn.map({layout.window.west + (x - layout.map.left) * metre,
                                        layout.window.north - (y - layout.map.top) * metre});
            };
            if (std::sscanf(text.text.c_str(), "%d°%d′%d″ %c", &degrees, &minutes, &seconds, &side) == 4) {
                const double value = degrees + minutes / 60.0 + seconds / 3600.0;
                const bool is_above = centre.y < layout.map.top;
                const Point at = test::degrees_at(is_above ? ground_at(centre.x, layout.map.top)
                                                           : ground_at(layout.map.right, centre.y));
                // A pixel and a half, as on a map that is not turned, at most 1.5 times as far along the side.
                EXPECT_NEAR(side == 'E' ? at.x : at.y, value,
                            (deg == 0 ? 1.5 : 2.2) * metre / (deg == 0 && side == 'N' ? 110e3 : 80e3))
                    << text.text << " at " << deg;
                above += is_above;
                continue;
            }
            double value = 0;
            if (std::sscanf(text.text.c_str(), "%d %d %d %c", &millions, &thousands, &units, &side) == 4)
                value = millions * 1e6 + thousands * 1e3 + units;
            else if (std::sscanf(text.text.c_str(), "%d %d %c", &thousands, &units, &side) == 3)
                value = thousands * 1e3 + units;
            if (value == 0 || (side != 'E' && side != 'N')) continue;
            const bool is_below = centre.y > layout.map.bottom;
            const Point at = is_below ? ground_at(centre.x, layout.map.bottom) : ground_at(layout.map.left, centre.y);
            // Two roundings to whole pixels.
            EXPECT_NEAR(side == 'E' ? at.x : at.y, value, (deg == 0 ? 1.5 : 2.2) * metre) << text.text << " at " << deg;
            EXPECT_EQ(side == 'E', (deg <= 20 && deg >= 0) == is_below) << text.text << " at " << deg;
            (is_below ? below : beside) += 1;
        }
        EXPECT_GE(below, 2) << deg;
        EXPECT_GE(beside, 1) << deg;
        EXPECT_GE(above, 1) << deg;
    }
}

}  // namespace
}  // namespace frana::render
