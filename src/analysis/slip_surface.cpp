// SPDX-License-Identifier: Apache-2.0
#include "analysis/slip_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "core/geometry.h"

namespace frana {
namespace {

// The cells inside an outline, indexed in a raster with a margin of at least one cell.
struct Inside {
    std::vector<std::size_t> cells;
    double longest = 1;  // of the outline's extents [cells]
};

Inside cells_inside(const GridSpec& grid, const MultiPolygon& outline) {
    Inside inside;
    const Bounds box = bounds(outline);
    const auto clamped = [](double value, std::int64_t last) {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(value)), 0, last);
    };
    const std::int64_t row0 = clamped((grid.north - box.north) / grid.cell_size, grid.rows - 1),
                       row1 = clamped((grid.north - box.south) / grid.cell_size, grid.rows - 1),
                       column0 = clamped((box.west - grid.west) / grid.cell_size, grid.columns - 1),
                       column1 = clamped((box.east - grid.west) / grid.cell_size, grid.columns - 1);
    const InsideTest in_outline(outline);
    for (std::int64_t row = row0; row <= row1; ++row) {
        for (std::int64_t column = column0; column <= column1; ++column) {
            if (!in_outline(grid.cell_centre(row, column))) continue;
            if (row == 0 || column == 0 || row == grid.rows - 1 || column == grid.columns - 1)
                throw Error(ErrorKind::input,
                            Problem{"a slip surface cannot be fitted to a perimeter that touches the grid's edge",
                                    "release.perimeter", "", "", "Take a larger DTM"});
            inside.cells.push_back(static_cast<std::size_t>(row * grid.columns + column));
        }
    }
    inside.longest = static_cast<double>(std::max(row1 - row0, column1 - column0) + 1);
    return inside;
}

// Relaxes every cell inside to the mean of its four neighbours plus `rise`, by successive over-relaxation in a fixed
// order; cells outside are unchanged. Stops when no cell changes by more than 1e-12 of its side or of the first
// changes.
void relax(const Inside& inside, double rise, Raster& values) {
    const double omega = 2 / (1 + std::sin(std::numbers::pi / (inside.longest + 1)));
    const auto stride = static_cast<std::size_t>(values.grid.columns);
    const auto sweeps = static_cast<int>(100 + 40 * inside.longest);
    double first = 0;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double change = 0;
        for (const std::size_t c : inside.cells) {
            const double mean = 0.25 * (values.values[c - 1] + values.values[c + 1] + values.values[c - stride] +
                                        values.values[c + stride]);
            const double step = omega * (mean + rise - values.values[c]);
            values.values[c] += step;
            change = std::max(change, std::abs(step));
        }
        first = std::max(first, change);
        if (change <= 1e-12 * std::max(first, values.grid.cell_size)) return;
    }
}

double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}

Point minus(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}

// Distance from the centre relative to that of a ring in the same direction; for a star-shaped ring about the centre,
// whose vertices are in the order of their directions.
class RadiusFraction {
  public:
    RadiusFraction(const Ring& ring, Point centre) : ring_(ring), centre_(centre), turned_(ring.size()) {
        const Point first = minus(ring.front(), centre);
        sense_ = cross(first, minus(ring[1], centre)) > 0 ? 1 : -1;
        for (std::size_t i = 1; i < ring.size(); ++i) turned_[i] = turn_to(minus(ring[i], centre));
    }

    [[nodiscard]] double operator()(Point point) const {
        const Point d = minus(point, centre_);
        // Rounding may select the neighbouring edge.
        constexpr std::size_t k_beside = 2;
        const auto after =
            static_cast<std::size_t>(std::upper_bound(turned_.begin(), turned_.end(), turn_to(d)) - turned_.begin());
        const std::size_t n = ring_.size(), count = std::min(n, 2 * k_beside + 1);
        std::array<std::size_t, 2 * k_beside + 1> near{};
        for (std::size_t k = 0; k < count; ++k) near[k] = (after + n + k - k_beside) % n;
        // In the order of edges, whichever it begins with.
        const auto end = near.begin() + static_cast<std::ptrdiff_t>(count);
        std::rotate(near.begin(), std::min_element(near.begin(), end), end);
        for (std::size_t k = 0; k < count; ++k)
            if (const double fraction = across_edge(near[k], d)) return fraction;
        for (std::size_t i = 0; i < n; ++i)
            if (const double fraction = across_edge(i, d)) return fraction;
        return 0;  // the centre itself
    }

  private:
    // Returns the angle from the first vertex in the ring's direction, 0 to a full turn.
    [[nodiscard]] double turn_to(Point d) const {
        const Point first = minus(ring_.front(), centre_);
        const double turn = sense_ * std::atan2(cross(first, d), first.x * d.x + first.y * d.y);
        return turn < 0 ? turn + 2 * std::numbers::pi : turn;
    }

