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
    if (texture.image.width == 0) return picture;
    // Pixels to the right and upwards.
    const auto place = [&](Point map) {
        const Point p = frame.turn.page(map);
        return ScenePoint{(p.x - frame.window.west) / frame.window.width() * frame.width,
                          (p.y - frame.window.north) / frame.window.height() * frame.height, 0};
    };
    std::vector<ScenePoint> places;
    for (const Point corner : corners(texture.box)) places.push_back(place(corner));
    return call_module([&] {
        // The shaders of the last picture need not be compiled again.
        static thread_local std::unique_ptr<TerrainScene> scene;
        if (!scene) {
            const SceneSurface rectangle{places, {0, 1, 2, 3}, 4, {255, 255, 255}, {0, 1, 1, 1, 1, 0, 0, 0}};
            scene = vtk().terrain_scene({rectangle});
            scene->set_background(k_no_terrain, k_no_terrain);
        }
        scene->move_points(places);
        scene->set_texture(texture.image.width, texture.image.height, texture.image.rgb);
        // In pieces, so that a large page needs no window of its size.
        constexpr int k_piece = 1024;
        for (int top = 0; top < frame.height; top += k_piece) {
            for (int left = 0; left < frame.width; left += k_piece) {
                const int width = std::min(k_piece, frame.width - left), height = std::min(k_piece, frame.height - top);
                scene->start(width, height);
                scene->look_down({left + width / 2.0, -(top + height / 2.0), 0}, height);
                const std::vector<std::uint8_t> piece = scene->draw(1);
                const std::size_t line = 3 * static_cast<std::size_t>(width);
                for (int row = 0; row < height; ++row)
                    std::copy_n(piece.data() + line * static_cast<std::size_t>(row), line,
                                picture.pixel(left, top + row));
            }
        }
        return picture;
    });
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
    // More than one cell for a pixel would not be seen, nor more than OpenGL takes.
    constexpr int k_most_texels = 8192;
    return draw_ground(frame,
                       relief_texture(*terrain, box, std::min(2 * std::max(frame.width, frame.height), k_most_texels)));
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

void paint_cells(Image& page, const MapFrame& frame, const Raster& layer, const ColourScale& scale, int edge_px) {
    const auto width = static_cast<std::size_t>(frame.width);
    std::vector<char> coloured(width * static_cast<std::size_t>(frame.height));
    for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
            const ColourClass* found = scale.find(cell_value(layer, frame.ground(column, row)));
            if (found == nullptr) continue;
            std::uint8_t* p = page.pixel(frame.left + column, frame.top + row);
            p[0] = found->colour.r;
            p[1] = found->colour.g;
            p[2] = found->colour.b;
            coloured[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] = 1;
        }
    }
    const auto is_coloured = [&](int column, int row) {
        return column >= 0 && column < frame.width && row >= 0 && row < frame.height &&
               coloured[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] != 0;
    };
    for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
            if (is_coloured(column, row)) continue;
            bool at_edge = false;
            for (int k = 1; k <= edge_px && !at_edge; ++k)
                at_edge = is_coloured(column - k, row) || is_coloured(column + k, row) ||
                          is_coloured(column, row - k) || is_coloured(column, row + k);
            if (!at_edge) continue;
            std::uint8_t* p = page.pixel(frame.left + column, frame.top + row);
            for (int k = 0; k < 3; ++k) p[k] = static_cast<std::uint8_t>(p[k] * 2 / 5);
        }
    }
}

}  // namespace frana::render
