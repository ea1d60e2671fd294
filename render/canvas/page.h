// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "render/canvas/image.h"
#include "render/canvas/lettering.h"

using cairo_surface_t = struct _cairo_surface;

namespace frana::render {

struct LineStyle {
    double width_px = 1;
    Rgb colour{0, 0, 0};
    double opacity = 1;
    std::vector<double> dashes{};  ///< lengths of stroke, gap, stroke, gap... [px]; empty: solid
};

/// Lines and shapes as they were drawn, later ones over earlier ones, with texts over all of them, in pixels from the
/// upper left corner.
struct Overlay {
    struct Shape {
        enum class Kind { line, ring, area, frame };
        Kind kind;
        std::vector<Point> points;  ///< of a frame: two corners
        LineStyle style;            ///< of an area: colour and opacity
    };
    struct Text {
        std::string words;
        TextLine line;
        Point origin;  ///< left end of the baseline, the corner of a pixel: letters are as sharp as elsewhere
        TextStyle style;
    };

    int width = 0, height = 0;
    std::vector<Shape> shapes{};
    std::vector<Text> texts{};
    std::shared_ptr<cairo_surface_t> pixels{};  ///< of all this, if kept
};

/// A page to draw on, in pixels from the upper left corner, which records what is drawn for every file format.
class Sheet {
  public:
    Sheet(int width, int height);

    void line(std::span<const Point> points, const LineStyle& style, bool closed = false);
    /// A filled polygon.
    void fill(std::span<const Point> corners, Rgb colour, double opacity = 1);
    void fill(const PageBox& box, Rgb colour, double opacity = 1);
    void frame(const PageBox& box, const LineStyle& style);
    void text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright);

    /// Adds what was drawn on another sheet, over what is on this one.
    void append(Sheet other);

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
    /// Returns everything; the sheet is empty then, but for the positions of its texts. `keep_pixels`: it will be put
    /// on the pixels of many pages, a film's, and is drawn once.
    [[nodiscard]] std::shared_ptr<const Overlay> take(bool keep_pixels = false);

  private:
    Lettering lettering_;
    Overlay content_;
    std::vector<TextBox> boxes_;
};

/// Sizes of everything on a page, from the page's size: letters shrink more slowly than the page, since a small page is
/// read from the same distance as a large one.
struct PageStyle {
    /// `density` below 1 makes letters and gaps smaller, to fit more on the page. No letter is smaller than `least_px`.
    PageStyle(int width, int height, double density = 1, int least_px = k_least_letters);

    double scale = 1;  ///< of lines and gaps; 1 on a page 1600 x 1200
    double margin = 28, gap = 14;
    TextStyle title, subtitle, heading, label, small;

    /// A length given for a page 1600 x 1200.
    [[nodiscard]] double length(double at_full_size) const { return at_full_size * scale; }
    /// The same for the width of a line, with a visible minimum.
    [[nodiscard]] double line(double at_full_size) const;
};

/// Ways of reducing the size of parts of a page, tried one after the other until everything fits.
struct Crowding {
    double density = 1;          ///< of letters and gaps
    bool notes_at_foot = false;  ///< side notes at the foot of the page, where they need far less height than beside
                                 ///< the map
};
inline constexpr Crowding k_crowdings[] = {{1, false}, {0.88, false}, {0.77, false}, {0.66, false}, {0.66, true}};

inline constexpr Rgb k_ink{25, 28, 32};            ///< of letters and frames
inline constexpr Rgb k_soft_ink{84, 90, 98};       ///< of less prominent parts
inline constexpr Rgb k_no_terrain{236, 237, 238};  ///< inside the frame where there is no terrain

/// A white page with pictures and drawings on it, later ones over earlier ones, which Cairo draws in any file format.
/// Copies share the content.
class Page {
  public:
    /// One thing on it, moved by whole pixels from the upper left corner: a picture or a drawing.
    struct Part {
        int left = 0, top = 0;
        std::shared_ptr<const Image> picture{};
        double scale = 1;  ///< of the picture's pixels
        std::shared_ptr<const Overlay> drawing{};
    };

    Page(int width, int height) : width_(width), height_(height) {}

    void put(std::shared_ptr<const Image> picture, int left, int top, double scale = 1);
    void put(std::shared_ptr<const Overlay> drawing) { parts_.push_back({.drawing = std::move(drawing)}); }
    /// Puts another page with its upper left corner there; only what lies inside is drawn.
    void put(const Page& other, int left, int top);

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] const std::vector<Part>& parts() const noexcept { return parts_; }

    /// Draws it as pixels. Throws Error(environment) if Cairo fails.
    [[nodiscard]] Image paint() const;

  private:
    int width_, height_;
    std::vector<Part> parts_;
};

/// Returns a PDF of one page, as large as its pixels are at `dots_per_inch`: texts as text with the letters' shapes,
/// lines and areas as vectors, pictures as they are. The same page gives the same bytes. `title` is stored in its
/// properties. Throws Error(environment) if Cairo fails.
std::string page_pdf(const Page& page, double dots_per_inch, const std::string& title);

/// Returns the same as an SVG file. Letters are shapes, alike in every viewer; over them is each text as transparent
/// text, which browsers and editors find, select and copy. With `dots_per_inch` 0 it is an element for an HTML page,
/// without a size of its own. Its ids are in no other drawing.
std::string page_svg(const Page& page, double dots_per_inch, const std::string& title);

/// Returns the versions of Cairo and Pango at run time, and those of VTK and FFmpeg's libavcodec, which are not loaded
/// for this, that frana was built with: one "NAME VERSION" per line.
std::string library_versions();

}  // namespace frana::render
