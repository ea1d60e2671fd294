// SPDX-License-Identifier: Apache-2.0
#include "analysis/runout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

#include "core/error.h"
#include "core/text.h"

namespace frana {
namespace {

std::size_t require_cell(const GridSpec& grid, Point place) {
    if (const auto cell = cell_at(grid, place)) return *cell;
    throw Error(ErrorKind::input, Problem{"a flow path ends outside the grid", "flow path",
                                          shortest_text(place.x) + ", " + shortest_text(place.y), "", ""});
}

/// Cost per metre through each cell: 1 / depth. Depths below a bound have the cost of the bound: with an infinite cost
/// no path would exist.
std::vector<float> costs_of(const Raster& depth) {
    constexpr double k_thinnest = 1e-6;  // [m]
    double least = std::numeric_limits<double>::infinity();
    for (const double value : depth.values)
        if (value > 0) least = std::min(least, std::max(value, k_thinnest));
    if (std::isinf(least)) least = 1;
    std::vector<float> costs(depth.values.size(), static_cast<float>(100 / least));
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (depth.values[i] > 0) costs[i] = static_cast<float>(1 / std::max(depth.values[i], k_thinnest));
    return costs;
}

/// Returns the neighbour from which each cell was reached, as a direction 0..7; 8: not reached.
std::vector<std::uint8_t> search(const GridSpec& grid, const std::vector<float>& costs, std::size_t from,
                                 std::size_t to, const int (&steps)[8][2]) {
    struct Entry {
        double cost;
        std::size_t cell;
        bool operator>(const Entry& other) const { return cost != other.cost ? cost > other.cost : cell > other.cell; }
    };
    std::vector<double> best;
    best.assign(costs.size(), std::numeric_limits<double>::infinity());
    std::vector<std::uint8_t> arrived_from(costs.size(), 8);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    best[from] = 0;
    open.push({0, from});
    while (!open.empty()) {
        const Entry now = open.top();
        open.pop();
        if (now.cell == to) break;
        if (now.cost > best[now.cell]) continue;
        const auto row = static_cast<std::int64_t>(now.cell) / grid.columns;
        const auto column = static_cast<std::int64_t>(now.cell) % grid.columns;
        for (std::uint8_t d = 0; d < 8; ++d) {
            const std::int64_t r = row + steps[d][0], c = column + steps[d][1];
            if (r < 0 || c < 0 || r >= grid.rows || c >= grid.columns) continue;
            const auto next = static_cast<std::size_t>(r * grid.columns + c);
            const double metres = std::hypot(steps[d][0], steps[d][1]);
            const double cost = now.cost + metres * 0.5 * (costs[now.cell] + costs[next]);
            if (cost >= best[next]) continue;
            best[next] = cost;
            arrived_from[next] = d;
            open.push({cost, next});
        }
    }
    return arrived_from;
}

double distance_to_segment(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
    const double t = squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Douglas and Peucker's line simplification, without recursion.
Polyline straightened(const Polyline& line, double tolerance) {
    std::vector<bool> keep(line.size(), false);
    keep.front() = keep.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, line.size() - 1}};
    while (!parts.empty()) {
        const auto [first, last] = parts.back();
        parts.pop_back();
        double farthest = tolerance;
        std::size_t where = 0;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double off = distance_to_segment(line[i], line[first], line[last]);
            if (off > farthest) {
                farthest = off;
                where = i;
            }
        }
        if (where == 0) continue;
        keep[where] = true;
        parts.emplace_back(first, where);
        parts.emplace_back(where, last);
    }
    Polyline result;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (keep[i]) result.push_back(line[i]);
    return result;
}

/// Returns the part of a raster that contains the flow and some places, to limit the cost on a large map. Empty if the
/// places are in flows that are far apart.
Raster around_flow(const Raster& depth, const std::vector<Point>& places) {
    const GridSpec& grid = depth.grid;
    std::int64_t top = grid.rows, left = grid.columns, bottom = -1, right = -1;
    const auto include = [&](std::int64_t row, std::int64_t column) {
        top = std::min(top, row);
        bottom = std::max(bottom, row);
        left = std::min(left, column);
        right = std::max(right, column);
    };
    depth.values.for_each_stored([&](std::size_t cell, double value) {
        const auto n = static_cast<std::int64_t>(cell);
        if (value > 0) include(n / grid.columns, n % grid.columns);
    });
    for (const Point& place : places) {
        const auto cell = static_cast<std::int64_t>(require_cell(grid, place));
        include(cell / grid.columns, cell % grid.columns);
    }
    const CellWindow box{top, left, bottom - top + 1, right - left + 1};
    if (box.rows * box.columns <= CellValues::k_most_dense) return part_of(depth, box);
    // Flows that are far apart: a path stays in one of them.
    for (const CellWindow& window : depth.values.stored_windows(grid.columns)) {
        const Bounds bounds = part_of(grid, window).bounds();
        if (std::all_of(places.begin(), places.end(), [&](Point p) { return bounds.contains(p.x, p.y); }))
            return part_of(depth, window);
    }
    return {};
}

}  // namespace

