// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/canvas/canvas.h"
#include "render/canvas/lettering.h"

namespace frana::render {

/// Lines and shapes as they were drawn, later ones over earlier ones, with texts over all of them, in pixels from the
/// upper left corner. They become pixels when they are first put on a picture; a page that is written as vectors needs
/// none. Copies share everything. Used by one thread at a time.
class Overlay {
  public:
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

    Overlay() : content_(std::make_shared<Content>()) {}
    explicit Overlay(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

    [[nodiscard]] const Content& content() const noexcept { return *content_; }
    /// Draws everything on a picture, moved to the right and down. Throws Error(environment) if VTK or OpenGL fails.
    void put(Image& page, int left = 0, int top = 0) const;
    /// Makes its pixels, which need most memory while they are made.
    void rasterise() const;

  private:
    std::shared_ptr<const Content> content_;
};

/// A page to draw on, in pixels from the upper left corner, which records what is drawn for every file format.
class Sheet {
  public:
    Sheet(int width, int height);

    void line(std::span<const Point> points, const LineStyle& style, bool closed = false);
    /// A filled convex polygon.
    void fill(std::span<const Point> corners, Rgb colour, double opacity = 1);
    void fill(const PageBox& box, Rgb colour, double opacity = 1);
    void frame(const PageBox& box, const LineStyle& style);
    void text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright);

    /// Writes lines one below the other, from the capitals' top of the first; returns the y below the last.
    double lines(const std::vector<std::string>& words, Point top, const TextStyle& style, Across across);
    /// Breaks a text into lines no wider than `width`; a single longer word is cut with an ellipsis.
    [[nodiscard]] std::vector<std::string> wrapped(const std::string& words, const TextStyle& style,
                                                   double width) const;
    /// From one line's capitals to the next line's [px].
    [[nodiscard]] static double line_height(const TextStyle& style) { return 1.35 * style.size_px; }
    [[nodiscard]] const Lettering& lettering() const noexcept { return lettering_; }

    /// The texts so far and the pixels that their ink covers.
    [[nodiscard]] const std::vector<TextBox>& texts() const noexcept { return boxes_; }
    /// Returns everything; the sheet is empty then, but for the positions of its texts.
    [[nodiscard]] Overlay take();

  private:
    Lettering lettering_;
    std::shared_ptr<Overlay::Content> content_;
    std::vector<TextBox> boxes_;
};

}  // namespace frana::render
