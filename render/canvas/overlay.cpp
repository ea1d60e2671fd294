// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/overlay.h"

#include "render/canvas/drawing.h"

namespace frana::render {

template <class Surface>
void Overlay::replay_shapes(Surface& surface) const {
    for (const Shape& one : content_->shapes) {
        switch (one.kind) {
            case Shape::Kind::line:
            case Shape::Kind::ring:
                surface.line(one.points, one.style, one.kind == Shape::Kind::ring);
                break;
            case Shape::Kind::area:
                surface.fill(one.points, one.style.colour, one.style.opacity);
                break;
            case Shape::Kind::frame:
                surface.frame({one.points[0].x, one.points[0].y, one.points[1].x, one.points[1].y}, one.style);
                break;
        }
    }
}

void Overlay::rasterise() const {
    if (!content_ || content_->has_pixels) return;
    Canvas canvas(content_->width, content_->height);
    replay_shapes(canvas);
    content_->pixels = canvas.draw();
    content_->has_pixels = true;
}

void Overlay::put(Image& page, int left, int top) const {
    if (!content_) return;
    rasterise();
    compose(page, content_->pixels, left, top);
    for (const Text& text : content_->texts) blend(page, text.glyphs, text.style, left, top);
}

void Overlay::replay(Drawing& drawing) const {
    if (!content_) return;
    replay_shapes(drawing);
    for (const Text& one : content_->texts) drawing.text(one.words, one.at, one.style, one.across, one.upright);
}

}  // namespace frana::render
