// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_body.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/module.h"
#include "render/canvas/image.h"
#include "render/canvas/page.h"
#include "render/map/relief.h"

namespace frana::render {

Bounds MapFrame::ground_bounds() const {
    Ring ring = corners(window);
    for (Point& corner : ring) corner = turn.map(corner);
    return bounds(MultiPolygon{{std::move(ring), {}}});
}

ReliefTones::ReliefTones(const Raster& shade) {
    std::vector<double> values;
    for (const double value : shade.values) {
        if (!std::isnan(value)) values.push_back(value);
    }
    double gamma = 1;
    if (!values.empty()) gamma = fit(values);
    for (int i = 0; i <= k_steps; ++i) {
        const double fraction = std::pow(static_cast<double>(i) / k_steps, gamma);
        // From a cool mid grey to a warm near-white.
        const double bright = 138 + 110 * fraction, warm = 5 * fraction - 2.5;
        const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(v)); };
        tones_[static_cast<std::size_t>(i)] = {byte(bright + warm), byte(bright + 0.4 * warm), byte(bright - warm)};
    }
}

double ReliefTones::fit(std::vector<double>& values) {
    // One cell in a hundred may be a cliff or a wall; these must not determine the tones of the others.
    const auto quantile = [&values](double fraction) {
        const auto place =
            values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), place, values.end());
        return *place;
    };
    darkest_ = quantile(0.01);
    brightest_ = quantile(0.99);
    constexpr double k_least_range = 0.4;
    const double lacking = k_least_range - (brightest_ - darkest_);
    if (lacking > 0) {
        darkest_ -= lacking / 2;
        brightest_ += lacking / 2;
    }
    // A hillside facing the light would be white all over: its middle is mapped to the middle of the tones.
    constexpr double k_middle_tone = 0.6;
    const double middle = std::clamp((quantile(0.5) - darkest_) / (brightest_ - darkest_), 0.05, 0.95);
    return std::clamp(std::log(k_middle_tone) / std::log(middle), 0.75, 2.5);
}

const VtkFunctions& vtk() {
    static const auto& functions = module_table<VtkFunctions>("vtk");
    return functions;
}

GroundTexture relief_texture(const Raster& terrain, const Bounds& window, std::int64_t most_cells) {
    const Raster part = raster_window(terrain, window, most_cells);
    GroundTexture texture{part.grid.bounds(),
                          Image(static_cast<int>(part.grid.columns), static_cast<int>(part.grid.rows), k_no_terrain)};
    if (part.grid.columns == 0) return texture;
    const Raster shade = hillshade(part);
    const ReliefTones tones(shade);
    std::uint8_t* to = texture.image.rgb.data();
    for (const double value : shade.values) {
        if (!std::isnan(value)) {
            const Rgb colour = tones.colour(value);
            to[0] = colour.r;
            to[1] = colour.g;
            to[2] = colour.b;
        }
        to += 3;
    }
    return texture;
}

void lay(Image& under, const std::vector<std::uint8_t>& picture, double lighter) {
    const std::uint8_t* from = picture.data();
    for (std::size_t i = 0; i < under.rgb.size(); i += 3, from += 4) {
        for (std::size_t k = 0; k < 3; ++k) {  // colours are premultiplied by their opacity
            const double through = under.rgb[i + k] * (255 - from[3]) / 255.0;
            const double lit = from[k] + lighter * (from[3] - from[k]);
            under.rgb[i + k] = static_cast<std::uint8_t>(std::lround(through + lit));
        }
    }
}

Image draw_ground(const MapFrame& frame, const GroundTexture& texture) {
    Image picture(frame.width, frame.height, k_no_terrain);
    const Image& of = texture.image;
    const double across = of.width / texture.box.width(), down = of.height / texture.box.height();
    for (int row = 0; row < frame.height && of.width > 0; ++row) {
        const Point first = frame.ground(0, row), second = frame.ground(1, row);
        for (int column = 0; column < frame.width; ++column) {
            const double x = (first.x + column * (second.x - first.x) - texture.box.west) * across,
                         y = (texture.box.north - first.y - column * (second.y - first.y)) * down;
            if (!(x >= 0 && x <= of.width && y >= 0 && y <= of.height)) continue;
            const double from_left = std::clamp(x - 0.5, 0.0, of.width - 1.0),
                         from_top = std::clamp(y - 0.5, 0.0, of.height - 1.0);
            const int left = std::min(static_cast<int>(from_left), std::max(of.width - 2, 0)),
                      top = std::min(static_cast<int>(from_top), std::max(of.height - 2, 0));
            const double right = from_left - left, below = from_top - top;
            const std::uint8_t* const upper = of.pixel(left, top);
            const std::uint8_t* const lower = of.pixel(left, std::min(top + 1, of.height - 1));
            const int next = of.width > 1 ? 3 : 0;
            std::uint8_t* const to = picture.pixel(column, row);
            for (int k = 0; k < 3; ++k) {
                const double a = upper[k] + right * (upper[next + k] - upper[k]),
                             b = lower[k] + right * (lower[next + k] - lower[k]);
                to[k] = static_cast<std::uint8_t>(a + below * (b - a) + 0.5);
            }
        }
    }
    return picture;
}

