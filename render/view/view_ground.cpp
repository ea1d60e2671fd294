// SPDX-License-Identifier: Apache-2.0
#include "render/view/view_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "render/canvas/page.h"
#include "render/map/map_body.h"
#include "render/map/relief.h"

namespace frana::render {
namespace {

constexpr double k_degree = std::numbers::pi / 180;

double dot(const ScenePoint& a, const ScenePoint& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct CameraAxes {
    ScenePoint right, up, forward;
};

CameraAxes camera_axes(double azimuth_deg, double elevation_deg) {
    const double a = azimuth_deg * k_degree, e = elevation_deg * k_degree;
    return {{std::cos(a), -std::sin(a), 0},
            {std::sin(a) * std::sin(e), std::cos(a) * std::sin(e), std::cos(e)},
            {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), -std::sin(e)}};
}

}  // namespace

Point PlacedCamera::project(const ScenePoint& point) const {
    const double east = target.x - position.x, north = target.y - position.y, up = target.z - position.z;
    const CameraAxes axes =
        camera_axes(std::atan2(east, north) / k_degree, -std::atan2(up, std::hypot(east, north)) / k_degree);
    const ScenePoint ray{point.x - position.x, point.y - position.y, point.z - position.z};
    const double distance = dot(ray, axes.forward) * std::tan(opening_deg / 2 * k_degree);
    return {dot(ray, axes.right) / distance, dot(ray, axes.up) / distance};
}

Camera find_camera(std::span<const ScenePoint> flow) {
    Camera camera;
    if (flow.size() < 2) return camera;
    std::vector<ScenePoint> points(flow.begin(), flow.end());
    std::sort(points.begin(), points.end(), [](const ScenePoint& a, const ScenePoint& b) { return a.z < b.z; });
    const auto centre = [&](std::size_t begin, std::size_t end) {
        Point sum;
        for (std::size_t i = begin; i < end; ++i) {
            sum.x += points[i].x;
            sum.y += points[i].y;
        }
        const auto count = static_cast<double>(end - begin);
        return Point{sum.x / count, sum.y / count};
    };
    const std::size_t quarter = std::max<std::size_t>(1, points.size() / 4);
    const Point low = centre(0, quarter), high = centre(points.size() - quarter, points.size());
    constexpr double k_sideways_deg = 24;  // straight up the path, height and distance would look the same
    if (std::hypot(high.x - low.x, high.y - low.y) > 0) {
        camera.azimuth_deg = std::atan2(high.x - low.x, high.y - low.y) / k_degree + k_sideways_deg;
    }
    camera.azimuth_deg = std::fmod(camera.azimuth_deg + 360, 360);
    camera.elevation_deg = 33;
    return camera;
}

PlacedCamera place_camera(const Camera& camera, std::span<const ScenePoint> points, double aspect) {
    const CameraAxes axes = camera_axes(camera.azimuth_deg, camera.elevation_deg);
    PlacedCamera placed;
    constexpr double k_fill = 0.8;  // fraction of the picture filled by the points
    const double steep = k_fill * std::tan(placed.opening_deg / 2 * k_degree), wide = steep * aspect;
    // In camera axes a point (a, b, c) is inside the picture when |a - a0| <= wide (c - c0) and |b - b0| <=
    // steep (c - c0): four bounds, linear in the camera's place (a0, b0, c0), from which the nearest place
    // follows at once.
    constexpr double k_least = -std::numeric_limits<double>::infinity();
    double right = k_least, left = k_least, top = k_least, bottom = k_least;
    for (const ScenePoint& p : points) {
        const double a = dot(p, axes.right), b = dot(p, axes.up), c = dot(p, axes.forward);
        right = std::max(right, a - wide * c);
        left = std::max(left, -a - wide * c);
        top = std::max(top, b - steep * c);
        bottom = std::max(bottom, -b - steep * c);
    }
    const double a0 = (right - left) / 2, b0 = (top - bottom) / 2;
    double c0 = std::min(-(right + left) / (2 * wide), -(top + bottom) / (2 * steep));
    double middle = 0;
    for (const ScenePoint& p : points) middle += dot(p, axes.forward) / static_cast<double>(points.size());
    const double distance = std::max(middle - c0, 1.0) / camera.zoom;
    c0 = middle - distance;
    const auto place = [&](double c) {
        return ScenePoint{a0 * axes.right.x + b0 * axes.up.x + c * axes.forward.x,
                          a0 * axes.right.y + b0 * axes.up.y + c * axes.forward.y,
                          a0 * axes.right.z + b0 * axes.up.z + c * axes.forward.z};
    };
    placed.position = place(c0);
    placed.target = place(c0 + distance);
    return placed;
}

namespace {

constexpr std::int64_t k_mesh_cells = 200;     // per side: 80,000 triangles, finer than visible below a texture
constexpr std::int64_t k_texels = 2048;        // per side at most
constexpr std::int64_t k_texels_per_cell = 3;  // keeps the edges of cells sharp between interpolated texels

Bounds shown_part(const Raster& terrain, const Raster* layer) {
    const Bounds all = terrain.grid.bounds();
    const std::optional<Bounds> data = layer != nullptr ? data_bounds(*layer) : std::nullopt;
    if (!data) return all;
    constexpr double k_around = 0.75;  // of the flow's greater side, on each side
    const double margin = std::max(k_around * std::max(data->width(), data->height()), 20 * layer->grid.cell_size);
    return {std::max(all.west, data->west - margin), std::max(all.south, data->south - margin),
            std::min(all.east, data->east + margin), std::min(all.north, data->north + margin)};
}

}  // namespace

ViewGround::ViewGround(const Raster& terrain, const Raster* layer, double exaggeration, const Background& background)
    : exaggeration_(exaggeration) {
    const Bounds part = shown_part(terrain, layer);
    heights_ = raster_window(terrain, part, k_mesh_cells);
    const ValueRange range = value_range(heights_);
    if (heights_.grid.columns < 2 || heights_.grid.rows < 2 || range.empty()) {
        throw Error(ErrorKind::input,
                    Problem{"a view needs terrain where its raster is", "", "", "", "is it the right DTM?"});
    }
    const Bounds box = heights_.grid.bounds();
    origin_ = {(box.west + box.east) / 2, (box.south + box.north) / 2};
    base_ = range.least;
    highest_ = exaggeration_ * (range.greatest - base_);
    lowest_ = 0;

    const GroundTexture detail = relief_texture(terrain, part, k_texels);
    const double detail_cell = detail.box.width() / detail.image.width;
    const double cell = layer != nullptr ? std::min(detail_cell, layer->grid.cell_size) : detail_cell;
    const double longer = std::max(box.width(), box.height());
    const double texel = std::max(cell / k_texels_per_cell, longer / static_cast<double>(k_texels));
    const int columns = std::max(2, static_cast<int>(box.width() / texel)),
              rows = std::max(2, static_cast<int>(box.height() / texel));
    relief_ = draw_ground({0, 0, columns, rows, box}, detail);
    if (background) lay(relief_, background(box, columns, rows), 0);
}

ScenePoint ViewGround::scene(Point map, double above) const {
    return {map.x - origin_.x, map.y - origin_.y, exaggeration_ * (interpolated(heights_, map) + above - base_)};
}

bool ViewGround::hides(const ScenePoint& eye, const ScenePoint& point) const {
    constexpr int k_samples = 64;
    const double margin = 0.01 * (highest_ - lowest_);
    for (int i = 0; i < k_samples; ++i) {
        const double fraction = static_cast<double>(i) / k_samples;
        const Point map{origin_.x + eye.x + fraction * (point.x - eye.x),
                        origin_.y + eye.y + fraction * (point.y - eye.y)};
        const double ground = scene(map, 0).z;  // NaN beyond the terrain, which hides nothing
        if (eye.z + fraction * (point.z - eye.z) < ground - margin) return true;
    }
    return false;
}

std::vector<ScenePoint> ViewGround::sample(const Raster* layer, std::int64_t most) const {
    const Raster& from = layer != nullptr && data_bounds(*layer) ? *layer : heights_;
    std::int64_t n_values = 0;
    from.values.for_each_stored([&](std::size_t, double value) { n_values += std::isnan(value) ? 0 : 1; });
    const std::int64_t step = std::max<std::int64_t>(1, n_values / most);
    std::vector<ScenePoint> points;
    std::int64_t k = 0;
    from.values.for_each_stored([&](std::size_t cell, double value) {
        if (std::isnan(value) || k++ % step != 0) return;
        const auto n = static_cast<std::int64_t>(cell);
        const ScenePoint p = scene(from.grid.cell_centre(n / from.grid.columns, n % from.grid.columns), 0);
        if (!std::isnan(p.z)) points.push_back(p);
    });
    return points;
}

Image ViewGround::colours(const Raster* layer, const ColourScale& scale) const {
    Image image = relief_;
    const std::optional<Bounds> data = layer != nullptr ? data_bounds(*layer) : std::nullopt;
    if (!data) return image;
    const Bounds box = heights_.grid.bounds();
    const double wide = box.width() / image.width, high = box.height() / image.height;
    const auto texel = [](double place, int count) {
        return static_cast<int>(std::clamp(std::floor(place), 0.0, static_cast<double>(count)));
    };
    const int last_row = texel((box.north - data->south) / high + 1, image.height);
    const int last_column = texel((data->east - box.west) / wide + 1, image.width);
    for (int row = texel((box.north - data->north) / high, image.height); row < last_row; ++row) {
        for (int column = texel((data->west - box.west) / wide, image.width); column < last_column; ++column) {
            const Point map{box.west + (column + 0.5) * wide, box.north - (row + 0.5) * high};
            const ColourClass* found = scale.find(cell_value(*layer, map));
            if (found == nullptr) continue;
            std::uint8_t* p = image.pixel(column, row);
            // On dark relief the colour is darkened too, but less, to resemble that of the legend.
            constexpr double k_least_light = 0.88;
            const double light =
                std::clamp(k_least_light + (1 - k_least_light) * (p[1] - 138) / 90.0, k_least_light, 1.0);
            const auto lit = [light](std::uint8_t v) { return static_cast<std::uint8_t>(std::lround(light * v)); };
            p[0] = lit(found->colour.r);
            p[1] = lit(found->colour.g);
            p[2] = lit(found->colour.b);
        }
    }
    return image;
}

}  // namespace frana::render
