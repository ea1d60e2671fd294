// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "core/utf8.h"
#include "render/canvas/vtk_errors.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

namespace frana::render {
namespace {

constexpr int k_dots_per_inch = 72;  // then a point is a pixel

std::string find_font(const std::string& name) {
    const std::array<const char*, 3> folders{"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/TTF/",
                                             "/usr/share/fonts/dejavu/"};
    for (const char* folder : folders) {
        if (std::filesystem::exists(folder + name)) return folder + name;
    }
    throw Error(ErrorKind::environment,
                Problem{"a font for maps is missing", folders[0] + name, "", "", "install Debian's fonts-dejavu-core"});
}

// No page has room for more letters; the time is proportional to their number.
constexpr std::size_t k_most_letters = 500;

/// File names and attributes may contain any characters: line ends and other control characters become spaces.
std::string printable(const std::string& text) {
    std::string clean = elided(valid_utf8(text), k_most_letters);
    for (char& c : clean)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    return clean;
}

Point rotated(Point p, double angle_deg) {
    const double angle = angle_deg * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// Draws white letters; returns the distance from the lower edge of VTK's box to the baseline.
double draw_with_vtk(const std::string& text, const std::string& font, int size, double angle_deg,
                     vtkImageData* pixels) {
    VtkErrors errors;
    vtkNew<vtkTextProperty> property;
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(font.c_str());
    property->SetFontSize(size);
    property->SetColor(1, 1, 1);
    property->SetOrientation(angle_deg);
    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    bool good = renderer != nullptr;
    vtkTextRenderer::Metrics metrics;
    if (good) {
        renderer->SetScaleToPowerOfTwo(false);
        std::array<int, 2> extent{};
        const vtkStdString words(text);
        // Backend FreeType: the default one would interpret a pair of dollar signs as mathematics.
        good =
            renderer->GetMetrics(property, words, metrics, k_dots_per_inch, vtkTextRenderer::FreeType) &&
            renderer->RenderString(property, words, pixels, extent.data(), k_dots_per_inch, vtkTextRenderer::FreeType);
    }
    errors.throw_if_any("a text could not be drawn: \"" + text + "\"");
    if (!good) {
        throw Error(ErrorKind::environment, Problem{"a text could not be drawn", "VTK", text, "", ""});
    }
    return std::hypot(metrics.Descent[0], metrics.Descent[1]) + 1;
}

}  // namespace

Lettering::Lettering() : regular_(find_font("DejaVuSans.ttf")), bold_(find_font("DejaVuSans-Bold.ttf")) {}

const Lettering::Drawn& Lettering::drawn(const std::string& text, const TextStyle& style) const {
    const auto [place, is_new] = kept_.try_emplace({text, style.size_px, style.bold, style.angle_deg});
    Drawn& drawn = place->second;
    if (!is_new || text.find_first_not_of(' ') == std::string::npos) return drawn;
    vtkNew<vtkImageData> pixels;
    drawn.descent = draw_with_vtk(text, style.bold ? bold_ : regular_, style.size_px, style.angle_deg, pixels);
    const int* extent = pixels->GetExtent();
    const int bands = pixels->GetNumberOfScalarComponents();
    const auto* values = static_cast<const unsigned char*>(pixels->GetScalarPointer());
    const int columns = extent[1] - extent[0] + 1, rows = extent[3] - extent[2] + 1;
    const auto alpha = [&](int column, int row) {  // row 0 at the bottom
        return values[static_cast<std::size_t>(bands) *
                          (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                           static_cast<std::size_t>(column)) +
                      static_cast<std::size_t>(bands) - 1];
    };
    int first_column = columns, last_column = -1, first_row = rows, last_row = -1;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            if (alpha(column, row) == 0) continue;
            first_column = std::min(first_column, column);
            last_column = std::max(last_column, column);
            first_row = std::min(first_row, row);
            last_row = std::max(last_row, row);
        }
    }
    if (last_column < 0) return drawn;
    drawn.first_column = extent[0] + first_column;
    drawn.last_row = extent[2] + last_row;
    drawn.glyphs.width = last_column - first_column + 1;
    drawn.glyphs.height = last_row - first_row + 1;
    for (int row = last_row; row >= first_row; --row) {
        for (int column = first_column; column <= last_column; ++column) drawn.glyphs.ink.push_back(alpha(column, row));
    }
    return drawn;
}

Glyphs Lettering::set(const std::string& text, const TextStyle& style, Across across, Upright upright) const {
    if (style.angle_deg == 90) {
        // Rotated pixel by pixel; upright labels keep their letters and their exact place.
        TextStyle level = style;
        level.angle_deg = 0;
        const Glyphs straight = set(text, level, across, upright);
        Glyphs turned{straight.top, -(straight.left + straight.width), straight.height, straight.width, {}};
        for (int row = 0; row < turned.height; ++row) {
            for (int column = 0; column < turned.width; ++column) {
                turned.ink.push_back(
                    straight.ink[static_cast<std::size_t>(column) * static_cast<std::size_t>(straight.width) +
                                 static_cast<std::size_t>(straight.width - 1 - row)]);
            }
        }
        return turned;
    }
    const std::string clean = printable(text);
    const Drawn& letters = drawn(clean, style);
    Glyphs glyphs = letters.glyphs;
    if (glyphs.width == 0) return glyphs;

    // The reference point in the unturned text, from the left end of the baseline.
    double ink_left = 0, ink_width = 0;
    if (style.angle_deg == 0 || across != Across::left) {
        TextStyle level = style;
        level.angle_deg = 0;
        const Drawn& straight = drawn(clean, level);
        ink_left = style.angle_deg == 0 ? straight.first_column : 0;
        ink_width = straight.glyphs.width;
    }
    const double capital = capital_height(style);
    const Point reference{across == Across::left     ? ink_left
                          : across == Across::centre ? ink_left + ink_width / 2
                                                     : ink_left + ink_width,
                          upright == Upright::baseline ? 0
                          : upright == Upright::middle ? capital / 2
                                                       : capital};
    const Point origin = rotated({reference.x, reference.y + letters.descent}, style.angle_deg);
    glyphs.left = static_cast<int>(std::lround(letters.first_column - origin.x));
    glyphs.top = -static_cast<int>(std::lround(letters.last_row + 1 - origin.y));
    return glyphs;
}

Glyphs Lettering::set(const std::string& text, Point at, const TextStyle& style, Across across, Upright upright) const {
    Glyphs glyphs = set(text, style, across, upright);
    glyphs.left += static_cast<int>(std::lround(at.x));
    glyphs.top += static_cast<int>(std::lround(at.y));
    return glyphs;
}

double Lettering::width(const std::string& text, const TextStyle& style) const {
    TextStyle level = style;
    level.angle_deg = 0;
    return set(text, level, Across::left, Upright::baseline).width;
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

void blend(Image& page, const Glyphs& glyphs, const TextStyle& style) {
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
                if (most > 0) mix(glyphs.left + column, glyphs.top + row, style.halo, most / 255);
            }
        }
    }
    for (int row = 0; row < glyphs.height; ++row) {
        for (int column = 0; column < glyphs.width; ++column) {
            if (const int fraction = coverage(column, row); fraction > 0)
                mix(glyphs.left + column, glyphs.top + row, style.colour, fraction / 255.0);
        }
    }
}

}  // namespace frana::render
