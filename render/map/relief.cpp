// SPDX-License-Identifier: Apache-2.0
#include "render/map/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

namespace frana::render {
namespace {

struct Light {
    double azimuth_deg;  ///< direction of the light, clockwise from north
    double elevation_deg;
    double weight;
};

/// The main light is in the north-west, as viewers expect; the others show slopes parallel to it.
constexpr std::array<Light, 4> k_lights{{{315, 42, 0.55}, {270, 45, 0.17}, {0, 45, 0.17}, {225, 50, 0.11}}};

}  // namespace

Raster hillshade(const Raster& terrain, double exaggeration) {
    const GridSpec& grid = terrain.grid;
    Raster shade(grid, k_no_data);
    struct Direction {
        double east, north, up;
    };
    std::array<Direction, k_lights.size()> lights{};
    for (std::size_t i = 0; i < k_lights.size(); ++i) {
        const double azimuth = k_lights[i].azimuth_deg * std::numbers::pi / 180;
        const double elevation = k_lights[i].elevation_deg * std::numbers::pi / 180;
        const double weight = k_lights[i].weight;
        lights[i] = {weight * std::cos(elevation) * std::sin(azimuth), weight * std::cos(elevation) * std::cos(azimuth),
                     weight * std::sin(elevation)};
    }
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double here = terrain.at(row, column);
            if (std::isnan(here)) continue;
            // Differences over the existing neighbours: central inside, one-sided along edges and gaps.
            const auto slope = [&](std::int64_t r0, std::int64_t c0, std::int64_t r1, std::int64_t c1) {
                const auto value = [&](std::int64_t r, std::int64_t c) {
                    const bool outside = r < 0 || c < 0 || r >= grid.rows || c >= grid.columns;
                    return outside ? k_no_data : terrain.at(r, c);
                };
                const double before = value(r0, c0), after = value(r1, c1);
                const bool has_before = !std::isnan(before), has_after = !std::isnan(after);
                if (!has_before && !has_after) return 0.0;
                const double length = grid.cell_size * ((has_before ? 1 : 0) + (has_after ? 1 : 0));
                return exaggeration * ((has_after ? after : here) - (has_before ? before : here)) / length;
            };
            const double to_east = slope(row, column - 1, row, column + 1);
            const double to_north = slope(row + 1, column, row - 1, column);
            const double length = std::sqrt(1 + to_east * to_east + to_north * to_north);
            double sum = 0;
            for (const Direction& light : lights) {
                sum += std::max(0.0, (light.up - to_east * light.east - to_north * light.north) / length);
            }
            shade.at(row, column) = std::min(sum, 1.0);
        }
    }
    return shade;
}

namespace {

using Edge = std::int64_t;  ///< between two neighbouring centres: 2 i towards the east, 2 i + 1 towards the south

struct Segment {
    Edge from, to;
};

/// Marching squares: the crossings of a level with the edges of the square of four centres whose upper left one is
/// (row, column).
class Squares {
  public:
    explicit Squares(const Raster& raster) : raster_(raster) {}

    [[nodiscard]] std::array<double, 4> corners(std::int64_t row, std::int64_t column) const {
        return {raster_.at(row, column), raster_.at(row, column + 1), raster_.at(row + 1, column + 1),
                raster_.at(row + 1, column)};
    }

    void cross(std::int64_t row, std::int64_t column, double level, std::vector<Segment>& segments) const {
        const std::array<double, 4> value = corners(row, column);
        const std::array<Edge, 4> edge{east(row, column), south(row, column + 1), east(row + 1, column),
                                       south(row, column)};
        std::array<Edge, 4> crossed{};
        std::size_t n_crossed = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            if ((value[k] >= level) != (value[(k + 1) % 4] >= level)) crossed[n_crossed++] = edge[k];
        }
        if (n_crossed == 2) segments.push_back({crossed[0], crossed[1]});
        if (n_crossed == 4) {  // a saddle: the mean decides which corners are connected
            const bool high = (value[0] + value[1] + value[2] + value[3]) / 4 >= level;
            const bool first_high = value[0] >= level;
            const std::size_t shift = high == first_high ? 0 : 1;
            // Corners 1 and 3 are cut off if corner 0 is connected to the middle: edges 0-1 and 2-3; otherwise 3-0 and
            // 1-2.
            segments.push_back({edge[shift == 0 ? 0 : 3], edge[shift == 0 ? 1 : 0]});
            segments.push_back({edge[shift == 0 ? 2 : 1], edge[shift == 0 ? 3 : 2]});
        }
    }

