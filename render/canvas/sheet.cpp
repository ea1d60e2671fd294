// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/sheet.h"

#include <utility>

namespace frana::render {

Sheet::Sheet(int width, int height) : content_(std::make_shared<Overlay::Content>()) {
    content_->width = width;
    content_->height = height;
}

void Sheet::line(std::span<const Point> points, const LineStyle& style, bool closed) {
    content_->shapes.push_back(
        {closed ? Overlay::Shape::Kind::ring : Overlay::Shape::Kind::line, {points.begin(), points.end()}, style});
}

void Sheet::fill(std::span<const Point> corners, Rgb colour, double opacity) {
    content_->shapes.push_back(
        {Overlay::Shape::Kind::area, {corners.begin(), corners.end()}, LineStyle{0, colour, opacity}});
}

void Sheet::frame(const PageBox& box, const LineStyle& style) {
    content_->shapes.push_back({Overlay::Shape::Kind::frame, {{box.left, box.top}, {box.right, box.bottom}}, style});
}

void Sheet::text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) {
    content_->texts.push_back({words, at, style, across, upright, lettering().set(words, at, style, across, upright)});
    boxes_.push_back(text_box(words, content_->texts.back().glyphs, style));
}

Overlay Sheet::take() {
    Overlay overlay;
    auto rest = std::make_shared<Overlay::Content>();
    rest->width = content_->width;
    rest->height = content_->height;
    overlay.content_ = std::exchange(content_, std::move(rest));
    return overlay;
}

}  // namespace frana::render
