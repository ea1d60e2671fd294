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

}  // namespace

std::optional<Jump> find_jump(const NodeGrid& nodes, const JumpRules& rules, Point place, Point along, double reach,
                              double clearance) {
    const double search_distance = k_sampling * nodes.cell_size();
    double time = 0, before = 0;
    Point last = place, way{};
    while (nodes.bounds().contains(place.x, place.y)) {
        Bed bed = bed_at(nodes, place);
        Point velocity = bed.map_velocity(along);
        if (bed.throws(velocity, rules.gravity)) {
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
// there are any. The splines' gradient is a mean of the differences between neighbours in its 3 x 3 nodes.
bool mark_near_edges(const NodeRange& range, const NodeGrid& nodes, double edge, std::uint8_t* marks) {
    // A particle's displacement in a step (less than a cell), the width of an edge, and the splines' support.
    constexpr std::int64_t k_near = static_cast<std::int64_t>(k_edge_width) + 3, k_side = k_tile + 2 * k_near;
    const std::int64_t west = range.i0 - k_near, south = range.j0 - k_near, stride = nodes.stride();
    const double* bed = nodes.bed.data();
    std::array<double, k_side * k_side> across{}, along{};
    double greatest_across = 0, greatest_along = 0;
    for (std::int64_t j = std::max<std::int64_t>(south, 0); j < std::min(range.j1 + k_near, nodes.padded_rows() - 1);
         ++j) {
        for (std::int64_t i = std::max<std::int64_t>(west, 0); i < std::min(range.i1 + k_near, stride - 1); ++i) {
            const auto place = static_cast<std::size_t>((j - south) * k_side + i - west);
            const double* z = bed + j * stride + i;
            greatest_across = std::max(greatest_across, across[place] = std::abs(z[1] - z[0]));
            greatest_along = std::max(greatest_along, along[place] = std::abs(z[stride] - z[0]));
        }
    }
    const double steep = edge * nodes.cell_size();
    bool any = false;
    const bool possible = std::hypot(greatest_across, greatest_along) >= steep;
    range.for_each(stride, [&](std::size_t n, std::int64_t i, std::int64_t j) {
        double x = 0, y = 0;
        for (std::int64_t b = j - south - k_near; possible && b <= j - south + k_near; ++b) {
            for (std::int64_t a = i - west - k_near; a <= i - west + k_near; ++a) {
                const auto place = static_cast<std::size_t>(b * k_side + a);
                x = std::max(x, across[place]);
                y = std::max(y, along[place]);
            }
        }
        marks[n] = std::hypot(x, y) >= steep ? 1 : 0;
        any = any || marks[n] != 0;
    });
    return any;
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