    [[nodiscard]] Point point(Edge edge, double level) const {
        const std::int64_t cell = edge / 2, row = cell / raster_.grid.columns, column = cell % raster_.grid.columns;
        const bool down = edge % 2 == 1;
        const double a = raster_.at(row, column), b = down ? raster_.at(row + 1, column) : raster_.at(row, column + 1);
        const double fraction = std::clamp((level - a) / (b - a), 0.0, 1.0) * raster_.grid.cell_size;
        const Point centre = raster_.grid.cell_centre(row, column);
        return down ? Point{centre.x, centre.y - fraction} : Point{centre.x + fraction, centre.y};
    }

  private:
    [[nodiscard]] Edge east(std::int64_t row, std::int64_t column) const {
        return 2 * (row * raster_.grid.columns + column);
    }
    [[nodiscard]] Edge south(std::int64_t row, std::int64_t column) const { return east(row, column) + 1; }

    const Raster& raster_;
};

/// Joins segments that share an edge into runs as long as possible.
std::vector<std::vector<Edge>> joined(const std::vector<Segment>& segments) {
    std::unordered_map<Edge, std::array<std::int64_t, 2>> at;  // segments ending on each edge
    for (std::size_t i = 0; i < segments.size(); ++i) {
        for (const Edge edge : {segments[i].from, segments[i].to}) {
            auto& ends = at.try_emplace(edge, std::array<std::int64_t, 2>{-1, -1}).first->second;
            ends[ends[0] < 0 ? 0 : 1] = static_cast<std::int64_t>(i);
        }
    }
    std::vector<bool> used(segments.size(), false);
    const auto walk = [&](std::size_t start, Edge from) {
        std::vector<Edge> run{from};
        auto segment = static_cast<std::int64_t>(start);
        while (segment >= 0 && !used[static_cast<std::size_t>(segment)]) {
            used[static_cast<std::size_t>(segment)] = true;
            const Segment& s = segments[static_cast<std::size_t>(segment)];
            run.push_back(s.from == run.back() ? s.to : s.from);
            const auto& ends = at.at(run.back());
            segment = ends[0] == segment ? ends[1] : ends[0];
        }
        return run;
    };
    std::vector<std::vector<Edge>> runs;
    for (std::size_t i = 0; i < segments.size(); ++i) {  // open lines first, from their ends
        if (used[i]) continue;
        for (const Edge edge : {segments[i].from, segments[i].to}) {
            if (!used[i] && at.at(edge)[1] < 0) runs.push_back(walk(i, edge));
        }
    }
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!used[i]) runs.push_back(walk(i, segments[i].from));
    }
    return runs;
}

}  // namespace

std::vector<Contour> contour_lines(const Raster& raster, double interval) {
    const Squares squares(raster);
    std::map<std::int64_t, std::vector<Segment>> by_level;
    for (std::int64_t row = 0; row + 1 < raster.grid.rows; ++row) {
        for (std::int64_t column = 0; column + 1 < raster.grid.columns; ++column) {
            const std::array<double, 4> corner = squares.corners(row, column);
            if (std::any_of(corner.begin(), corner.end(), [](double v) { return std::isnan(v); })) continue;
            const auto [low, high] = std::minmax_element(corner.begin(), corner.end());
            const auto first = static_cast<std::int64_t>(std::floor(*low / interval)) + 1;
            const auto last = static_cast<std::int64_t>(std::floor(*high / interval));
            for (std::int64_t k = first; k <= last; ++k) {
                squares.cross(row, column, static_cast<double>(k) * interval, by_level[k]);
            }
        }
    }
    std::vector<Contour> contours;
    for (const auto& [k, segments] : by_level) {
        const double level = static_cast<double>(k) * interval;
        for (const std::vector<Edge>& run : joined(segments)) {
            Contour contour{level, {}};
            for (const Edge edge : run) contour.points.push_back(squares.point(edge, level));
            contours.push_back(std::move(contour));
        }
    }
    return contours;
}

}  // namespace frana::render
