// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/lettering.h"

#include <cairo.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/text.h"

namespace frana::render {
namespace {

constexpr const char* k_family = "DejaVu Sans";

// No page has room for more letters; the time is proportional to their number.
constexpr std::size_t k_line_letters = 500;

template <class Object>
std::shared_ptr<Object> owned(Object* object) {
    return std::shared_ptr<Object>(object, [](Object* old) { g_object_unref(old); });
}

using Description = std::unique_ptr<PangoFontDescription, decltype(&pango_font_description_free)>;

/// File names and attributes may contain any characters: line ends and other control characters become spaces.
std::string printable(const std::string& text) {
    std::string clean = elided(shown_text(text), k_line_letters);
    for (char& c : clean)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    return clean;
}

Description font_of(const TextStyle& style) {
    Description font(pango_font_description_new(), &pango_font_description_free);
    pango_font_description_set_family_static(font.get(), k_family);
    pango_font_description_set_weight(font.get(), style.bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_font_description_set_absolute_size(font.get(), static_cast<double>(style.size_px) * PANGO_SCALE);
    return font;
}

/// Fontconfig would give some other font, and labels would have other widths than elsewhere.
void require_font(PangoContext* context) {
    const Description wanted = font_of({});
    const auto font = owned(pango_context_load_font(context, wanted.get()));
    bool found = false;
    if (font) {
        const Description got(pango_font_describe(font.get()), &pango_font_description_free);
        const char* family = pango_font_description_get_family(got.get());
        found = family != nullptr && std::string(family) == k_family;
    }
    if (!found)
        throw Error(ErrorKind::environment,
                    Problem{"a font for maps is missing", k_family, "", "", "install Debian's fonts-dejavu-core"});
}

/// Letters are not fitted to pixels, so that all resolutions have the same lines. Every text has its own: drawing
/// leaves a context turned.
std::shared_ptr<PangoContext> new_context() {
    auto made = owned(pango_font_map_create_context(pango_cairo_font_map_get_default()));
    pango_cairo_context_set_resolution(made.get(), 72);
    const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
        cairo_font_options_create(), &cairo_font_options_destroy);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(made.get(), options.get());
    pango_context_set_round_glyph_positions(made.get(), FALSE);
    // Not the user's, which would choose among fonts: pictures must not depend on the locale.
    pango_context_set_language(made.get(), pango_language_from_string("en"));
    thread_local bool has_font = false;
    if (!has_font) require_font(made.get());
    has_font = true;
    return made;
}

class LettersWithoutFont {
  public:
    void add(PangoLayout* layout) {
        const std::lock_guard lock(mutex_);
        for (const GSList* run = pango_layout_get_line_readonly(layout, 0)->runs; run != nullptr; run = run->next) {
            const PangoGlyphString* glyphs = static_cast<const PangoGlyphItem*>(run->data)->glyphs;
            for (int i = 0; i < glyphs->num_glyphs; ++i) {
                const PangoGlyph glyph = glyphs->glyphs[i].glyph;
                if ((glyph & PANGO_GLYPH_UNKNOWN_FLAG) != 0 && glyph != PANGO_GLYPH_INVALID_INPUT)
                    letters_.insert(glyph & ~PANGO_GLYPH_UNKNOWN_FLAG);
            }
        }
    }
    std::vector<std::string> take() {
        const std::lock_guard lock(mutex_);
        std::vector<std::string> all;
        for (const std::uint32_t letter : std::exchange(letters_, {})) {
            std::array<char, 6> bytes{};
            all.emplace_back(bytes.data(), static_cast<std::size_t>(g_unichar_to_utf8(letter, bytes.data())));
        }
        return all;
    }

