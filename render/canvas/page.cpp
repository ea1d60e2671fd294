// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/page.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <pango/pangocairo.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>
#include <utility>

#include "core/error.h"
#include "core/text.h"

namespace frana::render {

Sheet::Sheet(int width, int height) : content_{width, height} {}

void Sheet::line(std::span<const Point> points, const LineStyle& style, bool closed) {
    content_.shapes.push_back(
        {closed ? Overlay::Shape::Kind::ring : Overlay::Shape::Kind::line, {points.begin(), points.end()}, style});
}

void Sheet::fill(std::span<const Point> corners, Rgb colour, double opacity) {
    content_.shapes.push_back(
        {Overlay::Shape::Kind::area, {corners.begin(), corners.end()}, LineStyle{0, colour, opacity}});
}

void Sheet::fill(const PageBox& box, Rgb colour, double opacity) {
    fill(
        std::array<Point, 4>{
            {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}},
        colour, opacity);
}

void Sheet::frame(const PageBox& box, const LineStyle& style) {
    content_.shapes.push_back({Overlay::Shape::Kind::frame, {{box.left, box.top}, {box.right, box.bottom}}, style});
}

void Sheet::text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) {
    const TextLine line = lettering_.line(words, style);
    content_.texts.push_back({words, line, line.origin(at, style, across, upright), style});
    boxes_.push_back(lettering_.place(words, at, style, across, upright));
}

namespace {

constexpr std::size_t k_paragraph_letters = 2000;  // of a paragraph
constexpr std::size_t k_longest_line = 500;        // bytes; longer lines need not be measured

/// Whether a word must not begin a line after another: groups of a number's digits, and the unit of a number.
bool belongs_to(const std::string& before, const std::string& word) {
    static const std::array<std::string, 16> k_units{"m",   "m\u00B2",    "m\u00B3", "m/s", "m\u00B2/s", "m/s\u00B2",
                                                     "s",   "%",          "kPa",     "Pa",  "km",        "cm",
                                                     "min", "kg/m\u00B3", "\u00B0",  "h"};
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (before.empty() || !is_digit(before.back())) return false;
    std::string bare = word;  // without the sign that ends a clause
    while (!bare.empty() && (bare.back() == ',' || bare.back() == ';' || bare.back() == '.')) bare.pop_back();
    const bool group = bare.size() >= 3 && std::all_of(bare.begin(), bare.begin() + 3, is_digit) &&
                       (bare.size() == 3 || bare[3] == '.');
    return group || std::find(k_units.begin(), k_units.end(), bare) != k_units.end();
}

}  // namespace

void Sheet::append(Sheet other) {
    content_.shapes.insert(content_.shapes.end(), other.content_.shapes.begin(), other.content_.shapes.end());
    content_.texts.insert(content_.texts.end(), other.content_.texts.begin(), other.content_.texts.end());
    boxes_.insert(boxes_.end(), other.boxes_.begin(), other.boxes_.end());
}

double Sheet::lines(const std::vector<std::string>& words, Point top, const TextStyle& style, Across across) {
    for (const std::string& line : words) {
        text(line, top, style, across, Upright::top);
        top.y += line_height(style);
    }
    return top.y;
}

std::vector<std::string> Sheet::wrapped(const std::string& words, const TextStyle& style, double width) const {
    const auto fits = [&](const std::string& candidate) {
        return candidate.size() <= k_longest_line && lettering_.width(candidate, style) <= width;
    };
    // The longest part that fits is found by bisection: measuring a text is expensive.
    const auto cut = [&](const std::string& word) {
        std::size_t good = 1, bad = word.size() + 1;  // characters, with the ellipsis
        while (good + 1 < bad) {
            const std::size_t middle = (good + bad) / 2;
            (fits(elided(word, middle)) ? good : bad) = middle;
        }
        return elided(word, good);
    };
    std::vector<std::string> lines, parts;
    std::istringstream stream(elided(valid_utf8(words), k_paragraph_letters));
    for (std::string word; stream >> word;) {
        const std::string joint = parts.empty() ? word : parts.back() + " " + word;
        if (!parts.empty() && belongs_to(parts.back(), word) && fits(joint))
            parts.back() = joint;
        else
            parts.push_back(fits(word) ? std::move(word) : cut(word));
    }
    // The number of words that fit on each line, likewise.
    for (std::size_t first = 0; first < parts.size();) {
        const auto line = [&](std::size_t end) {
            std::string all = parts[first];
            for (std::size_t i = first + 1; i < end; ++i) all += " " + parts[i];
            return all;
        };
        std::size_t good = first + 1, bad = parts.size() + 1;
        if (fits(line(parts.size()))) good = parts.size();
        while (good + 1 < bad) {
            const std::size_t middle = (good + bad) / 2;
            (fits(line(middle)) ? good : bad) = middle;
        }
        lines.push_back(line(good));
        first = good;
    }
    return lines;
}

