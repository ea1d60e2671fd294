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
    : layout_(owned(pango_layout_new(new_context().get()))) {
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

Point TextLine::origin(Point at, const TextStyle& style, Across across, Upright upright) const {
    const double along = across == Across::left     ? ink_.left
                         : across == Across::centre ? (ink_.left + ink_.right) / 2
                                                    : ink_.right;
    const double capital = capital_height(style);
    const double up = upright == Upright::baseline ? 0 : upright == Upright::middle ? capital / 2 : capital;
    const double angle = style.angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    return {std::round(at.x - along * c + up * s), std::round(at.y + along * s + up * c)};
}

template <class Draw>
void TextLine::turned(cairo_t* on, Point origin, const TextStyle& style, const Draw& draw) const {
    cairo_save(on);
    cairo_translate(on, origin.x, origin.y);
    cairo_rotate(on, -style.angle_deg * std::numbers::pi / 180);
    pango_cairo_update_layout(on, layout_.get());
    cairo_move_to(on, 0, 0);
    draw(on, pango_layout_get_line_readonly(layout_.get(), 0));
    cairo_restore(on);
}

void TextLine::show(cairo_t* on, Point origin, const TextStyle& style) const {
    turned(on, origin, style, &pango_cairo_show_layout_line);
}

void TextLine::trace(cairo_t* on, Point origin, const TextStyle& style) const {
    turned(on, origin, style, &pango_cairo_layout_line_path);
}

std::vector<std::string> take_letters_without_font() {
    return letters_without_font().take();
}

const TextLine& Lettering::line(const std::string& text, const TextStyle& style) const {
    const Key key{text, style.size_px, style.bold};
    const auto known = kept_.find(key);
    return known != kept_.end() ? known->second : kept_.emplace(key, TextLine(text, style)).first->second;
}

TextBox Lettering::place(const std::string& text, Point at, const TextStyle& style, Across across,
                         Upright upright) const {
    const TextLine& letters = line(text, style);
    const PageBox& ink = letters.ink();
    const Point from = letters.origin(at, style, across, upright);
    const double angle = style.angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    PageBox all{1e9, 1e9, -1e9, -1e9};
    for (const double x : {ink.left, ink.right}) {
        for (const double y : {ink.top, ink.bottom}) {
            const Point to{from.x + c * x + s * y, from.y + c * y - s * x};
            all = {std::min(all.left, to.x), std::min(all.top, to.y), std::max(all.right, to.x),
                   std::max(all.bottom, to.y)};
        }
    }
    return {text, all, static_cast<double>(style.size_px)};
}

}  // namespace frana::render