  private:
    std::mutex mutex_;
    std::set<std::uint32_t> letters_;
};

LettersWithoutFont& letters_without_font() {
    static LettersWithoutFont letters;
    return letters;
}

}  // namespace

TextLine::TextLine(const std::string& text, const TextStyle& style)
    : layout_(owned(pango_layout_new(new_context().get()))), style_(style) {
    const std::string clean = printable(text);
    pango_layout_set_single_paragraph_mode(layout_.get(), TRUE);
    pango_layout_set_font_description(layout_.get(), font_of(style).get());
    pango_layout_set_text(layout_.get(), clean.data(), static_cast<int>(clean.size()));
    // Ligatures would stand in a PDF's text as letters of their own, which a search for "fi" does not find.
    const std::unique_ptr<PangoAttrList, decltype(&pango_attr_list_unref)> features(pango_attr_list_new(),
                                                                                    &pango_attr_list_unref);
    pango_attr_list_insert(features.get(), pango_attr_font_features_new("liga=0, clig=0"));
    pango_layout_set_attributes(layout_.get(), features.get());
    if (pango_layout_get_unknown_glyphs_count(layout_.get()) > 0) letters_without_font().add(layout_.get());
    PangoRectangle ink;
    pango_layout_line_get_extents(pango_layout_get_line_readonly(layout_.get(), 0), &ink, nullptr);
    constexpr double k_unit = PANGO_SCALE;
    if (ink.width > 0 && ink.height > 0)
        ink_ = {ink.x / k_unit, ink.y / k_unit, (ink.x + ink.width) / k_unit, (ink.y + ink.height) / k_unit};
}

Point TextLine::origin(Point at, Across across, Upright upright) const {
    const double along = across == Across::left     ? ink_.left
                         : across == Across::centre ? (ink_.left + ink_.right) / 2
                                                    : ink_.right;
    const double capital = capital_height(style_);
    const double up = upright == Upright::baseline ? 0 : upright == Upright::middle ? capital / 2 : capital;
    const double angle = style_.angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    return {at.x - along * c + up * s, at.y + along * s + up * c};
}

void TextLine::turn(cairo_t* on, Point origin) const {
    cairo_translate(on, origin.x, origin.y);
    cairo_rotate(on, -style_.angle_deg * std::numbers::pi / 180);
    pango_cairo_update_layout(on, layout_.get());
    cairo_move_to(on, 0, 0);
}

void TextLine::show(cairo_t* on, Point origin) const {
    cairo_save(on);
    turn(on, origin);
    pango_cairo_show_layout_line(on, pango_layout_get_line_readonly(layout_.get(), 0));
    cairo_restore(on);
}

void TextLine::trace(cairo_t* on, Point origin) const {
    cairo_save(on);
    turn(on, origin);
    pango_cairo_layout_line_path(on, pango_layout_get_line_readonly(layout_.get(), 0));
    cairo_restore(on);
}

std::vector<std::string> take_letters_without_font() {
    return letters_without_font().take();
}

namespace {

/// Returns the bounds of a box turned counterclockwise about the origin, in whole pixels.
PageBox turned(const PageBox& box, double angle_deg) {
    const double angle = angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    PageBox all{1e9, 1e9, -1e9, -1e9};
    for (const double x : {box.left, box.right}) {
        for (const double y : {box.top, box.bottom}) {
            const double to_x = c * x + s * y, to_y = c * y - s * x;
            all = {std::min(all.left, to_x), std::min(all.top, to_y), std::max(all.right, to_x),
                   std::max(all.bottom, to_y)};
        }
    }
    return {std::floor(all.left), std::floor(all.top), std::ceil(all.right), std::ceil(all.bottom)};
}

[[noreturn]] void fail(const std::string& text, cairo_status_t status) {
    throw Error(ErrorKind::environment,
                Problem{"a text could not be drawn", "Cairo", text, cairo_status_to_string(status), ""});
}

/// Cuts off the rows and columns without ink.
void trim(Glyphs& glyphs) {
    const int width = glyphs.width;
    int first_column = width, last_column = -1, first_row = glyphs.height, last_row = -1;
    for (int row = 0; row < glyphs.height; ++row) {
        for (int column = 0; column < width; ++column) {
            if (glyphs.ink[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(column)] == 0)
                continue;
            first_column = std::min(first_column, column);
            last_column = std::max(last_column, column);
            first_row = std::min(first_row, row);
            last_row = std::max(last_row, row);
        }
    }
    if (last_column < 0) {
        glyphs = {};
        return;
    }
    Glyphs inside{glyphs.left + first_column,
                  glyphs.top + first_row,
                  last_column - first_column + 1,
                  last_row - first_row + 1,
                  {}};
    for (int row = first_row; row <= last_row; ++row) {
        const auto begin = glyphs.ink.begin() + static_cast<std::ptrdiff_t>(row) * width + first_column;
        inside.ink.insert(inside.ink.end(), begin, begin + inside.width);
    }
    glyphs = std::move(inside);
}

}  // namespace

const Lettering::Drawn& Lettering::drawn(const std::string& text, const TextStyle& style) const {
    const Key key{text, style.size_px, style.bold, style.angle_deg};
    if (const auto known = kept_.find(key); known != kept_.end()) return known->second;
    Drawn& drawn = kept_.emplace(key, Drawn(TextLine(text, style))).first->second;
    const PageBox& ink = drawn.line.ink();
    if (!(ink.width() > 0)) return drawn;
    constexpr int k_rim = 2;  // a pixel's share of a letter beside it
    const PageBox box = turned(ink, style.angle_deg);
    Glyphs& glyphs = drawn.glyphs;
    glyphs.left = static_cast<int>(box.left) - k_rim;
    glyphs.top = static_cast<int>(box.top) - k_rim;
    glyphs.width = static_cast<int>(box.width()) + 2 * k_rim;
    glyphs.height = static_cast<int>(box.height()) + 2 * k_rim;
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        cairo_image_surface_create(CAIRO_FORMAT_A8, glyphs.width, glyphs.height), &cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> on(cairo_create(surface.get()), &cairo_destroy);
    drawn.line.show(on.get(), {static_cast<double>(-glyphs.left), static_cast<double>(-glyphs.top)});
    cairo_surface_flush(surface.get());
    if (const cairo_status_t status = cairo_status(on.get()); status != CAIRO_STATUS_SUCCESS) fail(text, status);
    const unsigned char* pixels = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int row = 0; row < glyphs.height; ++row) {
        const unsigned char* begin = pixels + static_cast<std::ptrdiff_t>(row) * stride;
        glyphs.ink.insert(glyphs.ink.end(), begin, begin + glyphs.width);
    }
    trim(glyphs);
    return drawn;
}