PageStyle::PageStyle(int width, int height, double density, int least_px) {
    scale = std::min(height / 1200.0, width / 1200.0);
    constexpr double k_letters = 0.72;  // 18 pixels at full size become 11 on a page of 800 x 600
    const double letters = std::pow(scale, k_letters) * density;
    margin = std::max(10.0, 28 * scale);
    gap = std::max(5.0, 14 * scale * density);
    // `least` where the smallest letters have k_least_letters.
    const auto size = [letters, least_px](double at_full_size, int least) {
        return std::max(least * least_px / k_least_letters, static_cast<int>(std::lround(at_full_size * letters)));
    };
    title = {size(34, 13), k_ink, true};
    subtitle = {size(21, 11), k_soft_ink};
    heading = {size(20, 11), k_ink, true};
    label = {size(18, 10), k_ink};
    small = {size(15, 9), k_soft_ink};
    for (TextStyle* const style : {&title, &subtitle, &heading, &label, &small}) style->least_px = least_px;
}

double PageStyle::line(double at_full_size) const {
    return std::max(0.6, at_full_size * std::sqrt(scale));
}

void Page::put(std::shared_ptr<const Image> picture, int left, int top, double scale) {
    parts_.push_back({left, top, std::move(picture), scale});
}

void Page::put(const Page& other, int left, int top) {
    for (Part part : other.parts_) {
        part.left += left;
        part.top += top;
        parts_.push_back(std::move(part));
    }
}

namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void check(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw Error(ErrorKind::environment,
                Problem{"a page could not be drawn", "Cairo", cairo_status_to_string(status), "", ""});
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + '"';
}

/// To a hundredth of a pixel.
std::string px(double value) {
    return shortest_text(std::round(100 * value) / 100 + 0.0);  // no "-0"
}

Surface pixels_of(int width, int height, cairo_format_t format) {
    Surface pixels(cairo_image_surface_create(format, width, height), &cairo_surface_destroy);
    check(cairo_surface_status(pixels.get()));
    return pixels;
}

/// A row of pixels: red, green and blue from the third byte down.
std::uint32_t* row_of(cairo_surface_t* pixels, int row) {
    return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(pixels) +
                                            static_cast<std::ptrdiff_t>(row) * cairo_image_surface_get_stride(pixels));
}

/// Copies a picture, as far as it is inside.
void copy(const Image& image, cairo_surface_t* to, int left, int top) {
    cairo_surface_flush(to);
    const int width = std::min(image.width, cairo_image_surface_get_width(to) - left),
              height = std::min(image.height, cairo_image_surface_get_height(to) - top);
    for (int row = std::max(0, -top); row < height; ++row) {
        std::uint32_t* pixel = row_of(to, top + row) + left;
        const std::uint8_t* from = image.pixel(0, row);
        for (int column = 0; column < width; ++column, from += 3)
            if (left + column >= 0) pixel[column] = static_cast<std::uint32_t>(from[0] << 16 | from[1] << 8 | from[2]);
    }
    cairo_surface_mark_dirty(to);
}

class CairoPen {
  public:
    explicit CairoPen(cairo_t* on) : on_(on) { cairo_set_line_cap(on_, CAIRO_LINE_CAP_BUTT); }

    void draw(const Page& page) {
        for (const Page::Part& part : page.parts()) {
            cairo_save(on_);
            cairo_translate(on_, part.left, part.top);
            if (part.picture)
                picture(*part.picture, part.scale);
            else
                draw(*part.drawing);
            cairo_restore(on_);
        }
        check(cairo_status(on_));
    }
    void draw(const Overlay& drawing) {
        if (drawing.pixels) {
            cairo_set_source_surface(on_, drawing.pixels.get(), 0, 0);
            cairo_paint(on_);
            return;
        }
        cairo_rectangle(on_, 0, 0, drawing.width, drawing.height);
        cairo_clip(on_);
        for (const Overlay::Shape& one : drawing.shapes) shape(one);
        for (const Overlay::Text& one : drawing.texts) text(one);
    }
    /// The texts drawn so far as SVG elements.
    [[nodiscard]] const std::string& words() const { return words_; }

