// SPDX-License-Identifier: Apache-2.0
#include "render/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "render/vtk_errors.h"
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
    throw Error(ErrorKind::environment, Problem{"a font for maps is missing", folders[0] + name, "", "",
                                                "install Debian's fonts-dejavu-core"});
}

/// Text from file names and attributes may hold anything; what is not UTF-8 becomes '?', line ends become
/// spaces.
std::string printable(const std::string& text) {
    std::string clean;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        std::size_t length = byte < 0x80                   ? 1
                             : byte >= 0xF0 && byte < 0xF5 ? 4
                             : byte >= 0xE0                ? 3
                             : byte >= 0xC2                ? 2
                                                           : 0;
        if (byte >= 0xF5) length = 0;
        bool whole = length > 0 && i + length <= text.size();
        for (std::size_t k = 1; whole && k < length; ++k) {
            whole = (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
        }
        if (!whole) {
            clean += '?';
            ++i;
            continue;
        }
        if (byte < 0x20 || byte == 0x7F) {
            clean += ' ';
        } else {
            clean += text.substr(i, length);
        }
        i += length;
    }
    return clean;
}

void mix(std::uint8_t* pixel, Rgb colour, double share) {
    const std::array<std::uint8_t, 3> ink{colour.r, colour.g, colour.b};
    for (std::size_t k = 0; k < 3; ++k) {
        pixel[k] = static_cast<std::uint8_t>(std::lround(pixel[k] + (ink[k] - pixel[k]) * share));
    }
}

Point rotated(Point p, double angle_deg) {
    const double angle = angle_deg * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}

struct Drawn {
    vtkNew<vtkImageData> pixels;
    double descent = 0;  ///< from the lower edge of VTK's box to the baseline
};

void draw_with_vtk(const std::string& text, const std::string& font, int size, double angle_deg,
                   Drawn& drawn) {
    VtkErrors errors;
    vtkNew<vtkTextProperty> property;
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(font.c_str());
    property->SetFontSize(size);
    property->SetColor(1, 1, 1);
    property->SetOrientation(angle_deg);
    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    bool good = renderer != nullptr;
    if (good) {
        renderer->SetScaleToPowerOfTwo(false);
        vtkTextRenderer::Metrics metrics;
        std::array<int, 2> extent{};
        const vtkStdString words(text);
        // Backend FreeType: the default one would read a pair of dollar signs as mathematics.
        good = renderer->GetMetrics(property, words, metrics, k_dots_per_inch, vtkTextRenderer::FreeType) &&
               renderer->RenderString(property, words, drawn.pixels, extent.data(), k_dots_per_inch,
                                      vtkTextRenderer::FreeType);
        drawn.descent = std::hypot(metrics.Descent[0], metrics.Descent[1]) + 1;
    }
    errors.throw_if_any("a text could not be drawn: \"" + text + "\"");
    if (!good) {
        throw Error(ErrorKind::environment, Problem{"a text could not be drawn", "VTK", text, "", ""});
    }
}

}  // namespace

/// Coverage of each pixel by ink, in page orientation (rows downwards), trimmed to the ink.
struct Lettering::Glyphs {
    int left = 0, top = 0;  ///< of the first pixel, from the point where the text is put
    int width = 0, height = 0;
    std::vector<std::uint8_t> ink;
};

Lettering::Lettering() : regular_(find_font("DejaVuSans.ttf")), bold_(find_font("DejaVuSans-Bold.ttf")) {}

