// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/simple_outline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace frana::gis {
namespace {

/// Thrown without a verdict: edges touch, or rounding hides whether they do.
struct Doubt {};

/// West before east, south before north: the order of points in the sweep.
bool earlier(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Returns the side of a point from the line a to b: +1 left, -1 right; 0 if rounding hides it.
int side(Point a, Point b, Point p) {
    const double left = (b.x - a.x) * (p.y - a.y), right = (b.y - a.y) * (p.x - a.x);
    const double turn = left - right;
    // Five differences and two products, each with a relative rounding error of 1.1e-16.
    const double rounding = 1e-15 * (std::abs(left) + std::abs(right));
    if (!(std::abs(turn) > rounding)) return 0;
    return turn > 0 ? 1 : -1;
}

int certain(int known_side) {
    if (known_side == 0) throw Doubt{};
    return known_side;
}

struct Edge {
    Point first, last;  // in the order of the sweep
};

bool same(Point a, Point b) {
    return a.x == b.x && a.y == b.y;
}

/// Returns which of two edges on the sweep line is further south; they meet at most in an end.
bool further_south(const Edge& a, const Edge& b) {
    if (same(a.first, b.first)) return certain(side(a.first, a.last, b.last)) > 0;
    if (earlier(a.first, b.first)) return certain(side(a.first, a.last, b.first)) > 0;
    return certain(side(b.first, b.last, a.first)) < 0;
}

Point meeting(const Edge& a, const Edge& b) {
    const Point d{a.last.x - a.first.x, a.last.y - a.first.y}, e{b.last.x - b.first.x, b.last.y - b.first.y};
    const double t = ((b.first.x - a.first.x) * e.y - (b.first.y - a.first.y) * e.x) / (d.x * e.y - d.y * e.x);
    return {a.first.x + t * d.x, a.first.y + t * d.y};
}

class Sweep {
  public:
    explicit Sweep(const Polygon& polygon) : status_(South{this}) {
        add(polygon.outer);
        for (const Ring& hole : polygon.holes) add(hole);
        places_.resize(edges_.size(), status_.end());
        std::vector<std::size_t> order(vertices_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return earlier(vertices_[a].place, vertices_[b].place); });
        for (std::size_t k = 0; k < order.size() && !crossing; ++k) {
            const Vertex& vertex = vertices_[order[k]];
            if (k > 0 && same(vertex.place, vertices_[order[k - 1]].place)) throw Doubt{};  // rings touch
            for (const std::size_t e : {vertex.before, vertex.after})
                if (same(edges_[e].last, vertex.place)) leave(e);
            for (const std::size_t e : {vertex.before, vertex.after})
                if (same(edges_[e].first, vertex.place)) enter(e);
        }
    }

    std::optional<Point> crossing;

  private:
    struct South {
        const Sweep* sweep;
        bool operator()(std::size_t a, std::size_t b) const {
            return a != b && further_south(sweep->edges_[a], sweep->edges_[b]);
        }
    };
    using Status = std::set<std::size_t, South>;
    struct Vertex {
        Point place;
        std::size_t before, after;  // its edges
    };

    void add(const Ring& ring) {
        const std::size_t first = edges_.size(), n = ring.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Point a = ring[i], b = ring[(i + 1) % n];
            edges_.push_back(earlier(a, b) ? Edge{a, b} : Edge{b, a});
            vertices_.push_back({a, first + (i + n - 1) % n, first + i});
        }
    }

    void enter(std::size_t e) {
        const auto at = status_.insert(e).first;
        places_[e] = at;
        if (at != status_.begin()) compare(*std::prev(at), e);
        if (std::next(at) != status_.end()) compare(e, *std::next(at));
    }

    void leave(std::size_t e) {
        const auto at = places_[e], next = std::next(at);
        if (at != status_.begin() && next != status_.end()) compare(*std::prev(at), *next);
        status_.erase(at);
    }

    void compare(std::size_t one, std::size_t other) {
        const Edge &a = edges_[one], &b = edges_[other];
        if (same(a.first, b.first) || same(a.last, b.last) || same(a.first, b.last) || same(a.last, b.first)) {
            // Neighbours along the ring meet only in their vertex unless one lies on the other: collinear, and both on
            // the same side of it.
            if (same(a.first, b.first)) (void)certain(side(a.first, a.last, b.last));
            if (same(a.last, b.last)) (void)certain(side(a.last, a.first, b.first));
            return;
        }
        // Apart if both ends of either are on one side of the other.
        const int b_first = side(a.first, a.last, b.first), b_last = side(a.first, a.last, b.last);
        if (b_first * b_last > 0) return;
        const int a_first = side(b.first, b.last, a.first), a_last = side(b.first, b.last, a.last);
        if (a_first * a_last > 0) return;
        (void)certain(a_first * a_last * b_first * b_last);
        crossing = meeting(a, b);
    }

    std::vector<Edge> edges_;
    std::vector<Vertex> vertices_;
    Status status_;  // along the sweep line, from the south
    std::vector<Status::iterator> places_;
};

/// For rings that do not meet: whether each hole is inside the outline and in no other hole.
bool nested_once(const Polygon& polygon) {
    for (const Ring& hole : polygon.holes) {
        if (!contains(polygon.outer, hole.front())) return false;
        for (const Ring& other : polygon.holes)
            if (&other != &hole && contains(other, hole.front())) return false;
    }
    return true;
}

}  // namespace

OutlineVerdict sweep(const Polygon& polygon) {
    constexpr std::size_t k_most_holes = 100;  // each is tested against all others
    if (polygon.holes.size() > k_most_holes) return {};
    try {
        const Sweep swept(polygon);
        if (swept.crossing) return {false, swept.crossing};
        return {nested_once(polygon), std::nullopt};
    } catch (const Doubt&) {
        return {};
    }
}

}  // namespace frana::gis
