// SPDX-License-Identifier: Apache-2.0
#include "render/view/view_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

}  // namespace frana::render
