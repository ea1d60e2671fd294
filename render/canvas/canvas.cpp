// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/module.h"

namespace frana::render {

const VtkFunctions& vtk() {
    static const auto& functions = module_table<VtkFunctions>("vtk");
    return functions;
}

std::vector<Polyline> dashed(std::span<const Point> points, const std::vector<double>& dashes) {
    constexpr double k_shortest = 0.05;  // of the first stroke: a length of zero would never advance
    std::vector<Polyline> strokes;
    std::size_t phase = 0;
    double left = dashes[0];
    Polyline stroke{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        Point from = points[i - 1];
        const Point to = points[i];
        double length = std::hypot(to.x - from.x, to.y - from.y);
        while (length > left) {
            const double fraction = left / length;
            from = {from.x + fraction * (to.x - from.x), from.y + fraction * (to.y - from.y)};
            length -= left;
            if (phase % 2 == 0) {
                stroke.push_back(from);
                strokes.push_back(std::move(stroke));
            }
            phase = (phase + 1) % dashes.size();
            left = std::max(dashes[phase], k_shortest * dashes[0]);
            stroke = {from};
        }
        left -= length;
        stroke.push_back(to);
    }
    if (phase % 2 == 0 && stroke.size() > 1) strokes.push_back(std::move(stroke));
    return strokes;
}

namespace {

std::uint32_t packed(Rgb colour, double opacity) {
    const auto alpha = static_cast<std::uint32_t>(std::lround(255 * std::clamp(opacity, 0.0, 1.0)));
    return static_cast<std::uint32_t>(colour.r) | static_cast<std::uint32_t>(colour.g) << 8U |
           static_cast<std::uint32_t>(colour.b) << 16U | alpha << 24U;
}

}  // namespace

Canvas::Canvas(int width, int height) : width_(width), height_(height) {}

void Canvas::triangle(Point a, Point b, Point c, Colour colour) {
    for (const Point p : {a, b, c}) {
        triangles_.corners.push_back(static_cast<float>(p.x));
        triangles_.corners.push_back(static_cast<float>(height_ - p.y));
        triangles_.colours.push_back(colour);
    }
}

void Canvas::stroke(std::span<const Point> points, const LineStyle& style) {
    const Colour colour = packed(style.colour, style.opacity);
    const double half = style.width_px / 2;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point a = points[i], b = points[i + 1];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length <= 0) continue;
        const Point side{-(b.y - a.y) / length * half, (b.x - a.x) / length * half};
        const Point a1{a.x + side.x, a.y + side.y}, a2{a.x - side.x, a.y - side.y};
        const Point b1{b.x + side.x, b.y + side.y}, b2{b.x - side.x, b.y - side.y};
        triangle(a1, a2, b1, colour);
        triangle(b1, a2, b2, colour);
    }
    // Round joints; gaps are invisible below two pixels, and in a translucent line joints would darken it.
    if (style.width_px < 1.9 || style.opacity < 1) return;
    constexpr int k_sides = 12;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Point centre = points[i];
        const auto rim = [&](int k) {
            const double angle = 2 * std::numbers::pi * k / k_sides;
            return Point{centre.x + half * std::cos(angle), centre.y + half * std::sin(angle)};
        };
        for (int k = 0; k < k_sides; ++k) triangle(centre, rim(k), rim(k + 1), colour);
    }
}

void Canvas::line(std::span<const Point> points, const LineStyle& style, bool closed) {
    if (points.size() < 2) return;
    Polyline whole(points.begin(), points.end());
    if (closed) {
        whole.push_back(points[0]);
        if (style.dashes.empty()) whole.push_back(points[1]);  // the join of both ends gets a round joint as well
    }
    if (style.dashes.empty()) {
        stroke(whole, style);
    } else {
        for (const Polyline& part : dashed(whole, style.dashes)) stroke(part, style);
    }
}

void Canvas::fill(std::span<const Point> corners, Rgb colour, double opacity) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        triangle(corners[0], corners[i], corners[i + 1], packed(colour, opacity));
    }
}

void Canvas::fill(const PageBox& box, Rgb colour, double opacity) {
    const std::array<Point, 4> corners{
        {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}};
    fill(corners, colour, opacity);
}

void Canvas::frame(const PageBox& box, const LineStyle& style) {
    const double half = style.width_px / 2;
    fill(PageBox{box.left - half, box.top - half, box.right + half, box.top + half}, style.colour, style.opacity);
    fill(PageBox{box.left - half, box.bottom - half, box.right + half, box.bottom + half}, style.colour, style.opacity);
    fill(PageBox{box.left - half, box.top + half, box.left + half, box.bottom - half}, style.colour, style.opacity);
    fill(PageBox{box.right - half, box.top + half, box.right + half, box.bottom - half}, style.colour, style.opacity);
}

OverlayImage Canvas::covered() const {
    float left = 1e9F, right = -1e9F, low = 1e9F, high = -1e9F;
    for (std::size_t i = 0; i < triangles_.corners.size(); i += 2) {
        left = std::min(left, triangles_.corners[i]);
        right = std::max(right, triangles_.corners[i]);
        low = std::min(low, triangles_.corners[i + 1]);
        high = std::max(high, triangles_.corners[i + 1]);
    }
    // Samples are up to half a pixel from a pixel's centre.
    const auto within = [](double edge, int length) {
        return static_cast<int>(std::clamp(edge, 0.0, static_cast<double>(length)));
    };
    OverlayImage part;
    part.left = within(std::floor(left), width_);
    part.top = height_ - within(std::ceil(high), height_);
    part.width = within(std::ceil(right), width_) - part.left;
    part.height = height_ - within(std::floor(low), height_) - part.top;
    if (part.width < 1 || part.height < 1) return {};
    return part;
}

OverlayImage Canvas::draw() const {
    OverlayImage picture = covered();
    const int width = picture.width, height = picture.height;
    if (width == 0) return {};
    constexpr int k_longest = 16384;  // of a side, for OpenGL
    if (width > k_longest || height > k_longest) {
        throw Error(ErrorKind::input,
                    Problem{"picture size is out of range", "", std::to_string(width) + " x " + std::to_string(height),
                            "1 to " + std::to_string(k_longest) + " pixels a side", ""});
    }
    const PixelWindow window{picture.left, height_ - picture.top - height, width, height};
    picture.rgba = call_module([&] { return vtk().draw_triangles(triangles_, window); });
    return picture;
}

void compose(Image& page, const OverlayImage& overlay, int right, int down) {
    const int left = overlay.left + right, top = overlay.top + down;
    if (left < 0 || top < 0 || left + overlay.width > page.width || top + overlay.height > page.height) {
        throw Error(ErrorKind::input, Problem{"a layer lies outside its page", "", "", "", ""});
    }
    const std::uint8_t* ink = overlay.rgba.data();
    for (int row = 0; row < overlay.height; ++row) {
        std::uint8_t* to = page.pixel(left, top + row);
        for (int column = 0; column < overlay.width; ++column, ink += 4, to += 3) {
            const unsigned through = 255U - ink[3];
            if (through == 255U) continue;
            for (int band = 0; band < 3; ++band) {
                const unsigned mixed = ink[band] + (to[band] * through + 127U) / 255U;
                to[band] = static_cast<std::uint8_t>(std::min(mixed, 255U));
            }
        }
    }
}

}  // namespace frana::render
