// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/canvas/image.h"
#include "render/canvas/overlay.h"

namespace frana::render {

/// A white page with pictures and drawings on it, later ones over earlier ones, from which any file format is made:
/// pixels by VTK through OSMesa, or vectors, texts and pictures by Cairo (PDF) or as SVG. Copies share the content.
class Page {
  public:
    /// One thing on it, moved by whole pixels from the upper left corner.
    struct Part {
        int left = 0, top = 0;
        std::shared_ptr<const Image> picture;  ///< null: the drawing
        Overlay drawing;
    };

    Page(int width, int height) : width_(width), height_(height) {}

    void put(std::shared_ptr<const Image> picture, int left, int top);
    void put(Image picture, int left, int top);
    void put(const Overlay& drawing) { parts_.push_back({0, 0, nullptr, drawing}); }
    /// Puts another page, which must lie inside, with its upper left corner there.
    void put(const Page& other, int left, int top);

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] const std::vector<Part>& parts() const noexcept { return parts_; }

    /// Draws it as pixels. Throws Error(environment) if VTK or OpenGL fails.
    [[nodiscard]] Image paint() const;

  private:
    int width_, height_;
    std::vector<Part> parts_;
};

/// Returns a PDF of one page, as large as its pixels are at `dots_per_inch`: texts as text with the letters' shapes,
/// lines and areas as vectors, pictures as they are. The same page gives the same bytes. `title` is stored in its
/// properties. Throws Error(environment) if Cairo fails.
std::string page_pdf(const Page& page, double dots_per_inch, const std::string& title);

/// Returns the same as an SVG file. Its texts are shown in the viewer's fonts.
std::string page_svg(const Page& page, double dots_per_inch, const std::string& title);

}  // namespace frana::render