Glyphs Lettering::set(const std::string& text, Point at, const TextStyle& style, Across across, Upright upright) const {
    const Drawn& letters = drawn(text, style);
    Glyphs glyphs = letters.glyphs;
    const Point origin = letters.line.origin(at, across, upright);
    glyphs.left += static_cast<int>(std::lround(origin.x));
    glyphs.top += static_cast<int>(std::lround(origin.y));
    return glyphs;
}

double Lettering::width(const std::string& text, const TextStyle& style) const {
    const auto [place, is_new] = widths_.try_emplace({text, style.size_px, style.bold, 0});
    if (is_new) place->second = TextLine(text, style).ink().width();
    return place->second;
}

TextBox text_box(const std::string& text, const Glyphs& glyphs, const TextStyle& style) {
    const double left = glyphs.left, top = glyphs.top;
    return {text, {left, top, left + glyphs.width, top + glyphs.height}, static_cast<double>(style.size_px)};
}

TextBox Lettering::place(const std::string& text, Point at, const TextStyle& style, Across across,
                         Upright upright) const {
    return text_box(text, set(text, at, style, across, upright), style);
}

TextBox Lettering::write(Image& page, const std::string& text, Point at, const TextStyle& style, Across across,
                         Upright upright) const {
    const Glyphs glyphs = set(text, at, style, across, upright);
    blend(page, glyphs, style);
    return text_box(text, glyphs, style);
}

void blend(Image& page, const Glyphs& glyphs, const TextStyle& style, int right, int down) {
    const int left = glyphs.left + right, top = glyphs.top + down;
    const auto mix = [&page](int column, int row, Rgb colour, double fraction) {
        if (column < 0 || row < 0 || column >= page.width || row >= page.height) return;
        std::uint8_t* pixel = page.pixel(column, row);
        const std::array<std::uint8_t, 3> ink{colour.r, colour.g, colour.b};
        for (std::size_t k = 0; k < 3; ++k)
            pixel[k] = static_cast<std::uint8_t>(std::lround(pixel[k] + (ink[k] - pixel[k]) * fraction));
    };
    const auto coverage = [&](int column, int row) -> int {
        if (column < 0 || row < 0 || column >= glyphs.width || row >= glyphs.height) return 0;
        return glyphs.ink[static_cast<std::size_t>(row) * static_cast<std::size_t>(glyphs.width) +
                          static_cast<std::size_t>(column)];
    };
    if (style.halo_px > 0 && glyphs.width > 0) {
        const int reach = static_cast<int>(std::ceil(style.halo_px));
        struct Near {
            int dx, dy;
            double fraction;
        };
        std::vector<Near> nears;
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                const double fraction = std::clamp(style.halo_px + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
                if (fraction > 0) nears.push_back({dx, dy, fraction});
            }
        }
        for (int row = -reach; row < glyphs.height + reach; ++row) {
            for (int column = -reach; column < glyphs.width + reach; ++column) {
                double most = 0;
                for (const Near& one : nears)
                    most = std::max(most, one.fraction * coverage(column + one.dx, row + one.dy));
                if (most > 0) mix(left + column, top + row, style.halo, most / 255);
            }
        }
    }
    for (int row = 0; row < glyphs.height; ++row) {
        for (int column = 0; column < glyphs.width; ++column) {
            if (const int fraction = coverage(column, row); fraction > 0)
                mix(left + column, top + row, style.colour, fraction / 255.0);
        }
    }
}

}  // namespace frana::render
