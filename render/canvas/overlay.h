// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/canvas/canvas.h"
#include "render/canvas/lettering.h"

namespace frana::render {

class Drawing;

/// Lines and shapes as they were drawn, with texts over them. They become pixels when they are first put on a picture;
/// a page that is written as vectors needs none. Copies share everything. Used by one thread at a time.
class Overlay {
  public:
    Overlay() = default;

    /// Draws everything on a picture, moved to the right and down. Throws Error(environment) if VTK or OpenGL fails.
    void put(Image& page, int left = 0, int top = 0) const;
    /// Makes its pixels, which need most memory while they are made.
    void rasterise() const;
    /// Makes the same calls again.
    void replay(Drawing& drawing) const;

    [[nodiscard]] int width() const noexcept { return content_ ? content_->width : 0; }
    [[nodiscard]] int height() const noexcept { return content_ ? content_->height : 0; }

  private:
    friend class Sheet;
    struct Shape {
        enum class Kind { line, ring, area, frame };
        Kind kind;
        std::vector<Point> points;  ///< of a frame: two corners
        LineStyle style;            ///< of an area: colour and opacity
    };
    struct Text {
        std::string words;
        Point at;
        TextStyle style;
        Across across;
        Upright upright;
        Glyphs glyphs;
    };
    struct Content {
        int width = 0, height = 0;
        std::vector<Shape> shapes;
        std::vector<Text> texts;
        mutable bool has_pixels = false;
        mutable OverlayImage pixels;  ///< of the shapes
    };
    template <class Surface>
    void replay_shapes(Surface& surface) const;

    std::shared_ptr<const Content> content_;
};

}  // namespace frana::render