Polyline flow_path(const Raster& whole, Point from, Point to) {
    require_cell(whole.grid, from);
    require_cell(whole.grid, to);
    const Raster depth = around_flow(whole, {from, to});
    if (depth.values.empty()) return {from, to};
    constexpr int k_steps[8][2]{{-1, 0}, {0, -1}, {0, 1}, {1, 0}, {-1, -1}, {-1, 1}, {1, -1}, {1, 1}};
    const GridSpec& grid = depth.grid;
    const std::size_t start = require_cell(grid, from), end = require_cell(grid, to);
    if (start == end) return {from, to};
    const std::vector<std::uint8_t> arrived_from = search(grid, costs_of(depth), start, end, k_steps);
    Polyline line{to};
    for (std::size_t cell = end; cell != start;) {
        const auto row = static_cast<std::int64_t>(cell) / grid.columns - k_steps[arrived_from[cell]][0];
        const auto column = static_cast<std::int64_t>(cell) % grid.columns - k_steps[arrived_from[cell]][1];
        cell = static_cast<std::size_t>(row * grid.columns + column);
        if (cell != start) line.push_back(grid.cell_centre(row, column));
    }
    line.push_back(from);
    std::reverse(line.begin(), line.end());
    return straightened(line, grid.cell_size);
}

double length(const Polyline& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    return sum;
}

double beta_of(const Polyline& path, const Raster& bed, double top) {
    constexpr double k_gentle = 10 * std::numbers::pi / 180, k_ahead = 30;  // [m]
    const double whole = length(path), ahead = std::max(k_ahead, 3 * bed.grid.cell_size);
    if (!(whole > ahead)) return 0;
    const std::vector<Station> along = stations(path, bed.grid.cell_size);
    // A path that crosses a slope sideways is gentle where the ground is not.
    const auto is_steep = [&](Point a, Point b) {
        const double x = 0.5 * (a.x + b.x), y = 0.5 * (a.y + b.y), half = 0.5 * ahead;
        const double east = cell_value(bed, {x + half, y}) - cell_value(bed, {x - half, y}),
                     north = cell_value(bed, {x, y + half}) - cell_value(bed, {x, y - half});
        return std::hypot(east, north) > std::tan(k_gentle) * ahead;
    };
    std::size_t next = 0;
    for (const Station& station : along) {
        while (next < along.size() && along[next].distance < station.distance + ahead) ++next;
        if (next == along.size()) break;
        const double here = cell_value(bed, station.place), fall = here - cell_value(bed, along[next].place);
        if (station.distance > 0 && fall < std::tan(k_gentle) * (along[next].distance - station.distance) &&
            !is_steep(station.place, along[next].place))
            return std::atan2(top - here, station.distance) * 180 / std::numbers::pi;
    }
    return 0;
}

double path_coordinate(const Polyline& line, Point point) {
    double nearest = std::numeric_limits<double>::infinity(), coordinate = 0, travelled = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point a = line[i - 1], b = line[i];
        const double dx = b.x - a.x, dy = b.y - a.y, piece = std::hypot(dx, dy);
        if (piece == 0) continue;
        const double t = std::clamp(((point.x - a.x) * dx + (point.y - a.y) * dy) / (piece * piece), 0.0, 1.0);
        const double off = std::hypot(point.x - a.x - t * dx, point.y - a.y - t * dy);
        if (off < nearest) {
            nearest = off;
            coordinate = travelled + t * piece;
        }
        travelled += piece;
    }
    return coordinate;
}

double runout_along(const Polyline& path, const Raster& mask) {
    double farthest = 0;
    mask.values.for_each_stored([&](std::size_t cell, double value) {
        if (value == 0 || std::isnan(value)) return;
        const auto n = static_cast<std::int64_t>(cell);
        const Point centre = mask.grid.cell_centre(n / mask.grid.columns, n % mask.grid.columns);
        farthest = std::max(farthest, path_coordinate(path, centre));
    });
    return farthest;
}