Image ground_picture(const MapFrame& frame, const Raster* terrain, const Background& background) {
    const Bounds box = frame.ground_bounds();
    if (background) {
        const double metre = frame.metres_per_pixel();
        constexpr double k_rounding = 1e-6, k_lighter = 0.18;
        Image image(static_cast<int>(std::ceil(box.width() / metre - k_rounding)),
                    static_cast<int>(std::ceil(box.height() / metre - k_rounding)), k_no_terrain);
        const Bounds shown{box.west, box.north - image.height * metre, box.west + image.width * metre, box.north};
        lay(image, background(shown, image.width, image.height), k_lighter);
        return draw_ground(frame, {shown, std::move(image)});
    }
    if (terrain == nullptr) return Image(frame.width, frame.height, k_no_terrain);
    // More than one cell for a pixel would not be seen.
    return draw_ground(frame, relief_texture(*terrain, box, 2 * std::max(frame.width, frame.height)));
}

void paint_dots(Image& page, const MapFrame& frame, const Dots& dots, const ColourScale& scale) {
    const double radius = std::max(0.5, dots.width_m / frame.metres_per_pixel() / 2);
    const PageBox box = frame.box();
    for (const Dot& dot : dots.dots) {
        const ColourClass* found = scale.find(dot.value);
        if (found == nullptr) continue;
        const Point at = frame.page(dot.place);
        const auto paint = [&](int column, int row) {
            if (column < box.left || column >= box.right || row < box.top || row >= box.bottom) return;
            std::uint8_t* p = page.pixel(column, row);
            p[0] = found->colour.r;
            p[1] = found->colour.g;
            p[2] = found->colour.b;
        };
        paint(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
        for (int row = static_cast<int>(at.y - radius); row <= static_cast<int>(at.y + radius); ++row) {
            for (int column = static_cast<int>(at.x - radius); column <= static_cast<int>(at.x + radius); ++column) {
                if (std::hypot(column + 0.5 - at.x, row + 0.5 - at.y) < radius) paint(column, row);
            }
        }
    }
}

namespace {

/// The classes of places on a layer.
class PlaceClasses {
  public:
    PlaceClasses(const Raster& layer, const ColourScale& scale) : layer_(layer), scale_(scale) {}

    /// Null beside the cells with a class: where these count less than a half of the four around a place. Otherwise
    /// that of their mean, or of categories the one that counts most.
    [[nodiscard]] const ColourClass* at(Point map) {
        const GridSpec& grid = layer_.grid;
        const double x = (map.x - grid.west) / grid.cell_size - 0.5, y = (grid.north - map.y) / grid.cell_size - 0.5;
        const double left = std::floor(x), top = std::floor(y);
        if (!(left >= -1 && top >= -1 && left < static_cast<double>(grid.columns) &&
              top < static_cast<double>(grid.rows)))
            return nullptr;
        std::array<double, 4> values{}, weights{};
        double covered = 0, sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto across = static_cast<std::int64_t>(k % 2), down = static_cast<std::int64_t>(k / 2);
            const auto column = static_cast<std::int64_t>(left) + across, row = static_cast<std::int64_t>(top) + down;
            if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) continue;
            values[k] = layer_.at(row, column);
            if (find(values[k]) == nullptr) continue;
            weights[k] = (1 - std::abs(x - left - static_cast<double>(across))) *
                         (1 - std::abs(y - top - static_cast<double>(down)));
            covered += weights[k];
            sum += weights[k] * values[k];
        }
        if (covered < 0.5) return nullptr;
        return find(scale_.categorical() ? most_of(values, weights) : sum / covered);
    }

  private:
    static double most_of(const std::array<double, 4>& values, const std::array<double, 4>& weights) {
        double most = 0, greatest = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            double same = 0;
            for (std::size_t other = 0; other < 4; ++other)
                if (values[other] == values[k]) same += weights[other];
            if (weights[k] > 0 && same > most) greatest = values[k];
            most = std::max(most, same);
        }
        return greatest;
    }
    /// Mostly that of the value before.
    const ColourClass* find(double value) {
        if (std::isnan(value)) return nullptr;
        const bool same = last_ != nullptr && value > last_->lower && value < last_->upper;
        if (!same) last_ = scale_.find(value);
        return last_;
    }

    const Raster& layer_;
    const ColourScale& scale_;
    const ColourClass* last_ = nullptr;
};