Lettering::Glyphs Lettering::set(const std::string& text, const TextStyle& style, Across across,
                                 Upright upright) const {
    if (style.angle_deg == 90) {
        // Turned pixel by pixel, upright labels keep their letters and their exact place.
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
    Glyphs glyphs;
    if (clean.find_first_not_of(' ') == std::string::npos) return glyphs;

    double ink_left = 0, ink_width = 0;
    if (style.angle_deg != 0 && across != Across::left) {
        TextStyle level = style;
        level.angle_deg = 0;
        const Glyphs straight = set(text, level, Across::left, Upright::baseline);
        ink_left = straight.left;
        ink_width = straight.width;
    }
    Drawn drawn;
    draw_with_vtk(clean, style.bold ? bold_ : regular_, style.size_px, style.angle_deg, drawn);
    const int* extent = drawn.pixels->GetExtent();
    const int bands = drawn.pixels->GetNumberOfScalarComponents();
    const auto* values = static_cast<const unsigned char*>(drawn.pixels->GetScalarPointer());
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
    if (last_column < 0) return glyphs;
    if (style.angle_deg == 0) {
        ink_left = extent[0] + first_column;
        ink_width = last_column - first_column + 1;
    }

    // The reference point in the unturned text, from the left end of the baseline.
    const double capital = capital_height(style);
    const Point reference{across == Across::left     ? (style.angle_deg == 0 ? ink_left : 0)
                          : across == Across::centre ? ink_left + ink_width / 2
                                                     : ink_left + ink_width,
                          upright == Upright::baseline ? 0
                          : upright == Upright::middle ? capital / 2
                                                       : capital};
    const Point origin = rotated({reference.x, reference.y + drawn.descent}, style.angle_deg);
    glyphs.width = last_column - first_column + 1;
    glyphs.height = last_row - first_row + 1;
    glyphs.left = static_cast<int>(std::lround(extent[0] + first_column - origin.x));
    glyphs.top = -static_cast<int>(std::lround(extent[2] + last_row + 1 - origin.y));
    glyphs.ink.reserve(static_cast<std::size_t>(glyphs.width) * static_cast<std::size_t>(glyphs.height));
    for (int row = last_row; row >= first_row; --row) {
        for (int column = first_column; column <= last_column; ++column)
            glyphs.ink.push_back(alpha(column, row));
    }
    return glyphs;
}

double Lettering::width(const std::string& text, const TextStyle& style) const {
    TextStyle level = style;
    level.angle_deg = 0;
    return set(text, level, Across::left, Upright::baseline).width;
}

TextBox Lettering::place(const std::string& text, Point at, const TextStyle& style, Across across,
                         Upright upright) const {
    const Glyphs glyphs = set(text, style, across, upright);
    const double left = std::round(at.x) + glyphs.left, top = std::round(at.y) + glyphs.top;
    return {text, {left, top, left + glyphs.width, top + glyphs.height}, static_cast<double>(style.size_px)};
}

template <class Blend>
TextBox Lettering::ink(const Blend& blend, const std::string& text, Point at, const TextStyle& style,
                       Across across, Upright upright) const {
    const Glyphs glyphs = set(text, style, across, upright);
    const int left = static_cast<int>(std::lround(at.x)) + glyphs.left;
    const int top = static_cast<int>(std::lround(at.y)) + glyphs.top;
    const auto coverage = [&](int column, int row) -> int {
        if (column < 0 || row < 0 || column >= glyphs.width || row >= glyphs.height) return 0;
        return glyphs.ink[static_cast<std::size_t>(row) * static_cast<std::size_t>(glyphs.width) +
                          static_cast<std::size_t>(column)];
    };
    if (style.halo_px > 0) {
        const int reach = static_cast<int>(std::ceil(style.halo_px));
        for (int row = -reach; row < glyphs.height + reach; ++row) {
            for (int column = -reach; column < glyphs.width + reach; ++column) {
                double most = 0;
                for (int dy = -reach; dy <= reach; ++dy) {
                    for (int dx = -reach; dx <= reach; ++dx) {
                        const double near = std::clamp(style.halo_px + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
                        most = std::max(most, near * coverage(column + dx, row + dy));
                    }
                }
                if (most > 0) blend(left + column, top + row, style.halo, most / 255);
            }
        }
    }
    for (int row = 0; row < glyphs.height; ++row) {
        for (int column = 0; column < glyphs.width; ++column) {
            if (const int share = coverage(column, row); share > 0) {
                blend(left + column, top + row, style.colour, share / 255.0);
            }
        }
    }
    return {text,
            {static_cast<double>(left), static_cast<double>(top), static_cast<double>(left + glyphs.width),
             static_cast<double>(top + glyphs.height)},
            static_cast<double>(style.size_px)};
}

TextBox Lettering::write(Image& page, const std::string& text, Point at, const TextStyle& style,
                         Across across, Upright upright) const {
    const auto blend = [&page](int column, int row, Rgb colour, double share) {
        if (column < 0 || row < 0 || column >= page.width || row >= page.height) return;
        mix(page.pixel(column, row), colour, share);
    };
    return ink(blend, text, at, style, across, upright);
}

TextBox Lettering::write(LayerImage& layer, const std::string& text, Point at, const TextStyle& style,
                         Across across, Upright upright) const {
    const auto blend = [&layer](int column, int row, Rgb colour, double share) {
        if (column < 0 || row < 0 || column >= layer.width || row >= layer.height) return;
        std::uint8_t* p =
            layer.rgba.data() + 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(layer.width) +
                                     static_cast<std::size_t>(column));
        // Colours are multiplied by opacity already, so ink over them mixes like ink over paper.
        mix(p, colour, share);
        p[3] = static_cast<std::uint8_t>(std::lround(p[3] + (255 - p[3]) * share));
    };
    return ink(blend, text, at, style, across, upright);
}

}  // namespace frana::render