std::vector<Station> stations(const Polyline& line, double spacing) {
    std::vector<Station> list;
    if (!line.empty()) list.push_back({0, line.front()});
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point a = line[i - 1], b = line[i];
        const double piece = std::hypot(b.x - a.x, b.y - a.y), before = list.back().distance;
        const auto count = static_cast<int>(std::ceil(piece / spacing));
        for (int k = 1; k <= count; ++k) {
            const double t = static_cast<double>(k) / count;
            list.push_back({before + t * piece, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}});
        }
    }
    return list;
}

double cell_value(const Raster& raster, Point place) {
    const auto cell = cell_at(raster.grid, place);
    return cell ? raster.values[*cell] : k_no_data;
}

std::vector<Runout> runouts_by_flow(const SeparateFlows& flows, const Raster& bed, const Raster& release,
                                    const Raster& trace) {
    const GridSpec& grid = bed.grid;
    if (!grid.same_cells(release.grid) || !grid.same_cells(trace.grid)) {
        throw Error(ErrorKind::input,
                    Problem{"bed, release and trace do not have the same cells", "run-out", "", "", ""});
    }
    std::vector<Runout> all(flows.count());
    std::vector<double> highest(flows.count(), k_no_data);
    const auto centre_of = [&](std::size_t cell) {
        const auto n = static_cast<std::int64_t>(cell);
        return grid.cell_centre(n / grid.columns, n % grid.columns);
    };
    const auto raise_top = [&](std::size_t flow, std::size_t cell, double thickness) {
        const double surface = bed.values[cell] + thickness;
        if (std::isnan(surface) || surface <= highest[flow]) return;
        highest[flow] = surface;
        all[flow].top = centre_of(cell);
    };
    const auto visit_flow = [&](std::size_t cell, const auto& visit) {
        if (const std::size_t flow = flows.flow_of(cell); flow < flows.count()) visit(flow, cell);
    };
    release.values.for_each_stored([&](std::size_t cell, double value) {
        if (!(value > 0)) return;
        visit_flow(cell, [&](std::size_t flow, std::size_t) { raise_top(flow, cell, value); });
    });
    const auto for_each_traced = [&](const auto& visit) {
        trace.values.for_each_stored([&](std::size_t cell, double touched) {
            if (touched != 0 && !std::isnan(touched)) visit_flow(cell, visit);
        });
    };
    std::vector<bool> released(flows.count());
    for (std::size_t flow = 0; flow < flows.count(); ++flow) released[flow] = !std::isnan(highest[flow]);
    for_each_traced([&](std::size_t flow, std::size_t cell) {
        if (!released[flow]) raise_top(flow, cell, 0);
    });

    std::vector<std::int64_t> cells(flows.count(), 0);
    for (Runout& one : all) one.tip = one.top;
    for_each_traced([&](std::size_t flow, std::size_t cell) {
        Runout& one = all[flow];
        ++cells[flow];
        if (std::isnan(bed.values[cell])) return;
        const Point centre = centre_of(cell);
        const double distance = std::hypot(centre.x - one.top.x, centre.y - one.top.y);
        if (distance <= one.horizontal_m) return;
        one.horizontal_m = distance;
        one.drop_m = highest[flow] - bed.values[cell];
        one.tip = centre;
    });
    for (std::size_t flow = 0; flow < flows.count(); ++flow) {
        Runout& one = all[flow];
        one.covered_area_m2 = static_cast<double>(cells[flow]) * grid.cell_area();
        one.reach_angle_deg = one.reach_angle(one.horizontal_m);
    }
    return all;
}

std::vector<Runout> runouts(const SeparateFlows& flows, const Raster& bed, const Raster& release, const Raster& trace) {
    std::vector<Runout> all = runouts_by_flow(flows, bed, release, trace);
    if (all.empty())
        throw Error(ErrorKind::input, Problem{"nothing is released and nothing flows", "run-out", "", "", ""});
    const auto is_traced = [](const Runout& one) { return one.covered_area_m2 > 0; };
    if (std::any_of(all.begin(), all.end(), is_traced))
        all.erase(std::remove_if(all.begin(), all.end(), std::not_fn(is_traced)), all.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Runout& a, const Runout& b) { return a.horizontal_m > b.horizontal_m; });
    return all;
}

}  // namespace frana