/// How the ground below changes a colour: its light and shade, lines and letters are seen through it. The legend's
/// colours are those on its mean tone: relief is bright, a photograph dark.
class GroundLight {
  public:
    GroundLight(const Image& page, const MapFrame& frame) {
        double sum = 0, count = 0;
        for (int row = 0; row < frame.height; row += k_apart)
            for (int column = 0; column < frame.width; column += k_apart, ++count)
                sum += static_cast<double>(tone(page.pixel(frame.left + column, frame.top + row)));
        for (std::size_t one = 0; one < light_.size(); ++one)
            light_[one] = std::clamp(std::pow(static_cast<double>(one) * count / std::max(sum, 1.0), 0.6), 0.4, 1.25);
    }
    /// A colour on ground of every tone.
    [[nodiscard]] std::array<Rgb, 256> on_tones(Rgb colour) const {
        std::array<Rgb, 256> lit{};
        for (std::size_t one = 0; one < lit.size(); ++one) {
            const auto tinted = [&](std::uint8_t of) {
                return static_cast<std::uint8_t>(std::min(255.0, std::round(of * light_[one])));
            };
            lit[one] = {tinted(colour.r), tinted(colour.g), tinted(colour.b)};
        }
        return lit;
    }
    static std::size_t tone(const std::uint8_t* p) { return static_cast<std::size_t>(p[0] + p[1] + p[2]) / 3; }

  private:
    static constexpr int k_apart = 5;  // pixels that tell the mean

    std::array<double, 256> light_{};
};

/// The pixels of a frame that the cells with values may reach, and `more` beside them.
struct PixelBox {
    int left, top, right, bottom;
};
PixelBox reached_pixels(const MapFrame& frame, const Bounds& data, int more) {
    PixelBox box{frame.width, frame.height, 0, 0};
    for (const Point corner : corners(data)) {
        const Point at = frame.alone().page(corner);
        const auto pixel = [&](double place, int most) {
            return static_cast<int>(std::clamp(place, -1.0, static_cast<double>(most) + 1));
        };
        const int x = pixel(at.x, frame.width), y = pixel(at.y, frame.height);
        box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
    return {std::max(0, box.left - more), std::max(0, box.top - more), std::min(frame.width, box.right + 1 + more),
            std::min(frame.height, box.bottom + 1 + more)};
}

}  // namespace

void paint_cells(Image& page, const MapFrame& frame, const Raster& layer, const ColourScale& scale, int edge_px) {
    const auto data = data_bounds(layer);
    if (!data) return;
    PlaceClasses classes(layer, scale);
    const PixelBox box = reached_pixels(frame, *data, edge_px + 1);
    const GroundLight light(page, frame);
    std::vector<std::array<Rgb, 256>> colours;
    for (const ColourClass& one : scale.classes()) colours.push_back(light.on_tones(one.colour));
    const auto stride = static_cast<std::ptrdiff_t>(frame.width + 2 * edge_px);
    std::vector<char> coloured(static_cast<std::size_t>(stride * (frame.height + 2 * edge_px)));  // with room around it
    const auto mark = [&](int column, int row) {
        return coloured.data() + (row + edge_px) * stride + column + edge_px;
    };
    for (int row = box.top; row < box.bottom; ++row) {
        for (int column = box.left; column < box.right; ++column) {
            const ColourClass* found = classes.at(frame.ground(column, row));
            if (found == nullptr) continue;
            std::uint8_t* const p = page.pixel(frame.left + column, frame.top + row);
            const Rgb lit = colours[static_cast<std::size_t>(found - scale.classes().data())][GroundLight::tone(p)];
            p[0] = lit.r;
            p[1] = lit.g;
            p[2] = lit.b;
            *mark(column, row) = 1;
        }
    }
    for (int row = box.top; row < box.bottom; ++row) {
        for (int column = box.left; column < box.right; ++column) {
            const char* const here = mark(column, row);
            if (*here != 0) continue;
            char near = 0;
            for (std::ptrdiff_t k = 1; k <= edge_px; ++k)
                near |= here[-k] | here[k] | here[-k * stride] | here[k * stride];
            if (near == 0) continue;
            std::uint8_t* p = page.pixel(frame.left + column, frame.top + row);
            for (int k = 0; k < 3; ++k) p[k] = static_cast<std::uint8_t>(p[k] * 2 / 5);
        }
    }
}

}  // namespace frana::render