  private:
    void shape(const Overlay::Shape& one) {
        using Kind = Overlay::Shape::Kind;
        if (one.points.size() < 2) return;
        if (one.kind == Kind::frame)
            cairo_rectangle(on_, one.points[0].x, one.points[0].y, one.points[1].x - one.points[0].x,
                            one.points[1].y - one.points[0].y);
        else
            for (const Point p : one.points) cairo_line_to(on_, p.x, p.y);
        if (one.kind == Kind::ring || one.kind == Kind::area) cairo_close_path(on_);
        if (one.kind == Kind::area) {
            set_colour(one.style.colour, one.style.opacity);
            cairo_fill(on_);
            return;
        }
        cairo_set_line_join(on_, one.kind == Kind::frame ? CAIRO_LINE_JOIN_MITER : CAIRO_LINE_JOIN_ROUND);
        stroke(one.style);
    }
    void text(const Overlay::Text& one) {
        if (one.style.halo_px > 0) {
            cairo_set_line_join(on_, CAIRO_LINE_JOIN_ROUND);
            one.line.trace(on_, one.origin, one.style);
            stroke({2 * one.style.halo_px, one.style.halo});
        }
        set_colour(one.style.colour, 1);
        one.line.show(on_, one.origin, one.style);
        double x = one.origin.x, y = one.origin.y;
        cairo_user_to_device(on_, &x, &y);
        words_ +=
            "<text" +
            attribute("transform", "translate(" + px(x) + ' ' + px(y) + ')' +
                                       (one.style.angle_deg == 0 ? "" : " rotate(" + px(-one.style.angle_deg) + ')')) +
            attribute("font-size", std::to_string(one.style.size_px)) +
            attribute("textLength", px(one.line.ink().right)) + '>' + escaped_markup(one.words) + "</text>\n";
    }
    void picture(const Image& image, double scale) {
        cairo_surface_t* const page = cairo_get_target(on_);
        if (scale == 1 && cairo_surface_get_type(page) == CAIRO_SURFACE_TYPE_IMAGE) {
            double left = 0, top = 0;
            cairo_user_to_device(on_, &left, &top);
            return copy(image, page, static_cast<int>(left), static_cast<int>(top));
        }
        const Surface pixels = pixels_of(image.width, image.height, CAIRO_FORMAT_RGB24);
        copy(image, pixels.get(), 0, 0);
        cairo_scale(on_, scale, scale);
        cairo_set_source_surface(on_, pixels.get(), 0, 0);
        // The cells of a raster have edges; what shrinks is averaged.
        cairo_pattern_set_filter(cairo_get_source(on_), scale < 1 ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
        cairo_paint(on_);
    }
    void set_colour(Rgb colour, double opacity) {
        constexpr double k_full = 255;
        cairo_set_source_rgba(on_, colour.r / k_full, colour.g / k_full, colour.b / k_full, opacity);
    }
    void stroke(const LineStyle& style) {
        set_colour(style.colour, style.opacity);
        cairo_set_line_width(on_, style.width_px);
        cairo_set_dash(on_, style.dashes.data(), static_cast<int>(style.dashes.size()), 0);
        cairo_stroke(on_);
    }

    cairo_t* on_;
    std::string words_;
};

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* to, const unsigned char* bytes, unsigned length) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), length);
    return CAIRO_STATUS_SUCCESS;
}

template <class Drawn>
void paint(const Drawn& drawn, cairo_surface_t* pixels) {
    const Context on(cairo_create(pixels), &cairo_destroy);
    CairoPen(on.get()).draw(drawn);
    check(cairo_status(on.get()));
    cairo_surface_flush(pixels);
}

}  // namespace

std::shared_ptr<const Overlay> Sheet::take(bool keep_pixels) {
    auto all = std::make_shared<Overlay>(std::exchange(content_, {content_.width, content_.height}));
    if (keep_pixels) {
        Surface pixels = pixels_of(all->width, all->height, CAIRO_FORMAT_ARGB32);
        paint(*all, pixels.get());
        all->pixels = std::move(pixels);
    }
    return all;
}