    // Returns the distance along a ray to the edge that ends at vertex i; 0: no intersection.
    [[nodiscard]] double across_edge(std::size_t i, Point d) const {
        const std::size_t j = i == 0 ? ring_.size() - 1 : i - 1;
        const Point a = minus(ring_[j], centre_), b = minus(ring_[i], centre_), edge = minus(b, a);
        const double across = cross(d, edge);
        if (across == 0) return 0;
        const double along = cross(a, edge) / across, place = cross(a, d) / across;  // along d, along the edge
        return along > 0 && place >= -1e-12 && place <= 1 + 1e-12 ? 1 / along : 0;
    }

    const Ring& ring_;
    Point centre_;
    double sense_ = 1;
    std::vector<double> turned_;  // 0 at the first vertex, increasing
};

}  // namespace

Point centroid(const MultiPolygon& outline) {
    Point sum;
    double total = 0;
    const auto add = [&](const Ring& ring, double sign) {
        if (ring.size() < 3) return;
        const Point o = ring.front();
        double twice = 0;
        Point moment;
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
            const Point a = minus(ring[i], o), b = minus(ring[i + 1], o);
            const double z = cross(a, b);
            twice += z;
            moment.x += z * (a.x + b.x) / 3;
            moment.y += z * (a.y + b.y) / 3;
        }
        if (twice == 0) return;
        const double area = sign * std::abs(twice);
        sum.x += area * (o.x + moment.x / twice);
        sum.y += area * (o.y + moment.y / twice);
        total += area;
    };
    for (const Polygon& polygon : outline) {
        add(polygon.outer, 1);
        for (const Ring& hole : polygon.holes) add(hole, -1);
    }
    return total > 0 ? Point{sum.x / total, sum.y / total} : sum;
}

bool visible_from_centroid(const MultiPolygon& outline) {
    if (outline.size() != 1 || !outline.front().holes.empty()) return false;
    const Ring& ring = outline.front().outer;
    const Point centre = centroid(outline);
    double side = 0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const double turn = cross(minus(ring[j], centre), minus(ring[i], centre));
        if (turn == 0 || turn * side < 0) return false;
        side = turn;
    }
    return true;
}

SlipSurface::SlipSurface(const Raster& ground, const MultiPolygon& perimeter)
    : above_membrane_(ground.grid),
      form_(ground.grid),
      shape_(visible_from_centroid(perimeter) ? SlipShape::ellipsoid : SlipShape::base_level) {
    const Inside inside = cells_inside(ground.grid, perimeter);
    if (inside.cells.empty()) {
        throw Error(ErrorKind::input, Problem{"a perimeter is too small for the cells to fit a slip surface to it",
                                              "release.perimeter", "", "", "Choose smaller cells"});
    }
    const auto stride = static_cast<std::size_t>(ground.grid.columns);
    for (const std::size_t c : inside.cells) {
        for (const std::size_t n : {c, c - 1, c + 1, c - stride, c + stride}) {
            if (!std::isnan(ground.values[n])) continue;
            throw Error(ErrorKind::input,
                        Problem{"the DTM has no elevation under or beside the release", "terrain.dtm", "", "",
                                "A slip surface is fitted to the ground along the perimeter: repair the DTM"});
        }
    }
    Raster membrane = ground;
    relax(inside, 0, membrane);
    for (const std::size_t c : inside.cells) above_membrane_.values[c] = ground.values[c] - membrane.values[c];
    if (shape_ == SlipShape::ellipsoid) {
        const RadiusFraction radius_fraction(perimeter.front().outer, centroid(perimeter));
        for (const std::size_t c : inside.cells) {
            const auto cell = static_cast<std::int64_t>(c);
            const Point p = ground.grid.cell_centre(cell / ground.grid.columns, cell % ground.grid.columns);
            const double r = radius_fraction(p);
            form_.values[c] = std::sqrt(std::max(0.0, 1 - r * r));
        }
    } else {
        relax(inside, 1, form_);
        double highest = 0;
        for (const std::size_t c : inside.cells) highest = std::max(highest, form_.values[c]);
        for (const std::size_t c : inside.cells) form_.values[c] /= highest;
    }
}

Raster SlipSurface::thickness(double depth) const {
    Raster result(form_.grid);
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = std::max(0.0, above_membrane_.values[i] + depth * form_.values[i]);
    return result;
}

double SlipSurface::volume(double depth) const {
    double sum = 0;
    for (std::size_t i = 0; i < form_.values.size(); ++i)
        sum += std::max(0.0, above_membrane_.values[i] + depth * form_.values[i]);
    return sum * form_.grid.cell_area();
}

double SlipSurface::depth_for(double wanted) const {
    double low = 0, high = 1;
    while (volume(high) < wanted && high < 1e6) high *= 2;
    while (high - low > 1e-9 * high) {
        const double middle = 0.5 * (low + high);
        (volume(middle) < wanted ? low : high) = middle;
    }
    return high;
}

}  // namespace frana
