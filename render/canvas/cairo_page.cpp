// SPDX-License-Identifier: Apache-2.0
// Pages as PDF: Cairo receives the drawing calls that Canvas turns into triangles.
#include <cairo-pdf.h>

#include <memory>

#include "core/error.h"
#include "core/markup.h"
#include "core/utf8.h"
#include "render/canvas/drawing.h"
#include "render/canvas/page.h"
#include "render/canvas/text_line.h"

namespace frana::render {
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
