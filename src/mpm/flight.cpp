// SPDX-License-Identifier: Apache-2.0
#include "mpm/flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/lanes.h"
#include "mpm/curvature.h"
#include "mpm/ground_walls.h"
#include "mpm/node_grid.h"
#include "mpm/nodes_to_particles.h"
#include "mpm/particle_update.h"
#include "mpm/shape.h"

namespace frana {
namespace {

// Interval at which a path over the bed and one through the air are sampled [cells]: the bed throws over a cell or
// more. Bisection finds an end of a free fall to 1e-9 of it.
constexpr double k_way_sampling = 0.5, k_sampling = 0.25;
constexpr int k_halvings = 30;

// Reach of a particle in a step, from anywhere in its node's cell [cells].
constexpr std::int64_t k_reach = 2;

// How much more than that of edges_at, and than falls_away from the last sample of the way, the mean angle from the
// place where the fall begins may be [rad].
constexpr double k_edge_margin = 5 * std::numbers::pi / 180, k_sample_margin = 10 * std::numbers::pi / 180;

// A part of a particle that flies is at least this fraction of it: less stays on the ground.
constexpr double k_least_part = 0.05;

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

// Inlined: the search for jumps calls it more often than anything else, and returned values go through memory.
[[gnu::always_inline]] inline Bed bed_at(const NodeGrid& nodes, Point p) noexcept {
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

Point at(Point from, Point velocity, double time) noexcept {
    return {from.x + velocity.x * time, from.y + velocity.y * time};
}

// Motion in the air, under gravity and a drag |v| v: by the velocity of the middle of a step, which is exact without
// drag. That velocity is implicit in the drag, so that a step of any length leaves the motion its direction.
struct Fall {
    double gravity, drag;  // [m/s2], [1/m]
    AirSpeed speed;
    double along = 0, up = 0;  // way in the map and height since the beginning [m]

    struct Acceleration {
        double along, up;
    };
    [[nodiscard]] Acceleration acceleration(double dt) const noexcept {
        if (drag == 0) return {0, -gravity};
        const double half = 0.5 * dt, held = 1 / (1 + half * drag * std::sqrt(speed.squared()));
        const AirSpeed middle{held * speed.along, held * (speed.up - half * gravity)};
        const double by_drag = drag * std::sqrt(middle.squared());
        return {-by_drag * middle.along, -gravity - by_drag * middle.up};
    }
    // Length of a step over which nothing changes by much more than the bed does over a sample [s].
    [[nodiscard]] double step(double distance) const noexcept {
        const double fastest = std::max({speed.along, std::abs(speed.up), std::sqrt(gravity * distance)});
        return std::min(distance, drag > 0 ? 1 / drag : distance) / fastest;
    }
    // The state `time` into a step over which the acceleration is `a`.
    [[nodiscard]] Fall after(double time, Acceleration a) const noexcept {
        Fall next = *this;
        next.speed = {speed.along + time * a.along, speed.up + time * a.up};
        next.along += 0.5 * time * (speed.along + next.speed.along);
        next.up += 0.5 * time * (speed.up + next.speed.up);
        return next;
    }
};

// Returns the velocity along the bed after landing. What is normal to the bed is lost, and by friction at the bed mu
// times as much of what is along it, at most all (Coulomb's friction in an impact: Stronge 2000, Impact Mechanics,
// chapter 3; a bend of the bed that turns the flow by a small angle takes as much).
Point landed_velocity(const NodeGrid& nodes, const JumpRules& rules, Point place, Point velocity, double climb) {
    const Interpolated z = ground_at(nodes, place);
    const double n = 1 + z.dx * z.dx + z.dy * z.dy;
    const double into = (climb - velocity.x * z.dx - velocity.y * z.dy) / n;
    const Point along = BedFrame::of({z.dx, z.dy}).along_bed(velocity.x + into * z.dx, velocity.y + into * z.dy);
    const double speed = std::sqrt(along.x * along.x + along.y * along.y);
    const double friction = rules.bearing * rules.friction.at(nodes.scale().node_of(place.x, place.y));
    const double rest = speed > 0 ? std::max(0.0, 1 - friction * std::abs(into) * std::sqrt(n) / speed) : 0;
    return {rest * along.x, rest * along.y};
}

// atan of a ratio of 0 or more, to k_quick_error (Rajan, Wang, Inkol, Joyal 2006, IEEE Signal Process. Mag. 23(3),
// 108): edges are looked for at every node, and few of the places where a fall might begin are steep enough.
constexpr double k_quick_error = 0.005;
double quick_atan(double ratio) noexcept {
    constexpr double k_fit = 0.28;
    return ratio <= 1 ? ratio / (1 + k_fit * ratio * ratio) : std::numbers::pi / 2 - ratio / (ratio * ratio + k_fit);
}

// Returns the mean angle by which the ground falls away below the path of a free fall [rad], seen from the edge over
// the length that a flow of this thickness does not bridge. The splines begin to fall a cell before an edge. `quick`:
// to k_quick_error.
double falls_away(const NodeGrid& nodes, const JumpRules& rules, const Bed& bed, Point from, Point velocity,
                  double climb, double thickness, bool quick) noexcept {
    const double speed = std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y), dx = nodes.cell_size();
    if (!(speed > 0)) return 0;
    const double width = std::max(k_edge_cells * dx, k_edge_thicknesses * thickness);
    const int count = static_cast<int>(std::ceil(width / dx));
    const double start = bed.z.value;
    double sum = 0;
    for (int k = 0; k < count; ++k) {
        const double beyond = (k + 0.5) * width / count, time = (dx + beyond) / speed;
        const Point place = at(from, velocity, time);
        if (!nodes.bounds().contains(place.x, place.y) || nodes.is_gap(nodes.scale().node_of(place.x, place.y)))
            return k > 0 ? sum / k : 0;
        const double height =
            std::max(0.0, start + (climb - 0.5 * rules.gravity * time) * time - ground_at(nodes, place).value);
        sum += quick ? quick_atan(height / beyond) : std::atan2(height, beyond);
    }
    return sum / count;
}

// Computes the free fall from jump.from until it lands.
void fall(const NodeGrid& nodes, const JumpRules& rules, Jump& jump) {
    const NodeScale grid = nodes.scale();
    const double search_distance = k_sampling * grid.dx, start = ground_at(nodes, jump.from).value;
    const double speed = std::hypot(jump.velocity.x, jump.velocity.y);
    Point direction{jump.velocity.x / speed, jump.velocity.y / speed};
    Point origin = jump.from;  // from which the way is counted
    Fall state{rules.gravity, jump.drag, {speed, jump.climb}};
    for (bool flies = true; flies;) {
        const double dt = state.step(search_distance);
        auto acceleration = state.acceleration(dt);
        const auto place_of = [&](const Fall& f) { return at(origin, direction, f.along); };
        const Point place = place_of(state);
        Fall next = state.after(dt, acceleration);
        Point to = place_of(next);
        const bool outside = !nodes.bounds().contains(to.x, to.y);
        const bool leaves = outside && !rules.wall;
        if (leaves || (!outside && nodes.is_gap(grid.node_of(to.x, to.y)))) {
            jump.left = leaves;
            jump.to = leaves ? place : to;
            jump.duration += dt;
            state = next;
            break;
        }
        if (outside || nodes.is_wall(grid.node_of(to.x, to.y))) {  // it falls down along the wall
            origin = place;
            state.along = state.speed.along = 0;
            acceleration = state.acceleration(dt);
            next = state.after(dt, acceleration);
            to = place;
        } else if (stop_jet_at_walls(nodes, start + next.up, place, to)) {  // and slides along that of the ground
            const Point way{to.x - place.x, to.y - place.y};
            const double slides = std::hypot(way.x, way.y), along = next.along - state.along;
            origin = place;
            direction = slides > 0 ? Point{way.x / slides, way.y / slides} : Point{};
            state.along = 0;
            state.speed.along *= along > 0 ? slides / along : 0;
            acceleration = state.acceleration(dt);
            next = state.after(dt, acceleration);
            to = place_of(next);
        }
        double ahead = dt;
        double above = start + next.up - ground_at(nodes, to).value;
        if (above <= 0) {
            double aloft = 0;
            for (int i = 0; i < k_halvings; ++i) {
                const double middle = 0.5 * (aloft + ahead);
                const Fall there = state.after(middle, acceleration);
                (start + there.up > ground_at(nodes, place_of(there)).value ? aloft : ahead) = middle;
            }
            next = state.after(ahead, acceleration);
            flies = false;
            above = 0;
        }
        state = next;
        jump.to = place_of(state);
        jump.duration += ahead;
        jump.height = std::max(jump.height, above);
        jump.over.push_back(
            {grid.node_of(jump.to.x, jump.to.y), above, jump.duration, std::sqrt(state.speed.squared())});
    }
    const Point velocity{state.speed.along * direction.x, state.speed.along * direction.y};
    jump.landed = landed_velocity(nodes, rules, jump.to, velocity, state.speed.up);
}

// Steps to the next node, by direction.
constexpr unsigned k_directions = 8;
struct Direction {
    int a, b;
};
constexpr Direction k_steps[k_directions] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

}  // namespace

std::uint8_t edges_at(const NodeGrid& nodes, std::int64_t column, std::int64_t row, double least) noexcept {
    const std::int64_t stride = nodes.stride();
    const auto exists = [&](std::int64_t i, std::int64_t j) {
        return i >= 0 && j >= 0 && i < stride && j < nodes.padded_rows();
    };
    const double* const z = nodes.bed.data() + row * stride + column;
    constexpr std::int64_t k_least_sight = static_cast<std::int64_t>(k_edge_cells);
    std::uint8_t edges = 0;
    for (unsigned d = 0; d < k_directions; ++d) {
        const auto [a, b] = k_steps[d];
        if (!exists(column - a, row - b)) continue;
        const std::int64_t step = b * stride + a;
        const double length = nodes.cell_size() * std::hypot(a, b), rise = z[0] - z[-step];
        std::array<double, k_edge_sight> falls{};
        double greatest = 0, sum = 0;
        std::int64_t sight = 0;
        for (; sight < k_edge_sight && exists(column + (sight + 1) * a, row + (sight + 1) * b); ++sight) {
            double& fall = falls[static_cast<std::size_t>(sight)];
            fall = (z[0] - z[(sight + 1) * step]) / static_cast<double>(sight + 1) + rise;
            greatest = std::max(greatest, fall);
        }
        if (quick_atan(greatest / length) < least) continue;  // nor is any mean greater
        for (std::int64_t k = 1; k <= sight; ++k) {
            sum += quick_atan(std::max(0.0, falls[static_cast<std::size_t>(k - 1)]) / length);
            if (k < k_least_sight || sum < least * static_cast<double>(k)) continue;
            edges = static_cast<std::uint8_t>(edges | 1U << d);
            break;
        }
    }
    return edges;
}

std::uint8_t directions_near(Point along) noexcept {
    const double x = std::abs(along.x), y = std::abs(along.y);
    constexpr double k_tangent = 0.41421356237309503;  // of half the angle between two directions
    const int a = x < k_tangent * y ? 0 : along.x > 0 ? 1 : -1, b = y < k_tangent * x ? 0 : along.y > 0 ? 1 : -1;
    unsigned nearest = 0;
    while (k_steps[nearest].a != a || k_steps[nearest].b != b) ++nearest;
    unsigned near = 0;
    for (const unsigned turn : {k_directions - 1, 0U, 1U}) near |= 1U << (nearest + turn) % k_directions;
    return static_cast<std::uint8_t>(near);
}

void greatest_convexity(const NodeRange& range, const NodeGrid& nodes, double* bounds) noexcept {
    // Within half a cell the second derivatives of the splines are means of these differences.
    struct Bend {
        double convex = 0, twist = 0;
    };
    constexpr std::int64_t k_side = k_tile + 2 * k_reach;
    std::array<Bend, k_side * k_side> bends{};
    const std::int64_t stride = nodes.stride(), west = range.i0 - k_reach, south = range.j0 - k_reach;
    const auto bend = [](const double* z, std::int64_t step) { return 2 * z[0] - z[step] - z[-step]; };
    for (std::int64_t j = std::max<std::int64_t>(1, south); j < std::min(nodes.padded_rows() - 1, range.j1 + k_reach);
         ++j) {
        for (std::int64_t i = std::max<std::int64_t>(1, west); i < std::min(stride - 1, range.i1 + k_reach); ++i) {
            const double* const z = nodes.bed.data() + j * stride + i;
            Bend& here = bends[static_cast<std::size_t>((j - south) * k_side + i - west)];
            for (const std::int64_t k : {-1, 0, 1}) {
                here.convex = std::max({here.convex, bend(z + k * stride, 1), bend(z + k, stride)});
                if (k == 0) continue;
                for (const std::int64_t l : {-1, 1})
                    here.twist = std::max(here.twist, std::abs(z[k * stride + l] - z[k * stride] - z[l] + z[0]));
            }
        }
    }
    range.for_each(stride, [&](std::size_t, std::int64_t i, std::int64_t j) {
        Bend most;
        for (std::int64_t b = j - south - k_reach; b <= j - south + k_reach; ++b) {
            for (std::int64_t a = i - west - k_reach; a <= i - west + k_reach; ++a) {
                const Bend& near = bends[static_cast<std::size_t>(b * k_side + a)];
                most = {std::max(most.convex, near.convex), std::max(most.twist, near.twist)};
            }
        }
        *bounds++ = (most.convex + most.twist) / (nodes.cell_size() * nodes.cell_size());
    });
}

std::optional<Jump> find_jump(const NodeGrid& nodes, const JumpRules& rules, Point place, Point along, double thickness,
                              double reach, double flown) {
    if (along.x == 0 && along.y == 0) return std::nullopt;
    const double search_distance = k_way_sampling * nodes.cell_size();
    double time = 0, before = 0;
    Point last = place, way{};
    for (Bed bed{}, behind{}; nodes.bounds().contains(place.x, place.y); behind = bed) {
        bed = bed_at(nodes, place);
        if (Point end = place; stop_jet_at_walls(nodes, behind.z.value + thickness, last, end)) return std::nullopt;
        const Point velocity = bed.map_velocity(along);
        if (bed.throws(velocity, rules.gravity)) {
            Jump jump;
            const auto angle_from = [&](Point from, bool quick) {
                jump.from = from;
                jump.velocity = bed.map_velocity(along);
                jump.climb = jump.velocity.x * bed.z.dx + jump.velocity.y * bed.z.dy;
                const double normal = thickness / BedFrame::of({bed.z.dx, bed.z.dy}).root;
                jump.drag = rules.drag / std::max(rules.least_depth, normal);
                return falls_away(nodes, rules, bed, from, jump.velocity, jump.climb, normal, quick);
            };
            if (time > 0) bed = behind;
            const double least = rules.angle - k_half_ramp - k_sample_margin;
            if (angle_from(last, true) < least - k_quick_error || angle_from(last, false) < least) return jump;
            // The place where the fall begins, between the previous sample and this one.
            double supported = 0, thrown = time - before;
            for (int i = 0; i < k_halvings && thrown > supported; ++i) {
                const double middle = 0.5 * (supported + thrown);
                const Bed there = bed_at(nodes, at(last, way, middle));
                (there.throws(there.map_velocity(along), rules.gravity) ? thrown : supported) = middle;
            }
            jump.glide = before + thrown;
            bed = bed_at(nodes, at(last, way, thrown));
            jump.fraction = smooth_step(rules.angle - k_half_ramp, rules.angle + k_half_ramp,
                                        angle_from(at(last, way, thrown), false));
            if (jump.fraction > 1 - k_least_part) jump.fraction = 1;
            if (jump.fraction - flown >= k_least_part * (1 - flown)) fall(nodes, rules, jump);
            return jump;
        }
        const double speed = std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y);
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

double Flights::kinetic() const noexcept {
    double sum = 0;
    for (const Flight& f : flights_) sum += 0.5 * get(f.particle, Field::volume) * f.speed.squared();
    return sum;
}

double Flights::momentum() const noexcept {
    double sum = 0;
    for (const Flight& f : flights_) sum += get(f.particle, Field::volume) * std::sqrt(f.speed.squared());
    return sum;
}

void Flights::advance_to(double time, const JumpRules& rules) {
    for (Flight& f : flights_) {
        for (; !f.over.empty() && f.begins + f.over.back().time <= time; f.over.pop_back()) {
            const Jump::Place& place = f.over.back();
            heights_[place.node] = std::max(heights_[place.node], static_cast<float>(place.height));
            if (place.height <= rules.clearance && f.depth >= rules.least_depth)
                low_.update<double>(place.node, 1, true, f.depth, place.speed, f.begins + place.time);
        }
        const double dt = time - f.now;
        if (!(dt > 0)) continue;
        const Fall state{rules.gravity, f.drag, f.speed};
        f.speed = state.after(dt, state.acceleration(dt)).speed;
        f.now = time;
    }
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
    flight.now = flight.begins;
    flight.speed = {std::hypot(jump.velocity.x, jump.velocity.y), jump.climb};
    flight.drag = jump.drag;
    flight.depth = get(particle, Field::volume) / get(particle, Field::area);
    flight.over.assign(jump.over.rbegin(), jump.over.rend());
    flight.left = jump.left;
    ParticleRow& row = flight.particle;
    get(row, Field::x) = jump.to.x;
    get(row, Field::y) = jump.to.y;
    get(row, Field::u) = jump.landed.x;
    get(row, Field::v) = jump.landed.y;
    stretch(row, jump.duration, cell_area);
    for (const Field c : {Field::c_xx, Field::c_xy, Field::c_yx, Field::c_yy, Field::flown}) get(row, c) = 0;
    next_landing_ = std::min(next_landing_, flight.ends);
    flights_.push_back(flight);

    statistics_.add(get(row, Field::volume), jump);
}

void JumpStatistics::add(double jumped, const Jump& jump) noexcept {
    const double length = std::hypot(jump.to.x - jump.from.x, jump.to.y - jump.from.y);
    merge({jumped, jump.height, length, jumped * length, jump.from, jump.to});
}

void JumpStatistics::merge(const JumpStatistics& other) noexcept {
    volume += other.volume;
    way += other.way;
    highest = std::max(highest, other.highest);
    if (!(other.longest > longest)) return;
    longest = other.longest;
    from = other.from;
    to = other.to;
}

// Edges of a bed that changes would have to be found at every step: there, any node may be near one.
bool Edges::examine(std::int64_t tile, const TileGrid& tiles, const NodeGrid& nodes, const JumpRules& rules) {
    known_.resize(static_cast<std::size_t>(tiles.tiles_x() * tiles.tiles_y()), k_unknown);
    std::uint8_t& known = known_[static_cast<std::size_t>(tile)];
    if (known != k_unknown) return known == k_edge;
    const NodeRange range(tile, tiles, nodes);
    constexpr std::int64_t k_side = k_tile + 2 * k_reach;
    std::array<std::uint8_t, k_side * k_side> edges{};
    std::array<double, k_tile * k_tile> convexity;
    const std::int64_t west = range.i0 - k_reach, south = range.j0 - k_reach;
    nodes.cover({west - k_edge_sight, range.i1 + k_reach + k_edge_sight, south - k_edge_sight,
                 range.j1 + k_reach + k_edge_sight});
    for (std::int64_t j = std::max<std::int64_t>(south, 0);
         !nodes.bed_changes && j < std::min(range.j1 + k_reach, nodes.padded_rows()); ++j)
        for (std::int64_t i = std::max<std::int64_t>(west, 0); i < std::min(range.i1 + k_reach, nodes.stride()); ++i)
            edges[static_cast<std::size_t>((j - south) * k_side + i - west)] =
                edges_at(nodes, i, j, rules.angle - k_half_ramp - k_edge_margin);
    greatest_convexity(range, nodes, convexity.data());
    known = k_none;
    const double* bound = convexity.data();
    range.for_each(nodes.stride(), [&](std::size_t n, std::int64_t i, std::int64_t j) {
        constexpr std::uint8_t k_everywhere = 0xff;
        std::uint8_t near = nodes.bed_changes ? k_everywhere : 0;
        for (std::int64_t b = j - south - k_reach; near != k_everywhere && b <= j - south + k_reach; ++b)
            for (std::int64_t a = i - west - k_reach; a <= i - west + k_reach; ++a)
                near |= edges[static_cast<std::size_t>(b * k_side + a)];
        // Rounded up by more than a float's rounding.
        near_[n] = {near != 0 ? static_cast<float>(*bound * (1 + 1e-6)) : 0, near};
        ++bound;
        if (near_[n].convexity > 0) known = k_edge;
    });
    return known == k_edge;
}

std::vector<std::size_t> Flights::take_off(ParticleSet& particles, const TileOrder& order, const NodeGrid& nodes,
                                           const JumpRules& rules, double time, double reach, ThreadPool& pool) {
    const auto& tiles = order.tiles();
    const double *x = particles[Field::x], *y = particles[Field::y], *u = particles[Field::u], *v = particles[Field::v];
    double *const volume = particles[Field::volume], *const flown = particles[Field::flown];
    const double *const area = particles[Field::area], *const pore = particles[Field::pore_pressure];
    std::vector<std::size_t> steep;
    if (nodes.bed_changes) edges_.forget(order.node_tiles());
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        bool any = false;
        for (std::int64_t b = tiles[t].y0; b <= tiles[t].y1; ++b)
            for (std::int64_t a = tiles[t].x0; a <= tiles[t].x1; ++a)
                any = edges_.examine(b * order.grid().tiles_x() + a, order.grid(), nodes, rules) || any;
        if (any) steep.push_back(t);
    }
    const NodeScale grid = nodes.scale();
    std::vector<std::vector<std::pair<std::size_t, Jump>>> found(steep.size());
    pool.for_each(steep.size(), [&](std::size_t t) {
        const ParticleTile& tile = tiles[steep[t]];
        for (std::size_t p = tile.begin; p < tile.end; ++p) {
            std::optional<Jump> jump;
            if (edges_.may_jump(grid.node_of(x[p], y[p]), {u[p], v[p]}, rules.gravity)) {
                JumpRules own = rules;
                if (pore != nullptr) own.bearing = 1 - pore[p];
                jump = find_jump(nodes, own, {x[p], y[p]}, {u[p], v[p]}, volume[p] / area[p], reach, flown[p]);
            }
            if (!jump) {
                flown[p] = 0;
            } else if (jump->duration > 0) {
                found[t].emplace_back(p, std::move(*jump));
            }
        }
    });
    std::vector<std::size_t> whole;
    for (const auto& jumps : found) {  // in the particles' order, independent of threads
        for (const auto& [p, jump] : jumps) {
            ParticleRow row = particles.row(p);
            if (jump.fraction == 1) {
                whole.push_back(p);
            } else {
                const double part = (jump.fraction - flown[p]) / (1 - flown[p]) * volume[p];
                get(row, Field::volume) = part;
                volume[p] -= part;
                flown[p] = jump.fraction;
            }
            begin(row, jump, time, nodes.cell_size() * nodes.cell_size());
        }
    }
    return whole;
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
