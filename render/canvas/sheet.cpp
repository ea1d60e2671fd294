// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/sheet.h"

namespace frana::render {

void Sheet::line(std::span<const Point> points, const LineStyle& style, bool closed) {
    canvas_.line(points, style, closed);
}

void Sheet::fill(std::span<const Point> corners, Rgb colour, double opacity) {
    canvas_.fill(corners, colour, opacity);
}

void Sheet::frame(const PageBox& box, const LineStyle& style) {
    canvas_.frame(box, style);
}

void Sheet::text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) {
    texts_.push_back({lettering().set(words, at, style, across, upright), style});
    boxes_.push_back(text_box(words, texts_.back().glyphs, style));
}

Overlay Sheet::draw() const {
    Overlay overlay;
    overlay.shapes_ = canvas_.draw();
    overlay.texts_ = texts_;
    return overlay;
}

void Overlay::put(Image& page) const {
    compose(page, shapes_);
    for (const Text& text : texts_) blend(page, text.glyphs, text.style);
}

}  // namespace frana::render