Image Page::paint() const {
    // Those of a film's last page, for the next: fresh memory for each would cost a third more.
    static thread_local Surface kept(nullptr, &cairo_surface_destroy);
    constexpr std::int64_t k_most_kept = 4'000'000;
    const bool fits = kept && cairo_image_surface_get_width(kept.get()) == width_ &&
                      cairo_image_surface_get_height(kept.get()) == height_;
    Surface pixels = fits ? std::move(kept) : pixels_of(width_, height_, CAIRO_FORMAT_RGB24);
    for (int row = 0; row < height_; ++row) std::fill_n(row_of(pixels.get(), row), width_, 0xFFFFFFU);
    cairo_surface_mark_dirty(pixels.get());
    frana::render::paint(*this, pixels.get());
    Image image;
    image.width = width_;
    image.height = height_;
    image.rgb.resize(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    for (int row = 0; row < height_; ++row) {
        const std::uint32_t* from = row_of(pixels.get(), row);
        std::uint8_t* to = image.pixel(0, row);
        for (int column = 0; column < width_; ++column, to += 3) {
            to[0] = static_cast<std::uint8_t>(from[column] >> 16);
            to[1] = static_cast<std::uint8_t>(from[column] >> 8);
            to[2] = static_cast<std::uint8_t>(from[column]);
        }
    }
    if (static_cast<std::int64_t>(width_) * height_ <= k_most_kept) kept = std::move(pixels);
    return image;
}

std::string page_pdf(const Page& page, double dots_per_inch, const std::string& title) {
    std::string bytes;
    const double point = 72 / dots_per_inch;
    const Surface surface(
        cairo_pdf_surface_create_for_stream(&append, &bytes, page.width() * point, page.height() * point),
        &cairo_surface_destroy);
    // Later versions pack their objects into streams, to which no place on the ground can be added.
    cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, shown_text(title).c_str());
    // The same page must give the same bytes.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
    const Context on(cairo_create(surface.get()), &cairo_destroy);
    cairo_scale(on.get(), point, point);
    CairoPen(on.get()).draw(page);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return bytes;
}

namespace {

void replace_all(std::string& text, const std::string& old, const std::string& with) {
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + with.size()))
        text.replace(at, old.size(), with);
}

/// Cairo counts the letters of every drawing from zero, but no two in one HTML page may share an id, and the pictures
/// of all that were ever drawn, but the same page must give the same bytes. Ids become a sum of the content with their
/// order. Nothing else in what Cairo writes has a '#', ' id=' or '~'.
void give_own_ids(std::string& svg) {
    const std::string before = " id=\"";
    std::size_t count = 0;
    for (std::size_t at = svg.find(before); at != std::string::npos; at = svg.find(before, at + 1)) {
        const std::size_t begin = at + before.size();
        const std::string old = svg.substr(begin, svg.find('"', begin) - begin), own = "~" + std::to_string(count++);
        replace_all(svg, before + old + '"', before + own + '"');
        replace_all(svg, "#" + old + '"', "#" + own + '"');
        replace_all(svg, "#" + old + ')', "#" + own + ')');
    }
    const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(svg.data()), static_cast<uInt>(svg.size()));
    replace_all(svg, "~", "d" + std::to_string(sum) + '-');
}

/// Drops digits beyond a hundredth of a pixel, a quarter of Cairo's text. Data of pictures have no point.
std::string shortened(const std::string& svg) {
    std::string text;
    int digits = -1;  // behind a point
    for (const char c : svg) {
        digits = c == '.' ? 0 : digits >= 0 && c >= '0' && c <= '9' ? digits + 1 : -1;
        if (digits <= 2) text += c;
    }
    return text;
}

}  // namespace

std::string page_svg(const Page& page, double dots_per_inch, const std::string& title) {
    std::string bytes;
    const Surface surface(cairo_svg_surface_create_for_stream(&append, &bytes, page.width(), page.height()),
                          &cairo_surface_destroy);
    const Context on(cairo_create(surface.get()), &cairo_destroy);
    CairoPen pen(on.get());
    pen.draw(page);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    // Cairo's own tag has a size in points; its content contains no words.
    const std::size_t begin = bytes.find('>', bytes.find("<svg ")) + 1, end = bytes.rfind("</svg>");
    std::string content = shortened(bytes.substr(begin, end - begin));
    give_own_ids(content);
    const double millimetre = dots_per_inch > 0 ? 25.4 / dots_per_inch : 0;
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"" +
           (millimetre > 0 ? attribute("width", px(page.width() * millimetre) + "mm") +
                                 attribute("height", px(page.height() * millimetre) + "mm")
                           : "") +
           attribute("viewBox", "0 0 " + std::to_string(page.width()) + ' ' + std::to_string(page.height())) +
           " role=\"img\" image-rendering=\"optimizeSpeed\">\n" +
           (title.empty() ? "" : "<title>" + escaped_markup(title) + "</title>\n") +
           "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>" + content +
           "<g opacity=\"0\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n" + pen.words() + "</g>\n</svg>\n";
}

std::string library_versions() {
    return std::string("VTK " FRANA_VTK_VERSION "\nCairo ") + cairo_version_string() + "\nPango " +
           pango_version_string() + "\nFFmpeg libavcodec " FRANA_LIBAVCODEC_VERSION "\n";
}

}  // namespace frana::render
