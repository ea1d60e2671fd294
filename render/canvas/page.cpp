// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/page.h"

#include <cairo-pdf.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "render/canvas/drawing.h"
#include "render/canvas/lettering.h"

namespace frana::render {

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

void Page::put(std::shared_ptr<const Image> picture, int left, int top) {
    parts_.push_back({left, top, std::move(picture), {}});
}

void Page::put(Image picture, int left, int top) {
    put(std::make_shared<const Image>(std::move(picture)), left, top);
}

void Page::put(const Page& other, int left, int top) {
    for (Part part : other.parts_) {
        part.left += left;
        part.top += top;
        parts_.push_back(std::move(part));
    }
}

Image Page::paint() const {
    for (const Part& part : parts_)
        if (!part.picture) part.drawing.rasterise();
    Image page(width_, height_);
    for (const Part& part : parts_) {
        if (!part.picture) {
            part.drawing.put(page, part.left, part.top);
            continue;
        }
        for (int row = 0; row < part.picture->height; ++row)
            std::copy_n(part.picture->pixel(0, row), 3 * static_cast<std::size_t>(part.picture->width),
                        page.pixel(part.left, part.top + row));
    }
    return page;
}

// Pages as PDF: Cairo receives the drawing calls that Canvas turns into triangles.

namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void check(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw Error(ErrorKind::environment,
                Problem{"a page could not be drawn", "Cairo", cairo_status_to_string(status), "", ""});
}

class CairoDrawing : public Drawing {
  public:
    explicit CairoDrawing(cairo_t* on) : on_(on) {
        cairo_set_line_join(on_, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(on_, CAIRO_LINE_CAP_BUTT);
    }

    void line(std::span<const Point> points, const LineStyle& style, bool closed) override {
        if (points.size() < 2) return;
        path(points, closed);
        stroke(style);
    }
    void fill(std::span<const Point> corners, Rgb colour, double opacity) override {
        path(corners, true);
        set_colour(colour, opacity);
        cairo_fill(on_);
    }
    void frame(const PageBox& box, const LineStyle& style) override {
        cairo_set_line_join(on_, CAIRO_LINE_JOIN_MITER);
        cairo_rectangle(on_, box.left, box.top, box.width(), box.height());
        stroke(style);
        cairo_set_line_join(on_, CAIRO_LINE_JOIN_ROUND);
    }
    void text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) override {
        const TextLine line(words, style);
        const Point origin = line.origin(at, across, upright);
        if (style.halo_px > 0) {
            line.trace(on_, origin);
            stroke({2 * style.halo_px, style.halo});
        }
        set_colour(style.colour, 1);
        line.show(on_, origin);
    }

    void picture(const Image& image) {
        const Surface pixels(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height),
                             &cairo_surface_destroy);
        check(cairo_surface_status(pixels.get()));
        unsigned char* bytes = cairo_image_surface_get_data(pixels.get());
        const int stride = cairo_image_surface_get_stride(pixels.get());
        for (int row = 0; row < image.height; ++row) {
            auto* to = reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(row) * stride);
            const std::uint8_t* from = image.pixel(0, row);
            for (int column = 0; column < image.width; ++column, from += 3)
                to[column] = static_cast<std::uint32_t>(from[0] << 16 | from[1] << 8 | from[2]);
        }
        cairo_surface_mark_dirty(pixels.get());
        cairo_set_source_surface(on_, pixels.get(), 0, 0);
        // The cells of a raster have edges.
        cairo_pattern_set_filter(cairo_get_source(on_), CAIRO_FILTER_NEAREST);
        cairo_paint(on_);
    }

  private:
    void path(std::span<const Point> points, bool closed) {
        cairo_new_path(on_);
        for (const Point p : points) cairo_line_to(on_, p.x, p.y);
        if (closed) cairo_close_path(on_);
    }
    void set_colour(Rgb colour, double opacity) {
        constexpr double k_full = 255;
        cairo_set_source_rgba(on_, colour.r / k_full, colour.g / k_full, colour.b / k_full,
                              opacity > k_opaque ? 1 : opacity);
    }
    void stroke(const LineStyle& style) {
        set_colour(style.colour, style.opacity);
        cairo_set_line_width(on_, style.width_px);
        cairo_set_dash(on_, style.dashes.data(), static_cast<int>(style.dashes.size()), 0);
        cairo_stroke(on_);
    }

    // Rims are drawn barely translucent for Canvas, which then omits their joints.
    static constexpr double k_opaque = 0.99;
    cairo_t* on_;
};

cairo_status_t append(void* to, const unsigned char* bytes, unsigned length) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), length);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

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
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> on(cairo_create(surface.get()), &cairo_destroy);
    cairo_scale(on.get(), point, point);
    CairoDrawing drawing(on.get());
    for (const Page::Part& part : page.parts()) {
        cairo_save(on.get());
        cairo_translate(on.get(), part.left, part.top);
        if (part.picture) {
            drawing.picture(*part.picture);
        } else {
            cairo_rectangle(on.get(), 0, 0, part.drawing.width(), part.drawing.height());
            cairo_clip(on.get());
            part.drawing.replay(drawing);
        }
        cairo_restore(on.get());
    }
    check(cairo_status(on.get()));
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return bytes;
}

}  // namespace frana::render
