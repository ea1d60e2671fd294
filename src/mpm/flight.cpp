// SPDX-License-Identifier: Apache-2.0
#include "mpm/flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mpm/curvature.h"
#include "mpm/node_grid.h"
#include "mpm/nodes_to_particles.h"
#include "mpm/particle_update.h"
#include "mpm/shape.h"

namespace frana {
namespace {

// Interval at which a path over the bed is sampled [cells]; bisection finds an end of a free fall to 1e-9 of it.
constexpr double k_sampling = 0.25;
constexpr int k_halvings = 30;

// Room for rounding in the bounds below.
constexpr double k_rounding = 1e-9;

// Least factor of an area in one flight.
constexpr double k_least_stretch = 0.5;

using Spline = Stencil<QuadraticSplineShape>;

// The bed of the quadratic splines.
struct Bed {
    Interpolated z;
    BedCurvature curvature;

    [[nodiscard]] Point map_velocity(Point along) const noexcept {
        return BedFrame::of({z.dx, z.dy}).in_map(along.x, along.y);
    }
    [[nodiscard]] bool throws(Point v, double gravity) const noexcept { return curvature.load(v.x, v.y) < -gravity; }
};

Interpolated ground_at(const NodeGrid& nodes, Point p) noexcept {
    nodes.cover_round(p);
    return interpolate(Spline(p.x, p.y, nodes.scale()), nodes.bed.data(), nodes.stride());
}

Bed bed_at(const NodeGrid& nodes, Point p) noexcept {
    nodes.cover_round(p);
    const NodeScale grid = nodes.scale();
    const Spline s(p.x, p.y, grid);
    const double inverse_dx2 = grid.inverse_dx * grid.inverse_dx,
                 bend[3] = {inverse_dx2, -2 * inverse_dx2, inverse_dx2};
    Bed bed{interpolate(s, nodes.bed.data(), nodes.stride()), {}};
    for (int b = 0; b < 3; ++b) {
        for (int a = 0; a < 3; ++a) {
            const double z = nodes.bed[s.first + static_cast<std::size_t>(b * nodes.stride() + a)];
            bed.curvature.xx += s.wy[b] * bend[a] * z;
            bed.curvature.xy += s.gy[b] * s.gx[a] * z;
            bed.curvature.yy += bend[b] * s.wx[a] * z;
        }
    }
    return bed;
}

struct Interval {
    double least, greatest;
};
inline Interval operator+(Interval a, Interval b) noexcept {
    return {a.least + b.least, a.greatest + b.greatest};
}
inline Interval operator-(Interval a) noexcept {
    return {-a.greatest, -a.least};
}
inline Interval operator*(Interval a, Interval b) noexcept {
    const double p = a.least * b.least, q = a.least * b.greatest, r = a.greatest * b.least, s = a.greatest * b.greatest;
    return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}
inline Interval square(Interval a) noexcept {
    const double x = a.least * a.least, y = a.greatest * a.greatest;
    return {a.least < 0 && a.greatest > 0 ? 0 : std::min(x, y), std::max(x, y)};
}
inline Interval root(Interval a) noexcept {
    return {std::sqrt(std::max(0.0, a.least)), std::sqrt(std::max(0.0, a.greatest))};
}
inline Interval operator*(double factor, Interval a) noexcept {
    return Interval{factor, factor} * a;
}
inline Interval hull(Interval a, Interval b) noexcept {
    return {std::min(a.least, b.least), std::max(a.greatest, b.greatest)};
}
struct Box {
    Interval x, y;  // local metres
};
inline Box box_of(Point a, Point b) noexcept {
    return {{std::min(a.x, b.x), std::max(a.x, b.x)}, {std::min(a.y, b.y), std::max(a.y, b.y)}};
}

// Returns bounds of the slope in direction `along` of the splines' bed in a part of a node's cell. The slope is linear
// along and quadratic across: it lies in the hull of its control values (Bernstein form; Farin 2002, Curves and
// Surfaces for CAGD, chapter 5).
// @param z of the node  @param along, across steps to the next node  @param u, v the part, from the node [cells]
inline Interval slope_in(const double* z, std::ptrdiff_t along, std::ptrdiff_t across, Interval u,
                         Interval v) noexcept {
    Interval slope[3];  // of a row, where the part begins and ends
    for (int b = 0; b < 3; ++b) {
        const double* const row = z + (b - 1) * across;
        const double before = row[0] - row[-along], bend = row[along] - row[0] - before;
        slope[b] = {before + (0.5 + u.least) * bend, before + (0.5 + u.greatest) * bend};
    }
    const auto control = [&](double p, double q) {
        const double south = 0.5 * (0.5 - p) * (0.5 - q), middle = 0.75 - p * q, north = 0.5 * (0.5 + p) * (0.5 + q);
        const double x = south * slope[0].least + middle * slope[1].least + north * slope[2].least;
        const double y = south * slope[0].greatest + middle * slope[1].greatest + north * slope[2].greatest;
        return Interval{std::min(x, y), std::max(x, y)};
    };
    return hull(hull(control(v.least, v.least), control(v.least, v.greatest)), control(v.greatest, v.greatest));
}

// The cells that a box touches, by padded numbers; none where a node round them does not exist.
struct Cells {
    std::int64_t i0, i1, j0, j1;
};
std::optional<Cells> cells_of(const NodeGrid& nodes, const Box& box) noexcept {
    const NodeScale grid = nodes.scale();
    const auto number = [&](double at, std::int64_t origin) {
        return static_cast<std::int64_t>(std::floor(at * grid.inverse_dx)) + origin;
    };
    const Cells c{number(box.x.least, grid.origin_x), number(box.x.greatest, grid.origin_x),
                  number(box.y.least, grid.origin_y), number(box.y.greatest, grid.origin_y)};
    if (c.i0 < 1 || c.j0 < 1 || c.i1 >= nodes.stride() - 1 || c.j1 >= nodes.padded_rows() - 1) return std::nullopt;
    nodes.cover({c.i0 - 1, c.i1 + 2, c.j0 - 1, c.j1 + 2});
    return c;
}

// Returns bounds of the gradient of the splines' bed in these cells: it is a mean of the differences between
// neighbours.
Box slopes_in(const NodeGrid& nodes, const Cells& cells) noexcept {
    const std::int64_t stride = nodes.stride();
    constexpr double k_none = std::numeric_limits<double>::infinity();
    Interval x{k_none, -k_none}, y = x;
    for (std::int64_t j = cells.j0 - 1; j <= cells.j1 + 1; ++j) {
        const double* const z = nodes.bed.data() + j * stride;
        for (std::int64_t i = cells.i0; i <= cells.i1 + 1; ++i) x = hull(x, {z[i] - z[i - 1], z[i] - z[i - 1]});
        if (j < cells.j0) continue;
        for (std::int64_t i = cells.i0 - 1; i <= cells.i1 + 1; ++i)
            y = hull(y, {z[i] - z[i - stride], z[i] - z[i - stride]});
    }
    const double inverse_dx = 1 / nodes.cell_size();
    return {inverse_dx * x, inverse_dx * y};
}

// Calls visit(x, y) with bounds of the gradient in every cell that a box touches, of the part inside the box.
template <class Visit>
void for_each_slope(const NodeGrid& nodes, const Box& box, const Cells& cells, const Visit& visit) noexcept {
    const NodeScale grid = nodes.scale();
    const Interval x = grid.inverse_dx * box.x, y = grid.inverse_dx * box.y;
    const auto part = [](Interval range, std::int64_t cell) {
        const auto from = static_cast<double>(cell);
        return Interval{std::max(range.least - from, 0.0) - 0.5, std::min(range.greatest - from, 1.0) - 0.5};
    };
    for (std::int64_t j = cells.j0; j <= cells.j1; ++j) {
        const Interval v = part(y, j - grid.origin_y);
        for (std::int64_t i = cells.i0; i <= cells.i1; ++i) {
            const double* const z = nodes.bed.data() + j * nodes.stride() + i;
            const Interval u = part(x, i - grid.origin_x);
            visit(grid.inverse_dx * slope_in(z, 1, nodes.stride(), u, v),
                  grid.inverse_dx * slope_in(z, nodes.stride(), 1, v, u));
        }
    }
}

Point at(Point from, Point velocity, double time) noexcept {
    return {from.x + velocity.x * time, from.y + velocity.y * time};
}

// Returns the velocity after landing, without its component normal to the bed.
Point landed_velocity(const NodeGrid& nodes, Point place, Point velocity, double climb) {
    const Interpolated z = ground_at(nodes, place);
    const double into = (climb - velocity.x * z.dx - velocity.y * z.dy) / (1 + z.dx * z.dx + z.dy * z.dy);
    return BedFrame::of({z.dx, z.dy}).along_bed(velocity.x + into * z.dx, velocity.y + into * z.dy);
}

// Computes the free fall from jump.from until it lands. Returns the steepest fall of the edge in its direction.
double fall(const NodeGrid& nodes, const JumpRules& rules, Jump& jump) {
    const NodeScale grid = nodes.scale();
    const double search_distance = k_sampling * grid.dx, start = ground_at(nodes, jump.from).value;
    const auto height = [&](double time) { return start + (jump.climb - 0.5 * rules.gravity * time) * time; };
    Point place = jump.from, velocity = jump.velocity;
    double time = 0, steepest = 0;
    for (bool flies = true; flies;) {
        const double speed = std::hypot(velocity.x, velocity.y);
        const bool at_edge = speed * time < k_edge_width * grid.dx;
        if (!at_edge && steepest < rules.edge) return steepest;  // no edge: the rest does not matter
        const double climb = jump.climb - rules.gravity * time;
        const double dt =
            search_distance / std::max({speed, std::abs(climb), std::sqrt(rules.gravity * search_distance)});
        Point next = at(place, velocity, dt);
        const bool outside = !nodes.bounds().contains(next.x, next.y);
        const bool leaves = outside && !rules.wall;
        if (leaves || (!outside && nodes.is_gap(grid.node_of(next.x, next.y)))) {
            jump.left = leaves;
            jump.to = leaves ? place : next;
            jump.duration = time + dt;
            break;
        }
        if (outside || nodes.is_wall(grid.node_of(next.x, next.y))) {
            velocity = {0, 0};
            next = place;
        }
        double ahead = dt;
        const Interpolated ground = ground_at(nodes, next);
        if (at_edge && (velocity.x != 0 || velocity.y != 0))
            steepest = std::max(steepest, -(velocity.x * ground.dx + velocity.y * ground.dy) / speed);
        if (height(time + dt) <= ground.value) {
            double above = 0;
            for (int i = 0; i < k_halvings; ++i) {
                const double middle = 0.5 * (above + ahead);
                (height(time + middle) > ground_at(nodes, at(place, velocity, middle)).value ? above : ahead) = middle;
            }
            next = at(place, velocity, ahead);
            flies = false;
        }
        place = next;
        time += ahead;
        const double above = flies ? height(time) - ground.value : 0;
        jump.height = std::max(jump.height, above);
        jump.over.push_back({grid.node_of(place.x, place.y), above});
        jump.to = place;
        jump.duration = time;
    }
    jump.landed = landed_velocity(nodes, jump.to, velocity, jump.climb - rules.gravity * jump.duration);
    return steepest;
}

// Bounds of a velocity in map view [m/s] that is `along` along the bed, and of its direction.
struct Velocity {
    Box map, direction;
};
inline Velocity velocity_on(const Box& slope, Point along) noexcept {
    const Interval steep = square(slope.x) + square(slope.y), length = root({1 + steep.least, 1 + steep.greatest});
    const Interval climb = along.x * slope.x + along.y * slope.y;
    const Interval share =
        climb * Interval{1 / (length.greatest * (length.greatest + 1)), 1 / (length.least * (length.least + 1))};
    // |u|^2 = |w|^2 - (u . grad Z)^2, with u . grad Z = (w . grad Z) / root.
    const double speed2 = along.x * along.x + along.y * along.y;
    const Interval upwards = square(climb * Interval{1 / length.greatest, 1 / length.least});
    const Interval speed = root(
        {std::max(speed2 - upwards.greatest, speed2 / (length.greatest * length.greatest)), speed2 - upwards.least});
    const auto within = [](double most, Interval a) {
        return Interval{std::max(-most, a.least), std::min(most, a.greatest)};
    };
    const Interval u = within(speed.greatest, Interval{along.x, along.x} + -(share * slope.x));
    const Interval v = within(speed.greatest, Interval{along.y, along.y} + -(share * slope.y));
    const Interval by_speed{1 / speed.greatest, 1 / speed.least};
    return {{u, v}, {within(1, u * by_speed), within(1, v * by_speed)}};
}

// steepest_fall_ahead for a particle that starts anywhere in a box. By intervals: the place of take-off and the
// direction, which follows from the slope there (BedFrame::in_map), are known within bounds only.
double steepest_fall(const NodeGrid& nodes, const Box& box, Point along, double reach) noexcept {
    constexpr double k_unknown = std::numeric_limits<double>::infinity();
    const double speed = std::hypot(along.x, along.y), dx = nodes.cell_size();
    if (!(speed > 0)) return k_unknown;
    const auto after = [&](const Interval& time, const Box& v) { return Box{box.x + time * v.x, box.y + time * v.y}; };
    Box from = box;
    if (reach > 0) {  // |u| is at most |w|; its direction on the slopes within that bounds the path better
        const Interval any{-speed, speed}, time{0, reach};
        const auto round = cells_of(nodes, after(time, {any, any}));
        if (!round) return k_unknown;
        from = after(time, velocity_on(slopes_in(nodes, *round), along).map);
    }
    const auto start = cells_of(nodes, from);
    if (!start) return k_unknown;
    std::optional<Box> slope;
    for_each_slope(nodes, from, *start, [&](Interval x, Interval y) {
        slope = slope ? Box{hull(slope->x, x), hull(slope->y, y)} : Box{x, y};
    });
    const Box way = velocity_on(*slope, along).direction;
    const Interval length{-k_rounding * dx, (k_edge_width + k_sampling + k_rounding) * dx};
    const Box to{from.x + length * way.x, from.y + length * way.y};
    const auto ahead = cells_of(nodes, to);
    if (!ahead) return k_unknown;
    double fall = 0;
    for_each_slope(nodes, to, *ahead, [&](Interval x, Interval y) {
        const double any_direction = root(square(x) + square(y)).greatest;
        fall = std::max(fall, std::min(any_direction, -(x * way.x + y * way.y).least));
    });
    return fall;
}

// Whether a jump may be found at all: one search in thousands finds one, even on steep ground.
bool may_jump(const NodeGrid& nodes, const JumpRules& rules, const Box& from, Point along, double reach) noexcept {
    return !(steepest_fall(nodes, from, along, reach) < rules.edge * (1 - k_rounding));
}

}  // namespace

double steepest_fall_ahead(const NodeGrid& nodes, Point place, Point along, double reach) noexcept {
    return steepest_fall(nodes, box_of(place, place), along, reach);
}

std::optional<Jump> find_jump(const NodeGrid& nodes, const JumpRules& rules, Point place, Point along, double reach,
                              double clearance) {
    if (along.x == 0 && along.y == 0) return std::nullopt;
    const double search_distance = k_sampling * nodes.cell_size();
    double time = 0, before = 0;
    Point last = place, way{};
    if (!may_jump(nodes, rules, box_of(place, place), along, reach)) return std::nullopt;
    while (nodes.bounds().contains(place.x, place.y)) {
        Bed bed = bed_at(nodes, place);
        Point velocity = bed.map_velocity(along);
        if (bed.throws(velocity, rules.gravity) && may_jump(nodes, rules, box_of(last, place), along, 0)) {
            // The place where the fall begins, between the previous sample and this one.
            double supported = 0, thrown = time - before;
            for (int i = 0; i < k_halvings && thrown > supported; ++i) {
                const double middle = 0.5 * (supported + thrown);
                const Bed there = bed_at(nodes, at(last, way, middle));
                (there.throws(there.map_velocity(along), rules.gravity) ? thrown : supported) = middle;
            }
            Jump jump;
            jump.from = at(last, way, thrown);
            jump.glide = before + thrown;
            bed = bed_at(nodes, jump.from);
            jump.velocity = bed.map_velocity(along);
            jump.climb = jump.velocity.x * bed.z.dx + jump.velocity.y * bed.z.dy;
            const double steepest = fall(nodes, rules, jump);
            if (jump.height > clearance && steepest >= rules.edge) return jump;
        }
        const double speed = std::hypot(velocity.x, velocity.y);
        if (!(time < reach) || !(speed > 0)) return std::nullopt;
        before = time;
        last = place;
        way = velocity;
        time = std::min(reach, time + search_distance / speed);
        place = at(place, velocity, time - before);
    }
    return std::nullopt;
}

double Flights::volume() const noexcept {
    double sum = 0;
    for (const Flight& f : flights_) sum += get(f.particle, Field::volume);
    return sum;
}

double Flights::Flight::squared_speed(double time, double gravity) const noexcept {
    const double upwards = climb - gravity * std::max(0.0, time - begins);
    return speed * speed + upwards * upwards;
}

double Flights::kinetic(double time, double gravity) const noexcept {
    double sum = 0;
    for (const Flight& f : flights_) sum += 0.5 * get(f.particle, Field::volume) * f.squared_speed(time, gravity);
    return sum;
}

double Flights::momentum(double time, double gravity) const noexcept {
    double sum = 0;
    for (const Flight& f : flights_) sum += get(f.particle, Field::volume) * std::sqrt(f.squared_speed(time, gravity));
    return sum;
}

namespace {

// During flight neighbours diverge or converge by the difference of their velocities at take-off: x -> x + T v(x),
// whose gradient is F = I + T C. The area changes by det F, the shape becomes F Q F^T; both are bounded to what
// splitting and the area relaxation can restore.
void stretch(ParticleRow& row, double time, double cell_area) {
    const double xx = 1 + time * get(row, Field::c_xx), xy = time * get(row, Field::c_xy);
    const double yx = time * get(row, Field::c_yx), yy = 1 + time * get(row, Field::c_yy);
    const double area = get(row, Field::area);
    const double most = std::max(1.0, k_largest_claim * cell_area / area);
    get(row, Field::area) = area * std::clamp(xx * yy - xy * yx, k_least_stretch, most);
    const auto q =
        deformed<double>({get(row, Field::q_xx), get(row, Field::q_xy), get(row, Field::q_yy)}, xx, xy, yx, yy);
    const double fit = std::min(1.0, k_largest_claim * cell_area / (q.xx + q.yy));
    get(row, Field::q_xx) = fit * q.xx;
    get(row, Field::q_xy) = fit * q.xy;
    get(row, Field::q_yy) = fit * q.yy;
}

}  // namespace

void Flights::begin(const ParticleRow& particle, const Jump& jump, double time, double cell_area) {
    Flight flight;
    flight.particle = particle;
    flight.begins = time + jump.glide;
    flight.ends = flight.begins + jump.duration;
    flight.climb = jump.climb;
    flight.speed = std::hypot(jump.velocity.x, jump.velocity.y);
    flight.left = jump.left;
    ParticleRow& row = flight.particle;
    get(row, Field::x) = jump.to.x;
    get(row, Field::y) = jump.to.y;
    get(row, Field::u) = jump.landed.x;
    get(row, Field::v) = jump.landed.y;
    stretch(row, jump.duration, cell_area);
    for (const Field c : {Field::c_xx, Field::c_xy, Field::c_yx, Field::c_yy}) get(row, c) = 0;
    next_landing_ = std::min(next_landing_, flight.ends);
    flights_.push_back(flight);

    statistics_.volume += get(row, Field::volume);
    statistics_.highest = std::max(statistics_.highest, jump.height);
    const double length = std::hypot(jump.to.x - jump.from.x, jump.to.y - jump.from.y);
    statistics_.way += get(row, Field::volume) * length;
    if (length > statistics_.longest) {
        statistics_.longest = length;
        statistics_.from = jump.from;
        statistics_.to = jump.to;
    }
    for (const Jump::Place& place : jump.over)
        heights_[place.node] = std::max(heights_[place.node], static_cast<float>(place.height));
}

namespace {

// Marks the nodes of a tile within k_near cells of which the splines' bed may be as steep as an edge; returns whether
// there are any.
bool mark_near_edges(const NodeRange& range, const NodeGrid& nodes, double edge, std::uint8_t* marks) {
    // A particle's displacement in a step (less than a cell) and the width of an edge with the last sample.
    constexpr std::int64_t k_near = static_cast<std::int64_t>(k_edge_width + k_sampling) + 2,
                           k_side = k_tile + 2 * k_near;
    const std::int64_t west = range.i0 - k_near, south = range.j0 - k_near, stride = nodes.stride();
    const double steep = edge * nodes.cell_size() * (1 - k_rounding);
    constexpr Interval k_cell{-0.5, 0.5};
    std::array<std::uint8_t, k_side * k_side> edges{};
    for (std::int64_t j = std::max<std::int64_t>(south, 1); j < std::min(range.j1 + k_near, nodes.padded_rows() - 1);
         ++j) {
        for (std::int64_t i = std::max<std::int64_t>(west, 1); i < std::min(range.i1 + k_near, stride - 1); ++i) {
            const double* const z = nodes.bed.data() + j * stride + i;
            const Interval x = slope_in(z, 1, stride, k_cell, k_cell), y = slope_in(z, stride, 1, k_cell, k_cell);
            edges[static_cast<std::size_t>((j - south) * k_side + i - west)] =
                root(square(x) + square(y)).greatest >= steep ? 1 : 0;
        }
    }
    const bool possible = std::find(edges.begin(), edges.end(), 1) != edges.end();
    range.for_each(stride, [&](std::size_t n, std::int64_t i, std::int64_t j) {
        marks[n] = 0;
        for (std::int64_t b = j - south - k_near; possible && b <= j - south + k_near; ++b)
            for (std::int64_t a = i - west - k_near; a <= i - west + k_near; ++a)
                marks[n] |= edges[static_cast<std::size_t>(b * k_side + a)];
    });
    return possible;
}

}  // namespace

// The result is cached while the bed equals the terrain.
bool Flights::has_edge(std::int64_t tile, const TileGrid& tiles, const NodeGrid& nodes, double edge) {
    std::uint8_t& known = edges_[static_cast<std::size_t>(tile)];
    if (known == k_unknown || nodes.bed_changes)
        known = mark_near_edges(NodeRange(tile, tiles, nodes), nodes, edge, near_edge_.data()) ? k_edge : k_none;
    return known == k_edge;
}

void Flights::take_off(const ParticleSet& particles, const TileOrder& order, const NodeGrid& nodes,
                       const JumpRules& rules, double time, double reach, std::vector<std::uint8_t>& keep,
                       ThreadPool& pool) {
    const auto& tiles = order.tiles();
    const double *x = particles[Field::x], *y = particles[Field::y], *u = particles[Field::u], *v = particles[Field::v];
    const double *volume = particles[Field::volume], *area = particles[Field::area];
    edges_.resize(static_cast<std::size_t>(order.grid().tiles_x() * order.grid().tiles_y()), k_unknown);
    std::vector<std::size_t> steep;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        bool any = false;
        for (std::int64_t b = tiles[t].y0; b <= tiles[t].y1; ++b)
            for (std::int64_t a = tiles[t].x0; a <= tiles[t].x1; ++a)
                any = has_edge(b * order.grid().tiles_x() + a, order.grid(), nodes, rules.edge) || any;
        if (any) steep.push_back(t);
    }
    const NodeScale grid = nodes.scale();
    std::vector<std::vector<std::pair<std::size_t, Jump>>> found(steep.size());
    pool.for_each(steep.size(), [&](std::size_t t) {
        const ParticleTile& tile = tiles[steep[t]];
        for (std::size_t p = tile.begin; p < tile.end; ++p) {
            if (near_edge_[grid.node_of(x[p], y[p])] == 0) continue;
            const double clearance = std::max(volume[p] / area[p], k_least_clearance * nodes.cell_size());
            if (auto jump = find_jump(nodes, rules, {x[p], y[p]}, {u[p], v[p]}, reach, clearance))
                found[t].emplace_back(p, std::move(*jump));
        }
    });
    for (const auto& jumps : found) {  // in the particles' order, independent of threads
        for (const auto& [p, jump] : jumps) {
            if (keep.empty()) keep.assign(particles.size(), 1);
            keep[p] = 0;
            begin(particles.row(p), jump, time, nodes.cell_size() * nodes.cell_size());
        }
    }
}

Flights::Landed Flights::land(double time, ParticleSet& particles) {
    Landed landed;
    if (time < next_landing_) return landed;
    next_landing_ = std::numeric_limits<double>::infinity();
    std::vector<Flight> still;
    for (const Flight& f : flights_) {
        if (time < f.ends) {
            next_landing_ = std::min(next_landing_, f.ends);
            still.push_back(f);
        } else if (f.left) {
            landed.left += get(f.particle, Field::volume);
        } else {
            particles.push_back(f.particle);
            ++landed.count;
        }
    }
    flights_.swap(still);
    return landed;
}

}  // namespace frana
